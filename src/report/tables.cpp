// SPDX-License-Identifier: MIT
#include "report/tables.h"

#include <fmt/format.h>
#include <ombrage/metrics.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/strings.h"
#include "report/html_text.h"

namespace ombrage {

namespace {

std::optional<double> metric(const RunRecord& r, const std::string& key) {
    const auto found = r.metrics.find(key);
    return found == r.metrics.end() ? std::nullopt : found->second;
}

const MetricInfo* infoOf(const std::string& key) {
    for (const MetricInfo& info : metricInfos())
        if (info.key == key) return &info;
    return nullptr;
}

std::string heading(const std::string& text, const std::string& title, bool number) {
    return "<th scope=\"col\" data-kind=\"" + std::string(number ? "number" : "text") + "\"" +
           (number ? "" : " class=\"text\"") + "><button type=\"button\" title=\"" + escapeHtml(title) + "\">" +
           escapeHtml(text) + "</button></th>";
}

std::string cell(const std::optional<double>& value, const std::string& shown, bool best) {
    const bool known = value && std::isfinite(*value);
    return "<td data-v=\"" + (known ? formatNumber(*value) : std::string()) + "\"" + (best ? " class=\"best\"" : "") +
           ">" + escapeHtml(shown) + "</td>";
}

/// The best value of a column, where there is more than one to choose from. Bias is best nearest to 0.
std::optional<double> bestOf(const std::vector<const RunRecord*>& group, const std::string& key, bool lowerIsBetter) {
    std::optional<double> best;
    int count = 0;
    for (const RunRecord* r : group) {
        const auto value = metric(*r, key);
        if (!value) continue;
        ++count;
        const auto rank = [&](double v) { return key == "bias" ? std::fabs(v) : lowerIsBetter ? v : -v; };
        if (!best || rank(*value) < rank(*best)) best = value;
    }
    return count > 1 ? best : std::nullopt;
}

}  // namespace

const std::vector<std::string>& metricColumns(const RunRecord& record) {
    static const std::vector<std::string> shadow{"wrong",       "wrong_domain", "rmse",     "bias", "over",  "alias",
                                                 "contact_gap", "acne",         "penumbra", "leak", "noise", "flip"};
    static const std::vector<std::string> ao{"rmse", "bias", "psnr", "gain_db", "ssim"};
    static const std::vector<std::string> motion{"flicker_mean", "flicker_p99", "flicker_patch", "lag"};
    static const std::vector<std::string> nothing;
    if (!record.motion.empty()) return motion;
    return record.family == "shadow" ? shadow : record.family == "ao" ? ao : nothing;
}

std::string recordTable(const std::vector<const RunRecord*>& group) {
    const RunRecord& first = *group.front();
    const std::vector<std::string>& columns = metricColumns(first);
    const std::string clock = first.clock + (first.device.software ? ", software" : "");
    std::string html =
        "<div class=\"wide\"><table class=\"sortable\"><caption>Headings sort. The best value of a column is "
        "underlined. "
        "GPU times by the clock: " +
        escapeHtml(clock) + ".</caption>\n<thead><tr>" +
        heading("technique", "id and parameters that differ from their defaults", false);
    for (const std::string& key : columns) {
        const MetricInfo* info = infoOf(key);
        html += heading(key, info ? info->help : key, true);
    }
    html += heading("GPU median [ms]", "median GPU time of the frame", true) +
            heading("GPU p95 [ms]", "95th percentile", true) + heading("CPU [ms]", "CPU time of the frame", true) +
            heading("bytes", "render targets and buffers of the technique", true) +
            heading("warnings", "what the program has to say of this run", false) + "</tr></thead>\n<tbody>\n";
    for (const RunRecord* r : group) {
        html += "<tr><td data-v=\"" + escapeHtml(r->pipeline) + "\"><code>" + escapeHtml(r->pipeline) + "</code></td>";
        for (const std::string& key : columns) {
            const MetricInfo* info = infoOf(key);
            const auto value = metric(*r, key), best = bestOf(group, key, !info || info->lowerIsBetter);
            html += cell(value, shortNumber(value), value && best && *value == *best);
        }
        html += cell(r->gpu_ms.median, shortNumber(r->gpu_ms.median), false) +
                cell(r->gpu_ms.p95, shortNumber(r->gpu_ms.p95), false) +
                cell(r->cpu_ms, shortNumber(r->cpu_ms), false) +
                cell(double(r->gpuBytes), byteText(double(r->gpuBytes)), false);
        html += "<td class=\"text\">" + escapeHtml(join(r->warnings, "; ")) + "</td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string recordDetails(const std::vector<const RunRecord*>& group) {
    std::string html = "<details><summary>All metrics, passes and parameters</summary>\n";
    for (const RunRecord* r : group) {
        html += "<h3><code>" + escapeHtml(r->pipeline) + "</code></h3>\n";
        std::vector<std::string> metrics, params, counters;
        for (const auto& [key, value] : r->metrics) metrics.push_back(key + " " + shortNumber(value));
        for (const auto& [key, value] : r->params) params.push_back(key + "=" + toString(value));
        for (const auto& [key, value] : r->counters) counters.push_back(key + " " + shortNumber(value));
        if (!metrics.empty()) html += "<p>" + escapeHtml(join(metrics, ", ")) + "</p>\n";
        if (!params.empty()) html += "<p class=\"params\">" + escapeHtml(join(params, ", ")) + "</p>\n";
        if (!counters.empty()) html += "<p class=\"params\">" + escapeHtml(join(counters, ", ")) + "</p>\n";
        if (r->passes.empty()) continue;
        html +=
            "<table><thead><tr><th scope=\"col\">pass</th><th scope=\"col\">GPU median [ms]</th><th scope=\"col\">p95 "
            "[ms]</th>"
            "<th scope=\"col\">draws</th><th scope=\"col\">triangles</th></tr></thead><tbody>\n";
        for (const RunRecord::Pass& pass : r->passes)
            html +=
                fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escapeHtml(pass.name),
                            shortNumber(pass.gpu_ms.median), shortNumber(pass.gpu_ms.p95), pass.draws, pass.triangles);
        html += "</tbody></table>\n";
    }
    return html + "</details>\n";
}

}  // namespace ombrage
