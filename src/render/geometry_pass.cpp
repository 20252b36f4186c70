// SPDX-License-Identifier: MIT
#include "render/geometry_pass.h"

namespace ombrage {

namespace {

/// As in ombrage/frame.glsl, std140.
struct FrameBlock {
    glm::mat4 viewFromWorld, clipFromView, clipFromWorld, worldFromView;
    glm::vec4 eye, forward, viewport, projection;
    glm::uvec4 random;
};

gl::TextureDesc plane(GLenum format, int width, int height) { return {.format = format, .width = width, .height = height}; }

}  // namespace

std::unique_ptr<GBuffer> GeometryPass::makeGBuffer(int width, int height, bool stencil) {
    auto g = std::make_unique<GBuffer>();
    const GLenum depthFormat = stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    g->depth = gl::Texture(plane(depthFormat, width, height), "g-buffer depth");
    g->normals = gl::Texture(plane(GL_RGBA16, width, height), "g-buffer normals");
    g->albedo = gl::Texture(plane(GL_SRGB8_ALPHA8, width, height), "g-buffer albedo");
    g->material = gl::Texture(plane(GL_RGBA8, width, height), "g-buffer material");
    g->ids = gl::Texture(plane(GL_RG32UI, width, height), "g-buffer ids");
    g->framebuffer =
        gl::Framebuffer({{&g->normals}, {&g->albedo}, {&g->material}, {&g->ids}}, {&g->depth}, "g-buffer");
    return g;
}

void GeometryPass::uploadFrameBlock(const FrameContext& frame) {
    const CameraView& view = frame.view;
    const float aspect = float(frame.width) / float(frame.height);
    const float halfHeight = view.orthographic ? view.orthoHeight_m * 0.5f : view.tanHalfFovY;
    const FrameBlock block{view.viewFromWorld,
                           view.clipFromView,
                           view.clipFromWorld,
                           view.worldFromView,
                           glm::vec4(view.eye, view.orthographic ? 1.0f : 0.0f),
                           glm::vec4(view.forward, 0.0f),
                           glm::vec4(frame.width, frame.height, 1.0f / float(frame.width), 1.0f / float(frame.height)),
                           glm::vec4(view.near_m, view.far_m, halfHeight * aspect, halfHeight),
                           glm::uvec4(frame.seed, frame.frameIndex, 0u, 0u)};
    if (!m_frameBlock) m_frameBlock = gl::Buffer(sizeof block, nullptr, "frame block");
    m_frameBlock.upload(0, sizeof block, &block);
    m_frameBlock.bindUniform(kFrameBinding);
}

void GeometryPass::draw(FrameContext& frame) const {
    const auto pass = frame.pass("g-buffer");
    const gl::Framebuffer& target = frame.gbuffer->framebuffer;
    target.bind();
    gl::DrawState state;
    state.depthTest = state.depthWrite = true;
    gl::apply(state);
    target.clearDepth(0.0f);
    if (frame.gbuffer->depth.desc().format == GL_DEPTH32F_STENCIL8) target.clearStencil(0);
    target.clearColorUint(3, glm::uvec4(kNoHit, kNoHit, 0, 0));

    const std::string normals = std::to_string(int(frame.normals));
    const auto draw = [&](DrawFilter::Alpha alpha, std::vector<std::pair<std::string, std::string>> defines) {
        if (frame.gpuScene->hasVertexColors()) defines.emplace_back("VERTEX_COLORS", "1");
        frame.program({{GL_VERTEX_SHADER, "ombrage/gbuffer.vert"}, {GL_FRAGMENT_SHADER, "ombrage/gbuffer.frag"}}, std::move(defines));
        const DrawCounts counts = frame.gpuScene->draw({.alpha = alpha}, false);
        frame.countDraw(counts.draws, counts.triangles);
    };
    // Opaque surfaces first: a shader without discard keeps the early depth test.
    draw(DrawFilter::Alpha::OpaqueOnly, {{"NORMALS", normals}});
    if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly, {{"NORMALS", normals}, {"ALPHA_MASK", "1"}});
}

std::uint64_t byteSize(const GBuffer& g) {
    return gl::byteSize(g.depth.desc()) + gl::byteSize(g.normals.desc()) + gl::byteSize(g.albedo.desc()) +
           gl::byteSize(g.material.desc()) + gl::byteSize(g.ids.desc());
}

}  // namespace ombrage
