// SPDX-License-Identifier: MIT
// shadow/pcss: percentage-closer soft shadows, a filter of a light's map as wide as the penumbra.
#include <cmath>

#include "techniques/shared/disks.h"
#include "techniques/shared/soft_map.h"

namespace ombrage {

namespace {

enum class PcssKernel { Vogel, Poisson };
/// Which texels of the map shade a point.
enum class PcssBlockers { Cone, Depth };

}  // namespace

template <>
struct EnumChoices<PcssKernel> {
    static std::vector<std::string> names() { return {"vogel", "poisson"}; }
};
template <>
struct EnumChoices<PcssBlockers> {
    static std::vector<std::string> names() { return {"cone", "depth"}; }
};

namespace {

constexpr GLuint kNoiseUnit = kFirstFreeUnit + 2;
constexpr const char *kBlockerDepth = "blocker-depth", *kPenumbraWidth = "penumbra-width", *kClipped = "clipped";

struct PcssParams : SoftMapParams {
    int blockerSamples = 16;
    int filterSamples = 32;
    PcssKernel kernel = PcssKernel::Vogel;
    DiskRotation rotation = DiskRotation::Interleaved;
    PcssBlockers blockers = PcssBlockers::Cone;
    float minRadius_texels = 1.0f;

    static ParamTable describe() {
        using P = PcssParams;
        return mapTable(
            {field(&P::blockerSamples, "blocker-samples")
                 .range(1, 64)
                 .tune(4, 64)
                 .effect(ParamEffect::Define)
                 .help("Texels that are looked at for blockers: more find thinner ones, and cost more everywhere."),
             field(&P::filterSamples, "filter-samples")
                 .range(1, 64)
                 .tune(8, 64)
                 .effect(ParamEffect::Define)
                 .help("Texels that are compared in penumbrae: more make less noise, or fewer steps, and cost more."),
             field(&P::kernel, "kernel")
                 .effect(ParamEffect::Host)
                 .help("How both spread over the light: along a spiral, or as points that keep apart."),
             field(&P::rotation, "rotation")
                 .effect(ParamEffect::Define)
                 .help("Turns them from pixel to pixel, which makes noise of steps: not at all, by interleaved "
                       "gradient noise or by blue noise."),
             field(&P::blockers, "blockers")
                 .effect(ParamEffect::Define)
                 .help("What shades a point: what its map shows between it and the light (cone), or all that is nearer "
                       "to the light within the filter, as published (depth)."),
             field(&P::minRadius_texels, "min-radius", Unit::Texel)
                 .range(0, 8)
                 .tune(0, 3)
                 .help("Narrowest filter of lights with a size: more hides the texels' steps where penumbrae are "
                       "narrower than they."),
             maxRadiusField(P(),
                            "Widest filter and search, beyond which penumbrae stay narrower than they are; the six "
                            "views of a point light overlap by as much, up to a quarter of them.")});
    }
};

class Pcss final : public SoftMapTechniqueOf<PcssParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        m_isRect = light.light->type == LightType::Rect;
        const ShadowLookup lookup = lookUp(frame, light, "shadow/pcss/pcss.glsl", double(p().minRadius_texels),
                                           [this](const gl::Program& program) { bind(program); });
        const char* names[] = {kBlockerDepth, kPenumbraWidth, kClipped};
        for (int shown = 0; shown < 3; ++shown)
            show(frame, lookup, names[shown], "shadow/pcss/show.frag", {{"SHOWN", std::to_string(shown)}});
        return lookup;
    }

private:
    void bind(const gl::Program& program) {
        const std::vector<glm::vec2> search = searchPoints(), filter = onLight(disk(p().filterSamples));
        program.set("u_searchDisk", search.data(), int(search.size()));
        program.set("u_filterDisk", filter.data(), int(filter.size()));
        if (p().rotation != DiskRotation::BlueNoise) return;
        if (!m_blueNoise) m_blueNoise = blueNoiseTexture();
        m_blueNoise.bind(kNoiseUnit);
    }

    std::vector<glm::vec2> disk(int count) const {
        return p().kernel == PcssKernel::Vogel ? vogelDisk(count) : poissonDisk(count);
    }

    /// The closer a blocker is to the receiver, the smaller a part of the region shows what of it is before the light:
    /// the points stand as dense along the radius as across it, and the first looks where the light's centre is.
    std::vector<glm::vec2> searchPoints() const {
        std::vector<glm::vec2> points = disk(p().blockerSamples);
        for (glm::vec2& point : points) point *= glm::length(point);
        points.front() = glm::vec2(0.0f);
        return onLight(points);
    }

    /// For a rect in polar coordinates, the angle in turns.
    std::vector<glm::vec2> onLight(std::vector<glm::vec2> points) const {
        if (!m_isRect) return points;
        for (glm::vec2& point : points) point = {glm::length(point), std::atan2(point.y, point.x) / 6.28318531f + 1.0f};
        return points;
    }

    gl::Texture m_blueNoise;
    bool m_isRect = false;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, pcss, Pcss,
    {.title = "Percentage-closer soft shadows",
     .summary =
         "A shadow map filtered as widely as the penumbra, which the blockers found about each point tell: sharp "
         "at the contact, soft away from it.",
     .papers = {"fernando2005pcss", "guennebaud2006backprojection", "shirley1997map"},
     .limits =
         "One mean blocker stands for all, so penumbrae that overlap have one width; what the light's centre does "
         "not see blocks nothing.",
     .domain = {.rect = true, .soft = true},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {kBlockerDepth, "mean distance of the blockers from the light along the view's axis, in metres"},
                {kPenumbraWidth, "width of the penumbra at the receiver, in metres"},
                {kClipped, "where the search is cut off by max-radius"}}})

}  // namespace ombrage
