// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/objects.h"
#include "techniques/shared/light_views.h"

namespace ombrage {

/// What a map stores of a depth: integers of so many bits, or floats.
enum class DepthFormat { Unorm16, Unorm24, Float32 };

/// The depth of the casters that one light sees, in a map (a layer for each of its views) that is kept while nothing in
/// it changes. Where some casters move in frame after frame and others do not, a second map holds those that stand
/// still: it is copied, and those that move are drawn onto the copy.
class LightDepth {
public:
    struct Options {
        int resolution = 1024;  ///< texels, width and height of each view
        DepthFormat format = DepthFormat::Float32;
        LightFit fit = LightFit::Scene;
        /// How far lookups beside a point reach: cube faces overlap by so much, but by no more than a quarter of the
        /// resolution; LightDepth::margin_texels() is what they have.
        int margin_texels = 0;
        GLenum cull = GL_NONE;  ///< as for drawLightDepth()
        bool keep = true;       ///< false: drawn anew by every update()
        LightShape shape = LightShape::Usual;
        bool operator==(const Options&) const = default;
    };

    /// Forgets everything; call when the scene changed.
    void reset();
    /// Casters may stand elsewhere; call from Technique::sceneMoved().
    void sceneMoved();

    /// Brings it up to date, in a pass of its own where there is something to draw.
    void update(FrameContext& frame, const LightFrame& light, const Options& options);

    /// How often it was drawn: what is made of it is kept while this stays the same.
    std::uint64_t drawn() const { return m_drawnCount; }

    /// What update() left: a 2D texture for one view, an array for more. Lookups beyond its border find the farthest
    /// depth where the options have a margin.
    const gl::Texture& map() const { return m_map; }
    /// From now on it is read through a shadow sampler: 1 where the reference is at least what the map holds, of the
    /// nearest texel or of the four around the point.
    void setCompare(bool linear);
    /// Or as it is, as after update().
    void setPlain();

    const LightViews& views() const { return *m_views; }
    int margin_texels() const { return margin_texels(m_fitted); }
    /// What a program that includes shared/light_views.glsl for this map is compiled for.
    std::vector<std::pair<std::string, std::string>> defines() const;
    std::uint64_t gpuBytes() const {
        return (m_map ? gl::byteSize(m_map.desc()) : 0) + (m_still ? gl::byteSize(m_still->map.desc()) : 0);
    }

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

    /// The map of the casters that stand still.
    struct Still {
        gl::Texture map;
        std::vector<bool> instances;  ///< of the scene, that are in it
    };

    static int margin_texels(const Options& options);
    void draw(FrameContext& frame, const LightFrame& light, const std::vector<glm::mat4>& casters,
              const Options& options);
    bool drawStill(FrameContext& frame, const LightFrame& light, const std::vector<glm::mat4>& casters,
                   const Options& options);
    void forgetMotion();
    void fitViews(const FrameContext& frame, const LightFrame& light, const Options& options);
    void makeMap(const Options& options);
    bool holds(const FrameContext& frame, const Options& options) const;

    gl::Texture m_map;
    bool m_hasBorder = false;
    std::optional<bool> m_comparesLinear;  ///< as setCompare() left it
    std::optional<LightViews> m_views;
    Pose m_pose;  ///< m_views were made for it, and for m_fitted
    Options m_fitted;
    std::optional<Drawn> m_drawn;
    std::uint64_t m_drawnCount = 0;
    bool m_mayHaveMoved = false;  ///< casters, since the map was drawn
    std::vector<bool> m_moves;    ///< instances that moved of late; empty: none did
    int m_quietUpdates = 0;       ///< since one moved
    std::optional<Still> m_still;
};

}  // namespace ombrage
