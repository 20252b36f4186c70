// SPDX-License-Identifier: MIT
#include "report/gallery.h"

#include "core/strings.h"
#include "report/html_text.h"
#include "report/tables.h"

namespace ombrage {

namespace {

std::string measured(const RunRecord& r, const std::vector<std::string>& columns) {
    std::vector<std::string> parts;
    for (const std::string& key : columns)
        if (const auto value = metricOf(r, key)) parts.push_back(key + " " + shortNumber(value));
    return join(parts, ", ");
}

std::string figure(const Previews& previews, const RunRecord& r, const std::string& kind, const std::string& title,
                   const std::string& alt) {
    const auto path = r.images.find(kind);
    if (path == r.images.end()) return {};
    const auto uri = previews.uris.find(path->second);
    if (uri == previews.uris.end()) return {};
    return "<figure><img data-path=\"" + escapeHtml(path->second) + "\" alt=\"" + escapeHtml(alt) +
           "\" decoding=\"async\" src=\"" + uri->second + "\"><figcaption>" + escapeHtml(title) +
           "</figcaption></figure>\n";
}

}  // namespace

std::string gallery(const Previews& previews, const RecordGroup& group) {
    const RunRecord& first = group.first();
    const std::string where = group.place();
    const std::vector<std::string> columns = metricColumns(group);
    const bool own = hasOwnTruth(first);
    std::string html;
    if (!own) html += figure(previews, first, "truth", "truth: visibility", "Ray-traced visibility of " + where);
    html += figure(previews, first, "reference", "truth: picture",
                   "Picture of " + where + " with the ray-traced visibility");
    for (const RunRecord* r : group.records) {
        const std::string values = measured(*r, columns),
                          suffix = " by " + r->pipeline + " on " + where + (values.empty() ? "" : ": " + values);
        if (own)
            html += figure(previews, *r, "truth", r->pipeline + ": claim",
                           "Ray-traced integral that " + r->pipeline + " claims on " + where);
        html += figure(previews, *r, "visibility", r->pipeline + ": visibility", "Visibility" + suffix);
        html += figure(previews, *r, "error", r->pipeline + ": error", "Error map" + suffix);
        html +=
            figure(previews, *r, "flicker", r->pipeline + ": largest change", "Largest change of the error" + suffix);
        html += figure(previews, *r, "classes", r->pipeline + ": error classes", "Classes of the errors" + suffix);
        html += figure(previews, *r, "picture", r->pipeline + ": picture", "Picture" + suffix);
    }
    if (html.empty()) return {};
    return "<details class=\"gallery\"><summary>All pictures</summary>\n<div class=\"cards\">\n" + html +
           "</div></details>\n";
}

}  // namespace ombrage
