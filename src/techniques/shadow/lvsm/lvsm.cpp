// SPDX-License-Identifier: MIT
// shadow/lvsm: layered variance shadow maps (Lauritzen, McCool 2008).
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shadow/lvsm/layers.h"
#include "techniques/shared/moment_technique.h"

namespace ombrage {
namespace {

/// Where the layers end.
enum class LvsmPlacement { Depths, Even };

constexpr int kBins = 256;
constexpr GLuint kCountStorage = 11;
/// Texels of a work group, a side.
constexpr int kGroup_texels = 64;

}  // namespace

template <>
struct EnumChoices<LvsmPlacement> {
    static std::vector<std::string> names() { return {"depths", "even"}; }
};

namespace {

struct LvsmParams : VarianceMapParams {
    int layers = 4;
    LvsmPlacement placement = LvsmPlacement::Depths;
    MomentBits bits = MomentBits::Unorm16;
    float overlap = 0.1f;

    LvsmParams() { bleeding = 0.2f; }

    static ParamTable describe() {
        using P = LvsmParams;
        return varianceTable(
            {field(&P::layers, "layers")
                 .range(1, 8)
                 .tune(2, 8)
                 .effect(ParamEffect::Define)
                 .help(
                     "Of depth, each with two moments: more, less light through overlapping casters, for as much more "
                     "memory."),
             field(&P::placement, "placement")
                 .effect(ParamEffect::Host)
                 .help("depths: about the depths that the map holds; even: of equal depth."),
             field(&P::bits, "bits")
                 .effect(ParamEffect::Define)
                 .help("Of each moment: a layer spans less depth than the whole, so that fewer serve."),
             field(&P::overlap, "overlap")
                 .range(0, 0.5)
                 .tune(0, 0.3)
                 .effect(ParamEffect::Host)
                 .help("How far a layer's moments reach beyond its ends, as a share of the thinner neighbour: less "
                       "light behind a layer's beginning and fewer dark lines at its end.")},
            LvsmParams());
    }
};

class LayeredVariance final : public MomentTechniqueOf<LvsmParams> {
public:
    void prepare(FrameContext& frame) override {
        MomentTechniqueOf::prepare(frame);
        m_ends.clear();
    }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        const bool isNew = map().updateDepth(frame, light, p());
        if (p().placement == LvsmPlacement::Even) {
            m_ends = lvsm::evenLayers(p().layers);
            m_isPlaced = false;
        } else if (isNew || m_ends.empty() || !m_isPlaced) {
            m_ends = lvsm::placeLayers(countDepths(frame), p().layers);
            m_isPlaced = true;
        }
        const std::vector<glm::vec4> spans = lvsm::layerSpans(m_ends, p().overlap, p().layers);
        std::vector<float> read = m_ends;
        read.push_back(p().overlap);
        map().updateMoments(frame, *this, p(),
                            {.path = "shadow/lvsm/lvsm_moments.glsl",
                             .format = GLenum(p().bits == MomentBits::Float32 ? GL_RG32F : GL_RG16),
                             .sheets = p().layers,
                             .read = std::move(read),
                             .bind = [spans](const gl::Program& program) {
                                 program.set("u_layers", spans.data(), int(spans.size()));
                             }});
        for (std::size_t i = 1; i + 1 < m_ends.size(); ++i)
            frame.counter("layer " + std::to_string(i) + " ends at z", double(m_ends[i]));
        return lookUp(frame, "shadow/lvsm/lvsm.glsl");
    }

private:
    /// The map's depths in bins over z. Waits for the map to be drawn.
    std::vector<std::uint32_t> countDepths(FrameContext& frame) {
        const auto pass = frame.pass("layers");
        if (!m_counts) m_counts = gl::Buffer(kBins * sizeof(std::uint32_t), nullptr, "depths in bins");
        m_counts.clear();
        auto defines = map().depth().defines();
        defines.emplace_back("BINS", std::to_string(kBins));
        const gl::Program& program = frame.program({{GL_COMPUTE_SHADER, "shadow/lvsm/histogram.comp"}}, defines);
        map().setUniforms(program);
        map().depth().map().bind(kFirstFreeUnit);
        m_counts.bindStorage(kCountStorage);
        const int groups = (p().resolution + kGroup_texels - 1) / kGroup_texels;
        gl::dispatch(groups, groups, int(map().depth().views().views.size()));
        gl::barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::vector<std::uint32_t> counts(kBins);
        m_counts.download(0, m_counts.size(), counts.data());
        return counts;
    }

    gl::Buffer m_counts;
    std::vector<float> m_ends;
    bool m_isPlaced = false;  ///< m_ends come from the map's depths
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, lvsm, LayeredVariance,
    {.title = "Layered variance shadow map",
     .summary =
         "A variance shadow map for each of several layers of depth, placed by themselves where the casters are: "
         "light leaks only within a layer.",
     .papers = {"lauritzen2008lvsm", "donnelly2006vsm"},
     .limits =
         "Casters of one layer still let light through; memory grows with the layers, and surfaces that cross from "
         "one to the next may show a line.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {"moments", "the blurred mean of depth in the first layer"}}})

}  // namespace ombrage
