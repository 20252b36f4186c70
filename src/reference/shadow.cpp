// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

namespace ombrage {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The ray from a point to a part of the light, ending just before it.
Ray rayTo(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>& instances) {
    Ray ray;
    ray.origin = point.position;
    ray.direction = s.direction;
    ray.length_m =
        std::isfinite(s.distance_m) ? std::max(0.0, s.distance_m - rays.positionError_m(s.distance_m)) : kInfinity;
    ray.ownTriangle = point.triangle;
    ray.instances = &instances;
    return ray;
}

bool seen(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>& instances) {
    // Parts below the geometric horizon and parts that turn their back count as blocked.
    if (!s.facing || glm::dot(s.direction, point.normal) <= 0) return false;
    return !rays.occluded(rayTo(rays, point, s, instances));
}

/// What masked pixels show: dark where the light cannot reach, lit where nothing is asked.
double maskedVisibility(Mask mask) {
    return mask == Mask::BelowHorizon || mask == Mask::OutOfRange ? 0.0 : 1.0;
}

float luminance(const glm::vec3& c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

const Light& checkedLight(const Scene& scene, int light) {
    if (light < 0 || std::size_t(light) >= scene.lights.size())
        throw Error(ErrorCode::Usage, "there is no light " + std::to_string(light),
                    "The scene has " + std::to_string(scene.lights.size()) + " lights, counted from 0.");
    return scene.lights[std::size_t(light)];
}

void resize(ShadowTruth& t, std::size_t count) {
    t.visibility.assign(count, 1.0f);
    t.standardError.assign(count, 0.0f);
    t.irradianceShare.assign(count, 1.0f);
    t.irradiance.assign(count, 0.0f);
    t.cosine.assign(count, 0.0f);
    t.blockerDistance_m.assign(count, std::numeric_limits<float>::infinity());
    t.lightDistance_m.assign(count, std::numeric_limits<float>::infinity());
    t.blockerInstance.assign(count, kNoHit);
    t.mask.assign(count, Mask::Sky);
}

}  // namespace

LightTruth lightTruth(const RayScene& rays, const LightShape& light, const SurfacePoint& point,
                      const std::vector<bool>& instances, int samples, std::uint32_t seed) {
    LightTruth truth;
    truth.mask = light.mask(point.position, point.normal);
    if (truth.mask != Mask::Valid) {
        truth.visibility = truth.irradianceShare = maskedVisibility(truth.mask);
        return truth;
    }
    if (!light.hasSize()) {
        const LightSample s = light.centre(point.position);
        truth.visibility = truth.irradianceShare = seen(rays, point, s, instances) ? 1 : 0;
        truth.irradiance = s.irradiance * std::max(0.0, glm::dot(s.direction, point.shadingNormal));
        return truth;
    }

    // Independent scramblings of the same points, each with its own mean.
    std::array<double, kScramblings> means{};
    double lit = 0, unshadowed = 0;
    for (int k = 0; k < kScramblings; ++k) {
        const std::uint32_t scrambling = hashCombine(seed, std::uint32_t(k));
        int count = 0;
        for (int i = 0; i < samples; ++i) {
            const LightSample s = light.sample(point.position, owenSobol2(std::uint32_t(i), scrambling));
            const double irradiance = s.irradiance * std::max(0.0, glm::dot(s.direction, point.shadingNormal));
            unshadowed += irradiance;
            if (!seen(rays, point, s, instances)) continue;
            lit += irradiance;
            ++count;
        }
        means[std::size_t(k)] = double(count) / samples;
    }
    const auto [mean, standardError] = combine(means);
    truth.visibility = mean;
    truth.standardError = standardError;
    truth.irradianceShare = unshadowed > 0 ? lit / unshadowed : mean;
    truth.irradiance = unshadowed / (double(samples) * kScramblings);
    return truth;
}

ShadowTruth Reference::shadow(const Receivers& receivers, const Camera&, int light,
                              const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const Scene& scene = m_impl->scene;
    const FlatScene& flat = m_impl->flat;
    const Light& source = checkedLight(scene, light);
    const LightShape shape(source, flat.origin);
    const std::vector<bool> instances = shadingInstances(flat, source);
    const int samples = shape.hasSize() ? samplesPerScrambling(options.samplesPerPixel, 1024) : 1;

    ShadowTruth t;
    t.width = receivers.width;
    t.height = receivers.height;
    t.soft = shape.hasSize();
    t.samplesPerPixel = t.soft ? samples * kScramblings : 1;
    resize(t, receivers.triangle.size());

    const double inset_m = m_impl->rays.positionError_m(0);
    parallelRows(receivers.height, options, [&](int y) {
        for (int x = 0; x < receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(receivers.width) + std::size_t(x);
            if (receivers.triangle[i] == kNoHit) continue;
            const SurfacePoint point = surfacePoint(flat, receivers, i, inset_m);
            const LightSample centre = shape.centre(point.position);
            t.cosine[i] = float(glm::dot(centre.direction, point.normal));
            t.lightDistance_m[i] = float(centre.distance_m);

            // Models that this light leaves alone are dark; those that receive no shadow are lit and ask no question.
            const FlatInstance& instance = flat.instances[point.instance];
            const bool excluded =
                std::count(source.excludedModels.begin(), source.excludedModels.end(), instance.model) > 0;
            if (excluded || !instance.receives) {
                t.mask[i] = Mask::NotReceiving;
                const double facing = std::max(0.0, glm::dot(centre.direction, point.shadingNormal));
                if (!excluded && shape.mask(point.position, point.normal) == Mask::Valid)
                    t.irradiance[i] = float(centre.irradiance * facing) * luminance(source.color);
                continue;
            }
            const LightTruth truth = lightTruth(m_impl->rays, shape, point, instances, samples,
                                                pointSeed(options.seed, std::uint32_t(light) + 1, std::uint32_t(i)));
            t.mask[i] = truth.mask;
            t.visibility[i] = float(truth.visibility);
            t.standardError[i] = float(truth.standardError);
            t.irradianceShare[i] = float(truth.irradianceShare);
            t.irradiance[i] = float(truth.irradiance) * luminance(source.color);
            if (truth.mask != Mask::Valid) continue;

            // The blocker that a hard shadow would come from.
            if (const auto hit = m_impl->rays.nearest(rayTo(m_impl->rays, point, centre, instances))) {
                t.blockerDistance_m[i] = float(hit->distance_m);
                t.blockerInstance[i] = flat.triangleInstance[hit->triangle];
            }
        }
    });
    summarise(t.mask, t.standardError, t.meanStandardError, t.maskedShare);
    return t;
}

Reference::Estimate Reference::shadowAt(const glm::dvec3& point, const glm::dvec3& normal, int light, int samples,
                                        std::uint64_t seed) const {
    const Light& source = checkedLight(m_impl->scene, light);
    SurfacePoint p;
    p.position = point - m_impl->flat.origin;
    p.normal = p.shadingNormal = glm::normalize(normal);
    const LightTruth truth =
        lightTruth(m_impl->rays, LightShape(source, m_impl->flat.origin), p, shadingInstances(m_impl->flat, source),
                   samplesPerScrambling(samples, 1024), pointSeed(seed, std::uint32_t(light) + 1, 0));
    return {truth.visibility, truth.standardError};
}

}  // namespace ombrage
