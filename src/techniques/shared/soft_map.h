// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/depth_pyramid.h"
#include "techniques/shared/map_params.h"

namespace ombrage {

/// Parameters of techniques that look about a point of a light's map as far as its penumbra asks. Parameter structs
/// derive from it, with it as their only base.
struct SoftMapParams : MapParams {
    int maxRadius_texels = 64;

    static ParamField maxRadiusField(const SoftMapParams& defaults, const char* help) {
        ParamField made = field(&SoftMapParams::maxRadius_texels, "max-radius", Unit::Texel)
                              .range(1, 1024)
                              .tune(16, 256)
                              .effect(ParamEffect::Host)
                              .help(help);
        made.info.defaultValue = made.get(&defaults);
        return made;
    }
};

/// A technique of soft shadows from one LightDepth and, where the light has a size, its DepthPyramid:
/// shared/soft_light.glsl.
template <typename P>
class SoftMapTechniqueOf : public ShadowLookupTechniqueOf<P> {
public:
    void prepare(FrameContext&) override {
        m_depth.reset();
        m_pyramid.reset();
    }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes() + m_pyramid.gpuBytes(); }

protected:
    static constexpr GLuint kPyramidUnit = kFirstFreeUnit + 1;

    /// Brings map and pyramid up to date and looks them up by the GLSL of `path`, which reads u_maxRadius_texels where
    /// SOFT is defined: the light has a size. `bindSoft` sets what else it reads there, and must live as long as this.
    /// @param kernelRadius_texels  of the narrowest filter of a light with a size
    ShadowLookup lookUp(FrameContext& frame, const LightFrame& light, const std::string& path,
                        double kernelRadius_texels, std::function<void(const gl::Program&)> bindSoft) {
        const bool isSoft = light.light->hasSize();
        LightDepth::Options options = this->p().depthOptions();
        if (isSoft) options.margin_texels = this->p().maxRadius_texels + kBeside_texels;
        m_depth.update(frame, light, options);
        m_depth.setPlain();
        if (isSoft) m_pyramid.update(frame, m_depth);
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(options.resolution);
        if (isSoft) m_footprint.kernelRadius_texels = kernelRadius_texels;
        m_range = m_depth.views().range(frame.gpuScene->origin());

        // Where views meet, lookups reach no farther than these overlap.
        int reach_texels = this->p().maxRadius_texels;
        if (m_depth.views().views.size() > 1)
            reach_texels = std::min(reach_texels, std::max(m_depth.margin_texels() - kBeside_texels, 1));
        ShadowLookup lookup{path, m_depth.defines(),
                            [this, isSoft, reach_texels, bindSoft = std::move(bindSoft)](const gl::Program& program) {
                                m_depth.views().setUniforms(program);
                                m_depth.map().bind(kFirstFreeUnit);
                                if (!isSoft) return;
                                m_pyramid.texture().bind(kPyramidUnit);
                                program.set("u_maxRadius_texels", float(reach_texels));
                                if (bindSoft) bindSoft(program);
                            },
                            LightViews::perPass()};
        if (isSoft) lookup.defines.emplace_back("SOFT", "1");
        return lookup;
    }

    /// Offers what the lookup finds on its way to --show: the fragment shader of `path`, compiled with `defines` too,
    /// writes it for each pixel.
    void show(FrameContext& frame, const ShadowLookup& lookup, const char* name, const char* path,
              const std::vector<std::pair<std::string, std::string>>& defines = {}) {
        if (!frame.wants(name)) return;
        const FrameContext::Uncounted aside(frame);
        const gl::Texture value({.format = GL_R32F, .width = frame.width, .height = frame.height}, name);
        const gl::Framebuffer target({{&value}}, {&frame.gbuffer->depth}, name);
        target.bind();
        target.clearColor(0, glm::vec4(0));
        auto all = lookup.defines;
        all.insert(all.end(), defines.begin(), defines.end());
        const gl::Program& program =
            frame.program(*this, {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, path}},
                          std::move(all), includeOf(lookup));
        lookup.bind(program);
        frame.bindGBuffer();
        frame.drawSurfaces();
        frame.expose(name, value, ShowAs::Count);
    }

private:
    /// Neighbours of the texels at the radius.
    static constexpr int kBeside_texels = 2;

    LightDepth m_depth;
    DepthPyramid m_pyramid;
    TexelFootprint m_footprint;
    ShadowRange m_range;
};

}  // namespace ombrage
