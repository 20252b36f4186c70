// SPDX-License-Identifier: MIT
// aa/fxaa: fast approximate anti-aliasing. See fxaa.md.
#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {

namespace {
enum class FxaaQuality { Low, Medium, High };
}

template <>
struct EnumChoices<FxaaQuality> {
    static std::vector<std::string> names() { return {"low", "medium", "high"}; }
};

namespace {

struct FxaaParams {
    float subpix = 0.75f;
    float edgeThreshold = 0.166f;
    float edgeThresholdMin = 0.0833f;
    FxaaQuality quality = FxaaQuality::Medium;

    static ParamTable describe() {
        using P = FxaaParams;
        return fields(
            field(&P::subpix, "subpix")
                .range(0, 1)
                .tune(0, 1)
                .help("Blur of details smaller than a pixel: 0 keeps them and their flicker, 1 softens most."),
            field(&P::edgeThreshold, "edge-threshold")
                .range(0.01, 0.5)
                .tune(0.063, 0.333)
                .help("Contrast that makes an edge, as a share of the brightest neighbour: higher is faster "
                      "and leaves weak edges."),
            field(&P::edgeThresholdMin, "edge-threshold-min")
                .range(0, 0.25)
                .tune(0.0312, 0.0833)
                .help("Contrast below which nothing is an edge: higher leaves dark areas alone."),
            field(&P::quality, "quality")
                .effect(ParamEffect::Define)
                .help("How finely an edge is followed to its ends: 3, 5 or 12 steps. More give better long, "
                      "nearly level edges."));
    }
};

class Fxaa final : public AaTechniqueOf<FxaaParams> {
public:
    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        const auto encoded = frame.targets->take(input.desc(), "fxaa encoded");
        {
            const auto pass = frame.pass("fxaa encode");
            const gl::Framebuffer target({{encoded.get()}}, {}, "fxaa encoded");
            target.bind();
            gl::apply({});
            input.bind(kFirstFreeUnit);
            frame.fullscreenProgram(*this, "shared/encode_luma.frag");
            frame.drawFullscreen();
        }
        // Pool textures are nearest for everybody else.
        encoded->setFilter(GL_LINEAR, GL_LINEAR);
        filterEdges(frame, input, *encoded, output);
        encoded->setFilter(GL_NEAREST, GL_NEAREST);
    }

private:
    void filterEdges(FrameContext& frame, const gl::Texture& input, const gl::Texture& encoded,
                     const gl::Texture& output) {
        const bool wantsEdges = frame.wants("fxaa-edges");
        TargetPool::Target edges;
        std::vector<gl::Attachment> targets{{&output}};
        std::vector<std::pair<std::string, std::string>> defines;
        if (wantsEdges) {
            edges =
                frame.targets->take({.format = GL_R16F, .width = frame.width, .height = frame.height}, "fxaa edges");
            targets.push_back({edges.get()});
            defines.emplace_back("WRITE_EDGES", "1");
        }
        {
            const auto pass = frame.pass("fxaa");
            const gl::Framebuffer target(targets, {}, "fxaa");
            target.bind();
            gl::apply({});
            input.bind(kFirstFreeUnit);
            encoded.bind(kFirstFreeUnit + 1);
            frame.fullscreenProgram(*this, "aa/fxaa/fxaa.frag", defines);
            frame.drawFullscreen();
        }
        if (wantsEdges) frame.expose("fxaa-edges", *edges, ShowAs::Value);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(aa, fxaa, Fxaa,
                  {.title = "Fast approximate anti-aliasing (FXAA 3.11 quality)",
                   .summary = "Finds edges by luma, follows each to its ends and blends across it by the distance from "
                              "the nearer end; works on the finished picture alone.",
                   .papers = {"lottes2009fxaa", "lottes2011fxaa"},
                   .limits = "Knows only the picture: detail thinner than a pixel keeps breaking up, texture and text "
                             "lose sharpness, and edges longer than the search stay stepped.",
                   .passes = {{"fxaa-edges",
                               "how far each pixel was moved across its edge, in pixels; black is left as "
                               "it was"}}})

}  // namespace ombrage
