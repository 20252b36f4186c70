// SPDX-License-Identifier: MIT
// filter/temporal: a mean over frames, found again by depth and clamped to what the frame shows. See temporal.md.
#include <utility>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/history.h"

namespace ombrage {
namespace {

struct TemporalParams {
    float blend = 0.05f;
    float gamma = 2.0f;
    float depthTolerance = 0.02f;

    static ParamTable describe() {
        using P = TemporalParams;
        return ParamTable(
            {field(&P::blend, "blend")
                 .range(0, 1)
                 .tune(0.02, 0.3)
                 .help("Share of the new frame once the history is long: lower leaves less noise and follows changes "
                       "later; "
                       "0 is the mean of all frames, 1 uses no history."),
             field(&P::gamma, "gamma")
                 .range(0, 64)
                 .tune(0.5, 4)
                 .help("Standard deviations of the 3x3 neighbourhood by which the history may leave its mean: lower "
                       "leaves "
                       "less ghosts and more noise; 0 takes the neighbourhood's mean in the history's place."),
             depthToleranceField(&P::depthTolerance)});
    }
};

class Temporal final : public FilterTechniqueOf<TemporalParams> {
public:
    void prepare(FrameContext& frame) override {
        m_hasHistory = false;
        for (gl::Texture& history : m_histories)
            history =
                gl::Texture({.format = GL_RGBA32F, .width = frame.width, .height = frame.height}, "temporal history");
    }

    /// Moved instances are no reason to forget: what no longer fits is refused by its depth, or clamped.
    void sceneMoved(FrameContext&) override {}

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        {
            const auto pass = frame.pass("temporal");
            const gl::Framebuffer target({{&output}, {&m_histories[1]}}, {}, "temporal");
            target.bind();
            gl::apply({});
            frame.bindGBuffer();
            input.bind(kFirstFreeUnit);
            m_histories[0].bind(kFirstFreeUnit + 1);
            const gl::Program& program = frame.fullscreenProgram(*this, "filter/temporal/temporal.frag");
            setReprojection(program, frame, m_hasHistory);
            frame.drawFullscreen();
        }
        std::swap(m_histories[0], m_histories[1]);
        m_hasHistory = true;
        exposeChannel(frame, "temporal-frames", m_histories[0], 3, 1.0f / 32);
    }

    std::uint64_t gpuBytes() const override { return m_histories[0] ? 2 * gl::byteSize(m_histories[0].desc()) : 0; }

private:
    /// Value, nothing, distance along the view axis, number of frames; of the frame before, and the next.
    gl::Texture m_histories[2];
    bool m_hasHistory = false;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    filter, temporal, Temporal,
    {.title = "Temporal accumulation",
     .summary = "Blends every frame's noise into the frames before, found again by depth and clamped to the "
                "values around each pixel.",
     .papers = {"nehab2007reprojection", "salvi2016clipping", "yang2020taa"},
     .limits = "Needs frames to gather; what was hidden a frame ago starts anew, and what moving casters leave "
               "behind fades over some frames.",
     .passes = {{"temporal-frames", "frames that every pixel's mean holds, as a share of 32"}},
     .settlingFrames = 32})

}  // namespace ombrage
