// SPDX-License-Identifier: MIT
// shadow/map: depth seen from the light (Williams 1978), with the whole family of biases. Everything but its GLSL and
// manual page.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/depth_pass.h"
#include "techniques/shared/light_views.h"

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
    void prepare(FrameContext&) override {
        m_drawn.reset();
        m_views.reset();
    }

    /// What was drawn knows where its casters stood: others may have moved.
    void sceneMoved(FrameContext&) override {
        m_views.reset();
        m_mayHaveMoved = true;
    }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        fitViews(frame, light);
        drawDepth(frame, light);
        if (frame.wants("light-depth")) frame.expose("light-depth", m_map, ShowAs::LightDepth);
        m_footprint = m_views->footprint(p().resolution);
        m_range = m_views->range(frame.gpuScene->origin());
        return {"shadow/map/map.glsl", m_views->defines(),
                [this](const gl::Program& program) {
                    m_views->setUniforms(program);
                    m_map.bind(kFirstFreeUnit);
                },
                LightViews::perPass()};
    }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_map ? gl::byteSize(m_map.desc()) : 0; }

private:
    /// Fitting looks at every caster's vertices, and to the scene depends on the light alone.
    void fitViews(const FrameContext& frame, const LightFrame& light) {
        const Pose pose{light.light->type, light.position, light.direction, light.light->outer_rad};
        if (m_views && p().fit == LightFit::Scene && m_fit == LightFit::Scene && m_pose == pose) return;
        m_views = makeLightViews(frame, light, p().fit);
        m_pose = pose;
        m_fit = p().fit;
    }

    void drawDepth(FrameContext& frame, const LightFrame& light) {
        const LightViews& views = *m_views;
        const bool isDrawn = p().cache && m_drawn && m_drawn->views == views &&
                             !(m_mayHaveMoved && m_drawn->casters != casterPlacements(frame));
        m_mayHaveMoved = false;
        if (isDrawn) return;
        const gl::TextureDesc desc{.kind = views.views.size() > 1 ? gl::TextureKind::Array2D : gl::TextureKind::Tex2D,
                                   .format = GL_DEPTH_COMPONENT32F,
                                   .width = p().resolution,
                                   .height = p().resolution,
                                   .layers = int(views.views.size())};
        if (!m_map || m_map.desc() != desc) {
            m_map = gl::Texture(desc, "shadow map");
            m_map.setCompare(GL_GEQUAL);
        }
        const auto pass = frame.pass("light depth");
        // Second-depth maps (Wang and Molnar 1994) hold the far sides of closed casters.
        GLenum cull = p().bias == BiasMode::SecondDepth ? GL_FRONT : GL_NONE;
        if (p().cull == CullMode::Front) cull = GL_FRONT;
        if (p().cull == CullMode::Back) cull = GL_BACK;
        drawLightDepth(frame, light, views, m_map, cull);
        m_drawn = {views, casterPlacements(frame)};
    }

    /// Where the casters stand, by their order in the scene.
    static std::vector<glm::mat4> casterPlacements(const FrameContext& frame) {
        std::vector<glm::mat4> placements;
        for (const FlatInstance& instance : frame.gpuScene->flat().instances)
            if (instance.casts) placements.push_back(instance.originFromLocal);
        return placements;
    }

    /// What a light's views depend on beside the scene.
    struct Pose {
        LightType type = LightType::Sun;
        glm::vec3 position{0.0f}, direction{0.0f};
        float outer_rad = 0;
        bool operator==(const Pose&) const = default;
    };

    /// What the map holds.
    struct Drawn {
        LightViews views;
        std::vector<glm::mat4> casters;
    };

    gl::Texture m_map;
    std::optional<LightViews> m_views;
    Pose m_pose;  ///< m_views were made for it, and for m_fit
    LightFit m_fit = LightFit::Scene;
    std::optional<Drawn> m_drawn;
    bool m_mayHaveMoved = false;  ///< casters, since the map was drawn
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
