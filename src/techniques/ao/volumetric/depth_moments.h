// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "gl/objects.h"
#include "render/frame_context.h"

namespace ombrage::volumetric {

/// Mean and mean square of the picture's depths over squares of 1, 2, 4 ... pixels. What is averaged is linear over the
/// picture on a plane: 1 / depth, or -depth under an orthographic camera. A margin around the picture continues it by
/// point reflection in its border, so that planes go on there; squares at the border are whole.
class DepthMoments {
public:
    static constexpr int kLevels = 8;  ///< up to squares of 128 pixels
    static constexpr int kMargin = 1 << (kLevels - 2);

    void update(FrameContext& frame);

    const gl::Texture& texture() const { return m_moments; }
    std::uint64_t gpuBytes() const { return m_moments ? gl::byteSize(m_moments.desc()) : 0; }

private:
    gl::Texture m_moments;
};

}  // namespace ombrage::volumetric
