// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/ao_estimator.h"
#include "reference/parallel_rows.h"
#include "reference/surface_color.h"

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint32_t kStream = 0x62000000u;

/// Light that one surface sends on to another.
class Bounce {
public:
    Bounce(const Scene& scene, const FlatScene& flat, const RayScene& rays)
        : m_scene(scene), m_flat(flat), m_rays(rays) {
        for (const Light& light : scene.lights) {
            m_shapes.emplace_back(light, flat.origin);
            m_casters.push_back(shadingInstances(flat, light));
        }
    }

    /// Radiance that leaves the surface met by a ray, lit by the lights' centres.
    glm::dvec3 leaving(const Ray& ray, const RayHit& hit) const {
        SurfacePoint point;
        point.triangle = hit.triangle;
        point.instance = m_flat.triangleInstance[hit.triangle];
        const glm::uvec3 t = m_flat.triangles[hit.triangle];
        const glm::dvec3 a(m_flat.positions[t.x]), ab = glm::dvec3(m_flat.positions[t.y]) - a,
                                                   ac = glm::dvec3(m_flat.positions[t.z]) - a;
        point.position = a + ab * hit.u + ac * hit.v;
        const glm::dvec3 n = glm::cross(ab, ac);
        if (!(glm::dot(n, n) > 0)) return glm::dvec3(0);
        point.normal = glm::normalize(n);
        if (glm::dot(point.normal, ray.direction) > 0) point.normal = -point.normal;

        glm::dvec3 irradiance(0);
        for (std::size_t l = 0; l < m_shapes.size(); ++l) irradiance += arriving(l, point);
        const SurfaceColor color = surfaceColor(m_scene, m_flat, hit.triangle, glm::vec2(hit.u, hit.v));
        return glm::dvec3(color.base) * irradiance / kPi;
    }

private:
    glm::dvec3 arriving(std::size_t l, const SurfacePoint& point) const {
        const Light& light = m_scene.lights[l];
        const int model = m_flat.instances[point.instance].model;
        if (std::count(light.excludedModels.begin(), light.excludedModels.end(), model) > 0) return glm::dvec3(0);
        if (m_shapes[l].mask(point.position, point.normal) != Mask::Valid) return glm::dvec3(0);
        const LightSample centre = m_shapes[l].centre(point.position);
        const double cosine = glm::dot(centre.direction, point.normal);
        if (!centre.facing || cosine <= 0) return glm::dvec3(0);
        if (m_flat.instances[point.instance].receives) {
            Ray ray;
            ray.origin = point.position;
            ray.direction = centre.direction;
            ray.length_m =
                std::max(0.0, centre.distance_m * (1 - (m_rays.positionError_m(1) - m_rays.positionError_m(0))) -
                                  m_rays.positionError_m(0));
            ray.ownTriangle = point.triangle;
            ray.instances = &m_casters[l];
            if (m_rays.occluded(ray)) return glm::dvec3(0);
        }
        return glm::dvec3(light.color) * (centre.irradiance * cosine);
    }

    const Scene& m_scene;
    const FlatScene& m_flat;
    const RayScene& m_rays;
    std::vector<LightShape> m_shapes;
    std::vector<std::vector<bool>> m_casters;
};

}  // namespace

Image Reference::indirect(const Receivers& receivers, const Camera&, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const FlatScene& flat = m_impl->flat;
    const RayScene& rays = m_impl->rays;
    const Bounce bounce(m_impl->scene, flat, rays);
    const SampleSets sets(pointSeed(options.seed, kStream, kNoHit),
                          samplesPerScrambling(options.samplesPerPixel, kAoSamples));
    Image image = Image::rgb(receivers.width, receivers.height);
    parallelRows(receivers.height, options, [&](int y) {
        SurfacePoints points(flat, receivers, rays.positionError_m(0));
        PolarSamples samples;
        RayBundle bundle;
        for (int x = 0; x < receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(receivers.width) + std::size_t(x);
            if (receivers.triangle[i] == kNoHit) continue;
            const SurfacePoint point = points.at(i);
            const std::uint32_t seed = pointSeed(options.seed, kStream, std::uint32_t(i));
            // Cosine-weighted rays: the mean of what they meet is the irradiance over pi.
            glm::dvec3 sum(0);
            for (int k = 0; k < kScramblings; ++k)
                for (int b = 0; b < sets.bundles(); ++b) {
                    sets.polar(k, b, SampleSets::moveOf(seed, k), samples);
                    directions(point.shadingNormal, Spread::Cosine, samples, bundle);
                    for (std::size_t j = 0; j < RayBundle::kSize; ++j) {
                        Ray ray;
                        ray.origin = point.position;
                        ray.direction = glm::dvec3(bundle.x[j], bundle.y[j], bundle.z[j]);
                        ray.ownTriangle = point.triangle;
                        if (!(sets.wanted(b) >> j & 1u) || glm::dot(ray.direction, point.normal) <= 0) continue;
                        if (const auto hit = rays.nearest(ray)) sum += bounce.leaving(ray, *hit);
                    }
                }
            const SurfaceColor color =
                surfaceColor(m_impl->scene, flat, receivers.triangle[i], receivers.barycentric[i]);
            const glm::dvec3 radiance = glm::dvec3(color.base) * sum / (double(sets.samples()) * kScramblings);
            for (int c = 0; c < 3; ++c) image.plane(c)[i] = float(radiance[c]);
        }
    });
    return image;
}

}  // namespace ombrage
