// SPDX-License-Identifier: MIT
// shadow/volume: stencil shadow volumes that choose how to count, caster by caster.
#include "techniques/shared/volume_split.h"
#include "techniques/shared/volume_technique.h"

namespace ombrage {

namespace {

struct AutomaticVolumeParams : VolumeParams {
    CountingMode count = CountingMode::Clamp;

    static ParamTable describe() {
        using P = AutomaticVolumeParams;
        return volumeTable(
            {field(&P::count, "count")
                 .effect(ParamEffect::Host)
                 .help("near-clip: z-fail for casters that reach between the near plane and the light, "
                       "z-pass for the others. clamp: z-pass for all but those that touch the eye or have it "
                       "on their volume's border, with depth clamped and the count started from the casters "
                       "between eye and light. Alpha-tested casters are always counted by z-fail.")});
    }
};

class ShadowVolume final : public VolumeTechniqueOf<AutomaticVolumeParams> {
    VolumeChoice needsCaps(const FrameContext& frame, const LightFrame& light) const override {
        return countedByZFail(frame, light, p().count);
    }

    void count(FrameContext& frame, const LightFrame& light, const VolumeCounter& counter) override {
        const VolumeSplit split(frame, light, volumes(), p().count, withCaps());
        const auto pass = frame.pass("shadow volumes");
        counter.begin(split.atTheEye);
        split.count(counter);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume, ShadowVolume,
    {.title = "Shadow volumes",
     .summary = "Stencil shadow volumes of the casters' silhouettes, counted by z-pass wherever that is right and by "
                "z-fail for the rest: the robust default.",
     .papers = {"everitt2002volumes", "heidmann1991", "crow1977", "bergeron1986", "kim2008volumes"},
     .limits =
         "Hard shadows of opaque triangles only: holes of alpha-tested casters are filled, and the fill cost grows "
         "with the silhouettes on the screen.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = volumePasses(),
     .needsStencil = true})

}  // namespace ombrage
