// SPDX-License-Identifier: MIT
#include "techniques/shared/depth_pass.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

namespace {

using Defines = std::vector<std::pair<std::string, std::string>>;

std::vector<gl::ShaderStage> stagesOf(const LightViews& views) {
    if (views.shape == LightShape::Paraboloids)
        return {{GL_VERTEX_SHADER, "shared/depth_layers.vert"},
                {GL_TESS_CONTROL_SHADER, "shared/depth_paraboloids.tesc"},
                {GL_TESS_EVALUATION_SHADER, "shared/depth_paraboloids.tese"},
                {GL_GEOMETRY_SHADER, "shared/depth_paraboloids.geom"},
                {GL_FRAGMENT_SHADER, "shared/depth_paraboloids.frag"}};
    if (views.layers() == 1)
        return {{GL_VERTEX_SHADER, "ombrage/depth_only.vert"}, {GL_FRAGMENT_SHADER, "ombrage/depth_only.frag"}};
    const bool isTetrahedron = views.shape == LightShape::Tetrahedron;
    return {{GL_VERTEX_SHADER, "shared/depth_layers.vert"},
            {GL_GEOMETRY_SHADER, isTetrahedron ? "shared/depth_tetrahedron.geom" : "shared/depth_layers.geom"},
            {GL_FRAGMENT_SHADER, "ombrage/depth_only.frag"}};
}

void setViews(const gl::Program& program, const LightViews& views, int resolution) {
    if (views.shape == LightShape::Paraboloids) {
        views.setUniforms(program);
        program.set("u_perResolution", 1.0f / float(resolution));
        // An arc of a circle of radius 1 or more bends by at most an eighth of its length's square; half a texel is 1 /
        // resolution.
        program.set("u_segment_rad", std::sqrt(8.0f / float(resolution)));
        return;
    }
    std::vector<glm::mat4> matrices;
    for (std::size_t v = 0; v < views.views.size(); ++v) matrices.push_back(views.clipFromWorld(v));
    program.set("u_clipFromWorld", matrices.data(), int(matrices.size()));
}

/// Into how many parts an edge may be cut. llvmpipe numbers the vertices that come of a draw with 16 bits, so meshes of
/// many triangles, whose edges are short, are cut less: n parts make about 3/4 n^2 vertices.
float mostParts(const FrameContext& frame, const DrawBatch& batch) {
    std::uint32_t most = 1;
    for (const std::uint32_t i : batch.instances)
        most = std::max(most, frame.gpuScene->flat().instances[i].triangleCount);
    return std::clamp(std::sqrt(65536.0f / (0.75f * float(most))), 8.0f, 64.0f);
}

/// While it lives, patches have three vertices.
class TrianglePatches {
public:
    TrianglePatches() {
        glGetIntegerv(GL_PATCH_VERTICES, &m_before);
        glPatchParameteri(GL_PATCH_VERTICES, 3);
    }
    ~TrianglePatches() { glPatchParameteri(GL_PATCH_VERTICES, m_before); }
    TrianglePatches(const TrianglePatches&) = delete;
    TrianglePatches& operator=(const TrianglePatches&) = delete;

private:
    GLint m_before = 3;
};

/// @param takes null: every caster
void drawDepth(const std::vector<bool>* takes, bool keep, FrameContext& frame, const LightFrame& light,
               const LightViews& views, const gl::Texture& map, GLenum cull) {
    const gl::Framebuffer target({}, {&map, 0, views.layers() > 1 ? -1 : 0}, "light depth");
    target.bind();
    gl::DrawState state;
    state.depthTest = state.depthWrite = true;
    // Casters before a perspective view's near side still cast; the sun's begins before all geometry.
    state.depthClamp = views.perspective;
    state.clipDistances = views.shape == LightShape::Usual ? 0 : 1;
    state.colorWrite = false;
    if (!keep) target.clearDepth(0.0f);

    frame.gpuScene->bindStorage();
    const bool isTessellated = views.shape == LightShape::Paraboloids;
    const TrianglePatches patches;
    const float nearest_m = 2.0f * views.views[0].near_m;  // the corners of a cube face's near plane
    const auto draw = [&](DrawFilter::Alpha alpha, bool positionsOnly) {
        Defines defines;
        if (views.shape != LightShape::Usual) defines = views.defines();
        if (!positionsOnly) defines.emplace_back("ALPHA_MASK", "1");
        const gl::Program& program = frame.program(stagesOf(views), std::move(defines));
        setViews(program, views, map.width());
        const DrawFilter filter{.castersOnly = true, .excludedByLight = light.index, .alpha = alpha};
        const std::vector<DrawBatch> some =
            takes ? frame.gpuScene->batchesOf(filter, *takes) : std::vector<DrawBatch>();
        for (const DrawBatch& batch : takes ? some : frame.gpuScene->batches(filter)) {
            // What a solid turns away from the light lies behind what it turns to it.
            const bool onlyFront = cull == GL_NONE && frame.gpuScene->hidesBackFaces(batch, light.toward(), nearest_m);
            state.cull = onlyFront ? GLenum(GL_BACK) : batch.bothSides ? GLenum(GL_NONE) : cull;
            gl::apply(state);
            if (isTessellated) program.set("u_mostParts", mostParts(frame, batch));
            const DrawCounts counts =
                frame.gpuScene->draw(batch, positionsOnly, isTessellated ? GL_PATCHES : GL_TRIANGLES);
            frame.countDraw(counts.draws, counts.triangles);
        }
    };
    draw(DrawFilter::Alpha::OpaqueOnly, true);
    if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly, false);
}

}  // namespace

void drawLightDepth(FrameContext& frame, const LightFrame& light, const LightViews& views, const gl::Texture& map,
                    GLenum cull) {
    drawDepth(nullptr, false, frame, light, views, map, cull);
}

void drawLightDepthOf(const std::vector<bool>& takes, bool keep, FrameContext& frame, const LightFrame& light,
                      const LightViews& views, const gl::Texture& map, GLenum cull) {
    drawDepth(&takes, keep, frame, light, views, map, cull);
}

}  // namespace ombrage
