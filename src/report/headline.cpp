// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>

#include <ombrage/truth_kind.h>
#include "core/strings.h"
#include "report/html_text.h"
#include "report/page.h"

namespace ombrage {

namespace {

struct Mean {
    double rmse = 0, gpu_ms = 0;
    int count = 0;
};

/// The pipeline with the smallest mean error among those that were measured most often, or "".
std::string bestOf(const std::vector<RunRecord>& records, const std::string& family, const char* what) {
    std::map<std::string, Mean> means;
    int most = 0;
    for (const RunRecord& r : records) {
        const auto rmse = r.metrics.find("rmse");
        // What a technique claims is a truth for itself alone.
        if (r.truth && r.truth->kind == truthKindName(TruthKind::Own)) continue;
        if (r.family != family || rmse == r.metrics.end() || !rmse->second) continue;
        Mean& mean = means[r.pipeline];
        mean.rmse += *rmse->second;
        mean.gpu_ms += r.gpu_ms.median;
        most = std::max(most, ++mean.count);
    }
    std::string best;
    for (const auto& [pipeline, mean] : means)
        if (mean.count == most && (best.empty() || mean.rmse < means.at(best).rmse)) best = pipeline;
    if (best.empty()) return {};
    const Mean& mean = means.at(best);
    const std::string cost =
        fmt::format("(rmse {} on average over {} picture{}, {} ms)", shortNumber(mean.rmse / mean.count), mean.count,
                    mean.count == 1 ? "" : "s", shortNumber(mean.gpu_ms / mean.count));
    if (means.size() == 1) return fmt::format("{} alone was measured for {} {}", best, what, cost);
    return fmt::format("of {} pipelines for {}, {} came nearest to the truth {}", means.size(), what, best, cost);
}

}  // namespace

std::string headline(const std::vector<RunRecord>& records) {
    std::set<std::string> scenes, sizes, devices;
    for (const RunRecord& r : records) {
        scenes.insert(r.scene);
        sizes.insert(fmt::format("{}x{}", r.width, r.height));
        devices.insert(r.device.renderer + (r.device.software ? " (software)" : ""));
    }
    const auto list = [](const std::set<std::string>& items) { return join({items.begin(), items.end()}, ", "); };
    std::string text = fmt::format("{} run{} on {} at {} on {}", records.size(), records.size() == 1 ? "" : "s",
                                   list(scenes), list(sizes), list(devices));
    const std::string shadow = bestOf(records, "shadow", "shadows"), ao = bestOf(records, "ao", "ambient occlusion");
    if (!shadow.empty()) text += ": " + shadow;
    if (!ao.empty()) text += (shadow.empty() ? ": " : "; ") + ao;
    return text + ".";
}

}  // namespace ombrage
