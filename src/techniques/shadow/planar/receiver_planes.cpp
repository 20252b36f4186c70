// SPDX-License-Identifier: MIT
#include "techniques/shadow/planar/receiver_planes.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

namespace ombrage::planar {

ReceiverPlanes::ReceiverPlanes(const FlatScene& flat, PlanarSurfaces surfaces)
    : planes(std::move(surfaces.planes)), tolerance_m(float(planeTolerance_m(flat))) {
    empty =
        std::all_of(surfaces.planeOf.begin(), surfaces.planeOf.end(), [](std::uint8_t plane) { return plane == 0; });
    // Whole words, and never an empty buffer.
    surfaces.planeOf.resize((surfaces.planeOf.size() + 3) / 4 * 4 + 4);
    planeOf = gl::Buffer::from(surfaces.planeOf, "receiver planes");
}

ReceiverPlanes givenPlane(const FlatScene& flat, const glm::vec3& normal, float offset_m) {
    const double length = glm::length(glm::dvec3(normal));
    if (!(length > 0))
        throw Error(ErrorCode::Usage, "the normal of the plane that shadow/planar is given is 0",
                    "give a direction, as in normal=(0;1;0)");
    PlanarSurfaces surfaces;
    Plane plane;
    plane.normal = glm::dvec3(normal) / length;
    plane.offset_m = double(offset_m) - glm::dot(plane.normal, flat.origin);
    surfaces.planes = {plane};
    surfaces.planeOf.assign(flat.triangles.size(), 0);
    const double tolerance_m = planeTolerance_m(flat);
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
        if (liesIn(plane, flat, t, tolerance_m)) surfaces.planeOf[t] = 1;
    return {flat, std::move(surfaces)};
}

namespace {

std::optional<ActivePlane> activated(const FrameContext& frame, const LightFrame& light, const Plane& plane,
                                     float tolerance_m, const ClipRules& clip) {
    ActivePlane active;
    active.plane = glm::vec4(plane.normal, -plane.offset_m);
    const glm::vec4 toward = light.toward();
    active.lightHeight = glm::dot(active.plane, toward);
    if (active.lightHeight < 0) {
        active.plane = -active.plane;
        active.lightHeight = -active.lightHeight;
    }
    // A light in the plane grazes it.
    if (active.lightHeight <= (toward.w == 0.0f ? 1e-6f : tolerance_m)) return std::nullopt;

    const bool seen = frame.view.orthographic ? glm::dot(glm::vec3(active.plane), frame.view.forward) < 0
                                              : glm::dot(active.plane, glm::vec4(frame.view.eye, 1.0f)) > 0;
    const glm::vec3 lower = frame.gpuScene->casterLower(), upper = frame.gpuScene->casterUpper();
    float lowest_m = active.highest_m = active.plane.w;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax({active.plane[axis] * lower[axis], active.plane[axis] * upper[axis]});
        lowest_m += low;
        active.highest_m += high;
    }
    const bool casts = active.highest_m > tolerance_m || (!clip.atPlane && lowest_m < -tolerance_m);
    if (!seen || !casts) return std::nullopt;
    return active;
}

}  // namespace

std::vector<ActivePlane> activePlanes(const FrameContext& frame, const LightFrame& light,
                                      const ReceiverPlanes& receivers, int count, const ClipRules& clip) {
    std::vector<ActivePlane> active;
    for (int i = 0; i < std::min(count, int(receivers.planes.size())); ++i)
        if (auto plane = activated(frame, light, receivers.planes[std::size_t(i)], receivers.tolerance_m, clip)) {
            plane->id = i + 1;
            active.push_back(*plane);
        }
    return active;
}

}  // namespace ombrage::planar
