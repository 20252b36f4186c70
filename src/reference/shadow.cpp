// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"
#include "reference/shadow_rows.h"

namespace ombrage {
namespace {

/// Every array's first touch costs about as much as a tenth of a hard ray a pixel: by turns on all threads.
void resize(ShadowTruth& t, std::size_t count, const ReferenceOptions& options) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const std::array<std::pair<std::vector<float>*, float>, 6> planes = {{{&t.visibility, 1.0f},
                                                                          {&t.standardError, 0.0f},
                                                                          {&t.irradianceShare, 1.0f},
                                                                          {&t.irradiance, 0.0f},
                                                                          {&t.cosine, 0.0f},
                                                                          {&t.lightDistance_m, kInfinite}}};
    ReferenceOptions quiet = options;
    quiet.progress = nullptr;
    parallelRows(int(planes.size()) + 1, quiet, [&](int i) {
        if (std::size_t(i) < planes.size()) {
            planes[std::size_t(i)].first->assign(count, planes[std::size_t(i)].second);
        } else {
            if (t.soft) t.centreSeen.assign(count, 0);
            t.mask.assign(count, Mask::Sky);
        }
    });
}

}  // namespace

LightTruth softTruth(const RayScene& rays, const LightShape& light, const SurfacePoint& point,
                     const std::vector<bool>* casters, const SampleSets& sets, std::uint32_t seed) {
    LightTruth truth;
    truth.mask = light.mask(point.position, point.normal);
    if (truth.mask != Mask::Valid) {
        truth.visibility = truth.irradianceShare = maskedVisibility(truth.mask);
        return truth;
    }

    // Independent scramblings of the same points, each with its own mean.
    const RayOrigin origin = rays.startAt(point.position, point.normal, point.triangle, casters);
    const glm::dvec3 n = point.normal, ns = point.shadingNormal;
    const double nearEnd_m = rays.positionError_m(0), shorter = 1 - (rays.positionError_m(1) - nearEnd_m);
    std::array<double, kScramblings> means{};
    double lit = 0, unshadowed = 0;
    LightBundle parts;
    RayBundle bundle;
    LightBundle::Lanes weights{};
    for (int k = 0; k < kScramblings; ++k) {
        const SampleSets::Move move = SampleSets::moveOf(seed, k);
        int count = 0;
        for (int b = 0; b < sets.bundles(); ++b) {
            light.sample(point.position, sets, k, b, move, parts);
            LightBundle::Lanes cosines{};
            for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
                bundle.x[i] = float(parts.x[i]);
                bundle.y[i] = float(parts.y[i]);
                bundle.z[i] = float(parts.z[i]);
                // Just before the light; a sun stays infinitely far.
                bundle.length_m[i] = float(std::max(0.0, parts.distance_m[i] * shorter - nearEnd_m));
                cosines[i] = parts.x[i] * n.x + parts.y[i] * n.y + parts.z[i] * n.z;
                weights[i] =
                    parts.irradiance[i] * std::max(0.0, parts.x[i] * ns.x + parts.y[i] * ns.y + parts.z[i] * ns.z);
            }
            const std::uint32_t wanted = sets.wanted(b);
            std::uint32_t above = 0;
            for (std::size_t i = 0; i < RayBundle::kSize; ++i) above |= std::uint32_t(cosines[i] > 0) << i;
            above &= wanted & parts.facing;
            const std::uint32_t seen = above & ~rays.occluded(origin, bundle, above);
            count += __builtin_popcount(seen);
            for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
                unshadowed += (wanted >> i & 1u) ? weights[i] : 0;
                lit += (seen >> i & 1u) ? weights[i] : 0;
            }
        }
        means[std::size_t(k)] = double(count) / sets.samples();
    }
    const auto [mean, standardError] = combine(means);
    truth.visibility = mean;
    truth.standardError = standardError;
    truth.irradianceShare = unshadowed > 0 ? lit / unshadowed : mean;
    truth.irradiance = unshadowed / (double(sets.samples()) * kScramblings);
    return truth;
}

ShadowTruth Reference::shadow(const Receivers& receivers, const Camera&, int light,
                              const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const FlatScene& flat = m_impl->flat;
    const Light& source = checkedLight(m_impl->scene, light);
    const LightShape shape(source, flat.origin);
    const TruthKind kind = checkedShadowKind(options);
    const int samples = shape.hasSize() ? samplesPerScrambling(options.samplesPerPixel, kSoftSamples) : 1;

    ShadowTruth t;
    t.width = receivers.width;
    t.height = receivers.height;
    t.soft = shape.hasSize();
    t.samplesPerPixel = t.soft ? samples * kScramblings : 1;
    resize(t, receivers.triangle.size(), options);

    // Who shades whom: all casters everyone, or every model itself alone. Where nothing is left out rays need not ask.
    const std::vector<std::vector<bool>> shading = castersByModel(flat, m_impl->scene, source, kind);
    ShadowRows::Casters casters;
    for (const std::vector<bool>& one : shading)
        casters.push_back(std::find(one.begin(), one.end(), false) == one.end() ? nullptr : &one);

    const std::uint32_t stream = std::uint32_t(light) + 1;
    const SampleSets sets(pointSeed(options.seed, stream, kNoHit), samples);
    ShadowRows rows(flat, m_impl->rays, source, shape, receivers, casters, t);
    if (t.soft)
        parallelRows(receivers.height, options, [&](int y) {
            rows.soft(y, sets, [&](std::size_t i) { return pointSeed(options.seed, stream, std::uint32_t(i)); });
        });
    else
        parallelRows((receivers.height + ShadowRows::kBand - 1) / ShadowRows::kBand, options,
                     [&](int band) { rows.hard(band); });
    // Without samples no pixel has an error.
    if (t.soft)
        summarise(t.mask, t.standardError, t.meanStandardError, t.maskedShare);
    else
        t.maskedShare = maskedShareOf(t.mask);
    return t;
}

Reference::Estimate Reference::shadowAt(const glm::dvec3& point, const glm::dvec3& normal, int light, int samples,
                                        std::uint64_t seed) const {
    const Light& source = checkedLight(m_impl->scene, light);
    const LightShape shape(source, m_impl->flat.origin);
    const std::vector<bool> casters = shadingInstances(m_impl->flat, source);
    SurfacePoint p;
    p.position = point - m_impl->flat.origin;
    p.normal = p.shadingNormal = glm::normalize(normal);
    const std::uint32_t stream = std::uint32_t(light) + 1;
    if (shape.hasSize()) {
        const SampleSets sets(pointSeed(seed, stream, kNoHit), samplesPerScrambling(samples, kSoftSamples));
        const LightTruth truth = softTruth(m_impl->rays, shape, p, &casters, sets, pointSeed(seed, stream, 0));
        return {truth.visibility, truth.standardError};
    }
    const Mask mask = shape.mask(p.position, p.normal);
    if (mask != Mask::Valid) return {maskedVisibility(mask), 0};
    const LightSample centre = shape.centre(p.position);
    return {isSeen(m_impl->rays, p, centre, &casters) ? 1.0 : 0.0, 0};
}

}  // namespace ombrage
