// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/technique.h"
#include "techniques/shared/light_depth.h"
#include "techniques/shared/moment_params.h"

namespace ombrage {

/// Statistics of the depths that one light sees, in a texture that may be filtered: blurred, with mipmaps, and kept
/// while nothing in it changes.
///
/// Depth is linear, z in [-1,1] from the nearest to the farthest of the scene: for a sun along its rays, for a lamp
/// along the view's axis between the near side and the farthest corner of the scene's bounds (or the lamp's range).
/// Scenes of any scale have the same z. Where nothing casts z is 1.
class MomentMap {
public:
    /// What is stored of a depth.
    struct Statistics {
        /// GLSL that defines `vec4 momentsOf(float z, int sheet)`, finite for z in [-1,1]; it may include the
        /// technique's params.
        std::string path;
        GLenum format = GL_RG32F;  ///< one that can be drawn into and filtered
        int sheets = 1;            ///< textures per view
        /// Values of the parameters that momentsOf() reads: others make the moments anew.
        std::vector<float> read;
        /// Sets uniforms that momentsOf() declares, in the passes of moments and blur and in lookups.
        std::function<void(const gl::Program&)> bind = {};
        bool logarithmic = false;  ///< `path` defines MOMENTS_LOG_EXPONENT
    };

    /// Forgets everything; call when the scene changed.
    void reset();
    /// Casters may stand elsewhere; call from Technique::sceneMoved().
    void sceneMoved() { m_depth.sceneMoved(); }

    /// Brings both up to date, in passes of their own where there is something to draw.
    void update(FrameContext& frame, Technique& technique, const LightFrame& light, const MomentMapParams& params,
                const Statistics& statistics);

    /// Its two halves, for statistics that depend on the depths. True when the depths were drawn anew.
    bool updateDepth(FrameContext& frame, const LightFrame& light, const MomentMapParams& params);
    void updateMoments(FrameContext& frame, Technique& technique, const MomentMapParams& params,
                       const Statistics& statistics);

    /// How lookups go on from there: `path` includes shared/moment_map.glsl. The map must outlive it.
    ShadowLookup lookup(const std::string& path) const;

    /// Offers "light-depth" and "moments" (level 0 of the first layer) to --show.
    void exposeTo(FrameContext& frame) const;

    /// The uniforms of shared/moment_range.glsl, for passes of the technique's own between the two halves.
    void setUniforms(const gl::Program& program) const;

    const LightDepth& depth() const { return m_depth; }
    /// What updateMoments() left: a 2D texture, or an array with layer view * sheets + sheet.
    const gl::Texture& moments() const { return m_moments; }
    /// Distances along the views' axes of z = -1 and z = 1.
    const glm::vec2& range_m() const { return m_range_m; }

    TexelFootprint footprint() const;
    ShadowRange shadowRange(const FrameContext& frame) const;
    std::uint64_t gpuBytes() const;

private:
    /// What the moments were made from.
    struct Made {
        std::uint64_t depths = 0;
        glm::vec2 range_m{0.0f};
        MomentBlur blur = MomentBlur::Gauss;
        int kernel_texels = 0;
        bool mipmaps = false;
        std::string path;
        std::vector<float> read;
        bool operator==(const Made&) const = default;
    };

    void makeTexture(const MomentMapParams& params, const Statistics& statistics);
    void drawMoments(FrameContext& frame, Technique& technique, const Statistics& statistics);
    void drawBlur(FrameContext& frame, Technique& technique, const Statistics& statistics,
                  const std::vector<float>& weights);
    void drawMipmaps(FrameContext& frame, Technique& technique, const Statistics& statistics);
    const gl::Program& program(FrameContext& frame, Technique& technique, const Statistics& statistics,
                               const char* fragmentPath,
                               std::vector<std::pair<std::string, std::string>> defines) const;
    void setUniforms(const gl::Program& program, const Statistics& statistics) const;
    static std::string perPass();
    std::vector<std::pair<std::string, std::string>> defines(int sheets) const;

    LightDepth m_depth;
    gl::Texture m_moments;
    std::optional<Made> m_made;
    Statistics m_statistics;
    glm::vec2 m_range_m{0.0f, 1.0f};
    int m_resolution = 1;
    float m_reach_texels = 0;
    float m_variance_texels = 0;  ///< of blur and bilinear lookup together
};

}  // namespace ombrage
