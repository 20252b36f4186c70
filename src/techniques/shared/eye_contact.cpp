// SPDX-License-Identifier: MIT
#include "techniques/shared/eye_contact.h"

#include <cmath>

#include "render/frame_context.h"
#include "techniques/shared/shadow_volume.h"

namespace ombrage {

namespace {

/// Whether a triangle of the instance may pass before the near plane, where the picture does not show it. Never false
/// for one that does.
bool touchesEye(const FrameContext& frame, std::size_t instance) {
    const glm::vec3& eye = frame.view.eye;
    const float reach_m = frame.view.nearReach_m();
    if (!frame.gpuScene->isWithin(instance, eye, reach_m)) return false;
    const FlatScene& flat = frame.gpuScene->flat();
    const FlatInstance& range = flat.instances[instance];
    for (std::uint32_t t = 0; t < range.triangleCount; ++t) {
        const glm::uvec3& v = flat.triangles[range.firstTriangle + t];
        const glm::vec3 &a = flat.positions[v.x], &b = flat.positions[v.y], &c = flat.positions[v.z];
        // In its bounds, and not far from its plane.
        const glm::vec3 lower = glm::min(a, glm::min(b, c)) - reach_m, upper = glm::max(a, glm::max(b, c)) + reach_m;
        if (glm::any(glm::lessThan(eye, lower)) || glm::any(glm::greaterThan(eye, upper))) continue;
        const glm::vec3 normal = glm::cross(b - a, c - a);
        if (std::abs(glm::dot(normal, eye - a)) <= reach_m * glm::length(normal)) return true;
    }
    return false;
}

/// Whether the eye lies on the border of the instance's volume.
bool isOnBorder(const FrameContext& frame, const LightFrame& light, std::size_t instance) {
    const GpuScene& gpuScene = *frame.gpuScene;
    if (!gpuScene.isOnTheWay(instance, frame.view.eye, light.toward())) return false;
    const int mesh = gpuScene.flat().instances[instance].mesh;
    const glm::dmat4 localFromWorld = glm::inverse(gpuScene.scene().instances[instance].worldFromLocal);
    const glm::dvec4 eye(glm::dvec3(frame.view.eye) + gpuScene.origin(), 1.0);
    return touchesEdge(gpuScene.derived<SceneTopology>().mesh(mesh), gpuScene.scene().meshes[std::size_t(mesh)],
                       localFromWorld * light.towardInWorld(), localFromWorld * eye);
}

}  // namespace

bool isAlphaTested(const FrameContext& frame, std::size_t instance) {
    const int material = frame.gpuScene->flat().instances[instance].material;
    return frame.gpuScene->scene().materials[std::size_t(material)].alphaMode == AlphaMode::Mask;
}

bool countsFromEye(const FrameContext& frame, const LightFrame& light, std::size_t instance) {
    return !isAlphaTested(frame, instance) && !touchesEye(frame, instance) && !isOnBorder(frame, light, instance);
}

}  // namespace ombrage
