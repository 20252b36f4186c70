// SPDX-License-Identifier: MIT
#include "scene/camera_view.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

namespace ombrage {

namespace {
constexpr double kSmallestNear_m = 1e-4;
constexpr double kLargestNear_m = 1e-2;
constexpr double kNearShare = 1e-4;

/// A unit vector perpendicular to `forward` on the side of `up`; another axis where the two are parallel.
glm::dvec3 rightOf(const glm::dvec3& forward, const glm::dvec3& up) {
    const glm::dvec3 right = glm::cross(forward, up);
    if (glm::length(right) > 1e-6 * std::max(glm::length(up), 1e-30)) return glm::normalize(right);
    const glm::dvec3 axis = std::abs(forward.y) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(forward, axis));
}

/// Distance of the farthest corner of the bounds along the forward axis.
double farthestCorner(const Bounds& bounds, const glm::dvec3& position, const glm::dvec3& forward) {
    double farthest = 0.0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? bounds.upper.x : bounds.lower.x, i & 2 ? bounds.upper.y : bounds.lower.y,
                                i & 4 ? bounds.upper.z : bounds.lower.z);
        farthest = std::max(farthest, glm::dot(corner - position, forward));
    }
    return farthest;
}
}  // namespace

CameraView makeCameraView(const Camera& camera, int width, int height, const glm::dvec3& origin, const Bounds& bounds) {
    const glm::dvec3 toTarget = camera.target - camera.position;
    const double targetDistance = glm::length(toTarget);
    if (!(targetDistance > 0.0) || !std::isfinite(targetDistance))
        throw Error(ErrorCode::Usage, "camera '" + camera.name + "' looks at its own position",
                    "give it a target away from its position");

    CameraView view;
    view.width = width;
    view.height = height;
    view.orthographic = camera.orthoHeight_m.has_value();
    const double near_m = std::clamp(kNearShare * bounds.diagonal(), kSmallestNear_m, kLargestNear_m);
    view.near_m = float(near_m);

    // The axes: right-handed, the camera looks along -z of its view space.
    const glm::dvec3 eye = camera.position - origin;
    const glm::dvec3 forward = toTarget / targetDistance;
    const glm::dvec3 right = rightOf(forward, glm::dvec3(camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    view.eye = glm::vec3(eye);
    view.forward = glm::vec3(forward);
    view.right = glm::vec3(right);
    view.up = glm::vec3(up);

    glm::dmat4 viewFromWorld(1.0);
    for (int i = 0; i < 3; ++i) {
        viewFromWorld[i][0] = right[i];
        viewFromWorld[i][1] = up[i];
        viewFromWorld[i][2] = -forward[i];
    }
    viewFromWorld[3] = glm::dvec4(-glm::dot(right, eye), -glm::dot(up, eye), glm::dot(forward, eye), 1.0);
    const glm::dmat4 worldFromView(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(-forward, 0),
                                   glm::dvec4(eye, 1));

    glm::dmat4 clipFromView(0.0);
    const double aspect = double(width) / double(height);
    if (view.orthographic) {
        // Depth 1 at the near plane, 0 behind the farthest corner of the scene.
        const double halfHeight = 0.5 * double(*camera.orthoHeight_m);
        const double far_m =
            std::max(2.0 * near_m, 1.01 * (bounds.empty() ? 0.0 : farthestCorner(bounds, camera.position, forward)));
        clipFromView[0][0] = 1.0 / (halfHeight * aspect);
        clipFromView[1][1] = 1.0 / halfHeight;
        clipFromView[2][2] = 1.0 / (far_m - near_m);
        clipFromView[3][2] = far_m / (far_m - near_m);
        clipFromView[3][3] = 1.0;
        view.far_m = float(far_m);
        view.orthoHeight_m = *camera.orthoHeight_m;
    } else {
        // Reversed z, infinite far plane: clip z = near, clip w = -z_view.
        const double tanHalf = std::tan(0.5 * double(camera.fovY_rad));
        clipFromView[0][0] = 1.0 / (tanHalf * aspect);
        clipFromView[1][1] = 1.0 / tanHalf;
        clipFromView[2][3] = -1.0;
        clipFromView[3][2] = near_m;
        view.tanHalfFovY = float(tanHalf);
    }
    view.viewFromWorld = glm::mat4(viewFromWorld);
    view.worldFromView = glm::mat4(worldFromView);
    view.clipFromView = glm::mat4(clipFromView);
    view.clipFromWorld = glm::mat4(clipFromView * viewFromWorld);
    return view;
}

CameraView jittered(const CameraView& view, const glm::dvec2& offset_px) {
    if (offset_px == glm::dvec2(0)) return view;
    CameraView moved = view;
    // The offset on the plane at view depth 1 (orthographic: in metres).
    const double height = view.orthographic ? double(view.orthoHeight_m) : 2.0 * double(view.tanHalfFovY);
    const glm::dvec2 shift = offset_px * height / double(view.height);
    const glm::dvec3 aside = glm::dvec3(view.right) * shift.x + glm::dvec3(view.up) * shift.y;
    glm::dmat4 movedFromView(1.0), viewFromMoved(1.0);
    const int column = view.orthographic ? 3 : 2;
    const double sign = view.orthographic ? -1.0 : 1.0;
    for (int i = 0; i < 2; ++i) {
        movedFromView[column][i] = sign * shift[i];
        viewFromMoved[column][i] = -sign * shift[i];
    }
    if (view.orthographic)
        moved.eye = glm::vec3(glm::dvec3(view.eye) + aside);
    else
        moved.forward = glm::vec3(glm::dvec3(view.forward) + aside);
    const glm::dmat4 viewFromWorld = movedFromView * glm::dmat4(view.viewFromWorld);
    moved.viewFromWorld = glm::mat4(viewFromWorld);
    moved.worldFromView = glm::mat4(glm::dmat4(view.worldFromView) * viewFromMoved);
    moved.clipFromWorld = glm::mat4(glm::dmat4(view.clipFromView) * viewFromWorld);
    return moved;
}

void CameraView::ray(double px, double py, glm::dvec3& start, glm::dvec3& direction) const {
    const double aspect = double(width) / double(height);
    const double x = (2.0 * px / width - 1.0) * aspect;
    const double y = 1.0 - 2.0 * py / height;
    if (orthographic) {
        const double half = 0.5 * double(orthoHeight_m);
        start = glm::dvec3(eye) + glm::dvec3(right) * (x * half) + glm::dvec3(up) * (y * half);
        direction = glm::normalize(glm::dvec3(forward));
    } else {
        const double tanHalf = double(tanHalfFovY);
        start = glm::dvec3(eye);
        direction =
            glm::normalize(glm::dvec3(forward) + glm::dvec3(right) * (x * tanHalf) + glm::dvec3(up) * (y * tanHalf));
    }
}

float CameraView::pixelSize(float viewDepth_m) const {
    return orthographic ? orthoHeight_m / float(height) : 2.0f * tanHalfFovY * viewDepth_m / float(height);
}

}  // namespace ombrage
