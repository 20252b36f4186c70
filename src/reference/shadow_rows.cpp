// SPDX-License-Identifier: MIT
#include "reference/shadow_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ombrage {
namespace {

float luminance(const glm::vec3& c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

}  // namespace

Ray rayTo(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>* casters) {
    Ray ray;
    ray.origin = point.position;
    ray.direction = s.direction;
    ray.length_m = rays.lengthTo_m(s.distance_m);
    ray.ownTriangle = point.triangle;
    ray.instances = casters;
    return ray;
}

/// Where a hard ray goes.
struct ShadowRows::Aim {
    glm::dvec3 from;
    LightSample centre;
    double length_m;
};

/// Pixels whose hard rays wait to be traced together.
struct ShadowRows::Queue {
    int count = 0;
    std::array<std::size_t, RayBundle::kSize> pixels{};
    std::array<Ray, RayBundle::kSize> rays;
};

ShadowRows::ShadowRows(const FlatScene& flat, const RayScene& rays, const Light& light, const LightShape& shape,
                       const Receivers& receivers, const Casters& casters, ShadowTruth& truth)
    : m_flat(flat),
      m_rays(rays),
      m_shape(shape),
      m_receivers(receivers),
      m_casters(casters),
      m_truth(truth),
      m_luminance(luminance(light.color)) {
    for (const FlatInstance& instance : flat.instances) {
        const bool excluded = std::count(light.excludedModels.begin(), light.excludedModels.end(), instance.model) > 0;
        m_asks.push_back(excluded ? Asks::Excluded : instance.receives ? Asks::Shadow : Asks::Nothing);
    }
}

const std::vector<bool>* ShadowRows::castersOf(std::uint32_t instance) const {
    return m_casters.size() == 1 ? m_casters.front() : m_casters[std::size_t(m_flat.instances[instance].model)];
}

float ShadowRows::irradianceOf(const LightSample& centre, const glm::dvec3& shadingNormal) const {
    return float(centre.irradiance * std::max(0.0, glm::dot(centre.direction, shadingNormal))) * m_luminance;
}

void ShadowRows::keepBlocker(std::size_t i, std::uint32_t triangle, double distance_m) {
    m_truth.blockerDistance_m[i] = float(distance_m);
    m_truth.blockerInstance[i] = m_flat.triangleInstance[triangle];
}

void ShadowRows::soft(int y, const SampleSets& sets, const std::function<std::uint32_t(std::size_t)>& seedOf) {
    SurfacePoints points(m_flat, m_receivers, m_rays.positionError_m(0));
    const std::size_t first = std::size_t(y) * std::size_t(m_receivers.width);
    for (std::size_t i = first; i < first + std::size_t(m_receivers.width); ++i) {
        if (m_receivers.triangle[i] == kNoHit) continue;
        const SurfacePoint point = points.at(i);
        const LightSample centre = m_shape.centre(point.position);
        m_truth.cosine[i] = float(glm::dot(centre.direction, point.normal));
        m_truth.lightDistance_m[i] = float(centre.distance_m);
        const Asks asks = m_asks[point.instance];
        if (asks != Asks::Shadow) {
            m_truth.mask[i] = Mask::NotReceiving;
            if (asks == Asks::Nothing && m_shape.mask(point.position, point.normal) == Mask::Valid)
                m_truth.irradiance[i] = irradianceOf(centre, point.shadingNormal);
            continue;
        }

        const std::vector<bool>* casters = castersOf(point.instance);
        const LightTruth truth = softTruth(m_rays, m_shape, point, casters, sets, seedOf(i));
        m_truth.mask[i] = truth.mask;
        m_truth.visibility[i] = float(truth.visibility);
        m_truth.standardError[i] = float(truth.standardError);
        m_truth.irradianceShare[i] = float(truth.irradianceShare);
        m_truth.irradiance[i] = float(truth.irradiance) * m_luminance;
        if (truth.mask != Mask::Valid) continue;
        // The blocker that a hard shadow would come from.
        if (const auto hit = m_rays.nearest(rayTo(m_rays, point, centre, casters)))
            keepBlocker(i, hit->triangle, hit->distance_m);
    }
}

void ShadowRows::hard(int y) {
    SurfacePoints points(m_flat, m_receivers, m_rays.positionError_m(0));
    // Each pixel works out only what it needs. Far from all, a sun stands the same everywhere: what depends on a normal
    // alone holds as long as the normal does, and a pixel that turns away has no use for its own position.
    const bool isFar = m_shape.isDirectional();
    Queue queue;
    Aim aim{glm::dvec3(0.0), m_shape.centre(glm::dvec3(0.0)), 0};
    aim.length_m = m_rays.lengthTo_m(aim.centre.distance_m);
    double cosine = 0;
    float irradiance = 0;
    Mask mask = Mask::Valid;
    glm::vec3 shadingNormal(0.0f);  // that the irradiance belongs to
    const std::size_t first = std::size_t(y) * std::size_t(m_receivers.width);
    for (std::size_t i = first; i < first + std::size_t(m_receivers.width); ++i) {
        if (m_receivers.triangle[i] == kNoHit) continue;
        const bool turns = points.turnTo(i);
        if (!isFar) {
            aim.from = points.position();
            aim.centre = m_shape.centre(aim.from);
            aim.length_m = m_rays.lengthTo_m(aim.centre.distance_m);
            m_truth.lightDistance_m[i] = float(aim.centre.distance_m);
        }
        if (turns || !isFar) {
            cosine = glm::dot(aim.centre.direction, points.normal());
            mask = m_shape.mask(aim.from, points.normal());
        }
        m_truth.cosine[i] = float(cosine);

        const Asks asks = m_asks[m_receivers.instance[i]];
        m_truth.mask[i] = asks == Asks::Shadow ? mask : Mask::NotReceiving;
        // Dark until its ray arrives.
        if (asks == Asks::Shadow) m_truth.visibility[i] = m_truth.irradianceShare[i] = 0;
        if (mask != Mask::Valid || asks == Asks::Excluded) continue;
        if (!isFar || m_receivers.shadingNormal[i] != shadingNormal) {
            shadingNormal = m_receivers.shadingNormal[i];
            irradiance = irradianceOf(aim.centre, points.shadingNormal());
        }
        m_truth.irradiance[i] = irradiance;
        if (asks != Asks::Shadow || !aim.centre.facing || !(cosine > 0)) continue;
        if (isFar) aim.from = points.position();
        enqueue(i, aim, queue);
    }
    flush(queue);
}

void ShadowRows::enqueue(std::size_t i, const Aim& aim, Queue& queue) {
    queue.pixels[std::size_t(queue.count)] = i;
    Ray& ray = queue.rays[std::size_t(queue.count++)];
    ray.origin = aim.from;
    ray.direction = aim.centre.direction;
    ray.length_m = aim.length_m;
    ray.ownTriangle = m_receivers.triangle[i];
    ray.instances = castersOf(m_receivers.instance[i]);
    if (queue.count == RayBundle::kSize) flush(queue);
}

/// One ray tells both whether the light is seen and what is in the way.
void ShadowRows::flush(Queue& queue) {
    if (queue.count == 0) return;
    RayScene::Blockers found;
    m_rays.nearest(queue.rays.data(), queue.count, found);
    for (std::size_t k = 0; k < std::size_t(queue.count); ++k) {
        const std::size_t i = queue.pixels[k];
        if (found.triangle[k] != kNoHit)
            keepBlocker(i, found.triangle[k], found.distance_m[k]);
        else
            m_truth.visibility[i] = m_truth.irradianceShare[i] = 1;
    }
    queue.count = 0;
}

}  // namespace ombrage
