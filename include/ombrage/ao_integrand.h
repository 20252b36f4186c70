// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace ombrage {

/// The surface point whose surroundings are asked for. Directions and offsets are in world space, metres.
struct AoReceiver {
    glm::dvec3 normal{0, 1, 0};         ///< n_g, unit, on the side seen
    glm::dvec3 shadingNormal{0, 1, 0};  ///< n_s, unit
    glm::dvec3 right{1, 0, 0};          ///< of the picture, unit
    glm::dvec3 up{0, 1, 0};             ///< of the picture, unit
    double sceneRadius_m = 0;           ///< the scene's ao_radius_m
    double sceneDiagonal_m = 0;         ///< of its bounds
};

/// What an integrand may ask of the scene at one receiver.
class AoProbe {
public:
    virtual ~AoProbe() = default;

    /// Distance from the receiver to the nearest surface along a unit direction; nothing within `length_m`.
    virtual std::optional<double> distanceTo(const glm::dvec3& direction, double length_m) const = 0;

    /// Offset from the receiver to the surface that the camera sees where it sees the point receiver + `offset`. Nothing
    /// where that is the sky, or where the point lies behind the eye. The picture has no border here.
    virtual std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const = 0;
};

/// The integral that a technique of ambient occlusion claims to compute: the question of the truth `own`. It lives in the
/// technique's folder and knows no OpenGL.
class AoIntegrand {
public:
    virtual ~AoIntegrand() = default;

    /// One sample: the mean over u, even in [0,1)^4, clamped to [0,1], is the visibility. Called from several threads.
    virtual double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const = 0;
};

}  // namespace ombrage
