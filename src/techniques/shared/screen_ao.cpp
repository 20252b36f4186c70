// SPDX-License-Identifier: MIT
#include "techniques/shared/screen_ao.h"

#include "techniques/shared/disks.h"

namespace ombrage {

double ScreenAoParams::radiusIn(double sceneRadius_m, double sceneDiagonal_m) const {
    if (radius_m > 0) return double(radius_m);
    return radiusPercent > 0 ? 0.01 * double(radiusPercent) * sceneDiagonal_m : sceneRadius_m;
}

ParamTable screenAoTable(std::vector<ParamField> own, const ScreenAoParams& defaults) {
    using P = ScreenAoParams;
    std::vector<ParamField> shared = {
        field(&P::radius_m, "radius", Unit::Metre)
            .range(0, 100)
            .tune(0.05, 2)
            .effect(ParamEffect::Host)
            .help("Farthest occluder; 0 takes radius-percent."),
        field(&P::radiusPercent, "radius-percent")
            .range(0, 100)
            .effect(ParamEffect::Host)
            .help("The same in percent of the scene's diagonal; 0 takes the scene's ao_radius_m."),
        field(&P::maxRadius_px, "max-radius", Unit::Pixel)
            .range(0, 4096)
            .help("Widest search in the picture: the radius of nearer surfaces shrinks to it, which keeps the cost of "
                  "close looks down; 0 leaves it as it is."),
        field(&P::rotation, "rotation")
            .effect(ParamEffect::Define)
            .help("How samples turn from pixel to pixel: not at all (bands), by interleaved gradient noise, by a hash "
                  "(grain), in tiles of 4x4 pixels, or by blue noise."),
        field(&P::pixels, "pixels")
            .effect(ParamEffect::Define)
            .help("full: each is computed. half: one of each 2x2, and the others from those of the same surface, "
                  "which costs about a quarter. deinterleaved: all, but in 16 pictures of every fourth pixel, so that "
                  "neighbouring threads read neighbouring depths; faster where the radius covers hundreds of pixels, "
                  "and samples lie at most two pixels beside their place.")};
    for (ParamField& one : shared) one.info.defaultValue = one.get(&defaults);
    own.insert(own.end(), shared.begin(), shared.end());
    return ParamTable(std::move(own));
}

double ownSurfaceShare(const AoReceiver& receiver) {
    return 0.5 - 0.5 * glm::dot(receiver.shadingNormal, receiver.normal);
}

glm::ivec2 receiversOf(const FrameContext& frame, const ScreenAoParams& params) {
    const glm::ivec2 size(frame.width, frame.height);
    return params.pixels == AoPixels::Half ? (size + 1) / 2 : size;
}

namespace {

/// Pixels between two of a part, across and down.
constexpr int kPartStride = 4;

/// Parts of the picture beside one another: how many texels that takes, as kPartStride does not always divide the
/// picture.
gl::TextureDesc partsDesc(const FrameContext& frame, GLenum format) {
    const auto padded = [](int pixels) { return (pixels + kPartStride - 1) / kPartStride * kPartStride; };
    return {.format = format, .width = padded(frame.width), .height = padded(frame.height)};
}

void drawParts(FrameContext& frame, const char* shader, const gl::Texture* from, const gl::Texture& to) {
    const gl::Framebuffer target({{&to}}, {}, "parts of the picture");
    target.bind();
    gl::apply({});
    frame.bindGBuffer();
    frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, shader}});
    if (from) from->bind(kUnitAoParts);
    frame.drawFullscreen();
}

}  // namespace

void ScreenAo::draw(FrameContext& frame, Technique& technique, const ScreenAoParams& params, const ScreenAoPass& pass,
                    const gl::Texture& target) {
    if (pass.depthLevels > 0) m_depths.update(frame, pass.depthLevels);
    if (params.pixels != AoPixels::Deinterleaved) {
        drawReceivers(frame, technique, params, pass, target, nullptr);
        return;
    }
    const auto depths = frame.targets->take(partsDesc(frame, GL_R32F), "depths by parts");
    const auto parts = frame.targets->take(partsDesc(frame, target.desc().format), "ao by parts");
    {
        const auto timed = frame.pass("deinterleave");
        drawParts(frame, "shared/ao_deinterleave.frag", nullptr, *depths);
    }
    drawReceivers(frame, technique, params, pass, *parts, depths.get());
    const auto timed = frame.pass("interleave");
    drawParts(frame, "shared/ao_interleave.frag", parts.get(), target);
}

void ScreenAo::drawReceivers(FrameContext& frame, Technique& technique, const ScreenAoParams& params,
                             const ScreenAoPass& pass, const gl::Texture& target, const gl::Texture* parts) {
    const auto timed = frame.pass(technique.entry().id());
    const gl::Framebuffer framebuffer({{&target}}, {}, "ao");
    framebuffer.bind();
    gl::apply({});
    frame.bindGBuffer();
    const gl::Program& program = frame.fullscreenProgram(technique, pass.fragmentPath, pass.defines);
    if (pass.depthLevels > 0) m_depths.texture().bind(kUnitAoDepths);
    if (parts) parts->bind(kUnitAoParts);
    if (params.rotation == AoRotation::BlueNoise) {
        if (!m_blueNoise) m_blueNoise = blueNoiseTexture();
        m_blueNoise.bind(kUnitAoNoise);
    }
    program.set("u_radius_m",
                float(params.radiusIn(double(frame.scene->aoRadius_m), frame.gpuScene->bounds().diagonal())));
    if (pass.bind) pass.bind(program);
    frame.drawFullscreen();
}

void ScreenAo::render(FrameContext& frame, Technique& technique, const ScreenAoParams& params, const ScreenAoPass& pass,
                      const gl::Texture& visibility) {
    if (params.pixels != AoPixels::Half) {
        draw(frame, technique, params, pass, visibility);
        return;
    }
    gl::TextureDesc desc = visibility.desc();
    const glm::ivec2 size = receiversOf(frame, params);
    desc.width = size.x;
    desc.height = size.y;
    const auto receivers = frame.targets->take(desc, "ao of receivers");
    draw(frame, technique, params, pass, *receivers);
    upsampleAo(frame, *receivers, visibility);
}

std::uint64_t ScreenAo::gpuBytes() const {
    return m_depths.gpuBytes() + (m_blueNoise ? gl::byteSize(m_blueNoise.desc()) : 0);
}

void upsampleAo(FrameContext& frame, const gl::Texture& receivers, const gl::Texture& visibility) {
    const auto pass = frame.pass("upsample");
    const gl::Framebuffer target({{&visibility}}, {}, "upsampled ao");
    target.bind();
    gl::apply({});
    frame.bindGBuffer();
    frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/ao_upsample.frag"}});
    receivers.bind(kFirstFreeUnit);
    frame.drawFullscreen();
}

}  // namespace ombrage
