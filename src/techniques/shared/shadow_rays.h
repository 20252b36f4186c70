// SPDX-License-Identifier: MIT
#pragma once

#include "render/frame_context.h"
#include "techniques/shared/gpu_bvh.h"

namespace ombrage {

/// Counts the pixels that a draw writes.
class PixelQuery {
public:
    PixelQuery() { glCreateQueries(GL_SAMPLES_PASSED, 1, &m_query); }
    ~PixelQuery() { glDeleteQueries(1, &m_query); }
    PixelQuery(const PixelQuery&) = delete;
    PixelQuery& operator=(const PixelQuery&) = delete;

    void begin() { glBeginQuery(GL_SAMPLES_PASSED, m_query); }
    void end() { glEndQuery(GL_SAMPLES_PASSED); }
    /// Waits for the draw.
    double pixels() const {
        GLuint64 count = 0;
        glGetQueryObjectui64v(m_query, GL_QUERY_RESULT, &count);
        return double(count);
    }

private:
    GLuint m_query = 0;
};

/// Visibility of one light by rays from every visible point through the scene's hierarchy.
class ShadowRays {
public:
    struct Options {
        int samples = 1;         ///< rays per pixel to a light of some size; hard lights take one
        bool sameModel = false;  ///< casters of the receiver's own scene model alone
        /// Defines for shared/shadow_rays.frag beside those of the technique's parameters; one of both sets PATTERN.
        std::vector<std::pair<std::string, std::string>> defines;
    };

    /// Forgets what depends on the scene.
    void reset() { m_instances = {}; }

    /// Records the pass "shadow rays" and, in frames that are read back, the counter "rays".
    void draw(FrameContext& frame, Technique& technique, const LightFrame& light, const gl::Texture& visibility,
              const Options& options);

    std::uint64_t gpuBytes() const { return m_bytes; }

private:
    PixelQuery m_query;
    gl::Buffer m_instances;
    std::uint64_t m_bytes = 0;
};

}  // namespace ombrage
