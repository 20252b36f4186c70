// SPDX-License-Identifier: MIT
#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

namespace ombrage {

Reference::Estimate openSky(const RayScene& rays, const SurfacePoint& point, double radius_m, int samples,
                            std::uint32_t seed) {
    Ray ray;
    ray.origin = point.position;
    ray.length_m = radius_m;
    ray.ownTriangle = point.triangle;
    std::array<double, kScramblings> means{};
    for (int k = 0; k < kScramblings; ++k) {
        const std::uint32_t scrambling = hashCombine(seed, std::uint32_t(k));
        int open = 0;
        for (int i = 0; i < samples; ++i) {
            ray.direction = cosineDirection(point.shadingNormal, owenSobol2(std::uint32_t(i), scrambling));
            // Below the geometric horizon the surface itself is in the way.
            if (glm::dot(ray.direction, point.normal) > 0 && !rays.occluded(ray)) ++open;
        }
        means[std::size_t(k)] = double(open) / samples;
    }
    return combine(means);
}

AoTruth Reference::ao(const Receivers& receivers, const Camera&, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const float radius_m = m_impl->scene.aoRadius_m;
    if (!(radius_m > 0))
        throw Error(ErrorCode::Usage, "the scene has no radius of ambient occlusion", "Set ao_radius_m above 0.");
    const int samples = samplesPerScrambling(options.samplesPerPixel, 256);

    AoTruth t;
    t.width = receivers.width;
    t.height = receivers.height;
    t.samplesPerPixel = samples * kScramblings;
    t.radius_m = radius_m;
    t.visibility.assign(receivers.triangle.size(), 1.0f);
    t.standardError.assign(receivers.triangle.size(), 0.0f);
    t.mask.assign(receivers.triangle.size(), Mask::Sky);

    const double inset_m = m_impl->rays.positionError_m(0);
    parallelRows(receivers.height, options, [&](int y) {
        for (int x = 0; x < receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(receivers.width) + std::size_t(x);
            if (receivers.triangle[i] == kNoHit) continue;
            const Estimate e = openSky(m_impl->rays, surfacePoint(m_impl->flat, receivers, i, inset_m), radius_m, samples,
                                       pointSeed(options.seed, 0, std::uint32_t(i)));
            t.mask[i] = Mask::Valid;
            t.visibility[i] = float(e.mean);
            t.standardError[i] = float(e.standardError);
        }
    });
    summarise(t.mask, t.standardError, t.meanStandardError, t.maskedShare);
    return t;
}

Reference::Estimate Reference::aoAt(const glm::dvec3& point, const glm::dvec3& normal, double radius_m, int samples,
                                    std::uint64_t seed) const {
    SurfacePoint p;
    p.position = point - m_impl->flat.origin;
    p.normal = p.shadingNormal = glm::normalize(normal);
    return openSky(m_impl->rays, p, radius_m, samplesPerScrambling(samples, 256), pointSeed(seed, 0, 0));
}

}  // namespace ombrage
