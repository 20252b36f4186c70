// SPDX-License-Identifier: MIT
#include "metrics/image_metrics.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

namespace ombrage {

double psnrFromRmse(double rmse) {
    if (rmse <= 0) return kPsnrLimit_dB;
    return std::min(kPsnrLimit_dB, -20 * std::log10(rmse));
}

double percentile(std::vector<float> values, double share) {
    if (values.empty()) return 0;
    // Nearest rank.
    const auto rank = std::size_t(std::max(1.0, std::ceil(share * double(values.size()))));
    const auto nth = values.begin() + std::ptrdiff_t(std::min(rank, values.size()) - 1);
    std::nth_element(values.begin(), nth, values.end());
    return double(*nth);
}

float measuredValue(float value, float truth) {
    return std::isfinite(value) ? value : (truth > 0.5f ? 0.0f : 1.0f);
}

void measureImage(std::span<const float> visibility, std::span<const float> truth, int width, int height,
                  const std::vector<Mask>& mask, Metrics& metrics) {
    const std::size_t count = std::size_t(width) * std::size_t(height);
    if (visibility.size() != count || truth.size() != count || mask.size() != count)
        throw Error(ErrorCode::Usage, "the picture and its truth differ in size",
                    "The truth is " + std::to_string(width) + "x" + std::to_string(height) + ".");
    for (const char* key : {"mae", "rmse", "bias", "p95", "psnr", "gain_db", "ssim"}) metrics[key] = std::nullopt;

    // Sums over the valid pixels; the truth's variance is the error of the best constant picture.
    std::vector<float> cleaned(visibility.begin(), visibility.end());
    std::vector<float> errors;
    double sum = 0, absolute = 0, squares = 0, truthSum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        cleaned[i] = measuredValue(cleaned[i], truth[i]);
        if (mask[i] != Mask::Valid) continue;
        const double e = double(cleaned[i]) - double(truth[i]);
        errors.push_back(float(std::abs(e)));
        sum += e;
        absolute += std::abs(e);
        squares += e * e;
        truthSum += double(truth[i]);
    }
    if (errors.empty()) return;
    const double n = double(errors.size()), mean = truthSum / n;
    double spread = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (mask[i] == Mask::Valid) spread += (double(truth[i]) - mean) * (double(truth[i]) - mean);

    const double rmse = std::sqrt(squares / n);
    metrics["mae"] = absolute / n;
    metrics["rmse"] = rmse;
    metrics["bias"] = sum / n;
    metrics["p95"] = percentile(std::move(errors), 0.95);
    metrics["psnr"] = psnrFromRmse(rmse);
    metrics["gain_db"] = psnrFromRmse(rmse) - psnrFromRmse(std::sqrt(spread / n));
    metrics["ssim"] = ssim(cleaned, truth, width, height, mask);
}

std::optional<double> noiseOf(const std::vector<std::vector<float>>& pictures, const std::vector<Mask>& mask) {
    const auto fits = [&](const std::vector<float>& picture) { return picture.size() == mask.size(); };
    if (pictures.size() < 2 || !std::all_of(pictures.begin(), pictures.end(), fits))
        throw Error(ErrorCode::Usage, "noise is measured among two or more pictures of one size");
    const double count = double(pictures.size());
    double variances = 0, valid = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] != Mask::Valid) continue;
        double mean = 0, squares = 0;
        for (const std::vector<float>& picture : pictures) mean += double(picture[i]) / count;
        for (const std::vector<float>& picture : pictures) {
            const double d = double(picture[i]) - mean;
            squares += d * d;
        }
        variances += squares / (count - 1);
        ++valid;
    }
    return valid > 0 ? std::optional<double>(std::sqrt(variances / valid)) : std::nullopt;
}

Metrics measureAo(std::span<const float> visibility, const AoTruth& truth) {
    Metrics metrics;
    measureImage(visibility, truth.visibility, truth.width, truth.height, truth.mask, metrics);
    metrics["residual"] = residual(visibility, truth);
    return metrics;
}

}  // namespace ombrage
