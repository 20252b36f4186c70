// SPDX-License-Identifier: MIT
#include "report/tables.h"

#include <fmt/format.h>
#include <ombrage/metrics.h>
#include <algorithm>
#include <cmath>

#include "core/strings.h"
#include "report/html_text.h"

namespace ombrage {

namespace {

const MetricInfo* infoOf(const std::string& key) {
    for (const MetricInfo& info : metricInfos())
        if (info.key == key) return &info;
    return nullptr;
}

bool lowerIsBetter(const std::string& key) {
    const MetricInfo* info = infoOf(key);
    return !info || info->lowerIsBetter;
}

/// The best value of a column, where values differ. Bias is best nearest to 0.
std::optional<double> bestOf(const RecordGroup& group, const std::string& key) {
    std::optional<double> best;
    bool differ = false;
    for (const RunRecord* r : group.records) {
        const auto value = metricOf(*r, key);
        if (!value) continue;
        differ = differ || (best && *value != *best);
        const auto rank = [&](double v) { return key == "bias" ? std::fabs(v) : lowerIsBetter(key) ? v : -v; };
        if (!best || rank(*value) < rank(*best)) best = value;
    }
    return differ ? best : std::nullopt;
}

double fastestOf(const RecordGroup& group) {
    double fastest_ms = INFINITY;
    for (const RunRecord* r : group.records) fastest_ms = std::min(fastest_ms, r->gpu_ms.median);
    return fastest_ms;
}

std::string passTable(const RunRecord& r) {
    std::string html =
        "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Passes\"><table><thead><tr>"
        "<th scope=\"col\">pass</th><th scope=\"col\">GPU median [ms]</th><th scope=\"col\">p95 [ms]</th>"
        "<th scope=\"col\">draws</th><th scope=\"col\">triangles</th></tr></thead><tbody>\n";
    for (const RunRecord::Pass& pass : r.passes)
        html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escapeHtml(pass.name),
                            shortNumber(pass.gpu_ms.median), shortNumber(pass.gpu_ms.p95), pass.draws, pass.triangles);
    return html + kTableEnd;
}

}  // namespace

std::string tableStart(const std::string& id, const std::string& caption) {
    return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table\"><table class=\"sortable\" id=\"" +
           id + "\"><caption><span>" + escapeHtml(caption) + "</span></caption>\n<thead><tr>";
}

std::string heading(const Column& column) {
    return "<th scope=\"col\" data-kind=\"" + std::string(column.number ? "number\"" : "text\" class=\"text\"") +
           (column.role.empty() ? "" : " data-role=\"" + column.role + "\"") + "><button type=\"button\" title=\"" +
           escapeHtml(column.title) + "\">" + escapeHtml(column.text) + "</button></th>";
}

std::string rowHeading(const std::string& pipeline, bool pick) {
    const std::string name = "<code>" + escapeHtml(pipeline) + "</code>";
    return "<th scope=\"row\" class=\"text\" data-v=\"" + escapeHtml(pipeline) + "\">" +
           (pick ? "<button type=\"button\" class=\"pick\" title=\"Show in the comparison\">" + name + "</button>"
                 : name) +
           "<span class=\"mark\"></span></th>";
}

std::string cell(const std::optional<double>& value, const std::string& shown, bool best) {
    const bool known = value && std::isfinite(*value);
    return "<td data-v=\"" + (known ? formatNumber(*value) : std::string()) + "\"" + (best ? " class=\"best\"" : "") +
           ">" + escapeHtml(shown) + "</td>";
}

std::vector<std::string> metricColumns(const RecordGroup& group) {
    // Classes of errors have a table of their own.
    static const std::vector<std::string> shadow{"rmse", "wrong",     "wrong_domain", "bias",   "over",
                                                 "flip", "leak_mass", "noise",        "edge_px"};
    static const std::vector<std::string> other{"rmse", "bias", "psnr", "gain_db", "ssim", "noise", "flip"};
    if (!group.first().motion.empty()) return {"flicker_mean", "flicker_p99", "flicker_patch", "lag"};
    std::vector<std::string> columns;
    for (const std::string& key : group.first().family == "shadow" ? shadow : other)
        if (std::any_of(group.records.begin(), group.records.end(), [&](const RunRecord* r) {
                return key == "rmse" ? metricOf(*r, key).has_value() : metricOf(*r, key).value_or(0) != 0;
            }))
            columns.push_back(key);
    return columns;
}

