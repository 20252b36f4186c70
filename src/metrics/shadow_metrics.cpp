// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "metrics/distance_transform.h"
#include "metrics/error_classes.h"
#include "metrics/image_metrics.h"
#include "metrics/shadow_edges.h"

namespace ombrage {
namespace {

/// Cosine below which the question itself is ill-posed: rounding of the normal decides the answer.
constexpr float kGrazing = 0.02f;

/// Share with a common denominator; null where that is 0.
struct Share {
    double part = 0, whole = 0;
    void add(bool counts, double weight = 1) {
        whole += weight;
        if (counts) part += weight;
    }
    std::optional<double> value() const { return whole > 0 ? std::optional<double>(part / whole) : std::nullopt; }
};

/// Root of a weighted mean of squares.
struct RootMeanSquare {
    double squares = 0, weight = 0;
    void add(double value, double w = 1) {
        squares += w * value * value;
        weight += w;
    }
    std::optional<double> value() const {
        return weight > 0 ? std::optional<double>(std::sqrt(squares / weight)) : std::nullopt;
    }
};

void check(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
           const ShadowQuestion& question) {
    const std::size_t n = std::size_t(truth.width) * std::size_t(truth.height);
    const auto fits = [&](const std::vector<bool>& mask) { return mask.empty() || mask.size() == n; };
    if (visibility.size() != n || truth.visibility.size() != n || truth.mask.size() != n ||
        (truth.soft && truth.centreSeen.size() != n) || receivers.pixelSize_m.size() != n || !fits(question.inDomain) ||
        !fits(question.inRange) || (question.features && question.features->shadingCosine.size() != n))
        throw Error(ErrorCode::Usage, "the picture, its truth and the receivers differ in size",
                    "The truth is " + std::to_string(truth.width) + "x" + std::to_string(truth.height) + ".");
}

/// Mean of the light that leaks into the true umbra, 4 pixels and more inside it.
std::optional<double> leakMass(std::span<const float> visibility, const ShadowTruth& truth) {
    constexpr float kInterior_px = 4;
    const std::size_t n = visibility.size();
    std::vector<bool> lit(n);
    for (std::size_t i = 0; i < n; ++i) lit[i] = truth.mask[i] == Mask::Valid && truth.visibility[i] > 0;
    const std::vector<float> toLit = distanceTransform(lit, truth.width, truth.height);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (truth.mask[i] == Mask::Valid && truth.visibility[i] == 0 && toLit[i] > kInterior_px) {
            sum += std::max(0.0, double(measuredValue(visibility[i], 0)));
            ++count;
        }
    return count > 0 ? std::optional<double>(sum / count) : std::nullopt;
}

/// Area between the true hard edges and the picture's, over the length of the true ones.
std::optional<double> edgeDisplacement_px(std::span<const float> visibility, const ShadowTruth& truth,
                                          const Receivers& receivers, const ErrorZones& zones,
                                          const ShadowMeasurement& measured, const ShadowQuestion& question) {
    const double length_px = hardEdgeLength_px(truth, receivers);
    if (!(length_px > 0)) return std::nullopt;
    double area = 0;
    for (std::size_t i = 0; i < visibility.size(); ++i) {
        const bool fits = measured.classes[i] == ErrorClass::None || measured.classes[i] == ErrorClass::Alias;
        if (truth.mask[i] != Mask::Valid || !fits) continue;
        if (double(zones.toHardEdge_px[i]) > aliasReach_px(question.footprint, truth, receivers, i)) continue;
        const float v = measuredValue(visibility[i], truth.visibility[i]);
        area += (v > 0.5f) != (truth.visibility[i] > 0.5f) ? 1 : 0;
    }
    return area / length_px;
}

/// Share of the pixels that receive this light's shadow and are lit by n_s, although n_g turns away.
std::optional<double> terminatorShare(const ShadowTruth& truth, const ShadowFeatures& features) {
    Share share;
    for (std::size_t i = 0; i < truth.mask.size(); ++i)
        if (truth.mask[i] == Mask::Valid || truth.mask[i] == Mask::BelowHorizon)
            share.add(features.shadingCosine[i] > 0 && truth.cosine[i] <= 0);
    return share.value();
}

/// Share of the valid pixels that leak under two or more blockers.
std::optional<double> layeredLeaks(const ShadowMeasurement& measured, const ShadowFeatures& features) {
    if (measured.validCount == 0) return std::nullopt;
    std::vector<std::uint32_t> leaks;
    for (std::size_t i = 0; i < measured.classes.size(); ++i)
        if (measured.classes[i] == ErrorClass::Leak) leaks.push_back(std::uint32_t(i));
    const std::vector<int> layers = leaks.empty() ? std::vector<int>() : features.layers(leaks);
    const auto several = std::count_if(layers.begin(), layers.end(), [](int n) { return n >= 2; });
    return double(several) / double(measured.validCount);
}

}  // namespace

ShadowMeasurement measureShadow(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
                                const ShadowQuestion& question) {
    check(visibility, truth, receivers, question);
    const std::size_t n = visibility.size();
    ShadowMeasurement result;
    Metrics& m = result.metrics;
    measureImage(visibility, truth.visibility, truth.width, truth.height, truth.mask, m);
    const ErrorZones zones = errorZones(truth, receivers);
    result.classes = classify(visibility, truth, receivers, zones, question);

    const std::vector<float> hard = hardShadow(truth);
    Share wrong, wrongDomain, wrongLit;
    RootMeanSquare lit, penumbra, hardPenumbra;
    for (std::size_t i = 0; i < n; ++i) {
        if (truth.mask[i] != Mask::Valid) continue;
        ++result.validCount;
        ++result.classCounts[std::size_t(result.classes[i])];
        const double v = double(truth.visibility[i]);
        const double e = double(measuredValue(visibility[i], truth.visibility[i])) - v;
        lit.add(e, double(truth.irradiance[i]));
        if (zones.penumbra[i]) {
            penumbra.add(e);
            hardPenumbra.add(double(hard[i]) - v);
        }
        // Plainly wrong pixels, without the grazing band.
        if (truth.cosine[i] < kGrazing) continue;
        const bool isWrong = std::abs(e) > 0.5;
        wrong.add(isWrong);
        wrongLit.add(isWrong, double(truth.irradiance[i]));
        const bool inDomain = question.inDomain.empty() || question.inDomain[i];
        const bool inRange = question.inRange.empty() || question.inRange[i];
        if (inDomain && inRange) wrongDomain.add(isWrong);
    }
    m["wrong"] = wrong.value();
    m["wrong_domain"] = wrongDomain.value();
    m["wrong_lit"] = wrongLit.value();
    m["rmse_lit"] = lit.value();
    m["rmse_penumbra"] = penumbra.value();
    m["hard_ratio"] = std::nullopt;
    if (const auto own = penumbra.value(), plain = hardPenumbra.value(); own && plain && *plain > 0)
        m["hard_ratio"] = *own / *plain;

    // Shares of the classes, and of those that belong together.
    const auto share = [&](std::size_t count) {
        return result.validCount > 0 ? std::optional<double>(double(count) / double(result.validCount)) : std::nullopt;
    };
    const auto counted = [&](ErrorClass c) { return result.classCounts[std::size_t(c)]; };
    m["over"] = share(result.validCount - counted(ErrorClass::None));
    for (std::size_t c = 1; c < kErrorClassCount; ++c) m[errorClassKey(ErrorClass(c))] = share(result.classCounts[c]);
    m["penumbra"] = share(counted(ErrorClass::OverBlur) + counted(ErrorClass::UnderBlur));
    m["leak_mass"] = leakMass(visibility, truth);
    m["edge_px"] = edgeDisplacement_px(visibility, truth, receivers, zones, result, question);
    m["leak_layered"] = question.features ? layeredLeaks(result, *question.features) : std::nullopt;
    m["terminator"] = question.features ? terminatorShare(truth, *question.features) : std::nullopt;
    return result;
}

}  // namespace ombrage
