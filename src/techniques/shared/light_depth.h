// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "gl/objects.h"
#include "techniques/shared/light_views.h"

namespace ombrage {

/// The depth of the casters that one light sees, in a map (a layer for each of its views) that is kept while nothing in
/// it changes.
class LightDepth {
public:
    struct Options {
        int resolution = 1024;  ///< texels, width and height of each view
        LightFit fit = LightFit::Scene;
        GLenum cull = GL_NONE;  ///< as for drawLightDepth()
        bool keep = true;       ///< false: drawn anew by every update()
        bool compare = false;   ///< read through a shadow sampler: 1 where the reference is at least what the map holds
        bool operator==(const Options&) const = default;
    };

    /// Forgets everything; call when the scene changed.
    void reset();
    /// Casters may stand elsewhere; call from Technique::sceneMoved().
    void sceneMoved();

    /// Brings it up to date, in a pass of its own where there is something to draw.
    void update(FrameContext& frame, const LightFrame& light, const Options& options);

    /// What update() left: a 2D texture for one view, an array for more; DEPTH_COMPONENT32F.
    const gl::Texture& map() const { return m_map; }
    const LightViews& views() const { return *m_views; }
    std::uint64_t gpuBytes() const { return m_map ? gl::byteSize(m_map.desc()) : 0; }

private:
    /// What a light's views depend on beside the scene.
    struct Pose {
        LightType type = LightType::Sun;
        glm::vec3 position{0.0f}, direction{0.0f};
        float outer_rad = 0;
        bool operator==(const Pose&) const = default;
    };

    /// What the map holds.
    struct Drawn {
        LightViews views;
        Options options;
        std::vector<glm::mat4> casters;
    };

    void fitViews(const FrameContext& frame, const LightFrame& light, LightFit fit);
    bool holds(const FrameContext& frame, const Options& options) const;

    gl::Texture m_map;
    std::optional<LightViews> m_views;
    Pose m_pose;  ///< m_views were made for it, and for m_fit
    LightFit m_fit = LightFit::Scene;
    std::optional<Drawn> m_drawn;
    bool m_mayHaveMoved = false;  ///< casters, since the map was drawn
};

}  // namespace ombrage
