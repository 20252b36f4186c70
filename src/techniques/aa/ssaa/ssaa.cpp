// SPDX-License-Identifier: MIT
// aa/ssaa: the mean of pictures whose samples lie elsewhere in the pixels. See ssaa.md.
#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {

namespace {
enum class SamplePattern { Ordered, Rotated };
}

template <>
struct EnumChoices<SamplePattern> {
    static std::vector<std::string> names() { return {"ordered", "rotated"}; }
};

namespace {

struct SsaaParams {
    int grid = 4;
    SamplePattern pattern = SamplePattern::Ordered;

    static ParamTable describe() {
        using P = SsaaParams;
        return ParamTable(
            {field(&P::grid, "grid")
                 .range(1, 16)
                 .tune(1, 8)
                 .effect(ParamEffect::Host)
                 .help("Samples along each side of a pixel: the frame is drawn as often as its square."),
             field(&P::pattern, "pattern")
                 .effect(ParamEffect::Host)
                 .help("ordered: a grid; rotated: the same number of samples, no two of them in one column or "
                       "row, so that nearly level edges get as many grades as there are samples.")});
    }
};

class Ssaa final : public AaTechniqueOf<SsaaParams> {
public:
    void prepare(FrameContext& frame) override {
        m_sum = gl::Texture({.format = GL_RGBA32F, .width = frame.width, .height = frame.height}, "ssaa sum");
    }

    std::vector<glm::vec2> samplePoints(const FrameContext&) override {
        const int n = p().grid;
        std::vector<glm::vec2> points;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                // Rotated: every cell's sample is moved by the number of its row and column (Chiu et al. 1994,
                // unshuffled); for n = 2 that is the grid turned by 26.6 degrees.
                const bool isOrdered = p().pattern == SamplePattern::Ordered;
                const float inX = isOrdered ? 0.5f : (float(j) + 0.5f) / float(n);
                const float inY = isOrdered ? 0.5f : (float(n - 1 - i) + 0.5f) / float(n);
                points.push_back((glm::vec2(float(i) + inX, float(j) + inY)) / float(n) - 0.5f);
            }
        return points;
    }

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        {
            const auto pass = frame.pass("ssaa sum");
            const gl::Framebuffer target({{&m_sum}}, {}, "ssaa sum");
            target.bind();
            if (frame.sample == 0) target.clearColor(0, glm::vec4(0.0f));
            gl::DrawState add;
            add.blend = true;
            gl::apply(add);
            input.bind(kFirstFreeUnit);
            frame.fullscreenProgram(*this, "aa/ssaa/scale.frag").set("u_scale", 1.0f / float(p().grid * p().grid));
            frame.drawFullscreen();
        }
        if (!frame.isLastSample) return;
        const auto pass = frame.pass("ssaa resolve");
        const gl::Framebuffer target({{&output}}, {}, "ssaa resolve");
        target.bind();
        gl::apply({});
        m_sum.bind(kFirstFreeUnit);
        frame.fullscreenProgram(*this, "aa/ssaa/scale.frag").set("u_scale", 1.0f);
        frame.drawFullscreen();
    }

    std::uint64_t gpuBytes() const override { return m_sum ? gl::byteSize(m_sum.desc()) : 0; }

private:
    gl::Texture m_sum;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    aa, ssaa, Ssaa,
    {.title = "Supersampling",
     .summary = "Draws the frame once for every one of the samples in a pixel and takes their mean: what the "
                "other techniques stand in for, and their truth.",
     .papers = {"chiu1994multijitter"},
     .limits = "Costs the whole frame for every sample; detail finer than the samples' distance still breaks "
               "up."})

}  // namespace ombrage
