// SPDX-License-Identifier: MIT
#include "techniques/shared/depth_pass.h"

namespace ombrage {

void drawLightDepth(FrameContext& frame, const LightFrame& light, const LightViews& views, const gl::Texture& map,
                    GLenum cull) {
    const bool layered = views.views.size() > 1;
    const gl::Framebuffer target({}, {&map, 0, layered ? -1 : 0}, "light depth");
    target.bind();
    gl::DrawState state;
    state.depthTest = state.depthWrite = true;
    // Casters before a perspective view's near side still cast; the sun's begins before all geometry.
    state.depthClamp = views.perspective;
    state.colorWrite = false;
    target.clearDepth(0.0f);

    frame.gpuScene->bindStorage();
    const float nearest_m = 2.0f * views.views[0].near_m;  // the corners of a cube face's near plane
    std::vector<glm::mat4> matrices;
    for (std::size_t v = 0; v < views.views.size(); ++v) matrices.push_back(views.clipFromWorld(v));
    const auto draw = [&](DrawFilter::Alpha alpha, bool positionsOnly) {
        std::vector<std::pair<std::string, std::string>> defines;
        if (!positionsOnly) defines.emplace_back("ALPHA_MASK", "1");
        std::vector<gl::ShaderStage> stages = {
            {GL_VERTEX_SHADER, layered ? "shared/depth_layers.vert" : "ombrage/depth_only.vert"},
            {GL_FRAGMENT_SHADER, "ombrage/depth_only.frag"}};
        if (layered) stages.push_back({GL_GEOMETRY_SHADER, "shared/depth_layers.geom"});
        const gl::Program& program = frame.program(std::move(stages), std::move(defines));
        program.set("u_clipFromWorld", matrices.data(), int(matrices.size()));
        for (const DrawBatch& batch :
             frame.gpuScene->batches({.castersOnly = true, .excludedByLight = light.index, .alpha = alpha})) {
            // What a solid turns away from the light lies behind what it turns to it.
            const bool onlyFront = cull == GL_NONE && frame.gpuScene->hidesBackFaces(batch, light.toward(), nearest_m);
            state.cull = onlyFront ? GLenum(GL_BACK) : cull;
            gl::apply(state);
            const DrawCounts counts = frame.gpuScene->draw(batch, positionsOnly);
            frame.countDraw(counts.draws, counts.triangles);
        }
    };
    draw(DrawFilter::Alpha::OpaqueOnly, true);
    if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly, false);
}

}  // namespace ombrage
