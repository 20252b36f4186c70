// SPDX-License-Identifier: MIT
// What the error classes ask beside the truth itself: rays for single pixels.
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

namespace ombrage {
namespace {

/// Rays through the disk about a pixel's own: on a sunflower, so that a caster as thin as a fourth of it meets some.
constexpr int kProbes = 16;
constexpr double kGoldenAngle_rad = 2.39996322972865332;

/// Below this cosine the tangent plane is as steep as the light's ray and says nothing of the surface beside the point.
constexpr double kSteepest = 0.02;

/// Steps that find where a wall begins: to 1/64 of the reach, where one 89 degrees from facing the light is lower than
/// it.
constexpr int kBisections = 6;

/// Pixels that one thread takes at a time.
constexpr std::size_t kChunk = 256;

/// Asks single pixels about one light.
class PixelProbe {
public:
    PixelProbe(const FlatScene& flat, const RayScene& rays, const Light& light, const Receivers& receivers,
               std::vector<std::vector<bool>> casters)
        : m_flat(flat),
          m_rays(rays),
          m_shape(light, flat.origin),
          m_receivers(receivers),
          m_casters(std::move(casters)) {}

    LightSurroundings surroundings(const SurfacePoint& point, double reach_m) const {
        const LightSample centre = m_shape.centre(point.position);
        glm::dvec3 right, up;
        basis(centre.direction, right, up);
        LightSurroundings found;
        found.ownCasts = castersOf(point)[point.instance];
        const bool isShaded = m_rays.occluded(rayBeside(point, glm::dvec3(0.0), reach_m));
        (isShaded ? found.shaded : found.lit) = true;
        for (int k = 0; k < kProbes && !(found.lit && found.shaded); ++k) {
            const double r = reach_m * std::sqrt((k + 0.5) / kProbes), angle_rad = k * kGoldenAngle_rad;
            const glm::dvec3 aside = right * (r * std::cos(angle_rad)) + up * (r * std::sin(angle_rad));
            if (!m_rays.occluded(rayBeside(point, aside, reach_m)))
                found.lit = true;
            else
                found.shaded = found.shaded || isDetached(point, aside, reach_m);
        }
        return found;
    }

    Blocker blocker(const SurfacePoint& point) const {
        const auto hit = m_rays.nearest(rayFrom(point, m_shape.centre(point.position), glm::dvec3(0.0)));
        return hit ? Blocker{float(hit->distance_m), m_flat.triangleInstance[hit->triangle]} : Blocker{};
    }

    int layers(const SurfacePoint& point) const {
        std::vector<RayCrossing> crossings;
        m_rays.crossings(rayFrom(point, m_shape.centre(point.position), glm::dvec3(0.0)), crossings);
        const auto fronts =
            std::count_if(crossings.begin(), crossings.end(), [](const RayCrossing& c) { return c.fromFront; });
        return int(std::max(fronts, std::ptrdiff_t(crossings.size()) - fronts));
    }

    /// Calls `ask(k, point)` for every pixel on all threads, the points of one chunk in order.
    template <typename Ask>
    void each(const std::vector<std::uint32_t>& pixels, const ReferenceOptions& options, Ask ask) const {
        const int chunks = int((pixels.size() + kChunk - 1) / kChunk);
        parallelRows(chunks, options, [&](int chunk) {
            SurfacePoints points(m_flat, m_receivers, m_rays.positionError_m(0));
            const std::size_t first = std::size_t(chunk) * kChunk, last = std::min(first + kChunk, pixels.size());
            for (std::size_t k = first; k < last; ++k) ask(k, points.at(pixels[k]));
        });
    }

    const LightShape& shape() const { return m_shape; }

private:
    /// The ray to the light through the point moved aside, from above both the point and its tangent plane there: what
    /// lies lower shades neither the point nor the surface that it seems to lie on.
    Ray rayBeside(const SurfacePoint& point, const glm::dvec3& aside, double reach_m) const {
        const LightSample s = m_shape.centre(point.position + aside);
        const double cosine = std::max(glm::dot(point.normal, s.direction), kSteepest);
        const double along_m = reach_m + std::max(0.0, -glm::dot(point.normal, aside) / cosine);
        Ray ray = rayFrom(point, s, aside + s.direction * along_m);
        if (std::isfinite(s.distance_m)) ray.length_m = std::max(0.0, ray.length_m - along_m);
        return ray;
    }

