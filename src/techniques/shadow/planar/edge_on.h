// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "render/frame_context.h"

namespace ombrage::planar {

/// Triangles of casters in whose plane a lamp lies. From the lamp they are lines and shade nothing; flattened they
/// would reach from one point to infinity, as wide as rounding makes them.
class EdgeOnCasters {
public:
    /// Bits per global triangle, or null where none is edge-on, and for a sun, whose edge-on casters stay narrow.
    /// Looks at every triangle once per place of the light; the tolerance may change with the geometry alone.
    const gl::Buffer* find(const FrameContext& frame, const LightFrame& light, float tolerance_m);
    /// The geometry changed.
    void clear() { m_found.clear(); }
    std::uint64_t gpuBytes() const;

private:
    struct Found {
        glm::vec4 toward{0.0f};
        std::optional<gl::Buffer> bits;
    };
    std::map<int, Found> m_found;  ///< per light
};

}  // namespace ombrage::planar
