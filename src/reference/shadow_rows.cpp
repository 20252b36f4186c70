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

/// The ray from a point to the light's centre, ending just before it.
Ray rayTo(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>* casters) {
    Ray ray;
    ray.origin = point.position;
    ray.direction = s.direction;
    ray.length_m = rays.lengthTo_m(s.distance_m);
    ray.ownTriangle = point.triangle;
    ray.instances = casters;
    return ray;
}

}  // namespace

bool isSeen(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>* casters) {
    // Parts below the geometric horizon and parts that turn their back count as blocked.
    return s.facing && glm::dot(s.direction, point.normal) > 0 && !rays.occluded(rayTo(rays, point, s, casters));
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
        // What a hard shadow would tell.
        if (truth.mask == Mask::Valid) m_truth.centreSeen[i] = isSeen(m_rays, point, centre, casters);
    }
}

/// What the pixels of a band have in common. Far from all, a sun stands the same everywhere: what depends on a normal
/// alone holds as long as the normal does, and a pixel that turns away has no use for its own position.
struct ShadowRows::Band {
    SurfacePoints points;
    bool isFar;
    Aim aim;
    Queue queue{};
    double cosine = 0;
    Mask mask = Mask::Valid;
    float irradiance = 0;
    glm::vec3 shadingNormal{0.0f};  ///< that the irradiance belongs to
};

void ShadowRows::hard(int band) {
    const glm::dvec3 anywhere(0.0);
    const LightSample centre = m_shape.centre(anywhere);
    Band b{{m_flat, m_receivers, m_rays.positionError_m(0)},
           m_shape.isDirectional(),
           Aim{anywhere, centre, m_rays.lengthTo_m(centre.distance_m)}};
    // In square tiles, so that the rays of a packet stay near each other.
    const int top = band * kBand, bottom = std::min(top + kBand, m_receivers.height);
    for (int left = 0; left < m_receivers.width; left += kBand) {
        const int right = std::min(left + kBand, m_receivers.width);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(m_receivers.width) + std::size_t(x);
                if (m_receivers.triangle[i] != kNoHit) hardPixel(i, b);
            }
    }
    flush(b.queue);
}

void ShadowRows::hardPixel(std::size_t i, Band& b) {
    const bool turns = b.points.turnTo(i);
    if (!b.isFar) {
        b.aim.from = b.points.position();
        b.aim.centre = m_shape.centre(b.aim.from);
        b.aim.length_m = m_rays.lengthTo_m(b.aim.centre.distance_m);
        m_truth.lightDistance_m[i] = float(b.aim.centre.distance_m);
    }
    if (turns || !b.isFar) {
        b.cosine = glm::dot(b.aim.centre.direction, b.points.normal());
        b.mask = m_shape.mask(b.aim.from, b.points.normal());
    }
    m_truth.cosine[i] = float(b.cosine);

    const Asks asks = m_asks[m_receivers.instance[i]];
    m_truth.mask[i] = asks == Asks::Shadow ? b.mask : Mask::NotReceiving;
    // Dark until its ray arrives.
    if (asks == Asks::Shadow) m_truth.visibility[i] = m_truth.irradianceShare[i] = 0;
    if (b.mask != Mask::Valid || asks == Asks::Excluded) return;
    if (!b.isFar || m_receivers.shadingNormal[i] != b.shadingNormal) {
        b.shadingNormal = m_receivers.shadingNormal[i];
        b.irradiance = irradianceOf(b.aim.centre, b.points.shadingNormal());
    }
    m_truth.irradiance[i] = b.irradiance;
    if (asks != Asks::Shadow || !b.aim.centre.facing || !(b.cosine > 0)) return;
    if (b.isFar) b.aim.from = b.points.position();
    enqueue(i, b.aim, b.queue);
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

void ShadowRows::flush(Queue& queue) {
    if (queue.count == 0) return;
    const std::uint32_t blocked = m_rays.occluded(queue.rays.data(), queue.count);
    for (int k = 0; k < queue.count; ++k) {
        const std::size_t i = queue.pixels[std::size_t(k)];
        if (!(blocked >> k & 1u)) m_truth.visibility[i] = m_truth.irradianceShare[i] = 1;
    }
    queue.count = 0;
}

}  // namespace ombrage
