// SPDX-License-Identifier: MIT
#include "reference/light_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ombrage {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

void basis(const glm::dvec3& n, glm::dvec3& t, glm::dvec3& b) {
    // Duff et al. 2017, "Building an orthonormal basis, revisited", equation 4.
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z);
    const double c = n.x * n.y * a;
    t = {1 + sign * n.x * n.x * a, sign * c, -sign * n.x};
    b = {c, sign + n.y * n.y * a, -n.y};
}

LightShape::LightShape(const Light& light, const glm::dvec3& origin)
    : m_light(light),
      m_position(light.position - origin),
      m_direction(glm::normalize(glm::dvec3(light.direction))),
      m_tangent(lightTangent(light)),
      m_bitangent(lightBitangent(light)),
      m_hasSize(light.hasSize()),
      m_cosInner(std::cos(double(light.inner_rad))),
      m_cosOuter(std::cos(double(light.outer_rad))) {}

double LightShape::spotFalloff(const glm::dvec3& fromLight) const {
    // Squared ramp of the cosine between the inner and the outer cone (KHR_lights_punctual).
    const double cosine = glm::dot(fromLight, m_direction);
    const double ramp = m_cosInner > m_cosOuter ? (cosine - m_cosOuter) / (m_cosInner - m_cosOuter)
                                                : (cosine >= m_cosOuter ? 1.0 : 0.0);
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

void LightShape::sampleCone(const glm::dvec3& axis, double oneMinusCos, const PolarSamples& samples,
                            LightBundle& found) const {
    // Uniform in solid angle. `oneMinusCos` of the half angle is kept apart because it loses all digits for small
    // cones.
    glm::dvec3 t, b;
    basis(axis, t, b);
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        const double height = double(samples.u[i]) * oneMinusCos;  // 1 - cos of the direction's angle
        const double sine = std::sqrt(height * (2 - height));
        const double x = double(samples.cosine[i]) * sine, y = double(samples.sine[i]) * sine, z = 1 - height;
        found.x[i] = axis.x * z + t.x * x + b.x * y;
        found.y[i] = axis.y * z + t.y * x + b.y * y;
        found.z[i] = axis.z * z + t.z * x + b.z * y;
    }
}

void LightShape::sampleSphere(const glm::dvec3& point, const PolarSamples& samples, LightBundle& found) const {
    const glm::dvec3 toCentre = m_position - point;
    const double distance2 = glm::dot(toCentre, toCentre), radius = m_light.radius_m, radius2 = radius * radius;
    const bool inside = distance2 <= radius2;
    // From within, the sphere fills all directions; from outside, a cone of sine radius / distance.
    const double sine2 = inside ? 0 : radius2 / distance2;
    const double oneMinusCos = inside ? 2 : sine2 / (1 + std::sqrt(1 - sine2));
    sampleCone(distance2 > 0 ? toCentre / std::sqrt(distance2) : glm::dvec3(0, 1, 0), oneMinusCos, samples, found);
    const double side = inside ? 1 : -1;
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        // Along the direction, the near side of the sphere, or its far side from within.
        const double along = toCentre.x * found.x[i] + toCentre.y * found.y[i] + toCentre.z * found.z[i];
        const double half = std::sqrt(std::max(0.0, radius2 - distance2 + along * along));
        found.distance_m[i] = std::max(0.0, along + side * half);
    }
    // Radiance I / (pi r^2) over the cone's solid angle 2 pi (1 - cos).
    found.irradiance.fill(double(m_light.intensity) / radius2 * 2 * oneMinusCos);
}

void LightShape::sampleArea(const glm::dvec3& point, const LightBundle::Lanes& right_m, const LightBundle::Lanes& up_m,
                            LightBundle& found) const {
    const glm::dvec3 toCentre = m_position - point;
    const bool isRect = m_light.type == LightType::Rect;
    const double area_m2 = isRect ? double(m_light.size_m.x) * double(m_light.size_m.y) : 1;
    found.facing = 0;
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        const glm::dvec3 to = toCentre + m_tangent * right_m[i] + m_bitangent * up_m[i];
        const double distance2 = glm::dot(to, to), distance_m = std::sqrt(distance2);
        // A receiver on the light has no direction there: any will do, none carries irradiance.
        const glm::dvec3 direction = distance_m > 0 ? to / distance_m : m_direction;
        const double cosine = -glm::dot(direction, m_direction);
        found.x[i] = direction.x;
        found.y[i] = direction.y;
        found.z[i] = direction.z;
        found.distance_m[i] = distance_m;
        found.facing |= std::uint32_t(cosine > 0) << i;
        const double towards = isRect ? std::max(cosine, 0.0) : spotFalloff(-direction);
        found.irradiance[i] = cosine > 0 ? double(m_light.intensity) * area_m2 * towards / distance2 : 0;
    }
}

void LightShape::sample(const glm::dvec3& point, const SampleSets& sets, int scrambling, int bundle,
                        const SampleSets::Move& move, LightBundle& found) const {
    LightBundle::Lanes right_m{}, up_m{};
    if (m_light.type == LightType::Rect) {
        SquareSamples samples;
        sets.square(scrambling, bundle, move, samples);
        for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
            right_m[i] = (double(samples.u[i]) - 0.5) * double(m_light.size_m.x);
            up_m[i] = (double(samples.v[i]) - 0.5) * double(m_light.size_m.y);
        }
        sampleArea(point, right_m, up_m, found);
        return;
    }

    PolarSamples samples;
    sets.polar(scrambling, bundle, move, samples);
    found.facing = 0xffffu;
    if (m_light.type == LightType::Sun) {
        const double quarterSine = std::sin(0.25 * double(m_light.angle_rad));
        sampleCone(-m_direction, 2 * quarterSine * quarterSine, samples, found);
        found.distance_m.fill(kInfinity);
        found.irradiance.fill(m_light.intensity);
    } else if (m_light.type == LightType::Point) {
        sampleSphere(point, samples, found);
    } else {
        // The disk of a spot, uniform in area.
        for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
            const double r = std::sqrt(double(samples.u[i])) * double(m_light.radius_m);
            right_m[i] = r * double(samples.cosine[i]);
            up_m[i] = r * double(samples.sine[i]);
        }
        sampleArea(point, right_m, up_m, found);
    }
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