std::string recordTable(const RecordGroup& group, std::size_t number) {
    const RunRecord& first = group.first();
    const std::vector<std::string> columns = metricColumns(group);
    std::string html =
        tableStart(fmt::format("table-{}", number),
                   "Headings sort, a technique's name shows it in the comparison. The best value of a column is "
                   "underlined; metrics that are 0 for all stand in the details only. GPU times by the clock: " +
                       first.clock + (first.device.software ? ", software" : "") + ".") +
        heading({"technique", "id and parameters that differ from their defaults", false});
    // Cost stands beside the first measure of error: the two decide, and both are seen without scrolling.
    const std::string costs = heading({"GPU [ms]", "median GPU time of the frame", true, "cost"}) +
                              heading({"p95 [ms]", "95th percentile of the GPU time", true, "cost"}) +
                              heading({"x fastest", "GPU median over the least of this table", true}) +
                              "<th scope=\"col\" class=\"text\" title=\"GPU time of each frame in order; the line is "
                              "the median\">frames</th>" +
                              heading({"bytes", "render targets and buffers of the technique", true, "cost"});
    if (columns.empty()) html += costs;
    for (const std::string& key : columns) {
        const MetricInfo* info = infoOf(key);
        html += heading({key, info ? info->help : key, true, lowerIsBetter(key) && key != "bias" ? "error" : ""});
        if (key == columns.front()) html += costs;
    }
    html += heading({"CPU [ms]", "CPU time of the frame", true, "cost"}) +
            heading({"warnings", "what the program has to say of this run", false}) + "</tr></thead>\n<tbody>\n";
    const double fastest_ms = fastestOf(group);
    for (std::size_t i = 0; i < group.records.size(); ++i) {
        const RunRecord* r = group.records[i];
        html +=
            fmt::format("<tr id=\"run-{}\" data-record=\"{}\" tabindex=\"-1\">", group.indices[i], group.indices[i]) +
            rowHeading(r->pipeline, true);
        const std::optional<double> relative =
            fastest_ms > 0 ? std::optional(r->gpu_ms.median / fastest_ms) : std::nullopt;
        const std::string cost = cell(r->gpu_ms.median, shortNumber(r->gpu_ms.median)) +
                                 cell(r->gpu_ms.p95, shortNumber(r->gpu_ms.p95)) +
                                 cell(relative, relative ? fmt::format("{:.2f}", *relative) : "–") +
                                 "<td class=\"spark\"></td>" + cell(double(r->gpuBytes), byteText(double(r->gpuBytes)));
        if (columns.empty()) html += cost;
        for (const std::string& key : columns) {
            const auto value = metricOf(*r, key), best = bestOf(group, key);
            html += cell(value, shortNumber(value), value && best && *value == *best);
            if (key == columns.front()) html += cost;
        }
        html += cell(r->cpu_ms, shortNumber(r->cpu_ms));
        html += "<td class=\"text\">" + escapeHtml(join(r->warnings, "; ")) + "</td></tr>\n";
    }
    return html + kTableEnd;
}

std::string recordDetails(const RecordGroup& group, const std::vector<RunNote>& notes) {
    std::string html = "<details class=\"runs\"><summary>All metrics, passes, parameters and commands</summary>\n";
    for (const RunRecord* r : group.records) {
        html += "<h3><code>" + escapeHtml(r->pipeline) + "</code></h3>\n<p class=\"command\"><code>" +
                escapeHtml(commandFor(*r, notes)) +
                "</code> <button type=\"button\" class=\"copy\">Copy</button></p>\n"
                "<details class=\"command\"><summary>As C++</summary><pre><code>" +
                escapeHtml(settingsFor(*r)) +
                "</code></pre><button type=\"button\" class=\"copy\">Copy</button></details>\n";
        std::vector<std::string> metrics, params, counters;
        for (const auto& [key, value] : r->metrics) metrics.push_back(key + " " + shortNumber(value));
        for (const auto& [key, value] : r->params) params.push_back(key + "=" + toString(value));
        for (const auto& [key, value] : r->counters) counters.push_back(key + " " + shortNumber(value));
        if (!metrics.empty()) html += "<p>" + escapeHtml(join(metrics, ", ")) + "</p>\n";
        if (!params.empty()) html += "<p class=\"params\">" + escapeHtml(join(params, ", ")) + "</p>\n";
        if (!counters.empty()) html += "<p class=\"params\">" + escapeHtml(join(counters, ", ")) + "</p>\n";
        if (!r->passes.empty()) html += passTable(*r);
    }
    return html + "</details>\n";
}

}  // namespace ombrage
