// SPDX-License-Identifier: MIT
#include "report/page.h"

#include <fmt/format.h>
#include <ombrage/metrics.h>

#include "core/strings.h"
#include "report/assets.h"
#include "report/class_shares.h"
#include "report/gallery.h"
#include "report/html_text.h"
#include "report/notices.h"
#include "report/overview.h"
#include "report/tables.h"

namespace ombrage {

namespace {

std::string about(const RunRecord& r) {
    std::string text = fmt::format("Camera {}, {}x{}, scene {}", r.camera, r.width, r.height, r.sceneHash);
    if (r.truth)
        text += fmt::format(". Truth {}: {} sample{} per pixel, standard error {}, {} % of the surface masked",
                            r.truth->kind, r.truth->spp, r.truth->spp == 1 ? "" : "s",
                            shortNumber(r.truth->standard_error), shortNumber(100 * r.truth->masked));
    else
        text += ". This family has no truth yet: pictures and cost only";
    return "<p class=\"about\">" + escapeHtml(text) + ".</p>\n";
}

/// The script fills the plot, the comparison and the times.
std::string section(const ReportData& data, const RecordGroup& group, std::size_t number) {
    const std::string crops = number < data.crops.size() ? data.crops[number] : std::string();
    return fmt::format("<section class=\"measured\" id=\"group-{}\">\n", number) + "<h2>" + escapeHtml(group.title()) +
           "</h2>\n" + about(group.first()) +
           "<div class=\"decide\"><div class=\"plot\"></div><div class=\"compare\"></div></div>\n" +
           recordTable(group, number) + classShares(group) + crops + "<div class=\"times\"></div>\n" +
           recordDetails(group, data.notes) + gallery(data.previews, group) + "</section>\n";
}

std::string contents(const std::vector<RecordGroup>& groups, bool hasOverview, bool hasBench) {
    std::string html = "<nav aria-label=\"Contents\"><ul>\n";
    if (hasOverview) html += "<li><a href=\"#overview0\">Over all scenes</a></li>\n";
    for (std::size_t g = 0; g < groups.size(); ++g)
        html += fmt::format("<li><a href=\"#group-{}\">", g) + escapeHtml(groups[g].title()) + "</a></li>\n";
    if (hasBench) html += "<li><a href=\"#bench\">Benchmarks</a></li>\n";
    return html +
           "<li><a href=\"#legend\">How to read the error maps</a></li>\n"
           "<li><a href=\"#environment\">Environment and commands</a></li>\n"
           "<li><a href=\"#definitions\">What the numbers mean</a></li>\n</ul></nav>\n";
}

std::string definitions() {
    std::string html = "<section id=\"definitions\">\n<h2>What the numbers mean</h2>\n<dl class=\"facts\">\n";
    for (const MetricInfo& info : metricInfos())
        html += "<dt>" + escapeHtml(info.key + (info.unit.empty() ? "" : " [" + info.unit + "]")) + "</dt><dd>" +
                escapeHtml(info.help) + (info.lowerIsBetter ? "" : " Higher is better.") + "</dd>\n";
    return html + "</dl>\n</section>\n";
}

std::string jsonScript(const char* id, std::string json) {
    return std::string("<script type=\"application/json\" id=\"") + id + "\">" + escapeScriptJson(std::move(json)) +
           "</script>\n";
}

std::string rawData(const ReportData& data) {
    std::vector<std::string> records;
    for (const RunRecord& r : data.records) records.push_back(r.toJson());
    return jsonScript("records", "{\"schema\":\"ombrage/records/1\",\"records\":[" + join(records, ",\n") + "]}") +
           jsonScript("benches", "[" + join(data.benchGroups, ",\n") + "]") + jsonScript("colors", colorTablesJson());
}

}  // namespace

std::string reportPage(const ReportData& data) {
    const std::vector<RecordGroup> groups = groupRecords(data.records);
    const std::string means = overview(groups);
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
        "script-src 'unsafe-inline'; img-src data:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Ombrage "
        "report</title>\n<style>";
    html += kReportStyle;
    html +=
        "</style>\n</head>\n<body>\n<header>\n<div class=\"top\"><h1>Ombrage report</h1>"
        "<button type=\"button\" id=\"theme\">Theme: system</button></div>\n<p class=\"headline\">" +
        escapeHtml(headline(data.records)) + "</p>\n";
    html += notices(data) +
            "<noscript><p class=\"notice\">Plots and comparisons need JavaScript. Tables and pictures "
            "are all here without it.</p></noscript>\n" +
            contents(groups, !means.empty(), !data.benchGroups.empty()) + "</header>\n<main>\n" + means;
    for (std::size_t g = 0; g < groups.size(); ++g) html += section(data, groups[g], g);
    if (!data.benchGroups.empty()) html += "<section id=\"bench\">\n<h2>Benchmarks</h2>\n</section>\n";
    html += errorLegend() + skippedTable(data.notes) + environment(data) + definitions() + "</main>\n";
    html += rawData(data) + "<script>";
    html += kReportScript;
    return html + "</script>\n</body>\n</html>\n";
}

}  // namespace ombrage
