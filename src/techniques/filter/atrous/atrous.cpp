// SPDX-License-Identifier: MIT
// filter/atrous: levels of a sparse 5x5 filter whose taps move apart. See atrous.md.
#include <cmath>

#include <fmt/format.h>

#include "techniques/shared/edge_stop_params.h"
#include "techniques/shared/filter_pass.h"

namespace ombrage {
namespace {

struct AtrousParams : EdgeStopParams {
    int levels = 3;
    float valueSigma = 0.0f;

    static ParamTable describe() {
        using P = AtrousParams;
        return edgeStopTable(
            {field(&P::levels, "levels")
                 .range(1, 6)
                 .tune(1, 5)
                 .effect(ParamEffect::Host)
                 .help(
                     "Passes, each with its taps twice as far apart as the one before: one more doubles the reach for "
                     "the same cost."),
             field(&P::valueSigma, "value-sigma")
                 .range(0, 4)
                 .tune(0, 1)
                 .effect(ParamEffect::Host)
                 .help("Difference of the image's own values at which a weight has fallen by exp(-1/2) in the first "
                       "level, half of it in the next, and so on: smaller keeps shadows' edges, and noise. 0 does not "
                       "ask values.")});
    }
};

class Atrous final : public FilterTechniqueOf<AtrousParams> {
public:
    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        constexpr double kLog2E = 1.4426950408889634;
        TargetPool::Target from, to;
        for (int level = 0; level < p().levels; ++level) {
            const bool isLast = level + 1 == p().levels;
            to = isLast ? nullptr : frame.targets->take(input.desc(), "atrous level");
            // The sigma of values halves with every level, for noise has been halved or more (section 3.3).
            const double sigma = double(p().valueSigma) * std::ldexp(1.0, -level);
            const float perValue2 = sigma > 0 ? float(-0.5 * kLog2E / (sigma * sigma)) : 0.0f;
            filterPass(frame, *this, fmt::format("atrous level {}", level), "filter/atrous/atrous.frag",
                       from ? *from : input, to ? *to : output, [&](const gl::Program& program) {
                           program.set("u_step", 1 << level);
                           program.set("u_perValue2", perValue2);
                       });
            if (level == 0 && frame.wants("atrous-first"))
                frame.expose("atrous-first", to ? *to : output, ShowAs::Value);
            from = to;
        }
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    filter, atrous, Atrous,
    {.title = "Edge-avoiding a-trous wavelet filter",
     .summary = "A 5x5 filter run over and over with its taps moving apart: a wide edge-stopping blur for "
                "25 reads a level.",
     .papers = {"dammertz2010atrous"},
     .limits = "The sparse taps of high levels leave rings and patterns where an edge stops some of them; "
               "contacts and hard shadow edges are softened unless values are asked.",
     .passes = {{"atrous-first", "the image after the first level"}}})

}  // namespace ombrage
