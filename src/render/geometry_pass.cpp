// SPDX-License-Identifier: MIT
#include "render/geometry_pass.h"

#include "render/edge_samples.h"

namespace ombrage {

namespace {

/// As in ombrage/frame.glsl, std140.
struct FrameBlock {
    glm::mat4 viewFromWorld, clipFromView, clipFromWorld, worldFromView;
    glm::vec4 eye, forward, viewport, projection;
    glm::uvec4 random;
};

/// The variant of gbuffer.frag that a batch needs.
std::vector<std::pair<std::string, std::string>> definesOf(const DrawBatch& batch, const FrameContext& frame,
                                                           bool masked, bool frontOnly) {
    const auto has = [&](std::size_t map) { return batch.textures[map] >= 0; };
    std::vector<std::pair<std::string, std::string>> defines;
    const auto define = [&](const char* name) { defines.emplace_back(name, "1"); };
    if (masked) define("ALPHA_MASK");
    if (has(0)) define("BASE_COLOR_MAP");
    if (frame.normals == NormalSource::Map && has(1))
        define("NORMAL_MAP");
    else if (frame.normals != NormalSource::Geometry && has(2))
        define("HEIGHT_MAP");
    if (frame.gbuffer->layout.material && has(3)) define("METALLIC_ROUGHNESS_MAP");
    if (!defines.empty()) define("UV");
    if (frontOnly) define("FRONT_ONLY");
    if (frame.gpuScene->hasVertexColors()) define("VERTEX_COLORS");
    if (frame.gbuffer->layout.material) define("MATERIAL_PLANE");
    if (frame.gbuffer->samples) {
        const auto samples = sampleDefines(*frame.gbuffer);
        defines.insert(defines.end(), samples.begin(), samples.end());
        if (masked && frame.gbuffer->layout.samples.alphaTest) define("ALPHA_SAMPLES");
    }
    return defines;
}

}  // namespace

std::unique_ptr<GBuffer> GeometryPass::makeGBuffer(const GBufferLayout& layout) {
    const auto plane = [&](GLenum format) {
        return gl::TextureDesc{.format = format, .width = layout.width, .height = layout.height};
    };
    auto g = std::make_unique<GBuffer>();
    g->layout = layout;
    g->depth = gl::Texture(plane(layout.stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F), "g-buffer depth");
    g->surface = gl::Texture(plane(GL_RGBA32UI), "g-buffer surface");
    std::vector<gl::Attachment> colors{{&g->surface}};
    if (layout.material) {
        g->material = gl::Texture(plane(GL_R32UI), "g-buffer material");
        colors.push_back({&g->material});
    }
    g->framebuffer = gl::Framebuffer(colors, {&g->depth}, "g-buffer");
    if (layout.samples.count > 1) g->samples = makeSamples(layout);
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
                           glm::vec4(view.forward, frame.scene->ambient),
                           glm::vec4(frame.width, frame.height, 1.0f / float(frame.width), 1.0f / float(frame.height)),
                           glm::vec4(view.near_m, view.far_m, halfHeight * aspect, halfHeight),
                           glm::uvec4(frame.seed, frame.frameIndex, 0u, 0u)};
    if (!m_frameBlock) m_frameBlock = gl::Buffer(sizeof block, nullptr, "frame block");
    m_frameBlock.upload(0, sizeof block, &block);
    m_frameBlock.bindUniform(kFrameBinding);
}

void GeometryPass::draw(FrameContext& frame) const {
    const GBuffer& gbuffer = *frame.gbuffer;
    drawInstances(frame, gbuffer.samples ? gbuffer.samples->framebuffer : gbuffer.framebuffer);
    if (gbuffer.samples) makePixels(frame);
}

void GeometryPass::drawInstances(FrameContext& frame, const gl::Framebuffer& target) const {
    const auto pass = frame.pass("g-buffer");
    target.bind();
    gl::DrawState state;
    state.depthTest = state.depthWrite = true;
    target.clearDepth(0.0f);
    if (frame.gbuffer->layout.stencil) frame.gbuffer->framebuffer.clearStencil(0);

    frame.gpuScene->bindStorage();
    // Back faces of solids are behind their front faces, but where the near plane cuts them open: an orthographic one
    // may do so anywhere.
    const CameraView& view = frame.view;
    const auto seesBackFaces = [&](const DrawBatch& batch) {
        return view.orthographic ||
               !frame.gpuScene->hidesBackFaces(batch, glm::vec4(view.eye, 1.0f), view.nearReach_m());
    };
    const auto draw = [&](DrawFilter::Alpha alpha) {
        for (const DrawBatch& batch : frame.gpuScene->batches({.alpha = alpha})) {
            const bool frontOnly = !seesBackFaces(batch);
            state.cull = frontOnly ? GL_BACK : GL_NONE;
            gl::apply(state);
            frame.program({{GL_VERTEX_SHADER, "ombrage/gbuffer.vert"}, {GL_FRAGMENT_SHADER, "ombrage/gbuffer.frag"}},
                          definesOf(batch, frame, alpha == DrawFilter::Alpha::MaskedOnly, frontOnly));
            const DrawCounts counts = frame.gpuScene->draw(batch, false);
            frame.countDraw(counts.draws, counts.triangles);
        }
    };
    // Opaque surfaces first: a shader without discard keeps the early depth test.
    draw(DrawFilter::Alpha::OpaqueOnly);
    if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly);
}

std::uint64_t byteSize(const GBuffer& g) {
    return gl::byteSize(g.depth.desc()) + gl::byteSize(g.surface.desc()) +
           (g.material ? gl::byteSize(g.material.desc()) : 0) + (g.samples ? byteSize(*g.samples) : 0);
}

}  // namespace ombrage
