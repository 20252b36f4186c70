// SPDX-License-Identifier: MIT
#include "techniques/shared/light_region.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

namespace {

/// One pixel more on every side than the corners' projection says, which is rounded.
constexpr int kMargin_px = 1;

float depthAt(const CameraView& view, float viewDepth_m) {
    if (view.orthographic) return 1.0f - (viewDepth_m - view.near_m) / (view.far_m - view.near_m);
    return view.near_m / viewDepth_m;
}

}  // namespace

LightRegion::LightRegion(const CameraView& view, const LightFrame& light) {
    const float range_m = light.light->range_m;
    if (light.light->type == LightType::Sun || !std::isfinite(range_m)) return;

    // Depths first: between the sphere's nearest and farthest point.
    const float middle_m = glm::dot(light.position - view.eye, view.forward);
    const float nearest_m = middle_m - range_m, farthest_m = middle_m + range_m;
    if (farthest_m <= view.near_m) {
        empty = true;
        return;
    }
    depthBounds = glm::vec2(depthAt(view, farthest_m * 1.0001f),
                            nearest_m <= view.near_m ? 1.0f : depthAt(view, nearest_m * 0.9999f));
    depthBounds = glm::clamp(*depthBounds, 0.0f, 1.0f);
    if (!view.orthographic && nearest_m <= view.near_m) return;  // part of it is beside or behind the eye

    // The box around the sphere, along the camera's axes: its corners bound its projection.
    glm::vec2 lower(2.0f), upper(-2.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p = light.position + range_m * ((corner & 1 ? 1.0f : -1.0f) * view.right +
                                                        (corner & 2 ? 1.0f : -1.0f) * view.up +
                                                        (corner & 4 ? 1.0f : -1.0f) * view.forward);
        const glm::vec4 clip = view.clipFromWorld * glm::vec4(p, 1.0f);
        lower = glm::min(lower, glm::vec2(clip) / clip.w);
        upper = glm::max(upper, glm::vec2(clip) / clip.w);
    }
    const auto pixel = [](float ndc, int size) { return (double(std::clamp(ndc, -1.0f, 1.0f)) * 0.5 + 0.5) * size; };
    const int left = std::max(0, int(std::floor(pixel(lower.x, view.width))) - kMargin_px),
              bottom = std::max(0, int(std::floor(pixel(lower.y, view.height))) - kMargin_px),
              right = std::min(view.width, int(std::ceil(pixel(upper.x, view.width))) + kMargin_px),
              top = std::min(view.height, int(std::ceil(pixel(upper.y, view.height))) + kMargin_px);
    empty = upper.x < -1 || lower.x > 1 || upper.y < -1 || lower.y > 1;
    scissor = gl::DrawState::Rect{left, bottom, right - left, top - bottom};
}

}  // namespace ombrage
