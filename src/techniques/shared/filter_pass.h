// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {

/// One full-screen pass of a filter: the G-buffer is bound, `from` is at kFirstFreeUnit.
/// @param set puts the program's uniforms
template <typename SetUniforms>
void filterPass(FrameContext& frame, Technique& technique, const std::string& name, const std::string& fragmentPath,
                const gl::Texture& from, const gl::Texture& to, SetUniforms&& set,
                std::vector<std::pair<std::string, std::string>> defines = {}) {
    const auto pass = frame.pass(name);
    const gl::Framebuffer target({{&to}}, {}, name.c_str());
    target.bind();
    gl::apply({});
    frame.bindGBuffer();
    from.bind(kFirstFreeUnit);
    set(frame.fullscreenProgram(technique, fragmentPath, std::move(defines)));
    frame.drawFullscreen();
}

}  // namespace ombrage
