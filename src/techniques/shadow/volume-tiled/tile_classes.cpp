// SPDX-License-Identifier: MIT
#include "techniques/shadow/volume-tiled/tile_classes.h"

#include <string>
#include <vector>

namespace ombrage {

namespace {

/// A multiple of what rasterisers share out their own work in; the paper's size.
constexpr int kTileSize = 8;

using Defines = std::vector<std::pair<std::string, std::string>>;

Defines tileDefines() {
    return {{"ONTO_TILES", std::to_string(kTileSize)}};
}

gl::TextureDesc perTile(const FrameContext& frame, GLenum format) {
    return {.format = format,
            .width = (frame.width + kTileSize - 1) / kTileSize,
            .height = (frame.height + kTileSize - 1) / kTileSize};
}

}  // namespace

TileClasses::TileClasses(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes)
    : m_frame(frame),
      m_light(light),
      m_volumes(volumes),
      m_cells(frame.targets->take(perTile(frame, GL_RG32F), "tile depths")),
      m_depth(frame.targets->take(perTile(frame, GL_DEPTH32F_STENCIL8), "tile counts")),
      m_classes(frame.targets->take(perTile(frame, GL_RG8), "tile classes")) {}

void TileClasses::findBoundary(const VolumeChoice& chosen) {
    {
        const auto pass = m_frame.pass("depths of tiles");
        const gl::Framebuffer target({{m_cells.get()}}, {m_depth.get()}, "tile depths");
        target.bind();
        gl::DrawState state;
        state.depthWrite = true;
        gl::apply(state);
        m_frame.gbuffer->depth.bind(kUnitDepth);
        m_frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"},
                         {GL_FRAGMENT_SHADER, "shadow/volume-tiled/tile_cells.frag"}},
                        tileDefines());
        m_frame.drawFullscreen();
    }
    const auto pass = m_frame.pass("boundary of volumes");
    const gl::Framebuffer target({{m_classes.get()}}, {}, "tile classes");
    target.bind();
    target.clearColor(0, glm::vec4(0));
    gl::apply({});
    m_cells->bind(kFirstFreeUnit);
    const VolumeLook look{
        .fragmentPath = "shadow/volume-tiled/tile_marks.frag", .tileBounds = true, .defines = tileDefines()};
    m_volumes.draw(m_frame, m_light, VolumePart::Sides, VolumePart::Sides, chosen, look);
    if (m_volumes.options().end())
        m_volumes.draw(m_frame, m_light, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen, look);
}

void TileClasses::classify(const VolumeChoice& chosen, int atTheEye) {
    const auto pass = m_frame.pass("count of tiles");
    {
        const gl::Framebuffer target({}, {m_depth.get()}, "tile counts");
        target.bind();
        target.clearStencil(atTheEye & 0xff);
        gl::DrawState state;
        state.depthTest = true;
        state.depthFunc = GL_GREATER;
        state.depthClamp = true;
        state.stencilTest = true;
        state.stencilFront.depthPass = GL_INCR_WRAP;
        state.stencilBack.depthPass = GL_DECR_WRAP;
        state.colorWrite = false;
        gl::apply(state);
        const VolumeLook look{.defines = tileDefines()};
        m_volumes.draw(m_frame, m_light, VolumePart::Sides, VolumePart::Sides, chosen, look);
        if (m_volumes.options().end())
            m_volumes.draw(m_frame, m_light, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen, look);
    }
    const gl::Framebuffer target({{m_classes.get()}}, {m_depth.get()}, "tile classes");
    target.bind();
    gl::DrawState state;
    state.stencilTest = true;
    state.stencilFront.func = state.stencilBack.func = GL_NOTEQUAL;
    state.blend = true;
    gl::apply(state);
    m_frame.program(
        {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shadow/volume-tiled/tile_dark.frag"}});
    m_frame.drawFullscreen();
}

void TileClasses::stencil(bool boundary, int value, unsigned writeMask) const {
    gl::DrawState state;
    // Tiles are drawn at infinity: before nothing but the sky.
    state.depthTest = true;
    state.depthFunc = GL_LESS;
    state.stencilTest = true;
    for (auto* face : {&state.stencilFront, &state.stencilBack}) {
        face->reference = value;
        face->depthPass = GL_REPLACE;
    }
    state.stencilWriteMask = writeMask;
    state.colorWrite = false;
    gl::apply(state);
    m_classes->bind(kFirstFreeUnit);
    const gl::Program& program = m_frame.program(
        {{GL_VERTEX_SHADER, "shadow/volume-tiled/tile_quads.vert"}, {GL_FRAGMENT_SHADER, "shared/empty.frag"}},
        tileDefines());
    program.set("u_boundary", boundary ? 1 : 0);
    gl::drawVertices(count() * 6);
    m_frame.countDraw(1, count() * 2);
}

gl::Texture TileClasses::shown(GLenum format, bool boundaryAlone) const {
    gl::Texture picture({.format = format, .width = m_frame.width, .height = m_frame.height}, "tile classes shown");
    const gl::Framebuffer target({{&picture}}, {}, "tile classes shown");
    target.bind();
    gl::apply({});
    m_frame.bindGBuffer();
    m_classes->bind(kFirstFreeUnit);
    Defines defines = tileDefines();
    if (boundaryAlone) defines.emplace_back("BOUNDARY_ALONE", "");
    m_frame.program(
        {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shadow/volume-tiled/tile_view.frag"}},
        std::move(defines));
    m_frame.drawFullscreen();
    return picture;
}

gl::Texture TileClasses::boundaryMask() const {
    return shown(GL_R8, true);
}

gl::Texture TileClasses::picture() const {
    return shown(GL_RGBA16F, false);
}

void TileClasses::report() const {
    std::vector<glm::vec2> cells(count());
    std::vector<glm::u8vec2> classes(count());
    m_cells->download(0, 0, GL_RG, GL_FLOAT, cells.size() * sizeof cells[0], cells.data());
    m_classes->download(0, 0, GL_RG, GL_UNSIGNED_BYTE, classes.size() * sizeof classes[0], classes.data());
    int boundary = 0, dark = 0, lit = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].y == 0.0f) continue;
        if (classes[i].r != 0)
            ++boundary;
        else if (classes[i].g != 0)
            ++dark;
        else
            ++lit;
    }
    m_frame.counter("tiles of the boundary", boundary);
    m_frame.counter("dark tiles", dark);
    m_frame.counter("lit tiles", lit);
}

}  // namespace ombrage
