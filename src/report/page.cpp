// SPDX-License-Identifier: MIT
#include "report/page.h"

#include <fmt/format.h>
#include <ombrage/metrics.h>
#include <ombrage/truth_kind.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/strings.h"
#include "metrics/error_colors.h"
#include "report/assets.h"
#include "report/html_text.h"
#include "report/tables.h"

namespace ombrage {

namespace {

std::string cssColor(const float rgb[3]) {
    return fmt::format("rgb({},{},{})", std::lround(rgb[0] * 255), std::lround(rgb[1] * 255),
                       std::lround(rgb[2] * 255));
}

/// One argument of a command as a shell takes it.
std::string shellQuoted(const std::string& word) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./=,:+").find(c) != std::string_view::npos;
    });
    if (plain) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string facts(const ReportData& data) {
    std::set<std::string> devices, versions, clocks;
    for (const RunRecord& r : data.records) {
        devices.insert(r.device.renderer + ", OpenGL " + r.device.version +
                       (r.device.software ? " (software: times are not a GPU's)" : ""));
        versions.insert(r.version);
        clocks.insert(r.clock);
    }
    const auto list = [](const std::set<std::string>& items) {
        return escapeHtml(join({items.begin(), items.end()}, "; "));
    };
    std::string html = "<dl class=\"facts\">\n";
    html += "<dt>Device</dt><dd>" + list(devices) + "</dd>\n";
    html += "<dt>Clock of the GPU times</dt><dd>" + list(clocks) + "</dd>\n";
    html += "<dt>Ombrage</dt><dd>" + list(versions) + "</dd>\n";
    std::set<std::string> commands;
    for (const RunNote& note : data.notes) {
        std::vector<std::string> words;
        for (const std::string& word : note.command) words.push_back(shellQuoted(word));
        if (!words.empty() && commands.insert(join(words, " ")).second)
            html += "<dt>Command</dt><dd><code>" + escapeHtml(join(words, " ")) + "</code></dd>\n";
    }
    return html + "</dl>\n";
}

std::string legend() {
    std::string stops;
    constexpr int kStops = 32;
    for (int i = 0; i <= kStops; ++i) {
        float rgb[3];
        errorColor(2.0f * float(i) / kStops - 1.0f, rgb);
        stops += (i == 0 ? "" : ",") + cssColor(rgb);
    }
    std::string marks;
    for (double error : {-1.0, -0.5, -0.1, -0.01, 0.0, 0.01, 0.1, 0.5, 1.0})
        marks += fmt::format("<span style=\"left:{:.1f}%\">{}</span>",
                             50.0 + 50.0 * double(errorScalePosition(float(error))), formatNumber(error));
    std::string html =
        "<section>\n<h2>How to read the error maps</h2>\n"
        "<p>Every error map of this report has the same scale: visibility minus truth, blue where the picture is too "
        "dark, "
        "orange where it is too bright, white where it is right. Grey pixels are not measured: sky, surfaces turned "
        "away "
        "from the light, and pixels where the raster and the rays see different triangles.</p>\n";
    html +=
        "<div class=\"scale\" role=\"img\" aria-label=\"Error scale from -1, dark blue, over 0, white, to 1, brown\">"
        "<div class=\"ramp\" style=\"background:linear-gradient(90deg," +
        stops + ")\"></div><div class=\"marks\">" + marks + "</div></div>\n";
    html += "<p>Classes of shadow errors:</p>\n<ul class=\"keys\">\n";
    for (std::size_t c = 0; c < kErrorClassCount; ++c)
        html += "<li><i style=\"background:" + cssColor(kErrorClassColors[c]) + "\"></i>" +
                errorClassKey(ErrorClass(c)) + (c == 0 ? " (darker in shadow)" : "") + "</li>\n";
    return html + "</ul>\n</section>\n";
}

std::string measured(const RunRecord& r) {
    std::vector<std::string> parts;
    for (const std::string& key : metricColumns(r))
        if (const auto found = r.metrics.find(key); found != r.metrics.end() && found->second)
            parts.push_back(key + " " + shortNumber(found->second));
    return join(parts, ", ");
}

