// SPDX-License-Identifier: MIT
// aa/msaa: surfaces drawn once into several samples a pixel, lit once where these show one surface. See msaa.md.
#include <algorithm>

#include "render/edge_samples.h"
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/copy.h"

namespace ombrage {

namespace {

struct MsaaParams {
    int samples = 4;
    bool alphaToCoverage = true;
    bool lumaWeights = false;

    static ParamTable describe() {
        using P = MsaaParams;
        return ParamTable(
            {field(&P::samples, "samples")
                 .range(1, 8)
                 .effect(ParamEffect::Resize)
                 .help("Samples of a pixel, as many as the device offers: 2, 4 and 8 where it can; any other number is "
                       "refused. 1 is no anti-aliasing."),
             field(&P::alphaToCoverage, "alpha-to-coverage")
                 .effect(ParamEffect::Host)
                 .help("Holes of alpha-tested surfaces are cut out of each sample; else of whole pixels, and stay "
                       "stepped."),
             field(&P::lumaWeights, "luma-weights")
                 .effect(ParamEffect::Define)
                 .help("Bright samples count less, by 1/(1 + luma): outlines of what is far brighter than white are "
                       "graded, and edges become darker than their mean.")});
    }
};

class Msaa final : public AaTechniqueOf<MsaaParams> {
public:
    GeometrySamples geometrySamples() const override { return {p().samples, p().samples > 1 && p().alphaToCoverage}; }

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        if (!frame.edgeColors) {
            copyTexture(input, output);
            return;
        }
        resolve(frame, input, output, nullptr);
        if (frame.countsSavings()) countEdges(frame);
        if (!frame.wants("msaa-edges")) return;
        const auto shown =
            frame.targets->take({.format = GL_R16F, .width = frame.width, .height = frame.height}, "msaa edges");
        const FrameContext::Uncounted uncounted(frame);
        resolve(frame, input, output, shown.get());
        frame.expose("msaa-edges", *shown, ShowAs::Value);
    }

private:
    /// @param surfaces takes the share of the samples that show another surface than the first; may be null
    void resolve(FrameContext& frame, const gl::Texture& input, const gl::Texture& output,
                 const gl::Texture* surfaces) {
        const auto pass = frame.pass("msaa resolve");
        copyTexture(input, output);
        std::vector<gl::Attachment> targets{{&output}};
        auto defines = sampleDefines(*frame.gbuffer);
        if (surfaces) {
            targets.push_back({surfaces});
            defines.emplace_back("WRITE_SURFACES", "1");
        }
        const gl::Framebuffer target(targets, {&frame.gbuffer->samples->selector}, "msaa resolve");
        target.bind();
        if (surfaces) target.clearColor(1, glm::vec4(0.0f));
        bindSamples(*frame.gbuffer);
        frame.edgeColors->bind(kFirstFreeUnit);
        frame.fullscreenProgram(*this, "aa/msaa/resolve.frag", std::move(defines));
        frame.drawSurfaces();
    }

    static void countEdges(FrameContext& frame) {
        const gl::Texture& edges = frame.gbuffer->samples->edges;
        std::vector<std::uint32_t> bits(std::size_t(frame.width) * std::size_t(frame.height));
        edges.download(0, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, bits.size() * sizeof bits[0], bits.data());
        const auto alike = std::count(bits.begin(), bits.end(), 0u);
        frame.counter("edge pixels", double(bits.size()) - double(alike));
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    aa, msaa, Msaa,
    {.title = "Multisampling",
     .summary =
         "Surfaces are drawn once into several samples a pixel; pixels whose samples show several surfaces are lit "
         "surface by surface, all others once.",
     .papers = {"akeley1993realityengine"},
     .limits = "Smooths the outlines of surfaces alone: edges of shadows, highlights and textures stay stepped.",
     .passes = {{"msaa-edges", "share of each pixel's samples that show another surface than its first"}}})

}  // namespace ombrage
