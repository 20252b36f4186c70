// SPDX-License-Identifier: MIT
// shadow/backprojection: the texels of a light's map, projected from the receiver onto the light.
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/depth_pyramid.h"
#include "techniques/shared/map_params.h"

namespace ombrage {

namespace {

/// Squares of each size along a side.
enum class SquaresAcross { Eight, Sixteen, ThirtyTwo, SixtyFour };
/// Between squares at different depths.
enum class SquareGaps { Closed, Open };

}  // namespace

template <>
struct EnumChoices<SquaresAcross> {
    static std::vector<std::string> names() { return {"8", "16", "32", "64"}; }
};
template <>
struct EnumChoices<SquareGaps> {
    static std::vector<std::string> names() { return {"closed", "open"}; }
};

namespace {

constexpr GLuint kPyramidUnit = kFirstFreeUnit + 1;
constexpr const char* kLookups = "lookups";

struct BackprojectionParams : MapParams {
    SquaresAcross across = SquaresAcross::Sixteen;
    SquareGaps gaps = SquareGaps::Closed;
    int maxRadius_texels = 96;

    static ParamTable describe() {
        using P = BackprojectionParams;
        return mapTable(
            {field(&P::across, "max-texels")
                 .effect(ParamEffect::Host)
                 .help("Squares along a side that are looked at as single texels about the receiver; around them stand "
                       "as many of two texels, of four and so on: more make smoother penumbrae for more time."),
             field(&P::gaps, "gaps")
                 .effect(ParamEffect::Define)
                 .help("Between texels at different depths: closed, as one surface, or open, where light comes "
                       "through."),
             field(&P::maxRadius_texels, "max-radius", Unit::Texel)
                 .range(1, 1024)
                 .tune(16, 256)
                 .effect(ParamEffect::Host)
                 .help("How far from the receiver's place in the map occluders are looked for; a light that needs more "
                       "counts as a smaller one. The six views of a point light overlap by as much, up to a quarter "
                       "of their width.")});
    }
};

class Backprojection final : public ShadowLookupTechniqueOf<BackprojectionParams> {
public:
    void prepare(FrameContext&) override {
        m_depth.reset();
        m_pyramid.reset();
    }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        m_isSoft = light.light->hasSize();
        LightDepth::Options options = p().depthOptions();
        if (m_isSoft) options.margin_texels = std::min(p().maxRadius_texels + 2, p().resolution / 4);
        m_depth.update(frame, light, options);
        m_depth.setPlain();
        m_maxRadius_texels = float(p().maxRadius_texels);
        if (m_depth.views().views.size() > 1)
            m_maxRadius_texels = std::min(m_maxRadius_texels, float(std::max(options.margin_texels - 2, 1)));
        if (m_isSoft) m_pyramid.update(frame, m_depth);
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        m_range = m_depth.views().range(frame.gpuScene->origin());

        ShadowLookup lookup{"shadow/backprojection/backprojection.glsl", m_depth.defines(),
                            [this](const gl::Program& program) { bind(program); }, LightViews::perPass()};
        if (m_isSoft) lookup.defines.emplace_back("SOFT", "1");
        if (frame.wants(kLookups)) showLookups(frame, lookup);
        return lookup;
    }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes() + m_pyramid.gpuBytes(); }

private:
    void bind(const gl::Program& program) const {
        m_depth.views().setUniforms(program);
        m_depth.map().bind(kFirstFreeUnit);
        if (!m_isSoft) return;
        m_pyramid.texture().bind(kPyramidUnit);
        program.set("u_maxRadius_texels", m_maxRadius_texels);
        program.set("u_across", 8 << int(p().across));
    }

    void showLookups(FrameContext& frame, const ShadowLookup& lookup) {
        const FrameContext::Uncounted aside(frame);
        const gl::Texture value({.format = GL_R32F, .width = frame.width, .height = frame.height}, kLookups);
        const gl::Framebuffer target({{&value}}, {&frame.gbuffer->depth}, kLookups);
        target.bind();
        target.clearColor(0, glm::vec4(0));
        const gl::Program& program = frame.program(
            *this,
            {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shadow/backprojection/show.frag"}},
            lookup.defines, includeOf(lookup));
        lookup.bind(program);
        frame.bindGBuffer();
        frame.drawSurfaces();
        frame.expose(kLookups, value, ShowAs::Count);
    }

    LightDepth m_depth;
    DepthPyramid m_pyramid;
    bool m_isSoft = false;
    float m_maxRadius_texels = 0;
    TexelFootprint m_footprint;
    ShadowRange m_range;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, backprojection, Backprojection,
    {.title = "Backprojection",
     .summary =
         "Every texel of a shadow map that lies between a point and the light is a small occluder: what they hide "
         "of the light, added up.",
     .papers = {"guennebaud2006backprojection"},
     .limits = "What several casters hide of the light is added up, so overlapping ones are too dark; what the light's "
               "centre does not see hides nothing.",
     .domain = {.rect = true, .soft = true},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {kLookups, "squares of the map that each pixel looks at"}}})

}  // namespace ombrage
