// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <ombrage/error.h>

#include "metrics/distance_transform.h"
#include "metrics/image_metrics.h"
#include "metrics/shadow_edges.h"

namespace ombrage {
namespace {

/// An error below it is not counted, beside three standard errors of the truth.
double tolerance(const ShadowTruth& truth) {
    return truth.soft ? 0.05 : 0.1;
}

/// Cosine below which the question itself is ill-posed: rounding of the normal decides the answer.
constexpr float kGrazing = 0.02f;

/// World size of a texel at the receiver; of a pixel for techniques without texels.
double texelSize_m(const TexelFootprint& footprint, const ShadowTruth& truth, const Receivers& receivers,
                   std::size_t i) {
    if (footprint.texel_m > 0) return footprint.texel_m;
    if (footprint.texelPerMetre > 0) return footprint.texelPerMetre * double(truth.lightDistance_m[i]);
    return double(receivers.pixelSize_m[i]);
}

/// How far in pixels the picture of a hard edge may lie from the edge.
double aliasReach_px(const TexelFootprint& footprint, const ShadowTruth& truth, const Receivers& receivers,
                     std::size_t i) {
    constexpr double kLeast_px = 2;
    if (!(footprint.texel_m > 0) && !(footprint.texelPerMetre > 0)) return kLeast_px;
    if (!(receivers.pixelSize_m[i] > 0)) return kLeast_px;
    // A texel faces the light, so its footprint on the receiver is longer by 1/cosine; limited, because at grazing
    // light everything would count as near to an edge.
    const double stretched_m = texelSize_m(footprint, truth, receivers, i) / std::max(double(truth.cosine[i]), 0.1);
    return std::max(kLeast_px, stretched_m / double(receivers.pixelSize_m[i]) * (1 + footprint.kernelRadius_texels));
}

/// Share with a common denominator; null where that is 0.
struct Share {
    double part = 0, whole = 0;
    void add(bool counts, double weight = 1) {
        whole += weight;
        if (counts) part += weight;
    }
    std::optional<double> value() const { return whole > 0 ? std::optional<double>(part / whole) : std::nullopt; }
};

void check(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
           const std::vector<bool>& inDomain) {
    const std::size_t n = std::size_t(truth.width) * std::size_t(truth.height);
    if (visibility.size() != n || truth.visibility.size() != n || truth.mask.size() != n ||
        receivers.pixelSize_m.size() != n || (!inDomain.empty() && inDomain.size() != n))
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

}  // namespace

ShadowMeasurement measureShadow(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
                                const TexelFootprint& footprint, const std::vector<bool>& inDomain) {
    check(visibility, truth, receivers, inDomain);
    const std::size_t n = visibility.size();
    const double tau = tolerance(truth);
    ShadowMeasurement result;
    result.classes.assign(n, ErrorClass::None);
    measureImage(visibility, truth.visibility, truth.width, truth.height, truth.mask, result.metrics);
    const std::vector<float> toEdge = distanceTransform(hardEdges(truth, receivers), truth.width, truth.height);

    Share wrong, wrongDomain, wrongLit, over;
    std::array<Share, 6> classes;
    for (std::size_t i = 0; i < n; ++i) {
        if (truth.mask[i] != Mask::Valid) continue;
        ++result.validCount;
        const double v = double(truth.visibility[i]);
        const double e = double(measuredValue(visibility[i], truth.visibility[i])) - v;

        // Plainly wrong pixels, without the grazing band.
        if (truth.cosine[i] >= kGrazing) {
            const bool isWrong = std::abs(e) > 0.5;
            wrong.add(isWrong);
            wrongLit.add(isWrong, double(truth.irradiance[i]));
            if (inDomain.empty() || inDomain[i]) wrongDomain.add(isWrong);
        }

        // Pixels over the tolerance, each in the first class that holds (design section 7).
        const bool isOver = std::abs(e) > tau + 3 * double(truth.standardError[i]);
        over.add(isOver);
        ErrorClass c = ErrorClass::None;
        if (isOver) {
            const double contact_m = 4 * texelSize_m(footprint, truth, receivers, i);
            if (e > tau && v == 0 && double(truth.blockerDistance_m[i]) < contact_m)
                c = ErrorClass::ContactGap;
            else if (double(toEdge[i]) <= aliasReach_px(footprint, truth, receivers, i))
                c = ErrorClass::Alias;
            else if (truth.soft && v > 0 && v < 1)
                c = ErrorClass::Penumbra;
            else if (e < -tau && v == 1)
                c = ErrorClass::Acne;
            else
                c = ErrorClass::Other;
        }
        result.classes[i] = c;
        for (std::size_t k = 0; k < classes.size(); ++k) classes[k].add(std::size_t(c) == k);
    }

    Metrics& m = result.metrics;
    m["wrong"] = wrong.value();
    m["wrong_domain"] = wrongDomain.value();
    m["wrong_lit"] = wrongLit.value();
    m["over"] = over.value();
    m["contact_gap"] = classes[std::size_t(ErrorClass::ContactGap)].value();
    m["alias"] = classes[std::size_t(ErrorClass::Alias)].value();
    m["penumbra"] = classes[std::size_t(ErrorClass::Penumbra)].value();
    m["acne"] = classes[std::size_t(ErrorClass::Acne)].value();
    m["other"] = classes[std::size_t(ErrorClass::Other)].value();
    m["leak_mass"] = leakMass(visibility, truth);
    return result;
}

}  // namespace ombrage
