// SPDX-License-Identifier: MIT
// shadow/volume-hybrid: a shadow map decides where it is sure, volumes where it is not.
#include <algorithm>
#include <vector>

#include "render/technique.h"
#include "techniques/shared/light_depth.h"
#include "techniques/shared/volume_fill.h"
#include "techniques/shared/volume_split.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

struct VolumeHybridParams : VolumeParams {
    int resolution = 1024;
    int radius = 1;
    float margin_texels = 1.0f;
    float maxSlope = 40.0f;
    bool cache = true;

    static ParamTable describe() {
        using P = VolumeHybridParams;
        return volumeTableWithoutEnds(
            {field(&P::resolution, "resolution", Unit::Texel)
                 .range(16, 8192, Scale::Log)
                 .tune(256, 4096)
                 .effect(ParamEffect::Resize)
                 .help(
                     "Width and height of the map: finer, fewer pixels are left to the volumes and thinner casters are "
                     "found."),
             field(&P::radius, "radius", Unit::Texel)
                 .range(1, 4)
                 .effect(ParamEffect::Define)
                 .help("How far around a point the map must be of one mind."),
             field(&P::margin_texels, "margin", Unit::Texel)
                 .range(0, 16)
                 .tune(0, 4)
                 .help(
                     "How far before the surface the map's depth must lie to be surely dark; nearer, volumes decide."),
             field(&P::maxSlope, "max-slope")
                 .range(0, 100)
                 .help("Steepest slope at which the receiver's plane is followed between texels."),
             field(&P::cache, "cache")
                 .effect(ParamEffect::Host)
                 .help("Keeps the map while neither the light nor the casters changed.")});
    }
};

class VolumeHybrid final : public ShadowTechniqueOf<VolumeHybridParams> {
public:
    void prepare(FrameContext&) override {
        m_volumes.reset();
        m_map.reset();
    }

    void sceneMoved(FrameContext&) override {
        m_volumes.reset();
        m_map.sceneMoved();
    }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const VolumeChoice byZFail = countedByZFail(frame, light, CountingMode::Clamp);
        m_volumes.update(frame, light, ShadowVolumeOptions(p()), byZFail);
        m_volumes.report(frame);
        m_map.update(frame, light, {.resolution = p().resolution, .keep = p().cache});
        const TargetPool::Target marked = askMap(frame, visibility);

        VolumeCounter counter(frame, light, m_volumes, p().twoSided);
        counter.restrictToMarked();
        const VolumeSplit split(frame, light, m_volumes, CountingMode::Clamp, byZFail);
        {
            const auto pass = frame.pass("shadow volumes");
            counter.begin(split.atTheEye);
            counter.mark(*marked);
            split.count(counter);
        }
        if (frame.wants("hybrid-marked")) frame.expose("hybrid-marked", *marked, ShowAs::Value);
        showVolumes(frame, light, m_volumes);
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }
        if (frame.countsSavings()) countSavings(frame, light, *marked);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes() + m_map.gpuBytes(); }

private:
    /// Chan and Durand 2004, section 3: a pixel whose texels disagree may lie at a silhouette.
    TargetPool::Target askMap(FrameContext& frame, const gl::Texture& visibility) {
        const auto pass = frame.pass("what the map knows");
        auto marked =
            frame.targets->take({.format = GL_R8, .width = frame.width, .height = frame.height}, "hybrid marks");
        const gl::Framebuffer target({{&visibility}, {marked.get()}}, {&frame.gbuffer->depth}, "hybrid");
        target.bind();
        target.clearColor(1, glm::vec4(0));
        frame.bindGBuffer();
        m_map.map().bind(kFirstFreeUnit);
        const gl::Program& program = frame.program(
            *this,
            {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shadow/volume-hybrid/hybrid.frag"}},
            m_map.defines(), {{"ombrage/per_pass_lookup.glsl", LightViews::perPass()}});
        m_map.views().setUniforms(program);
        frame.drawSurfaces();
        return marked;
    }

    void countSavings(FrameContext& frame, const LightFrame& light, const gl::Texture& marked) {
        reportFill(frame, countFill(frame, light, m_volumes.options(), &marked));
        std::vector<std::uint8_t> marks(std::size_t(frame.width) * std::size_t(frame.height));
        marked.download(0, 0, GL_RED, GL_UNSIGNED_BYTE, marks.size(), marks.data());
        frame.counter("pixels left to volumes",
                      double(std::count_if(marks.begin(), marks.end(), [](auto m) { return m != 0; })));
    }

    ShadowVolumes m_volumes;
    LightDepth m_map;
};

std::vector<PassInfo> passes() {
    std::vector<PassInfo> all = volumePasses();
    all.insert(all.begin(), {"hybrid-marked", "pixels that the map leaves to the volumes"});
    return all;
}

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_hybrid, VolumeHybrid,
    {.title = "Hybrid of shadow map and volumes",
     .summary =
         "A shadow map decides wherever all its texels about a point agree, and shadow volumes are counted in the "
         "remaining pixels: sharp edges for a fraction of the fill.",
     .papers = {"chan2004hybrid", "everitt2002volumes", "williams1978"},
     .limits = "Casters and gaps that the map has no texel of are lost. Hard shadows of opaque triangles only.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = passes(),
     .needsStencil = true})

}  // namespace ombrage
