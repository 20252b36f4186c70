// SPDX-License-Identifier: MIT
#include "techniques/shared/depth_pyramid.h"

#include <algorithm>

namespace ombrage {

void DepthPyramid::update(FrameContext& frame, const LightDepth& depth) {
    if (m_levels && m_version == depth.version()) return;
    const gl::Texture& map = depth.map();
    gl::TextureDesc desc = map.desc();
    desc.format = GL_RG32F;
    desc.width = desc.height = std::max(map.width() / 2, 1);
    desc.levels = 0;
    if (!m_levels || m_levels.desc() != desc) m_levels = gl::Texture(desc, "depth pyramid");

    const auto pass = frame.pass("depth pyramid");
    const bool layered = desc.kind == gl::TextureKind::Array2D;
    for (int level = 0; level < m_levels.levels(); ++level) {
        const gl::Program& program =
            frame.program({{GL_COMPUTE_SHADER, "shared/depth_pyramid.comp"}},
                          {{"OF_MAP", level == 0 ? "1" : "0"}, {"LAYERED", layered ? "1" : "0"}});
        program.set("u_level", level - 1);
        (level == 0 ? map : m_levels).bind(kFirstFreeUnit);
        m_levels.bindImage(0, GL_WRITE_ONLY, level);
        const int groups = (std::max(desc.width >> level, 1) + 7) / 8;
        gl::dispatch(groups, groups, desc.layers);
        gl::barrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    m_version = depth.version();
}

}  // namespace ombrage
