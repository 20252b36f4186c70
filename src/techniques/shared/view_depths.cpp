// SPDX-License-Identifier: MIT
#include "techniques/shared/view_depths.h"

#include <algorithm>

namespace ombrage {

void ViewDepths::update(FrameContext& frame, int levels) {
    gl::TextureDesc desc{.format = GL_R32F, .width = frame.width, .height = frame.height, .levels = 0};
    desc.levels = std::clamp(levels, 1, gl::levelCount(desc));
    if (!m_depths || m_depths.desc() != desc) {
        m_depths = gl::Texture(desc, "view depths");
        m_depths.setFilter(GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    }

    const auto pass = frame.pass("view depths");
    gl::apply({});
    for (int level = 0; level < desc.levels; ++level) {
        const gl::Framebuffer target({{&m_depths, level}}, {}, "view depths");
        target.bind();
        if (level == 0) {
            frame.bindGBuffer();
            frame.program(
                {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/view_depths.frag"}},
                {{"OF_GBUFFER", "1"}});
        } else {
            m_depths.setLevels(level - 1, level - 1);
            frame.program(
                {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/view_depths.frag"}},
                {{"OF_GBUFFER", "0"}});
            m_depths.bind(kFirstFreeUnit);
        }
        frame.drawFullscreen();
    }
    m_depths.setLevels(0, desc.levels - 1);
}

}  // namespace ombrage
