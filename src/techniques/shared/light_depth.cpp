// SPDX-License-Identifier: MIT
#include "techniques/shared/light_depth.h"

#include "render/frame_context.h"
#include "techniques/shared/depth_pass.h"

namespace ombrage {

namespace {

/// Where the casters stand, by their order in the scene.
std::vector<glm::mat4> casterPlacements(const FrameContext& frame) {
    std::vector<glm::mat4> placements;
    for (const FlatInstance& instance : frame.gpuScene->flat().instances)
        if (instance.casts) placements.push_back(instance.originFromLocal);
    return placements;
}

}  // namespace

void LightDepth::reset() {
    m_drawn.reset();
    m_views.reset();
}

void LightDepth::sceneMoved() {
    // What was drawn knows where its casters stood, and tells whether those did move.
    m_views.reset();
    m_mayHaveMoved = true;
}

/// Fitting looks at every caster's vertices, and to the scene depends on the light alone.
void LightDepth::fitViews(const FrameContext& frame, const LightFrame& light, LightFit fit) {
    const Pose pose{light.light->type, light.position, light.direction, light.light->outer_rad};
    if (m_views && fit == LightFit::Scene && m_fit == LightFit::Scene && m_pose == pose) return;
    m_views = makeLightViews(frame, light, fit);
    m_pose = pose;
    m_fit = fit;
}

bool LightDepth::holds(const FrameContext& frame, const Options& options) const {
    return options.keep && m_drawn && m_drawn->options == options && m_drawn->views == *m_views &&
           !(m_mayHaveMoved && m_drawn->casters != casterPlacements(frame));
}

void LightDepth::update(FrameContext& frame, const LightFrame& light, const Options& options) {
    fitViews(frame, light, options.fit);
    const bool isThere = holds(frame, options);
    m_mayHaveMoved = false;
    if (isThere) return;

    const gl::TextureDesc desc{.kind = m_views->views.size() > 1 ? gl::TextureKind::Array2D : gl::TextureKind::Tex2D,
                               .format = GL_DEPTH_COMPONENT32F,
                               .width = options.resolution,
                               .height = options.resolution,
                               .layers = int(m_views->views.size())};
    if (!m_map || m_map.desc() != desc) m_map = gl::Texture(desc, "light depth");
    m_map.setCompare(options.compare ? GL_GEQUAL : GL_NONE);
    const auto pass = frame.pass("light depth");
    drawLightDepth(frame, light, *m_views, m_map, options.cull);
    m_drawn = {*m_views, options, casterPlacements(frame)};
}

}  // namespace ombrage
