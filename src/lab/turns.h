// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <ombrage/renderer.h>

namespace ombrage {

/// Costs of frames, one of each kind for each frame.
struct FrameCosts {
    std::vector<double> gpu_ms, process_ms, cpu_ms;
};

/// Draws so many frames and says what they cost.
using Subject = std::function<FrameCosts(int frames)>;

/// Frames by turns: in each round every subject draws its share. Each second round goes backwards through the order of
/// the one before it, so that what changes slowly on the machine meets all of them alike; the orders themselves are
/// drawn anew, so that none always comes after another, whose big buffers it would find in the caches.
/// @return by subject, the rounds one after another
/// @param afterRound  may throw to stop
std::vector<FrameCosts> takeTurns(const std::vector<Subject>& subjects, int rounds, int framesPerRound,
                                  std::uint64_t seed, const std::function<void(int round)>& afterRound);

/// The rounds of a bench: at least so many, and again as many until the differences to the first subject are known well
/// enough, at most kMostTimes times.
struct TurnPlan {
    int rounds = 25, framesPerRound = 5;
    std::vector<double> FrameCosts::*deciding = &FrameCosts::gpu_ms;
    std::uint64_t seed = 1;
};
inline constexpr int kMostTimes = 8;

/// Takes turns by the plan. Well enough is an interval of at most 2 % to either side, or of a quarter of the change:
/// how wide it is ends the work and not where it lies, so that looking several times finds no more differences than
/// there are.
std::vector<FrameCosts> takeTurnsUntilClear(const std::vector<Subject>& subjects, const TurnPlan& plan,
                                            const std::function<void(int round)>& afterRound);

/// What each round cost: the median of its frames.
std::vector<double> costsOfRounds(const std::vector<double>& samples, int framesPerRound);

/// Draws frames of these settings, after one that lets what other settings left behind settle. Whole frames are timed,
/// without reading back. @param result  what the renderer said of the last frame
FrameCosts drawFrames(Renderer& renderer, RenderSettings settings, int frames, RenderResult* result = nullptr);

}  // namespace ombrage