    /// Whether what shades the place aside stands free of the point's surface. A wall that rises from it in a crease
    /// does not: where it begins to block, it is no higher than the ray's start.
    bool isDetached(const SurfacePoint& point, const glm::dvec3& aside, double reach_m) const {
        double open = 0, blocked = 1;
        for (int i = 0; i < kBisections; ++i) {
            const double middle = 0.5 * (open + blocked);
            (m_rays.occluded(rayBeside(point, aside * middle, reach_m)) ? blocked : open) = middle;
        }
        const auto hit = m_rays.nearest(rayBeside(point, aside * blocked, reach_m));
        return hit && hit->distance_m > reach_m;
    }

    Ray rayFrom(const SurfacePoint& point, const LightSample& s, const glm::dvec3& moved) const {
        Ray ray;
        ray.origin = point.position + moved;
        ray.direction = s.direction;
        if (std::isfinite(s.distance_m))
            ray.length_m = std::max(0.0, s.distance_m - m_rays.positionError_m(s.distance_m));
        ray.ownTriangle = point.triangle;
        ray.instances = &castersOf(point);
        return ray;
    }

    const std::vector<bool>& castersOf(const SurfacePoint& point) const {
        return m_casters.size() == 1 ? m_casters.front()
                                     : m_casters[std::size_t(m_flat.instances[point.instance].model)];
    }

    const FlatScene& m_flat;
    const RayScene& m_rays;
    const LightShape m_shape;
    const Receivers& m_receivers;
    const std::vector<std::vector<bool>> m_casters;  ///< of all points, or per model of the scene
};

}  // namespace

ShadowFeatures Reference::shadowFeatures(const Receivers& receivers, int light, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const Light& source = checkedLight(m_impl->scene, light);
    const FlatScene& flat = m_impl->flat;
    const auto probe = std::make_shared<const PixelProbe>(
        flat, m_impl->rays, source, receivers, castersByModel(flat, m_impl->scene, source, checkedShadowKind(options)));
    ReferenceOptions quiet = options;
    quiet.progress = nullptr;

    ShadowFeatures features;
    features.shadingCosine.assign(receivers.triangle.size(), 0.0f);
    parallelRows(receivers.height, quiet, [&](int y) {
        SurfacePoints points(flat, receivers, m_impl->rays.positionError_m(0));
        for (std::size_t i = std::size_t(y) * std::size_t(receivers.width), end = i + std::size_t(receivers.width);
             i < end; ++i) {
            if (receivers.triangle[i] == kNoHit) continue;
            const SurfacePoint point = points.at(i);
            features.shadingCosine[i] =
                float(glm::dot(probe->shape().centre(point.position).direction, point.shadingNormal));
        }
    });
    features.blockers = [probe, quiet](const std::vector<std::uint32_t>& pixels) {
        std::vector<Blocker> found(pixels.size());
        probe->each(pixels, quiet, [&](std::size_t k, const SurfacePoint& point) { found[k] = probe->blocker(point); });
        return found;
    };
    features.surroundings = [probe, quiet](const std::vector<std::uint32_t>& pixels,
                                           const std::vector<float>& reach_m) {
        if (pixels.size() != reach_m.size())
            throw Error(ErrorCode::Usage, "every pixel that is asked about needs a reach of its own");
        std::vector<LightSurroundings> found(pixels.size());
        probe->each(pixels, quiet, [&](std::size_t k, const SurfacePoint& point) {
            found[k] = probe->surroundings(point, double(reach_m[k]));
        });
        return found;
    };
    features.layers = [probe, quiet](const std::vector<std::uint32_t>& pixels) {
        std::vector<int> counts(pixels.size());
        probe->each(pixels, quiet, [&](std::size_t k, const SurfacePoint& point) { counts[k] = probe->layers(point); });
        return counts;
    };
    return features;
}

std::vector<glm::dvec3> Reference::positions(const Receivers& receivers) const {
    checkReceivers(receivers);
    std::vector<glm::dvec3> positions(receivers.triangle.size(), glm::dvec3(0.0));
    SurfacePoints points(m_impl->flat, receivers, 0);
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (receivers.triangle[i] != kNoHit) positions[i] = points.at(i).position + m_impl->flat.origin;
    return positions;
}

}  // namespace ombrage
