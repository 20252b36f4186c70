// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <ombrage/metrics.h>

namespace ombrage {

/// psnr stops here, so that equal images have a number that can be averaged.
inline constexpr double kPsnrLimit_dB = 99;

/// Peak 1. Infinite only never: stops at kPsnrLimit_dB.
double psnrFromRmse(double rmse);

/// The smallest value that at least `share` of the values do not exceed; 0 of none.
double percentile(std::vector<float> values, double share);

/// `value` as it is measured: an answer that is not a number is as wrong as can be.
float measuredValue(float value, float truth);

/// mae, rmse, bias, p95, psnr, gain_db over the valid pixels and ssim; all null where none is valid.
void measureImage(std::span<const float> visibility, std::span<const float> truth, int width, int height,
                  const std::vector<Mask>& mask, Metrics& metrics);

/// Structural similarity around each pixel, NaN where there is no window; see ssim().
std::vector<float> ssimMap(std::span<const float> a, std::span<const float> b, int width, int height,
                           const std::vector<Mask>& mask);

}  // namespace ombrage
