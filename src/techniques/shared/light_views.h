// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "gl/shader_library.h"
#include "render/frame_context.h"

namespace ombrage {

/// How the views of a light share the directions about it.
enum class LightShape {
    Usual,        ///< one view of a sun and of a spot, six square ones of other lights
    Paraboloids,  ///< a point light's halves, up and down: xy / (1 + z) of the unit direction, depth near/d for the
                  ///< distance d from the light
    Tetrahedron  ///< a point light's four faces of a tetrahedron, sheared into halves of two squares
};

/// One picture taken from a light. Depth is reversed: perspective near/d for the distance d along `forward`, infinite
/// far plane; orthographic (far - d)/(far - near). Nearer than `near_m` is clamped, not clipped.
struct LightView {
    glm::vec3 origin{0.0f};  ///< the light, or a point on the near side of an orthographic view; in the moved world
    glm::vec3 right{1, 0, 0}, up{0, 1, 0},
        forward{0, 0, -1};       ///< unit, orthogonal; a tetrahedron's first two are neither
    glm::vec2 halfExtent{1.0f};  ///< metres for an orthographic view, tangents for a perspective one
    float near_m = 0.01f;
    float far_m = 1.0f;  ///< orthographic only
    bool operator==(const LightView&) const = default;
};

/// All the views that one light needs: 1 for a sun (fitted orthographic) and a spot, 6 for a point light, which may
/// have 2 or 4 of other shapes instead.
struct LightViews {
    LightShape shape = LightShape::Usual;
    bool perspective = false;
    std::vector<LightView> views;
    bool operator==(const LightViews&) const = default;

    glm::mat4 clipFromWorld(std::size_t view) const;  ///< not of paraboloids

    /// Of the map: one for each view, but for a tetrahedron, of which two share one.
    int layers() const { return int(shape == LightShape::Tetrahedron ? views.size() / 2 : views.size()); }

    /// Size of a texel of a square map, for the measurement.
    TexelFootprint footprint(int resolution) const;

    /// What the views show. @param origin of the moved world
    ShadowRange range(const glm::dvec3& origin) const;

    /// Sets the uniforms of shared/light_views.glsl.
    void setUniforms(const gl::Program& program) const;
    /// What the program that includes it is compiled for.
    std::vector<std::pair<std::string, std::string>> defines() const;
    /// As ShadowLookup::perPass, for lookups that need nothing else.
    static std::string perPass();
};

/// What an orthographic view covers.
enum class LightFit {
    Scene,  ///< everything that can cast: does not move with the camera
    View    ///< the part of it that can shade what the camera sees: finer, but moves with the camera
};

/// Views of a light. `margin` is how far beyond its quarter of the sphere a cube's face reaches, as a share of the
/// face: lookups beside a point near its border then stay in it. A spot wider than 75 degrees half angle and a rect get
/// the six views of a point light.
///
/// The sun's view leaves out of its extent (not out of its depths) flat instances that have all other geometry on the
/// lit side, such as a ground: nothing lies behind them, so nothing can be in their shadow.
///
/// @param shape other than Usual: of a light that has a position
LightViews makeLightViews(const FrameContext& frame, const LightFrame& light, LightFit fit, float margin = 0.0f,
                          LightShape shape = LightShape::Usual);

}  // namespace ombrage
