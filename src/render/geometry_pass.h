// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "render/frame_context.h"

namespace ombrage {

/// Makes G-buffers and fills them, and keeps the camera's uniform block.
class GeometryPass {
public:
    /// @throws Error(Environment) when the device does not draw with as many samples.
    static std::unique_ptr<GBuffer> makeGBuffer(const GBufferLayout& layout);

    /// Uploads the camera's block and binds it for every later shader of the frame.
    void uploadFrameBlock(const FrameContext& frame);

    /// Draws every instance into frame.gbuffer. Where it has samples: into them, and makes the pixels of them.
    void draw(FrameContext& frame) const;

private:
    void drawInstances(FrameContext& frame, const gl::Framebuffer& target) const;
    gl::Buffer m_frameBlock;
};

/// Bytes of all planes.
std::uint64_t byteSize(const GBuffer& gbuffer);

}  // namespace ombrage
