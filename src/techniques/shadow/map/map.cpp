// SPDX-License-Identifier: MIT
// shadow/map: depth seen from the light (Williams 1978), with the whole family of biases. Everything but its GLSL and
// manual page.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/light_depth.h"

namespace ombrage {
namespace {

enum class BiasMode { Constant, Slope, NormalOffset, ReceiverPlane, Adaptive, Oriented, SecondDepth };
enum class CullMode { None, Front, Back };

}  // namespace

template <>
struct EnumChoices<BiasMode> {
    static std::vector<std::string> names() {
        return {"constant", "slope", "normal-offset", "receiver-plane", "adaptive", "oriented", "second-depth"};
    }
};
template <>
struct EnumChoices<CullMode> {
    static std::vector<std::string> names() { return {"none", "front", "back"}; }
};
template <>
struct EnumChoices<LightFit> {
    static std::vector<std::string> names() { return {"scene", "view"}; }
};

namespace {

struct MapParams {
    int resolution = 1024;
    BiasMode bias = BiasMode::Adaptive;
    float constantBias_texels = 0.5f;
    float slopeBias_texels = 0.75f;
    float normalOffset_texels = 1.0f;
    float maxSlope = 40.0f;
    CullMode cull = CullMode::None;
    LightFit fit = LightFit::Scene;
    bool cache = true;

    static ParamTable describe() {
        using P = MapParams;
        return fields(
            field(&P::resolution, "resolution", Unit::Texel)
                .range(16, 8192, Scale::Log)
                .tune(256, 4096)
                .effect(ParamEffect::Resize)
                .help("Width and height of the map (of each of six for a point light): finer edges for more time and "
                      "memory."),
            field(&P::bias, "bias").effect(ParamEffect::Define).help("How a surface is kept from shadowing itself."),
            field(&P::constantBias_texels, "constant-bias", Unit::Texel)
                .range(0, 32)
                .tune(0, 4)
                .help("Distance towards the light, added in every mode: less acne, wider contact gaps."),
            field(&P::slopeBias_texels, "slope-bias", Unit::Texel)
                .range(0, 16)
                .tune(0, 4)
                .help("Distance per unit of slope (tangent of the light's angle to the normal), in mode slope."),
            field(&P::normalOffset_texels, "normal-offset", Unit::Texel)
                .range(0, 16)
                .tune(0, 4)
                .help("Shift along the normal times the sine of the light's angle to it, in mode normal-offset."),
            field(&P::maxSlope, "max-slope")
                .range(0, 100)
                .tune(1, 100)
                .help("Steepest slope that the biases follow: higher, less acne at grazing light; lower, fewer leaks."),
            field(&P::cull, "cull")
                .effect(ParamEffect::Host)
                .help("Which faces, seen from the light, stay out of the map."),
            field(&P::fit, "fit")
                .effect(ParamEffect::Host)
                .help("What a sun's map covers: all that casts, or the part that can shade what the camera sees "
                      "(finer, but it "
                      "moves with the camera)."),
            field(&P::cache, "cache")
                .effect(ParamEffect::Host)
                .help("Keeps the map while neither the light nor the casters nor the fit changed."));
    }
};

class ShadowMap final : public ShadowLookupTechniqueOf<MapParams> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        m_depth.update(
            frame, light,
            {.resolution = p().resolution, .fit = p().fit, .cull = culled(), .keep = p().cache, .compare = true});
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        m_range = m_depth.views().range(frame.gpuScene->origin());
        return {"shadow/map/map.glsl", m_depth.views().defines(),
                [this](const gl::Program& program) {
                    m_depth.views().setUniforms(program);
                    m_depth.map().bind(kFirstFreeUnit);
                },
                LightViews::perPass()};
    }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes(); }

private:
    GLenum culled() const {
        if (p().cull == CullMode::Front) return GL_FRONT;
        if (p().cull == CullMode::Back) return GL_BACK;
        // Second-depth maps (Wang and Molnar 1994) hold the far sides of closed casters.
        return p().bias == BiasMode::SecondDepth ? GL_FRONT : GL_NONE;
    }

    LightDepth m_depth;
    TexelFootprint m_footprint;
    ShadowRange m_range;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, map, ShadowMap,
    {.title = "Shadow map",
     .summary = "Compares each surface's distance from the light with the depth that the light sees there.",
     .papers = {"williams1978", "wang1994seconddepth", "isidoro2006pcf", "holbert2011normaloffset", "dou2014adaptive",
                "ffxvi2023"},
     .limits = "Edges are as coarse as the map's texels; casters thinner than a texel break up.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"}}})

}  // namespace ombrage
