// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_counter.h"

#include "render/frame_context.h"

namespace ombrage {

namespace {

using StencilFace = gl::DrawState::StencilFace;

constexpr GLuint kAllBits = 0xff;

}  // namespace

VolumeCounter::VolumeCounter(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, bool twoSided)
    : m_frame(frame),
      m_light(light),
      m_volumes(volumes),
      m_twoSided(twoSided),
      m_region(frame.view, light),
      m_target({}, {&frame.gbuffer->depth}, "shadow volumes") {}

void VolumeCounter::addFragmentsTo(const gl::Texture& image) {
    m_addsFragments = true;
    m_target = gl::Framebuffer({{&image}}, {}, "volume fill");
}

void VolumeCounter::begin(int atTheEye) const {
    if (m_addsFragments) return;
    m_target.bind();
    m_target.clearStencil(atTheEye & int(kAllBits & ~GLuint(m_maskBit)));
}

gl::DrawState VolumeCounter::state() const {
    gl::DrawState state;
    state.depthTest = true;
    // Reversed depth: what lies behind fails, and so does the surface itself, which is its own volume's light cap.
    state.depthFunc = GL_GREATER;
    state.depthClamp = m_frame.view.orthographic;  // its far plane would cut the volumes open
    state.stencilTest = true;
    state.colorWrite = false;
    if (m_maskBit != 0) {
        for (StencilFace* face : {&state.stencilFront, &state.stencilBack}) {
            face->func = GL_EQUAL;
            face->reference = m_maskBit;
            face->readMask = GLuint(m_maskBit);
        }
        state.stencilWriteMask = kAllBits & ~GLuint(m_maskBit);
    }
    state.scissor = m_region.scissor;
    return state;
}

void VolumeCounter::draw(gl::DrawState state, VolumePart first, VolumePart last, const VolumeChoice& chosen,
                         VolumeLook look) const {
    if (m_addsFragments) {
        gl::DrawState adding;
        adding.blend = true;
        adding.depthClamp = state.depthClamp;
        adding.clipDistances = state.clipDistances;
        adding.scissor = state.scissor;
        look.fragmentPath = "shared/volume_one.frag";
        gl::apply(adding);
        m_volumes.draw(m_frame, m_light, first, last, chosen, look);
        return;
    }
    // Beyond them the light does not matter, and the count stays that of the eye.
    const gl::DepthBounds bounds(m_region.depthBounds);
    if (m_twoSided) {
        gl::apply(state);
        m_volumes.draw(m_frame, m_light, first, last, chosen, look);
        return;
    }
    for (const GLenum culled : {GL_BACK, GL_FRONT}) {
        state.cull = culled;
        gl::apply(state);
        m_volumes.draw(m_frame, m_light, first, last, chosen, look);
    }
}

void VolumeCounter::mark(const gl::Texture& mask) const {
    m_target.bind();
    gl::DrawState state;
    state.stencilTest = true;
    state.colorWrite = false;
    for (StencilFace* face : {&state.stencilFront, &state.stencilBack}) {
        face->reference = m_maskBit;
        face->depthPass = GL_REPLACE;
    }
    state.stencilWriteMask = GLuint(m_maskBit);
    gl::apply(state);
    mask.bind(kFirstFreeUnit);
    m_frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/volume_mask.frag"}});
    m_frame.drawFullscreen();
}

void VolumeCounter::zPass(const VolumeChoice& chosen, bool clampDepth) const {
    if (m_region.empty) return;
    gl::DrawState state = this->state();
    // Without the clamp an orthographic far plane cuts what lies behind everything, and the near plane what it must.
    state.depthClamp = clampDepth;
    state.stencilFront.depthPass = GL_INCR_WRAP;
    state.stencilBack.depthPass = GL_DECR_WRAP;
    // The dark caps of endless volumes lie behind everything.
    m_target.bind();
    draw(state, VolumePart::Sides, VolumePart::Sides, chosen);
    if (m_volumes.options().end()) draw(state, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen);
}

void VolumeCounter::zPassLightCaps(const VolumeChoice& chosen, bool clampDepth) const {
    if (m_region.empty) return;
    gl::DrawState state = this->state();
    state.depthClamp = clampDepth;
    m_target.bind();
    for (const VolumePart part : {VolumePart::LightCaps, VolumePart::InwardLightCaps}) {
        const bool outwards = part == VolumePart::LightCaps;
        state.stencilFront.depthPass = outwards ? GL_INCR_WRAP : GL_DECR_WRAP;
        state.stencilBack.depthPass = outwards ? GL_DECR_WRAP : GL_INCR_WRAP;
        draw(state, part, part, chosen);
    }
}

void VolumeCounter::zFail(const VolumeChoice& chosen) const {
    if (m_region.empty) return;
    gl::DrawState state = this->state();
    m_target.bind();
    state.stencilFront.depthFail = GL_DECR_WRAP;
    state.stencilBack.depthFail = GL_INCR_WRAP;
    // Light caps are clipped where the G-buffer's triangles were: clipping makes new corners, and other bits of depth.
    gl::DrawState capState = state;
    capState.depthClamp = false;
    if (state.depthClamp) {
        draw(state, VolumePart::Sides, VolumePart::Sides, chosen);
        draw(capState, VolumePart::LightCaps, VolumePart::LightCaps, chosen);
        draw(state, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen);
    } else {
        draw(state, VolumePart::Sides, VolumePart::DarkCaps, chosen);
    }
    capState.stencilFront.depthFail = GL_INCR_WRAP;
    capState.stencilBack.depthFail = GL_DECR_WRAP;
    draw(capState, VolumePart::InwardLightCaps, VolumePart::InwardLightCaps, chosen);
}

void VolumeCounter::nearPlane(const VolumeChoice& chosen) const {
    if (m_region.empty) return;
    gl::DrawState state = this->state();
    state.depthTest = false;
    state.clipDistances = 2;
    state.stencilFront.depthPass = state.stencilBack.depthPass = GL_INCR_WRAP;
    m_target.bind();
    for (const VolumePart part : {VolumePart::LightCaps, VolumePart::InwardLightCaps})
        draw(state, part, part, chosen, {.ontoNearPlane = true});
    // Volumes that end before the near plane do not hold it.
    if (!m_volumes.options().end()) return;
    state.stencilFront.depthPass = state.stencilBack.depthPass = GL_DECR_WRAP;
    draw(state, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen, {.ontoNearPlane = true});
}

void VolumeCounter::darken(const gl::Texture& visibility) const {
    const gl::Framebuffer target({{&visibility}}, {&m_frame.gbuffer->depth}, "shadow from stencil");
    target.bind();
    gl::DrawState state;
    state.stencilTest = true;
    // The highest bit alone means that nothing holds the point.
    state.stencilFront.func = state.stencilBack.func = m_maskBit != 0 ? GL_LESS : GL_NOTEQUAL;
    state.stencilFront.reference = state.stencilBack.reference = m_maskBit;
    state.scissor = m_region.scissor;
    if (m_region.empty) return;
    gl::apply(state);
    m_frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/dark.frag"}});
    m_frame.drawFullscreen();
}

}  // namespace ombrage
