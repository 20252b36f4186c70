// SPDX-License-Identifier: MIT
#include "techniques/ao/volumetric/depth_moments.h"

namespace ombrage::volumetric {

void DepthMoments::update(FrameContext& frame) {
    // Whole texels of the coarsest level, so that each level's are squares of one size.
    const auto padded = [](int size) {
        constexpr int kCoarsest = 1 << (kLevels - 1);
        return (size + 2 * kMargin + kCoarsest - 1) / kCoarsest * kCoarsest;
    };
    const gl::TextureDesc desc{
        .format = GL_RG32F, .width = padded(frame.width), .height = padded(frame.height), .levels = kLevels};
    if (!m_moments || m_moments.desc() != desc) {
        m_moments = gl::Texture(desc, "depth moments");
        m_moments.setFilter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
    }

    const auto pass = frame.pass("depth moments");
    const gl::Framebuffer target({{&m_moments, 0}}, {}, "depth moments");
    target.bind();
    gl::apply({});
    frame.bindGBuffer();
    frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "ao/volumetric/moments.frag"}})
        .set("u_margin", kMargin);
    frame.drawFullscreen();
    m_moments.generateMipmap();
}

}  // namespace ombrage::volumetric
