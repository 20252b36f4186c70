// SPDX-License-Identifier: MIT
#include "reference/ray_filters.h"

#include <algorithm>
#include <cmath>

namespace ombrage {
namespace {

/// Whether the ray meets the triangle farther than `onPlane_m` away, in double precision from vertices as they are.
bool meetsBeyond(const FlatScene& flat, std::uint32_t triangle, const Ray& ray, double onPlane_m) {
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::dvec3 a(flat.positions[t.x]), b(flat.positions[t.y]), c(flat.positions[t.z]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double distance_m = glm::dot(n, a - ray.origin) / glm::dot(n, ray.direction);
    if (!(distance_m > onPlane_m)) return false;
    // Inside to a billionth of its heights: beside a convex edge the neighbour's plane is met outside the neighbour.
    const glm::dvec3 p = ray.origin + ray.direction * distance_m;
    const double least = std::min({glm::dot(n, glm::cross(c - b, p - b)), glm::dot(n, glm::cross(a - c, p - c)),
                                   glm::dot(n, glm::cross(b - a, p - a))});
    return least >= -1e-9 * glm::dot(n, n);
}

/// Whether the point is a hole of a cut-out material.
bool isHoleAt(const RayContext& context, std::uint32_t triangle, float u, float v) {
    const FlatScene& flat = *context.flat;
    const auto& instance = flat.instances[flat.triangleInstance[triangle]];
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::vec2 uv = (1 - u - v) * flat.uvs[t.x] + u * flat.uvs[t.y] + v * flat.uvs[t.z];
    return isHole(*context.scene, context.scene->materials[std::size_t(instance.material)], uv);
}

/// Whether a triangle comes nearer to the point than `radius_m`; in doubt it does.
bool comesNear(const FlatScene& flat, std::uint32_t triangle, const glm::dvec3& point, double radius_m) {
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::dvec3 a(flat.positions[t.x]), b(flat.positions[t.y]), c(flat.positions[t.z]);
    const glm::dvec3 lower = glm::min(a, glm::min(b, c)) - radius_m, upper = glm::max(a, glm::max(b, c)) + radius_m;
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < lower[axis] || point[axis] > upper[axis]) return false;
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    if (!(length > 0)) return true;
    if (std::abs(glm::dot(n, point - a)) > radius_m * length) return false;
    // Farther outside an edge, in the plane, than the radius.
    const auto outside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 inward = glm::cross(n, to - from);
        return glm::dot(inward, point - from) < -radius_m * glm::length(inward);
    };
    return !outside(a, b) && !outside(b, c) && !outside(c, a);
}

}  // namespace

void filterHoles(const RTCFilterFunctionNArguments* args) {
    const auto& context = *reinterpret_cast<const RayContext*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const std::uint32_t triangle =
            context.triangleOf(RTCHitN_geomID(args->hit, args->N, i), RTCHitN_primID(args->hit, args->N, i));
        if (isHoleAt(context, triangle, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i)))
            args->valid[i] = 0;
    }
}

void filterHits(const RTCFilterFunctionNArguments* args) {
    const auto& context = *reinterpret_cast<const RayContext*>(args->context);
    const FlatScene& flat = *context.flat;
    const unsigned n = args->N;
    int* valid = args->valid;
    for (unsigned i = 0; i < n; ++i) {
        if (valid[i] == 0) continue;
        // The receiver's own triangle, which most rays leave from.
        const Ray& ray = context.rays[RTCRayN_id(args->ray, n, i)];
        const std::uint32_t triangle =
            context.triangleOf(RTCHitN_geomID(args->hit, n, i), RTCHitN_primID(args->hit, n, i));
        if (triangle == ray.ownTriangle) {
            valid[i] = 0;
            continue;
        }

        // Instances that this ray does not see.
        bool counts = !ray.instances || (*ray.instances)[flat.triangleInstance[triangle]];

        // The float origin may lie a rounding error behind its surface and then meets the neighbours in the same plane.
        // A second look in double tells them from a true blocker, however near that is.
        const float distance_m = RTCRayN_tfar(args->ray, n, i);
        if (counts && distance_m < context.recheckBelow_m)
            counts = meetsBeyond(flat, triangle, ray, double(context.recheckBelow_m) * 1e-9);

        // A hit that is only counted is refused as well, so that the ray goes on.
        if (counts && context.crossed) context.crossed->emplace_back(triangle, distance_m);
        if (!counts || context.crossed) valid[i] = 0;
    }
}

bool seeNear(RTCPointQueryFunctionArguments* args) {
    auto& query = *static_cast<NearQuery*>(args->userPtr);
    if (query.found) return false;
    const std::uint32_t triangle = query.context->triangleOf(args->geomID, args->primID);
    query.found =
        triangle != query.ownTriangle && comesNear(*query.context->flat, triangle, query.point, query.radius_m);
    return false;
}

}  // namespace ombrage
