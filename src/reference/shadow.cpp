// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

namespace ombrage {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The ray from a point to the light's centre, ending just before it.
Ray rayTo(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>* casters) {
    Ray ray;
    ray.origin = point.position;
    ray.direction = s.direction;
    ray.length_m =
        std::isfinite(s.distance_m) ? std::max(0.0, s.distance_m - rays.positionError_m(s.distance_m)) : kInfinity;
    ray.ownTriangle = point.triangle;
    ray.instances = casters;
    return ray;
}

/// Parts below the geometric horizon and parts that turn their back count as blocked.
bool mayBeSeen(const SurfacePoint& point, const LightSample& s) {
    return s.facing && glm::dot(s.direction, point.normal) > 0;
}

/// What masked pixels show: dark where the light cannot reach, lit where nothing is asked.
double maskedVisibility(Mask mask) {
    return mask == Mask::BelowHorizon || mask == Mask::OutOfRange ? 0.0 : 1.0;
}

float luminance(const glm::vec3& c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

/// Every array's first touch costs about as much as a tenth of a hard ray a pixel: by turns on all threads.
void resize(ShadowTruth& t, std::size_t count, const ReferenceOptions& options) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const std::array<std::pair<std::vector<float>*, float>, 7> planes = {{{&t.visibility, 1.0f},
                                                                          {&t.standardError, 0.0f},
                                                                          {&t.irradianceShare, 1.0f},
                                                                          {&t.irradiance, 0.0f},
                                                                          {&t.cosine, 0.0f},
                                                                          {&t.blockerDistance_m, kInfinite},
                                                                          {&t.lightDistance_m, kInfinite}}};
    ReferenceOptions quiet = options;
    quiet.progress = nullptr;
    parallelRows(int(planes.size()) + 1, quiet, [&](int i) {
        if (std::size_t(i) < planes.size()) {
            planes[std::size_t(i)].first->assign(count, planes[std::size_t(i)].second);
        } else {
            t.blockerInstance.assign(count, kNoHit);
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

namespace {

/// Fills the truth of one light row by row.
class ShadowRows {
public:
    ShadowRows(const FlatScene& flat, const RayScene& rays, const Light& light, const LightShape& shape,
               const Receivers& receivers, ShadowTruth& truth)
        : m_flat(flat), m_rays(rays), m_light(light), m_shape(shape), m_receivers(receivers), m_truth(truth) {}

    /// @param casters per model of the scene, or one for all, which instances shade it; null: all do
    /// @param sets of a light with a size; else null
    void row(int y, const std::vector<const std::vector<bool>*>& casters, const SampleSets* sets,
             const std::function<std::uint32_t(std::size_t)>& seedOf) {
        Queue queue;
        SurfacePoints points(m_flat, m_receivers, m_rays.positionError_m(0));
        for (int x = 0; x < m_receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(m_receivers.width) + std::size_t(x);
            if (m_receivers.triangle[i] == kNoHit) continue;
            const SurfacePoint point = points.at(i);
            const LightSample centre = m_shape.centre(point.position);
            m_truth.cosine[i] = float(glm::dot(centre.direction, point.normal));
            m_truth.lightDistance_m[i] = float(centre.distance_m);
            if (!asksAt(i, point, centre)) continue;
            const std::vector<bool>* seen =
                casters.size() == 1 ? casters.front() : casters[std::size_t(m_flat.instances[point.instance].model)];
            if (sets) {
                softPixel(i, point, centre, seen, *sets, seedOf(i));
            } else {
                hardPixel(i, point, centre, seen, queue);
            }
        }
        flush(queue);
    }

private:
    /// Pixels whose hard rays wait to be traced together.
    struct Queue {
        int count = 0;
        std::array<std::size_t, RayBundle::kSize> pixels{};
        std::array<Ray, RayBundle::kSize> rays;
    };

    /// Models that this light leaves alone are dark; those that receive no shadow are lit and ask no question.
    bool asksAt(std::size_t i, const SurfacePoint& point, const LightSample& centre) {
        const FlatInstance& instance = m_flat.instances[point.instance];
        const bool excluded =
            std::count(m_light.excludedModels.begin(), m_light.excludedModels.end(), instance.model) > 0;
        if (!excluded && instance.receives) return true;
        m_truth.mask[i] = Mask::NotReceiving;
        const double facing = std::max(0.0, glm::dot(centre.direction, point.shadingNormal));
        if (!excluded && m_shape.mask(point.position, point.normal) == Mask::Valid)
            m_truth.irradiance[i] = float(centre.irradiance * facing) * luminance(m_light.color);
        return false;
    }

    void softPixel(std::size_t i, const SurfacePoint& point, const LightSample& centre,
                   const std::vector<bool>* casters, const SampleSets& sets, std::uint32_t seed) {
        store(i, softTruth(m_rays, m_shape, point, casters, sets, seed));
        if (m_truth.mask[i] != Mask::Valid) return;
        if (const auto hit = m_rays.nearest(rayTo(m_rays, point, centre, casters))) keepBlocker(i, *hit);
    }

    void hardPixel(std::size_t i, const SurfacePoint& point, const LightSample& centre,
                   const std::vector<bool>* casters, Queue& queue) {
        LightTruth truth;
        truth.mask = m_shape.mask(point.position, point.normal);
        truth.visibility = truth.mask == Mask::Valid ? 0.0 : maskedVisibility(truth.mask);
        truth.irradianceShare = truth.visibility;
        if (truth.mask == Mask::Valid)
            truth.irradiance = centre.irradiance * std::max(0.0, glm::dot(centre.direction, point.shadingNormal));
        store(i, truth);
        if (truth.mask != Mask::Valid || !mayBeSeen(point, centre)) return;
        queue.pixels[std::size_t(queue.count)] = i;
        queue.rays[std::size_t(queue.count++)] = rayTo(m_rays, point, centre, casters);
        if (queue.count == RayBundle::kSize) flush(queue);
    }

    /// One ray tells both whether the light is seen and what is in the way.
    void flush(Queue& queue) {
        if (queue.count == 0) return;
        std::array<std::optional<RayHit>, RayBundle::kSize> hits;
        m_rays.nearest(queue.rays.data(), queue.count, hits.data());
        for (std::size_t k = 0; k < std::size_t(queue.count); ++k) {
            const std::size_t i = queue.pixels[k];
            if (hits[k])
                keepBlocker(i, *hits[k]);
            else
                m_truth.visibility[i] = m_truth.irradianceShare[i] = 1;
        }
        queue.count = 0;
    }

    /// The blocker that a hard shadow would come from.
    void keepBlocker(std::size_t i, const RayHit& hit) {
        m_truth.blockerDistance_m[i] = float(hit.distance_m);
        m_truth.blockerInstance[i] = m_flat.triangleInstance[hit.triangle];
    }

    void store(std::size_t i, const LightTruth& truth) {
        m_truth.mask[i] = truth.mask;
        m_truth.visibility[i] = float(truth.visibility);
        m_truth.standardError[i] = float(truth.standardError);
        m_truth.irradianceShare[i] = float(truth.irradianceShare);
        m_truth.irradiance[i] = float(truth.irradiance) * luminance(m_light.color);
    }

    const FlatScene& m_flat;
    const RayScene& m_rays;
    const Light& m_light;
    const LightShape& m_shape;
    const Receivers& m_receivers;
    ShadowTruth& m_truth;
};

}  // namespace

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
    std::vector<const std::vector<bool>*> casters;
    for (const std::vector<bool>& one : shading)
        casters.push_back(std::find(one.begin(), one.end(), false) == one.end() ? nullptr : &one);

    const std::uint32_t stream = std::uint32_t(light) + 1;
    const SampleSets sets(pointSeed(options.seed, stream, kNoHit), samples);
    ShadowRows rows(flat, m_impl->rays, source, shape, receivers, t);
    parallelRows(receivers.height, options, [&](int y) {
        rows.row(y, casters, t.soft ? &sets : nullptr,
                 [&](std::size_t i) { return pointSeed(options.seed, stream, std::uint32_t(i)); });
    });
    summarise(t.mask, t.standardError, t.meanStandardError, t.maskedShare);
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
    const bool seen = mayBeSeen(p, centre) && !m_impl->rays.occluded(rayTo(m_impl->rays, p, centre, &casters));
    return {seen ? 1.0 : 0.0, 0};
}

}  // namespace ombrage