std::string figure(const Previews& previews, const RunRecord& r, const std::string& kind, const std::string& title,
                   const std::string& alt) {
    const auto path = r.images.find(kind);
    if (path == r.images.end()) return {};
    const auto uri = previews.uris.find(path->second);
    if (uri == previews.uris.end()) return {};
    return "<figure><img data-title=\"" + escapeHtml(title) + "\" alt=\"" + escapeHtml(alt) + "\" src=\"" +
           uri->second + "\"><figcaption>" + escapeHtml(title) + "</figcaption></figure>\n";
}

/// Every technique is held against a truth of its own.
bool isOwn(const RunRecord& r) {
    return r.truth && r.truth->kind == truthKindName(TruthKind::Own);
}

std::string cards(const Previews& previews, const std::vector<const RunRecord*>& group) {
    const RunRecord& first = *group.front();
    const std::string where = first.scene + (first.light.empty() ? "" : ", light " + first.light);
    std::string html = "<div class=\"cards\">\n";
    if (!isOwn(first))
        html += figure(previews, first, "truth", "truth: visibility", "Ray-traced visibility of " + where);
    html += figure(previews, first, "reference", "truth: picture",
                   "Picture of " + where + " with the ray-traced visibility");
    for (const RunRecord* r : group) {
        const std::string values = measured(*r),
                          suffix = " by " + r->pipeline + " on " + where + (values.empty() ? "" : ": " + values);
        if (isOwn(*r))
            html += figure(previews, *r, "truth", r->pipeline + ": claim",
                           "Ray-traced integral that " + r->pipeline + " claims on " + where);
        html += figure(previews, *r, "visibility", r->pipeline + ": visibility", "Visibility" + suffix);
        html += figure(previews, *r, "error", r->pipeline + ": error", "Error map" + suffix);
        html +=
            figure(previews, *r, "flicker", r->pipeline + ": largest change", "Largest change of the error" + suffix);
        html += figure(previews, *r, "classes", r->pipeline + ": error classes", "Classes of the errors" + suffix);
        html += figure(previews, *r, "picture", r->pipeline + ": picture", "Picture" + suffix);
    }
    return html + "</div>\n";
}

std::string sections(const ReportData& data) {
    // Only runs that answer the same question stand in one table.
    using Key =
        std::tuple<std::string, std::string, std::string, std::string, std::string, std::string, int, int, std::string>;
    std::vector<std::pair<Key, std::vector<const RunRecord*>>> groups;
    for (const RunRecord& r : data.records) {
        const Key key{r.scene,  r.sceneHash, r.family,
                      r.camera, r.light,     r.motion,
                      r.width,  r.height,    r.truth ? r.truth->kind : std::string()};
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == key; });
        if (group == groups.end()) group = groups.insert(groups.end(), {key, {}});
        group->second.push_back(&r);
    }
    std::string html;
    for (const auto& [key, group] : groups) {
        const RunRecord& r = *group.front();
        html += "<section class=\"measured\">\n<h2>" + escapeHtml(r.scene) + ": " + escapeHtml(r.family) +
                (r.light.empty() ? "" : ", light " + escapeHtml(r.light)) +
                (r.motion.empty() ? "" : ", under " + escapeHtml(r.motion)) +
                (isOwn(r) ? ", against what each technique claims" : "") + "</h2>\n";
        std::string about = fmt::format("Camera {}, {}x{}, scene {}", r.camera, r.width, r.height, r.sceneHash);
        if (r.truth)
            about += fmt::format(". Truth {}: {} sample{} per pixel, standard error {}, {} % of the surface masked",
                                 r.truth->kind, r.truth->spp, r.truth->spp == 1 ? "" : "s",
                                 shortNumber(r.truth->standard_error), shortNumber(100 * r.truth->masked));
        else
            about += ". This family has no truth yet: pictures and cost only";
        html += "<p>" + escapeHtml(about) + ".</p>\n" + recordTable(group) + recordDetails(group) +
                cards(data.previews, group) + "</section>\n";
    }
    return html;
}

