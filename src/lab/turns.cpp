// SPDX-License-Identifier: MIT
#include "lab/turns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "core/process_time.h"
#include "lab/statistics.h"

namespace ombrage {

namespace {

void append(FrameCosts& to, const FrameCosts& from) {
    for (const auto member : {&FrameCosts::gpu_ms, &FrameCosts::process_ms, &FrameCosts::cpu_ms})
        (to.*member).insert((to.*member).end(), (from.*member).begin(), (from.*member).end());
}

bool isClear(const std::vector<FrameCosts>& costs, const TurnPlan& plan) {
    for (std::size_t i = 1; i < costs.size(); ++i) {
        const Difference d = pairedDifference(costsOfRounds(costs[0].*plan.deciding, plan.framesPerRound),
                                              costsOfRounds(costs[i].*plan.deciding, plan.framesPerRound), plan.seed);
        if ((d.high - d.low) / 2 > std::max(kLeastDifference, std::abs(d.change) / 4)) return false;
    }
    return true;
}

}  // namespace

std::vector<FrameCosts> takeTurns(const std::vector<Subject>& subjects, int rounds, int framesPerRound,
                                  std::uint64_t seed, const std::function<void(int round)>& afterRound) {
    std::vector<FrameCosts> all(subjects.size());
    std::vector<std::size_t> order(subjects.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 random(seed);
    for (int round = 0; round < rounds; ++round) {
        // Forwards, in an order that was drawn for these two rounds, and then the same backwards.
        if (round % 2 == 0) {
            for (std::size_t i = order.size(); i > 1; --i)
                std::swap(order[i - 1], order[std::size_t((random() >> 32) * i >> 32)]);
        } else {
            std::reverse(order.begin(), order.end());
        }
        for (const std::size_t turn : order) append(all[turn], subjects[turn](framesPerRound));
        afterRound(round);
    }
    return all;
}

std::vector<FrameCosts> takeTurnsUntilClear(const std::vector<Subject>& subjects, const TurnPlan& plan,
                                            const std::function<void(int round)>& afterRound) {
    std::vector<FrameCosts> all(subjects.size());
    for (int time = 0; time < kMostTimes && (time == 0 || !isClear(all, plan)); ++time) {
        const auto costs = takeTurns(subjects, plan.rounds, plan.framesPerRound, plan.seed + std::uint64_t(time),
                                     [&](int round) { afterRound(time * plan.rounds + round); });
        for (std::size_t i = 0; i < all.size(); ++i) append(all[i], costs[i]);
    }
    return all;
}

std::vector<double> costsOfRounds(const std::vector<double>& samples, int framesPerRound) {
    std::vector<double> costs;
    const auto block = std::ptrdiff_t(framesPerRound);
    for (auto at = samples.begin(); samples.end() - at >= block; at += block)
        costs.push_back(medianOf({at, at + block}));
    return costs;
}

FrameCosts drawFrames(Renderer& renderer, RenderSettings settings, int frames, RenderResult* result) {
    settings.timing = Timing::Frame;
    settings.warmupFrames = 1;
    settings.frames = frames + 1;
    // Called before each frame: the time of one is known when the next begins, and the last is only read back.
    std::vector<double> stamps;
    settings.progress = [&, progress = settings.progress](double share) {
        stamps.push_back(processTime_ms());
        return !progress || progress(share);
    };
    RenderResult drawn = renderer.render(settings);
    FrameCosts costs{drawn.frames_ms, {}, drawn.cpuFrames_ms};
    costs.gpu_ms.resize(std::size_t(frames));
    costs.cpu_ms.resize(std::size_t(frames));
    for (std::size_t i = 2; i < stamps.size(); ++i) costs.process_ms.push_back(stamps[i] - stamps[i - 1]);
    if (result) *result = std::move(drawn);
    return costs;
}

}  // namespace ombrage
