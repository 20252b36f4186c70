// SPDX-License-Identifier: MIT
// filter/svgf: a mean over frames, then levels of a sparse filter that go as far as the noise is high. See svgf.md.
#include <utility>

#include <fmt/format.h>

#include "techniques/shared/filter_pass.h"
#include "techniques/shared/history.h"

namespace ombrage {
namespace {

/// Whose variance decides how far values may be apart that are mixed.
enum class Guide { Frame, Mean };

}  // namespace

template <>
struct EnumChoices<Guide> {
    static std::vector<std::string> names() { return {"frame", "mean"}; }
};

namespace {

/// Defaults are the paper's, but for sigma-z (svgf.md).
struct SvgfParams {
    float alpha = 0.2f;
    float momentsAlpha = 0.2f;
    float depthTolerance = 0.02f;
    bool feedback = true;
    Guide guide = Guide::Frame;
    int levels = 5;
    float sigmaL = 4.0f;
    float sigmaZ_px = 1.0f;
    float sigmaN = 128.0f;

    static ParamTable describe() {
        using P = SvgfParams;
        return ParamTable(
            {field(&P::alpha, "alpha")
                 .range(0, 1)
                 .tune(0.02, 0.4)
                 .help("Share of the new frame once the history is long: lower leaves less noise and follows changes "
                       "later; 0 is the mean of all frames, 1 uses no history."),
             field(&P::momentsAlpha, "moments-alpha")
                 .range(0, 1)
                 .tune(0.02, 0.4)
                 .help("The same of the moments that the variance comes from: lower knows it better and follows "
                       "changes later; 1 knows none, and filters only in the first three frames."),
             depthToleranceField(&P::depthTolerance),
             field(&P::feedback, "feedback")
                 .effect(ParamEffect::Host)
                 .help("The next frame's history is the picture after the first level, as in the paper: steadier, and "
                       "blurred again in every frame. Without it the history is the mean alone."),
             field(&P::guide, "guide")
                 .effect(ParamEffect::Define)
                 .help(
                     "Whose variance sigma-l counts in: one frame's, as in the paper, or that of the mean over frames, "
                     "which falls as frames are gathered, and penumbrae with it stay sharper."),
             field(&P::levels, "levels")
                 .range(1, 6)
                 .tune(2, 6)
                 .effect(ParamEffect::Host)
                 .help("Passes over the picture, each with its taps twice as far apart as the one before: one more "
                       "doubles the reach for the same cost."),
             field(&P::sigmaL, "sigma-l")
                 .range(0, 64)
                 .tune(0.5, 8)
                 .help("Difference of values at which a weight has fallen to 1/e, in standard deviations of the "
                       "noise: higher is smoother and blurs penumbrae, 0 does not filter over the picture."),
             field(&P::sigmaZ_px, "sigma-z", Unit::Pixel)
                 .range(0.01, 1000, Scale::Log)
                 .tune(0.1, 20)
                 .help("Distance from the tangent plane at which a neighbour's weight has fallen by exp(-1/2), in "
                       "sizes of a pixel at the surface: larger lets light and shade bleed over steps, smaller "
                       "leaves noise on curved surfaces."),
             field(&P::sigmaN, "sigma-n")
                 .range(0, 256)
                 .tune(0, 256)
                 .help("Exponent of the cosine between the shading normals: higher keeps creases and bumps apart, 0 "
                       "ignores normals.")});
    }
};

class Svgf final : public FilterTechniqueOf<SvgfParams> {
public:
    void prepare(FrameContext& frame) override {
        m_hasHistory = false;
        for (gl::Texture& moments : m_moments)
            moments = gl::Texture({.format = GL_RGBA32F, .width = frame.width, .height = frame.height}, "svgf moments");
        m_values = gl::Texture({.format = GL_RG32F, .width = frame.width, .height = frame.height}, "svgf values");
    }

