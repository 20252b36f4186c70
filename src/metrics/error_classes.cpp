// SPDX-License-Identifier: MIT
#include "metrics/error_classes.h"

#include <algorithm>
#include <cmath>

#include "metrics/distance_transform.h"
#include "metrics/image_metrics.h"
#include "metrics/shadow_edges.h"

namespace ombrage {
namespace {

bool hasTexels(const TexelFootprint& footprint) {
    return footprint.texel_m > 0 || footprint.texelPerMetre > 0;
}

/// World size of a texel at the receiver; of a pixel for techniques without texels.
double texelSize_m(const TexelFootprint& footprint, const ShadowTruth& truth, const Receivers& receivers,
                   std::size_t i) {
    if (footprint.texel_m > 0) return footprint.texel_m;
    if (footprint.texelPerMetre > 0) return footprint.texelPerMetre * double(truth.lightDistance_m[i]);
    return double(receivers.pixelSize_m[i]);
}

/// Nearer to the middle than the truth: the transition is too wide. Else it is too narrow, or in another place.
ErrorClass penumbraClass(double v, double truth) {
    return std::abs(v - 0.5) < std::abs(truth - 0.5) ? ErrorClass::OverBlur : ErrorClass::UnderBlur;
}

/// How far a pixel is from its truth where that counts as an error, else 0.
double countedError(float visibility, const ShadowTruth& truth, std::size_t i) {
    if (truth.mask[i] != Mask::Valid) return 0;
    const double e = double(measuredValue(visibility, truth.visibility[i])) - double(truth.visibility[i]);
    return std::abs(e) > errorTolerance(truth) + 3 * double(truth.standardError[i]) ? e : 0;
}

bool misses(const ShadowQuestion& question, std::size_t i) {
    return !question.inRange.empty() && !question.inRange[i];
}

/// Per pixel, whether it is too light under a blocker so near that a bias must lose it. Needs the question's features.
std::vector<bool> contactGaps(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
                              const ShadowQuestion& question) {
    std::vector<bool> gap(visibility.size(), false);
    if (question.features == nullptr) return gap;
    std::vector<std::uint32_t> asked;
    for (std::size_t i = 0; i < gap.size(); ++i)
        if (truth.visibility[i] == 0 && countedError(visibility[i], truth, i) > 0 && !misses(question, i))
            asked.push_back(std::uint32_t(i));
    if (asked.empty()) return gap;
    const std::vector<Blocker> blockers = question.features->blockers(asked);
    for (std::size_t k = 0; k < asked.size(); ++k)
        gap[asked[k]] =
            double(blockers[k].distance_m) < 4 * texelSize_m(question.footprint, truth, receivers, asked[k]);
    return gap;
}

}  // namespace

ErrorZones errorZones(const ShadowTruth& truth, const Receivers& receivers) {
    ErrorZones zones;
    zones.toHardEdge_px = distanceTransform(hardEdges(truth, receivers), truth.width, truth.height);
    const std::size_t n = truth.visibility.size();
    zones.penumbra.assign(n, false);
    if (!truth.soft) return zones;
    std::vector<bool> partly(n);
    for (std::size_t i = 0; i < n; ++i)
        partly[i] = truth.mask[i] == Mask::Valid && truth.visibility[i] > 0 && truth.visibility[i] < 1;
    const std::vector<float> toPenumbra_px = distanceTransform(partly, truth.width, truth.height);
    for (std::size_t i = 0; i < n; ++i)
        zones.penumbra[i] = truth.mask[i] == Mask::Valid && toPenumbra_px[i] <= kPenumbraMargin_px;
    return zones;
}

std::vector<float> hardShadow(const ShadowTruth& truth) {
    return truth.soft ? std::vector<float>(truth.centreSeen.begin(), truth.centreSeen.end()) : truth.visibility;
}

double errorTolerance(const ShadowTruth& truth) {
    return truth.soft ? 0.05 : 0.1;
}

double aliasReach_px(const TexelFootprint& footprint, const ShadowTruth& truth, const Receivers& receivers,
                     std::size_t i) {
    constexpr double kLeast_px = 2;
    if (!hasTexels(footprint) || !(receivers.pixelSize_m[i] > 0)) return kLeast_px;
    // A texel faces the light, so its footprint on the receiver is longer by 1/cosine; limited, because at grazing
    // light everything would count as near to an edge.
    const double stretched_m = texelSize_m(footprint, truth, receivers, i) / std::max(double(truth.cosine[i]), 0.1);
    return std::max(kLeast_px, stretched_m / double(receivers.pixelSize_m[i]) * (1 + footprint.kernelRadius_texels));
}

std::vector<ErrorClass> classify(std::span<const float> visibility, const ShadowTruth& truth,
                                 const Receivers& receivers, const ErrorZones& zones, const ShadowQuestion& question) {
    const TexelFootprint& footprint = question.footprint;
    const bool texels = hasTexels(footprint);
    const std::vector<bool> isContactGap = contactGaps(visibility, truth, receivers, question);
    std::vector<ErrorClass> classes(visibility.size(), ErrorClass::None);

    // Pixels whose class depends on what the light sees around them, and how far around.
    std::vector<std::uint32_t> asked;
    std::vector<float> reach_m;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const double e = countedError(visibility[i], truth, i);
        if (e == 0) continue;

        // The first that holds (design section 7).
        const double v = double(truth.visibility[i]);
        const bool tooLight = e > 0 && v == 0, tooDark = e < 0 && v == 1;
        ErrorClass c = ErrorClass::Other;
        if (misses(question, i))
            c = ErrorClass::Missing;
        else if (isContactGap[i])
            c = ErrorClass::ContactGap;
        else if (double(zones.toHardEdge_px[i]) <= aliasReach_px(footprint, truth, receivers, i))
            c = ErrorClass::Alias;
        else if (zones.penumbra[i])
            c = penumbraClass(v + e, v);
        else if (tooDark)
            c = texels ? ErrorClass::Acne : ErrorClass::FalseShadow;
        else if (tooLight)
            c = ErrorClass::Leak;
        classes[i] = c;
        if (texels && (c == ErrorClass::Acne || c == ErrorClass::Leak)) {
            asked.push_back(std::uint32_t(i));
            reach_m.push_back(float(texelSize_m(footprint, truth, receivers, i) * (1 + footprint.kernelRadius_texels)));
        }
    }

    // A technique with texels answers for what lies within their reach. A shadow's edge there is a true edge, although
    // it falls on another surface or on none that is seen; without one, only the point's own surface can have made it
    // dark.
    if (question.features == nullptr || asked.empty()) return classes;
    const std::vector<LightSurroundings> around = question.features->surroundings(asked, reach_m);
    for (std::size_t k = 0; k < asked.size(); ++k) {
        ErrorClass& c = classes[asked[k]];
        const bool crossesEdge = c == ErrorClass::Acne ? around[k].shaded : around[k].lit;
        if (crossesEdge && !truth.soft)
            c = ErrorClass::Alias;
        else if (c == ErrorClass::Acne && (crossesEdge || !around[k].ownCasts))
            c = ErrorClass::FalseShadow;
    }
    return classes;
}

}  // namespace ombrage
