// SPDX-License-Identifier: MIT
#include "techniques/shadow/planar/blur.h"

#include <algorithm>
#include <cmath>

namespace ombrage::planar {

namespace {

constexpr unsigned kUnitMask = kFirstFreeUnit, kUnitReach = kFirstFreeUnit + 1, kUnitCasterColor = kFirstFreeUnit + 2;
/// A lamp's casters count up to this share of its height: past it half-shadows grow over all bounds.
constexpr float kHighestShare = 0.95f;
/// Tiles along the mask's height, each at least of 24 pixels: every tile asks every other.
constexpr int kTilesHigh = 24;

}  // namespace

std::vector<glm::vec4> blurKernel(int samples) {
    constexpr float kGoldenAngle_rad = 2.39996323f;
    std::vector<glm::vec4> kernel;
    for (int i = 0; i < samples; ++i) {
        const float angle_rad = kGoldenAngle_rad * float(i);
        const glm::vec2 direction(std::cos(angle_rad), std::sin(angle_rad));
        const float searched = float(i) / float(samples - 1);
        kernel.emplace_back(direction * std::sqrt((float(i) + 0.5f) / float(samples)), direction * searched);
    }
    return kernel;
}

void blurMask(FrameContext& frame, Technique& technique, const Params& params, const LightFrame& light,
              const ActivePlane& plane, const CasterMask& casters, const gl::Framebuffer& seen, bool isColored,
              const gl::DrawState& state) {
    const gl::Texture& mask = *casters.mask;
    const int tile_px = std::max(24, (mask.height() + kTilesHigh - 1) / kTilesHigh);
    const gl::TextureDesc desc{.format = GL_RG16F,
                               .width = (mask.width() + tile_px - 1) / tile_px,
                               .height = (mask.height() + tile_px - 1) / tile_px};
    const auto tiles = frame.targets->take(desc, "planar tiles"), reach = frame.targets->take(desc, "planar reach");

    std::vector<std::pair<std::string, std::string>> defines;
    if (params.blur == Blur::Contact) defines.emplace_back("CONTACT", "1");
    if (params.blur == Blur::Constant && params.width_px > 0) defines.emplace_back("PIXELS", "1");
    const bool isSun = light.light->type == LightType::Sun;
    const auto setCommon = [&](const gl::Program& program) {
        program.set("u_plane", plane.plane);
        program.set("u_toward", light.toward());
        program.set("u_zoom", casters.zoom);
        program.set("u_radius", 0.5f * (params.width_px > 0 ? params.width_px : params.width_m));
        program.set("u_tileInMask", float(tile_px) / glm::vec2(mask.width(), mask.height()));
        program.set("u_highest_m",
                    isSun ? plane.highest_m : std::min(plane.highest_m, kHighestShare * plane.lightHeight));
    };
    {
        const auto pass = frame.pass("planar tiles");
        mask.bind(kUnitMask);
        gl::apply({});
        const gl::Framebuffer tileTarget({{tiles.get()}}, {}, "planar tiles");
        tileTarget.bind();
        const gl::Program& program = frame.fullscreenProgram(technique, "shadow/planar/tiles.frag");
        program.set("u_tile_px", tile_px);
        program.set("u_tallest_m", plane.highest_m);
        frame.drawFullscreen();
        const gl::Framebuffer reachTarget({{reach.get()}}, {}, "planar reach");
        reachTarget.bind();
        tiles->bind(kUnitMask);
        setCommon(frame.fullscreenProgram(technique, "shadow/planar/reach.frag", defines));
        frame.drawFullscreen();
    }
    const auto pass = frame.pass("planar blur");
    seen.bind();
    frame.bindGBuffer();
    mask.bind(kUnitMask);
    reach->bind(kUnitReach);
    if (casters.casterColor) casters.casterColor->bind(kUnitCasterColor);
    if (isColored) defines.emplace_back("COLORED", "1");
    const gl::Program& program = frame.fullscreenProgram(technique, "shadow/planar/blur.frag", std::move(defines));
    setCommon(program);
    program.set("u_tallest_m", plane.highest_m);
    const std::vector<glm::vec4> kernel = blurKernel(params.samples);
    program.set("u_kernel", kernel.data(), params.samples);
    gl::apply(state);
    frame.drawFullscreen();
}

}  // namespace ombrage::planar
