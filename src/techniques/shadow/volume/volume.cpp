// SPDX-License-Identifier: MIT
// shadow/volume: stencil shadow volumes that choose how to count, caster by caster.
#include "techniques/shared/near_clip.h"
#include "techniques/shared/volume_technique.h"

namespace ombrage {

namespace {

/// How a caster's volume is counted.
enum class CountingMode { NearClip, Clamp };

}  // namespace

template <>
struct EnumChoices<CountingMode> {
    static std::vector<std::string> names() { return {"near-clip", "clamp"}; }
};

namespace {

struct VolumeParamsAutomatic : VolumeParams {
    CountingMode count = CountingMode::Clamp;

    static ParamTable describe() {
        using P = VolumeParamsAutomatic;
        return volumeTable({field(&P::count, "count")
                                .effect(ParamEffect::Host)
                                .help("near-clip: z-fail for casters that reach between the near plane and the light, "
                                      "z-pass for the others. clamp: z-pass for all but those that touch the eye, with "
                                      "depth clamped and the count started from the casters between eye and light.")});
    }
};

class ShadowVolume final : public VolumeTechniqueOf<VolumeParamsAutomatic> {
    void count(FrameContext& frame, const LightFrame& light, const VolumeCounter& counter) override {
        // An orthographic camera has no eye to start from.
        const bool clamp = p().count == CountingMode::Clamp && !frame.view.orthographic;
        const VolumeChoice& casters = volumes().casters();
        const NearClipVolume nearClip(frame.view, light.toward());
        VolumeChoice zPass = casters, zFail = casters;
        int passing = 0, failing = 0;
        for (std::size_t i = 0; i < casters.size(); ++i) {
            const auto& [lower, upper] = frame.gpuScene->instanceBounds(i);
            const bool fails = clamp ? frame.gpuScene->isWithin(i, frame.view.eye, frame.view.nearReach_m())
                                     : nearClip.touches(lower, upper);
            zPass[i] = casters[i] && !fails;
            zFail[i] = casters[i] && fails;
            passing += zPass[i] ? 1 : 0;
            failing += zFail[i] ? 1 : 0;
        }
        frame.counter("casters by z-pass", passing);
        frame.counter("casters by z-fail", failing);

        const int atTheEye = clamp ? volumes().around(frame, light, frame.view.eye, zPass) : 0;
        frame.counter("volumes around the eye", atTheEye);
        const auto pass = frame.pass("shadow volumes");
        counter.begin(atTheEye);
        counter.zPass(zPass, clamp);
        counter.zFail(zFail);
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
