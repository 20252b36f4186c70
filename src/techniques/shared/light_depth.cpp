// SPDX-License-Identifier: MIT
#include "techniques/shared/light_depth.h"

#include <algorithm>

#include "render/frame_context.h"
#include "techniques/shared/copy.h"
#include "techniques/shared/depth_pass.h"

namespace ombrage {

namespace {

/// So many updates without motion, and all casters count as still again.
constexpr int kQuietUpdates = 30;

/// Where the casters stand, by their order in the scene.
std::vector<glm::mat4> casterPlacements(const FrameContext& frame) {
    std::vector<glm::mat4> placements;
    for (const FlatInstance& instance : frame.gpuScene->flat().instances)
        if (instance.casts) placements.push_back(instance.originFromLocal);
    return placements;
}

GLenum glFormat(DepthFormat format) {
    switch (format) {
        case DepthFormat::Unorm16:
            return GL_DEPTH_COMPONENT16;
        case DepthFormat::Unorm24:
            return GL_DEPTH_COMPONENT24;
        case DepthFormat::Float32:
            break;
    }
    return GL_DEPTH_COMPONENT32F;
}

}  // namespace

void LightDepth::reset() {
    m_drawn.reset();
    m_views.reset();
    forgetMotion();
}

void LightDepth::forgetMotion() {
    m_moves.clear();
    m_still.reset();
    m_quietUpdates = 0;
}

void LightDepth::sceneMoved() {
    // What was drawn knows where its casters stood, and tells whether those did move.
    m_views.reset();
    m_mayHaveMoved = true;
}

int LightDepth::margin_texels(const Options& options) {
    return std::min(options.margin_texels, options.resolution / 4);
}

/// Fitting looks at every caster's vertices, and to the scene depends on the light alone.
void LightDepth::fitViews(const FrameContext& frame, const LightFrame& light, const Options& options) {
    const Pose pose{light.light->type, light.position, light.direction, light.light->outer_rad};
    const bool isFitted = m_views && options.fit == LightFit::Scene && m_fitted.fit == LightFit::Scene &&
                          m_pose == pose && m_fitted.resolution == options.resolution &&
                          m_fitted.margin_texels == options.margin_texels && m_fitted.shape == options.shape;
    if (isFitted) return;
    const float margin = 2.0f * float(margin_texels(options)) / float(options.resolution);
    m_views = makeLightViews(frame, light, options.fit, margin, options.shape);
    m_pose = pose;
    m_fitted = options;
}

bool LightDepth::holds(const FrameContext& frame, const Options& options) const {
    return options.keep && m_drawn && m_drawn->options == options && m_drawn->views == *m_views &&
           !(m_mayHaveMoved && m_drawn->casters != casterPlacements(frame));
}

void LightDepth::makeMap(const Options& options) {
    const gl::TextureDesc desc{.kind = m_views->layers() > 1 ? gl::TextureKind::Array2D : gl::TextureKind::Tex2D,
                               .format = glFormat(options.format),
                               .width = options.resolution,
                               .height = options.resolution,
                               .layers = m_views->layers()};
    const bool hasBorder = options.margin_texels > 0;
    if (m_map && m_map.desc() == desc && m_hasBorder == hasBorder) return;
    m_map = gl::Texture(desc, "light depth");
    m_hasBorder = hasBorder;
    m_comparesLinear.reset();
    if (hasBorder) m_map.setBorder(glm::vec4(0.0f));
}

void LightDepth::setCompare(bool linear) {
    if (m_comparesLinear == linear) return;
    m_comparesLinear = linear;
    m_map.setCompare(GL_GEQUAL);
    const GLenum filter = linear ? GL_LINEAR : GL_NEAREST;
    m_map.setFilter(filter, filter);
}

void LightDepth::setPlain() {
    if (!m_comparesLinear) return;
    m_comparesLinear.reset();
    m_map.setCompare(GL_NONE);
    m_map.setFilter(GL_NEAREST, GL_NEAREST);
}

std::vector<std::pair<std::string, std::string>> LightDepth::defines() const {
    auto defines = m_views->defines();
    if (m_drawn->options.format == DepthFormat::Unorm16) defines.emplace_back("MAP_BITS", "16");
    if (m_drawn->options.format == DepthFormat::Unorm24) defines.emplace_back("MAP_BITS", "24");
    return defines;
}

void LightDepth::update(FrameContext& frame, const LightFrame& light, const Options& options) {
    fitViews(frame, light, options);
    const bool isThere = holds(frame, options);
    m_mayHaveMoved = false;
    if (isThere) {
        if (!m_moves.empty() && ++m_quietUpdates > kQuietUpdates) forgetMotion();
        return;
    }
    makeMap(options);
    std::vector<glm::mat4> casters = casterPlacements(frame);
    draw(frame, light, casters, options);
    m_drawn = {*m_views, options, std::move(casters)};
    ++m_drawnCount;
}

void LightDepth::draw(FrameContext& frame, const LightFrame& light, const std::vector<glm::mat4>& casters,
                      const Options& options) {
    if (drawStill(frame, light, casters, options)) {
        const auto pass = frame.pass("light depth");
        copyTexture(m_still->map, m_map);
        drawLightDepthOf(m_moves, true, frame, light, *m_views, m_map, options.cull);
        return;
    }
    const auto pass = frame.pass("light depth");
    drawLightDepth(frame, light, *m_views, m_map, options.cull);
}

/// Brings the map of what stands still up to date, for the second time in a row that some casters moved and others not.
/// False where all are to be drawn.
bool LightDepth::drawStill(FrameContext& frame, const LightFrame& light, const std::vector<glm::mat4>& casters,
                           const Options& options) {
    const bool onlyCastersDiffer = options.keep && m_drawn && m_drawn->options == options &&
                                   m_drawn->views == *m_views && m_drawn->casters.size() == casters.size();
    if (!onlyCastersDiffer) {
        forgetMotion();
        return false;
    }
    m_quietUpdates = 0;
    const std::vector<FlatInstance>& instances = frame.gpuScene->flat().instances;
    const bool movedBefore = !m_moves.empty();
    m_moves.resize(instances.size(), false);
    std::vector<bool> still(instances.size(), false);
    bool anyStill = false;
    for (std::size_t i = 0, caster = 0; i < instances.size(); ++i) {
        if (!instances[i].casts) continue;
        if (m_drawn->casters[caster] != casters[caster]) m_moves[i] = true;
        ++caster;
        still[i] = !m_moves[i];
        anyStill = anyStill || still[i];
    }
    if (!movedBefore || !anyStill) {
        m_still.reset();
        return false;
    }

    if (m_still && m_still->instances == still) return true;
    if (!m_still) m_still = Still{gl::Texture(m_map.desc(), "still casters' depth"), {}};
    m_still->instances = std::move(still);
    const auto pass = frame.pass("static depth");
    drawLightDepthOf(m_still->instances, false, frame, light, *m_views, m_still->map, options.cull);
    return true;
}

}  // namespace ombrage
