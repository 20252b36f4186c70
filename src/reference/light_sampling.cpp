// SPDX-License-Identifier: MIT
#include "reference/light_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Direction in the cone about `axis`, uniform in solid angle. `oneMinusCos` of the half angle, kept apart because it
/// loses all digits for small cones.
glm::dvec3 coneDirection(const glm::dvec3& axis, double oneMinusCos, glm::vec2 u) {
    glm::dvec3 t, b;
    basis(axis, t, b);
    const double height = double(u.x) * oneMinusCos;  // 1 - cos of the direction's angle
    const double sine = std::sqrt(std::max(0.0, height * (2 - height)));
    const double phi = 2 * kPi * double(u.y);
    return glm::normalize(axis * (1 - height) + (t * std::cos(phi) + b * std::sin(phi)) * sine);
}

/// Point of the unit disk, uniform in area.
glm::dvec2 diskPoint(glm::vec2 u) {
    const double r = std::sqrt(double(u.x)), phi = 2 * kPi * double(u.y);
    return {r * std::cos(phi), r * std::sin(phi)};
}

}  // namespace

void basis(const glm::dvec3& n, glm::dvec3& t, glm::dvec3& b) {
    // Duff et al. 2017, "Building an orthonormal basis, revisited", equation 4.
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z);
    const double c = n.x * n.y * a;
    t = {1 + sign * n.x * n.x * a, sign * c, -sign * n.x};
    b = {c, sign + n.y * n.y * a, -n.y};
}

glm::dvec3 cosineDirection(const glm::dvec3& n, glm::vec2 u) {
    // A uniform disk point lifted to the sphere is cosine-weighted (Malley).
    glm::dvec3 t, b;
    basis(n, t, b);
    const glm::dvec2 d = diskPoint(u);
    return glm::normalize(t * d.x + b * d.y + n * std::sqrt(std::max(0.0, 1 - double(u.x))));
}

LightShape::LightShape(const Light& light, const glm::dvec3& origin)
    : m_light(light),
      m_position(light.position - origin),
      m_direction(glm::normalize(glm::dvec3(light.direction))),
      m_tangent(lightTangent(light)),
      m_bitangent(lightBitangent(light)),
      m_hasSize(light.hasSize()) {}

double LightShape::spotFalloff(const glm::dvec3& fromLight) const {
    // Squared ramp of the cosine between the inner and the outer cone (KHR_lights_punctual).
    const double cosine = glm::dot(fromLight, m_direction);
    const double inner = std::cos(double(m_light.inner_rad)), outer = std::cos(double(m_light.outer_rad));
    const double ramp = inner > outer ? (cosine - outer) / (inner - outer) : (cosine >= outer ? 1.0 : 0.0);
    const double t = std::clamp(ramp, 0.0, 1.0);
    return t * t;
}

LightSample LightShape::centre(const glm::dvec3& point) const {
    LightSample s;
    if (m_light.type == LightType::Sun) {
        s.direction = -m_direction;
        s.distance_m = kInfinity;
        s.irradiance = m_light.intensity;
        return s;
    }
    const glm::dvec3 toLight = m_position - point;
    s.distance_m = glm::length(toLight);
    // A receiver at the very centre has no direction: any will do, none carries irradiance.
    if (s.distance_m <= 0) return s;
    s.direction = toLight / s.distance_m;
    const double inverseSquare = 1 / (s.distance_m * s.distance_m);
    switch (m_light.type) {
        case LightType::Spot:
            s.irradiance = m_light.intensity * inverseSquare * spotFalloff(-s.direction);
            break;
        case LightType::Rect: {
            const double cosine = -glm::dot(s.direction, m_direction);
            const double area_m2 = double(m_light.size_m.x) * double(m_light.size_m.y);
            s.facing = cosine > 0;
            s.irradiance = m_light.intensity * area_m2 * std::max(cosine, 0.0) * inverseSquare;
            break;
        }
        default:
            s.irradiance = m_light.intensity * inverseSquare;
    }
    return s;
}