std::string notices(const ReportData& data) {
    std::string html;
    std::vector<std::string> gates;
    bool interrupted = false;
    for (const RunNote& note : data.notes) {
        for (const std::string& gate : note.failedGates)
            if (std::find(gates.begin(), gates.end(), gate) == gates.end()) gates.push_back(gate);
        interrupted = note.interrupted;
    }
    if (interrupted)
        html += "<p class=\"notice\">The last run was interrupted: some of what was asked for is missing.</p>\n";
    if (!gates.empty()) {
        html += "<div class=\"notice\"><p>Gates that failed:</p>\n<ul>\n";
        for (const std::string& gate : gates) html += "<li>" + escapeHtml(gate) + "</li>\n";
        html += "</ul></div>\n";
    }
    if (!data.previews.leftOut.empty())
        html += "<p class=\"notice\">Too many pictures for one file: the kinds " +
                escapeHtml(join(data.previews.leftOut, ", ")) +
                " are left out. All of them are in the folder images.</p>\n";
    if (!data.previews.missing.empty())
        html += fmt::format("<p class=\"notice\">{} picture(s) of the records could not be read, such as {}.</p>\n",
                            data.previews.missing.size(), escapeHtml(data.previews.missing.front()));
    return html;
}

std::string skippedTable(const std::vector<RunNote>& notes) {
    std::vector<RunNote::Skipped> skipped;
    for (const RunNote& note : notes)
        for (const RunNote::Skipped& s : note.skipped)
            if (std::find(skipped.begin(), skipped.end(), s) == skipped.end()) skipped.push_back(s);
    if (skipped.empty()) return {};
    std::string html =
        "<section>\n<h2>Skipped</h2>\n<table><thead><tr><th scope=\"col\">scene</th><th scope=\"col\" "
        "class=\"text\">technique</th>"
        "<th scope=\"col\" class=\"text\">reason</th></tr></thead><tbody>\n";
    for (const RunNote::Skipped& s : skipped)
        html += "<tr><td>" + escapeHtml(s.scene) + "</td><td class=\"text\">" + escapeHtml(s.technique) +
                "</td><td class=\"text\">" + escapeHtml(s.reason) + "</td></tr>\n";
    return html + "</tbody></table>\n</section>\n";
}

std::string definitions() {
    std::string html = "<section>\n<h2>What the numbers mean</h2>\n<dl class=\"facts\">\n";
    for (const MetricInfo& info : metricInfos())
        html += "<dt>" + escapeHtml(info.key + (info.unit.empty() ? "" : " [" + info.unit + "]")) + "</dt><dd>" +
                escapeHtml(info.help) + (info.lowerIsBetter ? "" : " Higher is better.") + "</dd>\n";
    return html + "</dl>\n</section>\n";
}

std::string rawRecords(const std::vector<RunRecord>& records) {
    std::vector<std::string> texts;
    for (const RunRecord& r : records) texts.push_back(r.toJson());
    return "<script type=\"application/json\" id=\"records\">" +
           escapeScriptJson("{\"schema\":\"ombrage/records/1\",\"records\":[" + join(texts, ",\n") + "]}") +
           "</script>\n";
}

}  // namespace

std::string reportPage(const ReportData& data) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
        "script-src 'unsafe-inline'; img-src data:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Ombrage "
        "report</title>\n<style>";
    html += kReportStyle;
    html += "</style>\n</head>\n<body>\n<header>\n<h1>Ombrage report</h1>\n<p class=\"headline\">" +
            escapeHtml(headline(data.records)) + "</p>\n";
    html += notices(data) + facts(data) + "</header>\n<main>\n" + legend() + sections(data) + skippedTable(data.notes) +
            definitions();
    html += fmt::format(
        "<p>Previews are at most {} px wide; the folder images has the full pictures. The raw records stand in this "
        "file "
        "as JSON (script element \"records\").</p>\n</main>\n",
        data.previews.width_px);
    html += rawRecords(data.records) + "<script>";
    html += kReportScript;
    return html + "</script>\n</body>\n</html>\n";
}

}  // namespace ombrage
