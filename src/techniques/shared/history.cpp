// SPDX-License-Identifier: MIT
#include "techniques/shared/history.h"

namespace ombrage {

void setReprojection(const gl::Program& program, const FrameContext& frame, bool hasHistory) {
    program.set("u_clipNow", frame.centredView.clipFromWorld);
    program.set("u_clipBefore", frame.previousView.clipFromWorld);
    program.set("u_viewBefore", frame.previousView.viewFromWorld);
    program.set("u_hasHistory", hasHistory ? 1 : 0);
}

void exposeChannel(FrameContext& frame, const std::string& name, const gl::Texture& texture, int channel, float scale) {
    if (!frame.wants(name)) return;
    const auto shown =
        frame.targets->take({.format = GL_R32F, .width = frame.width, .height = frame.height}, "channel");
    const gl::Framebuffer target({{shown.get()}}, {}, "channel");
    target.bind();
    gl::apply({});
    texture.bind(kFirstFreeUnit);
    const FrameContext::Uncounted uncounted(frame);
    const gl::Program& program =
        frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/channel.frag"}});
    program.set("u_channel", channel);
    program.set("u_scale", scale);
    frame.drawFullscreen();
    frame.expose(name, *shown, ShowAs::Value);
}

}  // namespace ombrage
