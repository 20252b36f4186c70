// SPDX-License-Identifier: MIT
// aa/taa: samples gathered over frames, with a history that is clipped to what the frame shows. See taa.md.
#include <utility>

#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {

namespace {
enum class HistoryFilter { Bilinear, CatmullRom };
}

template <>
struct EnumChoices<HistoryFilter> {
    static std::vector<std::string> names() { return {"bilinear", "catmull-rom"}; }
};

namespace {

/// Of the Halton sequence (Halton 1964), in [0,1).
float radicalInverse(std::uint32_t index, std::uint32_t base) {
    double value = 0, digit = 1;
    for (; index > 0; index /= base) {
        digit /= base;
        value += digit * (index % base);
    }
    return float(value);
}

struct TaaParams {
    float blend = 0.1f;
    float gamma = 1.25f;
    int period = 16;
    HistoryFilter historyFilter = HistoryFilter::CatmullRom;
    bool lumaWeights = false;

    static ParamTable describe() {
        using P = TaaParams;
        return ParamTable(
            {field(&P::blend, "blend")
                 .range(0.01, 1)
                 .tune(0.02, 0.3)
                 .help(
                     "Share of the new frame once the history is long: lower is smoother and follows changes later; 1 "
                     "uses no history."),
             field(&P::gamma, "gamma")
                 .range(0.1, 8)
                 .tune(0.75, 2)
                 .help("Standard deviations of the 3x3 neighbourhood by which the history may leave its mean: lower "
                       "leaves "
                       "less ghosts and more flicker."),
             field(&P::period, "period")
                 .range(1, 64)
                 .tune(4, 32)
                 .effect(ParamEffect::Host)
                 .help("Samples of the Halton sequence before it begins again."),
             field(&P::historyFilter, "history-filter")
                 .effect(ParamEffect::Define)
                 .help("How the history is read between its pixels under a moving camera: catmull-rom stays sharp."),
             field(&P::lumaWeights, "luma-weights")
                 .effect(ParamEffect::Define)
                 .help("Bright samples count less, by 1/(1 + luma): single fireflies vanish, and edges become darker "
                       "than "
                       "their mean.")});
    }
};

class Taa final : public AaTechniqueOf<TaaParams> {
public:
    void prepare(FrameContext& frame) override {
        m_frames = 0;
        for (gl::Texture& history : m_histories) {
            history = gl::Texture({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "taa history");
            history.setFilter(GL_LINEAR, GL_LINEAR);
        }
    }

    /// Moved instances are no reason to forget: what no longer fits is clipped.
    void sceneMoved(FrameContext&) override {}

    std::vector<glm::vec2> samplePoints(const FrameContext&) override {
        const auto index = std::uint32_t(int(m_frames) % p().period) + 1;
        return {glm::vec2(radicalInverse(index, 2), radicalInverse(index, 3)) - 0.5f};
    }

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        {
            const auto pass = frame.pass("taa");
            const gl::Framebuffer target({{&output}, {&m_histories[1]}}, {}, "taa");
            target.bind();
            gl::apply({});
            frame.bindGBuffer();
            input.bind(kFirstFreeUnit);
            m_histories[0].bind(kFirstFreeUnit + 1);
            const gl::Program& program = frame.fullscreenProgram(*this, "aa/taa/taa.frag");
            program.set("u_clipNow", frame.centredView.clipFromWorld);
            program.set("u_clipBefore", frame.previousView.clipFromWorld);
            program.set("u_hasHistory", m_frames > 0 ? 1 : 0);
            frame.drawFullscreen();
        }
        std::swap(m_histories[0], m_histories[1]);
        ++m_frames;
        if (frame.wants("taa-input")) frame.expose("taa-input", input, ShowAs::Color);
    }

    std::uint64_t gpuBytes() const override { return m_histories[0] ? 2 * gl::byteSize(m_histories[0].desc()) : 0; }

private:
    gl::Texture m_histories[2];  ///< colour, and the number of frames in alpha; of the frame before, and the next
    std::uint64_t m_frames = 0;  ///< since the history began
};

}  // namespace

OMBRAGE_TECHNIQUE(
    aa, taa, Taa,
    {.title = "Temporal anti-aliasing",
     .summary = "Every frame has its samples elsewhere in the pixels and is blended into the frames before, "
                "found again by depth and clipped to the colours around each pixel.",
     .papers = {"karis2014taa", "salvi2016clipping", "yang2020taa"},
     .limits = "Needs frames to gather; what was hidden a frame ago has no history, moving objects leave faint "
               "ghosts within the colours around them, and detail that comes and goes is clipped to a flicker.",
     .passes = {{"taa-input", "the frame as it was drawn, with moved samples"}},
     .settlingFrames = 32})

}  // namespace ombrage