LightSample LightShape::sample(const glm::dvec3& point, glm::vec2 u) const {
    if (!m_hasSize) return centre(point);
    LightSample s;
    switch (m_light.type) {
        case LightType::Sun: {
            const double half = 0.5 * double(m_light.angle_rad);
            s.direction = coneDirection(-m_direction, 2 * std::sin(0.5 * half) * std::sin(0.5 * half), u);
            s.distance_m = kInfinity;
            s.irradiance = m_light.intensity;
            return s;
        }
        case LightType::Point: {
            const glm::dvec3 toCentre = m_position - point;
            const double distance2 = glm::dot(toCentre, toCentre), radius = m_light.radius_m, radius2 = radius * radius;
            const bool inside = distance2 <= radius2;
            // From within, the sphere fills all directions; from outside, a cone of sine radius / distance.
            const double sine2 = inside ? 0 : radius2 / distance2;
            const double oneMinusCos = inside ? 2 : sine2 / (1 + std::sqrt(1 - sine2));
            const glm::dvec3 axis = distance2 > 0 ? toCentre / std::sqrt(distance2) : glm::dvec3(0, 1, 0);
            s.direction = coneDirection(axis, oneMinusCos, u);
            // Along the direction, the near side of the sphere, or its far side from within.
            const double along = glm::dot(toCentre, s.direction);
            const double half = std::sqrt(std::max(0.0, radius2 - distance2 + along * along));
            s.distance_m = std::max(0.0, inside ? along + half : along - half);
            // Radiance I / (pi r^2) over the cone's solid angle 2 pi (1 - cos).
            s.irradiance = m_light.intensity / radius2 * 2 * oneMinusCos;
            return s;
        }
        default:
            break;
    }

    // A point on the rect or the disk.
    glm::dvec2 offset = m_light.type == LightType::Rect ? glm::dvec2(u) - 0.5 : diskPoint(u);
    offset *= m_light.type == LightType::Rect ? glm::dvec2(m_light.size_m) : glm::dvec2(m_light.radius_m);
    const glm::dvec3 toLight = m_position + m_tangent * offset.x + m_bitangent * offset.y - point;
    s.distance_m = glm::length(toLight);
    if (s.distance_m <= 0) return s;
    s.direction = toLight / s.distance_m;
    const double cosine = -glm::dot(s.direction, m_direction);
    s.facing = cosine > 0;
    const double inverseSquare = 1 / (s.distance_m * s.distance_m);
    if (m_light.type == LightType::Rect)
        s.irradiance = m_light.intensity * double(m_light.size_m.x) * double(m_light.size_m.y) * std::max(cosine, 0.0) *
                       inverseSquare;
    else
        s.irradiance = m_light.intensity * inverseSquare * spotFalloff(-s.direction);
    return s;
}

Mask LightShape::mask(const glm::dvec3& point, const glm::dvec3& normal) const {
    if (m_light.type == LightType::Sun) {
        // The sun's upper rim stands half its angle above its centre.
        const double rim = m_hasSize ? std::sin(0.5 * double(m_light.angle_rad)) : 0;
        return glm::dot(normal, -m_direction) + rim > 0 ? Mask::Valid : Mask::BelowHorizon;
    }
    const glm::dvec3 toLight = m_position - point;
    if (glm::length(toLight) > double(m_light.range_m)) return Mask::OutOfRange;
    const double height = glm::dot(normal, toLight);  // of the centre above the tangent plane
    const double front = -glm::dot(toLight, m_direction);

    if (m_light.type == LightType::Point)
        return height + double(m_light.radius_m) > 0 ? Mask::Valid : Mask::BelowHorizon;

    if (m_light.type == LightType::Spot) {
        // The part of the disk nearest to the receiver's side sees it under the smallest angle to the axis.
        const double radius = m_light.radius_m;
        const double aside = std::sqrt(std::max(0.0, glm::dot(toLight, toLight) - front * front));
        const double angle = std::atan2(std::max(0.0, aside - radius), front);
        if (angle > double(m_light.outer_rad)) return Mask::OutOfRange;
        const double along = glm::dot(normal, m_direction);
        const double highest = height + radius * std::sqrt(std::max(0.0, 1 - along * along));
        // A hard spot is a point and has no back.
        return highest > 0 && (front > 0 || !m_hasSize) ? Mask::Valid : Mask::BelowHorizon;
    }

    const double highest = height + 0.5 * (std::abs(glm::dot(normal, m_tangent)) * double(m_light.size_m.x) +
                                           std::abs(glm::dot(normal, m_bitangent)) * double(m_light.size_m.y));
    return highest > 0 && front > 0 ? Mask::Valid : Mask::BelowHorizon;
}

}  // namespace ombrage
