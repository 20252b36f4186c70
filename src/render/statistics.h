// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <ombrage/renderer.h>

namespace ombrage {

/// Median and 95th percentile (nearest rank). Zero for no samples.
Stats statsOf(std::vector<double> samples);

/// CPU time of the calling thread so far, in ms.
double threadTime_ms();

}  // namespace ombrage
