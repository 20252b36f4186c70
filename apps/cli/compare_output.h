// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ombrage/compare.h>

namespace ombrage::cli {

/// Frames of a comparison: enough for a median; the first one compiles the shaders and is not counted.
inline constexpr int kCompareFrames = 3;
inline constexpr int kCompareWarmupFrames = 1;

/// One line per record: scene, light, technique, the errors that matter and the cost.
std::string recordLines(const CompareResult& result);

}  // namespace ombrage::cli