    /// Moved instances are no reason to forget: what no longer fits is refused by its depth.
    void sceneMoved(FrameContext&) override {}

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        const auto accumulated =
            frame.targets->take({.format = GL_R32F, .width = frame.width, .height = frame.height}, "svgf accumulated");
        accumulate(frame, input, *accumulated);
        exposeChannel(frame, "svgf-accumulated", *accumulated, 0, 1.0f);
        exposeChannel(frame, "svgf-frames", m_moments[0], 3, 1.0f / 32);

        // Without feedback what is kept is what the first level begins with.
        auto from = p().feedback ? frame.targets->take(m_values.desc(), "svgf level") : nullptr;
        const gl::Texture& begun = from ? *from : m_values;
        m_moments[0].bind(kFirstFreeUnit + 1);
        filterPass(frame, *this, "svgf variance", "filter/svgf/variance.frag", *accumulated, begun,
                   [&](const gl::Program&) {});
        // Values in [0,1] have a variance of 1/4 at most.
        exposeChannel(frame, "svgf-variance", begun, 1, 4.0f);
        filter(frame, from, output);
    }

    std::uint64_t gpuBytes() const override {
        return m_values ? 2 * gl::byteSize(m_moments[0].desc()) + gl::byteSize(m_values.desc()) : 0;
    }

private:
    /// Section 4.1 and 4.2: values and moments, each blended into the frame before's.
    void accumulate(FrameContext& frame, const gl::Texture& input, const gl::Texture& accumulated) {
        {
            const auto pass = frame.pass("svgf accumulate");
            const gl::Framebuffer target({{&accumulated}, {&m_moments[1]}}, {}, "svgf accumulate");
            target.bind();
            gl::apply({});
            frame.bindGBuffer();
            input.bind(kFirstFreeUnit);
            m_moments[0].bind(kFirstFreeUnit + 1);
            m_values.bind(kFirstFreeUnit + 2);
            setReprojection(frame.fullscreenProgram(*this, "filter/svgf/accumulate.frag"), frame, m_hasHistory);
            frame.drawFullscreen();
        }
        std::swap(m_moments[0], m_moments[1]);
        m_hasHistory = true;
    }

    /// Section 4.3 and 4.4: the levels.
    /// @param from what the first of them reads; null: the values kept
    void filter(FrameContext& frame, TargetPool::Target from, const gl::Texture& output) {
        for (int level = 0; level < p().levels; ++level) {
            const bool isKept = p().feedback && level == 0, isLast = level + 1 == p().levels;
            TargetPool::Target to;
            if (!isKept && !isLast) to = frame.targets->take(m_values.desc(), "svgf level");
            std::vector<gl::Attachment> targets;
            if (isKept || to) targets.push_back({isKept ? &m_values : to.get()});
            if (isLast) targets.push_back({&output});
            const auto pass = frame.pass(fmt::format("svgf level {}", level));
            const gl::Framebuffer target(targets, {}, "svgf level");
            target.bind();
            gl::apply({});
            frame.bindGBuffer();
            (from ? *from : m_values).bind(kFirstFreeUnit);
            frame.fullscreenProgram(*this, "filter/svgf/level.frag").set("u_step", 1 << level);
            frame.drawFullscreen();
            from = to;
        }
    }

    /// First and second moment of the values, distance along the view axis, number of frames; of the frame before, and
    /// the next.
    gl::Texture m_moments[2];
    gl::Texture m_values;  ///< value and variance that the next frame's history is, after the first level or before it
    bool m_hasHistory = false;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    filter, svgf, Svgf,
    {.title = "Spatiotemporal variance-guided filter",
     .summary = "Blends every frame into the frames before, estimates how noisy each pixel is, and blurs over the "
                "picture as far as that allows.",
     .papers = {"schied2017svgf", "dammertz2010atrous", "nehab2007reprojection"},
     .limits = "Needs frames to gather; what moving lights and casters leave behind fades by the share of the new "
               "frame in each frame, and what was hidden a frame ago is blurred widely at first.",
     .passes = {{"svgf-accumulated", "the mean over frames, before it is filtered over the picture"},
                {"svgf-frames", "frames that every pixel's mean holds, as a share of 32"},
                {"svgf-variance", "variance of the noise as it is estimated, times 4"}},
     .settlingFrames = 32})

}  // namespace ombrage
