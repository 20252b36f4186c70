// SPDX-License-Identifier: MIT
#include "techniques/shared/depth_pyramid.h"

#include <algorithm>

namespace ombrage {

void DepthPyramid::update(FrameContext& frame, const LightDepth& depth) {
    if (m_levels && m_drawn == depth.drawn()) return;
    const gl::Texture& map = depth.map();
    const int first = std::max(map.width() / 2, 1);
    gl::TextureDesc desc = map.desc();
    desc.format = GL_RG32F;
    desc.width = first + std::max(first / 2, 1);
    desc.height = first;
    if (!m_levels || m_levels.desc() != desc) m_levels = gl::Texture(desc, "depth pyramid");

    const auto pass = frame.pass("depth pyramid");
    const bool layered = desc.kind == gl::TextureKind::Array2D;
    for (int level = 0; first >> level >= 1; ++level) {
        const gl::Program& program =
            frame.program({{GL_COMPUTE_SHADER, "shared/depth_pyramid.comp"}},
                          {{"OF_MAP", level == 0 ? "1" : "0"}, {"LAYERED", layered ? "1" : "0"}});
        program.set("u_level", level);
        (level == 0 ? map : m_levels).bind(kFirstFreeUnit);
        m_levels.bindImage(0, GL_WRITE_ONLY);
        const int groups = ((first >> level) + 7) / 8;
        gl::dispatch(groups, groups, desc.layers);
        gl::barrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    m_drawn = depth.drawn();
}

}  // namespace ombrage
