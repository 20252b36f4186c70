// SPDX-License-Identifier: MIT
#include "report/overview.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/strings.h"
#include "report/html_text.h"
#include "report/tables.h"

namespace ombrage {

namespace {

struct Row {
    std::map<std::size_t, double> errors;  ///< by the place's number
    double gpu_ms = 0, bytes = 0;          ///< sums over the places
};

std::string table(const std::vector<const RecordGroup*>& places, std::size_t number) {
    std::map<std::string, Row> rows;
    std::vector<std::string> order;
    for (std::size_t p = 0; p < places.size(); ++p)
        for (const RunRecord* r : places[p]->records) {
            const auto rmse = metricOf(*r, "rmse");
            if (!rmse) continue;
            if (rows.count(r->pipeline) == 0) order.push_back(r->pipeline);
            Row& row = rows[r->pipeline];
            row.errors[p] = *rmse;
            row.gpu_ms += r->gpu_ms.median;
            row.bytes += double(r->gpuBytes);
        }
    std::string html = tableStart(
        fmt::format("overview-{}", number),
        "Means over the places that a technique was measured in, and rmse in each of them. Means over fewer places are "
        "not comparable. Headings sort.");
    html += heading({"technique", "id and parameters that differ from their defaults", false}) +
            heading({"mean rmse", "mean over the places", true, "error"}) +
            heading({"mean GPU [ms]", "mean of the median GPU times", true, "cost"}) +
            heading({"mean bytes", "mean of the bytes held", true, "cost"}) +
            heading({"places", "scenes and lights that it was measured on", true});
    for (const RecordGroup* place : places)
        html += heading({place->place(), place->title(), true, places.size() > 1 ? "error" : ""});
    html += "</tr></thead>\n<tbody>\n";
    for (const std::string& pipeline : order) {
        const Row& row = rows.at(pipeline);
        const double n = double(row.errors.size());
        double sum = 0;
        for (const auto& [place, error] : row.errors) sum += error;
        html += "<tr>" + rowHeading(pipeline, false) + cell(sum / n, shortNumber(sum / n)) +
                cell(row.gpu_ms / n, shortNumber(row.gpu_ms / n)) + cell(row.bytes / n, byteText(row.bytes / n)) +
                cell(n, shortNumber(n));
        for (std::size_t p = 0; p < places.size(); ++p) {
            const auto error = row.errors.find(p);
            html +=
                error == row.errors.end() ? cell(std::nullopt, "–") : cell(error->second, shortNumber(error->second));
        }
        html += "</tr>\n";
    }
    return html + kTableEnd;
}

}  // namespace

std::string overview(const std::vector<RecordGroup>& groups) {
    std::vector<std::pair<std::string, std::vector<const RecordGroup*>>> families;
    for (const RecordGroup& group : groups) {
        const RunRecord& r = group.first();
        if (!r.truth || hasOwnTruth(r) || !r.motion.empty()) continue;
        const std::string name = r.family + ", truth " + r.truth->kind;
        auto family = std::find_if(families.begin(), families.end(), [&](const auto& f) { return f.first == name; });
        if (family == families.end()) family = families.insert(families.end(), {name, {}});
        family->second.push_back(&group);
    }
    std::string html;
    std::size_t number = 0;
    for (const auto& [name, places] : families)
        if (places.size() > 1) {
            html += fmt::format("<section class=\"overview\" id=\"overview{}\">\n", number) +
                    "<h2>Over all scenes: " + escapeHtml(name) + "</h2>\n<div class=\"plot\"></div>\n" +
                    table(places, number) + "</section>\n";
            ++number;
        }
    return html;
}

}  // namespace ombrage
