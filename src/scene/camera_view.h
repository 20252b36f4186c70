// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage {

/// A camera's matrices for one picture size, in the space moved by `origin` (see FlatScene).
/// Reversed-Z with an infinite far plane: depth = near / distance along the view axis for a perspective camera, 1 at
/// the near plane and 0 at infinity; orthographic depth is 1 - (distance - near)/(far - near).
struct CameraView {
    int width = 0, height = 0;
    bool orthographic = false;
    float near_m = 0.01f;
    /// Farther than this from the eye no point is before the near plane's corners, for a field of view up to 150
    /// degrees.
    float nearReach_m() const { return 4.0f * near_m; }
    float far_m = 0;              ///< orthographic only
    glm::vec3 eye{0.0f};          ///< relative to the origin
    glm::vec3 forward{0, 0, -1};  ///< unit
    glm::vec3 right{1, 0, 0};
    glm::vec3 up{0, 1, 0};
    float tanHalfFovY = 0.4663f;
    float orthoHeight_m = 0;
    glm::mat4 viewFromWorld{1.0f};  ///< "world" is the space moved by the origin
    glm::mat4 clipFromView{1.0f};
    glm::mat4 clipFromWorld{1.0f};
    glm::mat4 worldFromView{1.0f};

    /// Unit direction and start of the ray through a point of the picture; (0,0) is its top left corner, in pixels.
    void ray(double px, double py, glm::dvec3& start, glm::dvec3& direction) const;
    /// World size of a pixel at the given distance along the forward axis.
    float pixelSize(float viewDepth_m) const;
};

/// near_m is 1e-4 of the bounds' diagonal, kept within 0.1 mm and 1 cm: a reversed float depth loses nothing by it.
CameraView makeCameraView(const Camera& camera, int width, int height, const glm::dvec3& origin, const Bounds& bounds);

/// The same camera with its samples moved within the pixels, right and up, by an offset in pixels. View space is
/// sheared (a perspective one) or moved (an orthographic one) for it, so that everything made from the view agrees: the
/// ray through a pixel's centre, `forward` and the matrices are those of the moved sample. `forward` is then no unit
/// vector, by some 1e-6.
CameraView jittered(const CameraView& view, const glm::dvec2& offset_px);

}  // namespace ombrage
