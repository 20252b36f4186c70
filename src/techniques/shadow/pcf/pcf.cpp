// SPDX-License-Identifier: MIT
// shadow/pcf: percentage-closer filtering of a light's map, on a grid of texels or on a disk of points.
#include <cmath>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/disks.h"
#include "techniques/shared/map_params.h"

namespace ombrage {
namespace {

enum class Kernel { Grid, Poisson, Vogel };
/// Who compares a texel with what.
enum class Compare { Texels, Hardware };

}  // namespace

template <>
struct EnumChoices<Kernel> {
    static std::vector<std::string> names() { return {"grid", "poisson", "vogel"}; }
};
template <>
struct EnumChoices<Compare> {
    static std::vector<std::string> names() { return {"texels", "hardware"}; }
};

namespace {

constexpr GLuint kNoiseUnit = kFirstFreeUnit + 1;

struct PcfParams : MapParams {
    Kernel kernel = Kernel::Grid;
    int size = 3;
    float radius_texels = 2.0f;
    int samples = 16;
    DiskRotation rotation = DiskRotation::Interleaved;
    float crease = 10.0f;
    Compare compare = Compare::Texels;

    static ParamTable describe() {
        using P = PcfParams;
        return mapTable(
            {field(&P::kernel, "kernel")
                 .effect(ParamEffect::Define)
                 .help("Where texels are compared: a square of them, or points of a disk, evenly spread (poisson, "
                       "vogel)."),
             field(&P::size, "size", Unit::Texel)
                 .range(1, 9)
                 .tune(1, 9)
                 .effect(ParamEffect::Define)
                 .help("Width of the square with kernel=grid: wider blurs more; it costs by its square."),
             field(&P::radius_texels, "radius", Unit::Texel)
                 .range(0, 32)
                 .tune(0.5, 8)
                 .help("Of the disk: larger blurs more and needs more samples."),
             field(&P::samples, "samples")
                 .range(1, 64)
                 .tune(4, 64)
                 .effect(ParamEffect::Define)
                 .help("Points of the disk: more cost more and show fewer steps, or less noise."),
             field(&P::rotation, "rotation")
                 .effect(ParamEffect::Define)
                 .help("Turns the disk from pixel to pixel, which makes noise of steps: not at all, by interleaved "
                       "gradient noise or by blue noise."),
             field(&P::crease, "crease")
                 .range(0, 64)
                 .tune(0, 16)
                 .help("Steepest corner of two surfaces, height over width, that does not darken itself: higher, less "
                       "acne where walls meet; lower, a whole outer rim of shadows close to their casters."),
             field(&P::compare, "compare")
                 .effect(ParamEffect::Define)
                 .help("texels: every texel with the receiver's distance at its own centre. hardware: the sampler "
                       "compares four with one distance, which asks for more bias.")});
    }

    /// How far from the point a texel may lie that is looked at.
    float reach_texels() const { return kernel == Kernel::Grid ? 0.5f * float(size) : radius_texels; }
};

class Pcf final : public ShadowLookupTechniqueOf<PcfParams> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        LightDepth::Options options = p().depthOptions();
        options.margin_texels = int(std::ceil(p().reach_texels())) + 1;
        m_depth.update(frame, light, options);
        if (p().compare == Compare::Hardware)
            m_depth.setCompare(true);
        else
            m_depth.setPlain();
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        m_footprint.kernelRadius_texels = double(p().reach_texels()) + 0.5;
        m_range = m_depth.views().range(frame.gpuScene->origin());
        return {"shadow/pcf/pcf.glsl", m_depth.defines(), [this](const gl::Program& program) { bind(program); },
                LightViews::perPass()};
    }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes(); }

private:
    void bind(const gl::Program& program) {
        m_depth.views().setUniforms(program);
        m_depth.map().bind(kFirstFreeUnit);
        if (p().kernel == Kernel::Grid) return;
        if (m_disk.size() != std::size_t(p().samples) || m_diskKernel != p().kernel) {
            m_disk = p().kernel == Kernel::Vogel ? vogelDisk(p().samples) : poissonDisk(p().samples);
            m_diskKernel = p().kernel;
        }
        program.set("u_disk", m_disk.data(), p().samples);
        if (p().rotation != DiskRotation::BlueNoise) return;
        if (!m_blueNoise) m_blueNoise = blueNoiseTexture();
        m_blueNoise.bind(kNoiseUnit);
    }

    LightDepth m_depth;
    std::vector<glm::vec2> m_disk;  ///< of p().samples points
    Kernel m_diskKernel = Kernel::Poisson;
    gl::Texture m_blueNoise;
    TexelFootprint m_footprint;
    ShadowRange m_range;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, pcf, Pcf,
    {.title = "Percentage-closer filtering",
     .summary = "A shadow map compared in many places about each point and averaged: edges of one width, without the "
                "steps of the texels.",
     .papers = {"reeves1987pcf", "isidoro2006pcf", "dou2014adaptive", "jimenez2014noise", "vogel1979",
                "mitchell1991candidates", "ulichney1993voidcluster"},
     .limits = "The blur has one width, whatever lies between caster and receiver, and it rounds off what is thinner.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"}}})

}  // namespace ombrage
