// SPDX-License-Identifier: MIT
#include "report/class_shares.h"

#include <fmt/format.h>
#include <ombrage/metrics.h>
#include <algorithm>
#include <cmath>

#include "core/strings.h"
#include "metrics/error_colors.h"
#include "report/html_text.h"

namespace ombrage {

namespace {

std::string percent(double share) {
    return shortNumber(100 * share) + " %";
}

std::string swatch(std::size_t errorClass) {
    return "<i class=\"swatch\" style=\"background:" + cssColor(kErrorClassColors[errorClass]) + "\"></i>";
}

std::string helpOf(const std::string& key) {
    for (const MetricInfo& info : metricInfos())
        if (info.key == key) return info.help;
    return "Within the tolerance; darker where the truth is in shadow.";
}

/// Classes that some run of the group has at all.
std::vector<std::size_t> occurring(const RecordGroup& group) {
    std::vector<std::size_t> classes;
    for (std::size_t c = 1; c < kErrorClassCount; ++c)
        if (std::any_of(group.records.begin(), group.records.end(),
                        [&](const RunRecord* r) { return metricOf(*r, errorClassKey(ErrorClass(c))).value_or(0) > 0; }))
            classes.push_back(c);
    return classes;
}

}  // namespace

std::string cssColor(const float rgb[3]) {
    return fmt::format("rgb({},{},{})", std::lround(rgb[0] * 255), std::lround(rgb[1] * 255),
                       std::lround(rgb[2] * 255));
}

std::string errorLegend() {
    std::string stops;
    constexpr int kStops = 32;
    for (int i = 0; i <= kStops; ++i) {
        float rgb[3];
        errorColor(2.0f * float(i) / kStops - 1.0f, rgb);
        stops += (i == 0 ? "" : ",") + cssColor(rgb);
    }
    std::string marks;
    for (double error : {-1.0, -0.5, -0.1, -0.01, 0.01, 0.1, 0.5, 1.0})
        marks += fmt::format("<span style=\"left:{:.1f}%\">{}</span>",
                             50.0 + 50.0 * double(errorScalePosition(float(error))), formatNumber(error));
    std::string html =
        "<section id=\"legend\">\n<h2>How to read the error maps</h2>\n"
        "<p>Every error map of this report has the same scale: visibility minus truth, blue where the picture is too "
        "dark, orange where it is too bright, white where it is right. Grey pixels are not measured: sky, surfaces "
        "turned away from the light, and pixels where the raster and the rays see different triangles.</p>\n"
        "<div class=\"scale\" role=\"img\" aria-label=\"Error scale from -1, dark blue, over 0, white, to 1, brown\">"
        "<div class=\"ramp\" style=\"background:linear-gradient(90deg," +
        stops + ")\"></div><div class=\"marks\">" + marks + "</div></div>\n" +
        "<h3>Classes of shadow errors</h3>\n<dl class=\"keys\">\n";
    for (std::size_t c = 0; c < kErrorClassCount; ++c) {
        const std::string key = errorClassKey(ErrorClass(c));
        html += "<div><dt>" + swatch(c) + key + "</dt><dd>" + escapeHtml(helpOf(key)) + "</dd></div>\n";
    }
    return html + "</dl>\n</section>\n";
}

std::string classShares(const RecordGroup& group) {
    const std::vector<std::size_t> classes = occurring(group);
    if (classes.empty()) return {};
    double most = 0;
    for (const RunRecord* r : group.records) most = std::max(most, metricOf(*r, "over").value_or(0));
    if (!(most > 0)) return {};
    std::string html =
        "<details class=\"shares\" open><summary>Errors by class</summary>\n<div class=\"wide\" tabindex=\"0\" "
        "role=\"region\" "
        "aria-label=\"Errors by class\"><table class=\"sortable\"><caption><span>Shares of the measured pixels; the "
        "longest "
        "bar is " +
        percent(most) + ".</span></caption>\n<thead><tr><th scope=\"col\" class=\"text\" data-kind=\"text\">" +
        "<button type=\"button\">technique</button></th><th scope=\"col\" class=\"text\">classes</th>"
        "<th scope=\"col\" data-kind=\"number\"><button type=\"button\">over</button></th>";
    for (std::size_t c : classes)
        html += "<th scope=\"col\" data-kind=\"number\"><button type=\"button\" title=\"" +
                escapeHtml(helpOf(errorClassKey(ErrorClass(c)))) + "\">" + swatch(c) + errorClassKey(ErrorClass(c)) +
                "</button></th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const RunRecord* r : group.records) {
        const auto over = metricOf(*r, "over");
        if (!over) continue;
        std::string bar, cells, spoken;
        for (std::size_t c : classes) {
            const std::string key = errorClassKey(ErrorClass(c));
            const double share = metricOf(*r, key).value_or(0);
            if (share > 0) {
                bar += fmt::format("<i style=\"width:{:.3f}%;background:{}\"></i>", 100 * share / most,
                                   cssColor(kErrorClassColors[c]));
                spoken += (spoken.empty() ? "" : ", ") + key + " " + percent(share);
            }
            cells += "<td data-v=\"" + formatNumber(share) + "\">" + (share > 0 ? percent(share) : "") + "</td>";
        }
        html += "<tr><th scope=\"row\" class=\"text\"><code>" + escapeHtml(r->pipeline) +
                "</code></th><td class=\"barcell\"><span class=\"bar\" role=\"img\" aria-label=\"" +
                escapeHtml(spoken.empty() ? "none" : spoken) + "\">" + bar + "</span></td><td data-v=\"" +
                formatNumber(*over) + "\">" + percent(*over) + "</td>" + cells + "</tr>\n";
    }
    return html + "</tbody></table></div></details>\n";
}

std::string colorTablesJson() {
    std::string ramp, classes;
    // Fine enough that neighbours differ by less than one step of eight bits.
    constexpr int kSteps = 256;
    for (int i = 0; i <= kSteps; ++i) {
        float rgb[3];
        errorColor(2.0f * float(i) / kSteps - 1.0f, rgb);
        ramp += fmt::format("{}\"{}\"", i == 0 ? "" : ",", cssColor(rgb));
    }
    const auto entry = [&](const std::string& key, const float rgb[3]) {
        classes += fmt::format("{}{{\"key\":\"{}\",\"color\":[{},{},{}]}}", classes.empty() ? "" : ",", key,
                               std::lround(rgb[0] * 255), std::lround(rgb[1] * 255), std::lround(rgb[2] * 255));
    };
    for (std::size_t c = 0; c < kErrorClassCount; ++c) entry(errorClassKey(ErrorClass(c)), kErrorClassColors[c]);
    entry("right", kRightAndLit);
    const float masked[3] = {kMaskedGrey, kMaskedGrey, kMaskedGrey};
    entry("not measured", masked);
    return "{\"ramp\":[" + ramp + "],\"classes\":[" + classes + "]}";
}

}  // namespace ombrage
