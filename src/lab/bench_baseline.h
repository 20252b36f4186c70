// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/bench.h>
#include <ombrage/error.h>

namespace ombrage {

/// @throws Error(Input)
void requireSameDevice(const BenchResult& result, const BenchResult& baseline);

/// Error(Input) on a baseline of other things.
Error noCommonRun();

/// Sets `toBaseline` of every run that the baseline has as well (same scene content, camera, light, size, sweep value
/// and label), and the sentences on those slower by more than `failAbove`.
/// @throws Error(Input) when the baseline has none of the runs
void holdAgainst(BenchResult& result, const BenchResult& baseline, std::optional<double> failAbove, std::uint64_t seed);

}  // namespace ombrage
