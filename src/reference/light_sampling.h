// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <ombrage/reference.h>
#include <ombrage/scene.h>

#include "reference/sample_sets.h"

namespace ombrage {

/// One direction towards a light.
struct LightSample {
    glm::dvec3 direction{0, 1, 0};  ///< unit, from the receiver
    double distance_m = 0;          ///< to the light's surface; +inf for suns
    double irradiance = 0;          ///< of a surface that faces the direction, per unit of colour, if the whole light
                                    ///< shone as this sample does: the mean over samples times cosines is lx
    bool facing = true;             ///< the receiver sees the lit side there
};

/// Directions towards sixteen parts of a light; as LightSample, field by field.
struct LightBundle {
    using Lanes = std::array<double, RayBundle::kSize>;
    alignas(64) Lanes x{}, y{}, z{};
    alignas(64) Lanes distance_m{}, irradiance{};
    std::uint32_t facing = 0;  ///< one bit each
};

/// The shape of one light seen from receivers, in the space moved by an origin. Sphere lights and the sun are uniform
/// in the solid angle of their cone, rects and the disk of a spot uniform in area and lit on one side (design section
/// 6).
class LightShape {
public:
    LightShape(const Light& light, const glm::dvec3& origin);

    bool hasSize() const { return m_hasSize; }

    /// Every point sees its centre in the same direction, and position does not matter to mask() either.
    bool isDirectional() const { return m_light.type == LightType::Sun; }

    /// The light's centre; irradiance as if all light came from there.
    LightSample centre(const glm::dvec3& point) const;

    /// Parts of a light that has a size.
    void sample(const glm::dvec3& point, const SampleSets& sets, int scrambling, int bundle,
                const SampleSets::Move& move, LightBundle& found) const;

    /// OutOfRange beyond range_m or wholly outside a spot's cone; BelowHorizon when the whole light is below the
    /// tangent plane or shows its back; else Valid.
    Mask mask(const glm::dvec3& point, const glm::dvec3& normal) const;

private:
    void sampleCone(const glm::dvec3& axis, double oneMinusCos, const PolarSamples& samples, LightBundle& found) const;
    void sampleSphere(const glm::dvec3& point, const PolarSamples& samples, LightBundle& found) const;
    void sampleArea(const glm::dvec3& point, const LightBundle::Lanes& right_m, const LightBundle::Lanes& up_m,
                    LightBundle& found) const;
    double spotFalloff(const glm::dvec3& fromLight) const;

    const Light& m_light;
    glm::dvec3 m_position;
    glm::dvec3 m_direction;
    glm::dvec3 m_tangent, m_bitangent;
    bool m_hasSize;
    double m_cosInner, m_cosOuter;  ///< of a spot's cones
};

/// Two unit vectors that complete `n` to an orthonormal basis.
void basis(const glm::dvec3& n, glm::dvec3& t, glm::dvec3& b);

}  // namespace ombrage
