// SPDX-License-Identifier: MIT
#include "lab/bench_baseline.h"

#include <ombrage/error.h>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "lab/bench_json.h"
#include "lab/statistics.h"
#include "lab/turns.h"

namespace ombrage {

void requireSameDevice(const BenchResult& result, const BenchResult& baseline) {
    if (baseline.device.renderer == result.device.renderer && baseline.decidedBy == result.decidedBy) return;
    throw Error(
        ErrorCode::Input,
        "the baseline was measured on '" + baseline.device.renderer + "', this is '" + result.device.renderer + "'",
        "times of two devices say nothing of a change; measure the baseline here");
}

Error noCommonRun() {
    return {ErrorCode::Input, "the baseline has none of the runs that are asked for",
            "measure the same scenes, techniques and sizes as it did"};
}

void holdAgainst(BenchResult& result, const BenchResult& baseline, std::optional<double> failAbove,
                 std::uint64_t seed) {
    const auto nameOf = [](const BenchGroup& g, const BenchRun& run) {
        return std::tuple(g.scene, g.sceneHash, g.camera, g.light, g.width, g.height, g.axis, g.value, run.label);
    };
    std::map<decltype(nameOf({}, {})), const BenchRun*> known;
    for (const BenchGroup& group : baseline.groups)
        for (const BenchRun& run : group.runs) known[nameOf(group, run)] = &run;
    std::size_t found = 0, runs = 0;
    for (BenchGroup& group : result.groups)
        for (BenchRun& run : group.runs) {
            ++runs;
            const auto old = known.find(nameOf(group, run));
            if (old == known.end()) continue;
            ++found;
            const Difference d = unpairedDifference(
                costsOfRounds(decidingFigures(baseline, *old->second).samples, baseline.framesPerRound),
                costsOfRounds(decidingFigures(result, run).samples, result.framesPerRound), seed);
            run.toBaseline = BenchDifference{d.change, d.low, d.high, verdictName(d.verdict)};
            if (failAbove && d.verdict == Difference::Verdict::More && d.change > *failAbove)
                result.regressions.push_back(fmt::format(
                    "{} on {}{}: {:+.1f} % against the baseline, 99 % interval {:+.1f} to {:+.1f} %, allowed +{:g} %",
                    run.label, group.scene, group.axis.empty() ? "" : ", " + group.axis + " " + group.value,
                    100 * d.change, 100 * d.low, 100 * d.high, 100 * *failAbove));
        }
    if (found == 0 && runs > 0) throw noCommonRun();
}

}  // namespace ombrage
