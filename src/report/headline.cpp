// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
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

/// Of what was measured most often. @param total  of all pipelines
std::map<std::string, Mean> meansOf(const std::vector<RunRecord>& records, const std::string& family,
                                    std::size_t& total) {
    std::map<std::string, Mean> means;
    int most = 0;
    for (const RunRecord& r : records) {
        const auto rmse = r.metrics.find("rmse");
        // What a technique claims is a truth for itself alone.
        if (r.truth && r.truth->kind == truthKindName(TruthKind::Own)) continue;
        // What leaves everything lit is not an answer.
        if (r.technique == family + "/none" || r.family != family || rmse == r.metrics.end() || !rmse->second) continue;
        Mean& mean = means[r.pipeline];
        mean.rmse += *rmse->second;
        mean.gpu_ms += r.gpu_ms.median;
        most = std::max(most, ++mean.count);
    }
    total = means.size();
    // One measured on fewer scenes is not compared with those measured on all.
    for (auto mean = means.begin(); mean != means.end();)
        mean = mean->second.count == most ? std::next(mean) : means.erase(mean);
    return means;
}

/// "rmse 0.02, 3.1 ms"
std::string figures(const Mean& mean) {
    return "rmse " + shortNumber(mean.rmse / mean.count) + ", " + shortNumber(mean.gpu_ms / mean.count) + " ms";
}

using Named = std::pair<const std::string, Mean>;

/// Of those that cost less than `limit_ms` (a sum as in Mean), the one nearest to the truth; the cheaper of equals.
const Named* nearestBelow(const std::map<std::string, Mean>& means, double limit_ms) {
    const Named* best = nullptr;
    for (const Named& named : means) {
        const Mean& mean = named.second;
        if (!(mean.gpu_ms < limit_ms)) continue;
        if (!best || mean.rmse < best->second.rmse ||
            (mean.rmse == best->second.rmse && mean.gpu_ms < best->second.gpu_ms))
            best = &named;
    }
    return best;
}

/// Which pipeline came nearest to the truth, and two steps down the front of error and cost; "" for none measured.
std::string answer(const std::vector<RunRecord>& records, const std::string& family, const char* what) {
    std::size_t total = 0;
    const std::map<std::string, Mean> means = meansOf(records, family, total);
    const Named* best = nearestBelow(means, INFINITY);
    if (!best) return {};
    const int count = best->second.count;
    const std::string over =
        fmt::format("{}, mean of {} picture{}", figures(best->second), count, count == 1 ? "" : "s");
    if (total == 1) return fmt::format("{} alone was measured for {} ({})", best->first, what, over);
    std::string text =
        fmt::format("of {} pipelines for {}, {} came nearest to the truth ({})", total, what, best->first, over);
    const Named* cheaper = nearestBelow(means, best->second.gpu_ms);
    if (!cheaper) return means.size() == 1 ? text : text + ", and none is cheaper";
    text += fmt::format(", among the cheaper ones {} ({})", cheaper->first, figures(cheaper->second));
    if (const Named* next = nearestBelow(means, cheaper->second.gpu_ms))
        text += fmt::format(", then {} ({})", next->first, figures(next->second));
    return text;
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
    const std::string shadow = answer(records, "shadow", "shadows"), ao = answer(records, "ao", "ambient occlusion");
    if (!shadow.empty()) text += ": " + shadow;
    if (!ao.empty()) text += (shadow.empty() ? ": " : "; ") + ao;
    return text + ".";
}

}  // namespace ombrage
