// SPDX-License-Identifier: MIT
// shadow/volume-zpplus: z-pass that starts from what the light sees of the near plane.
#include <algorithm>

#include "techniques/shared/volume_split.h"
#include "techniques/shared/volume_technique.h"

namespace ombrage {

namespace {

struct VolumeZPPlusParams : VolumeParams {
    static ParamTable describe() { return volumeTable(); }
};

class VolumeZPPlus final : public VolumeTechniqueOf<VolumeZPPlusParams> {
    /// Only casters between the near plane and the light can cover it.
    VolumeChoice needsCaps(const FrameContext& frame, const LightFrame& light) const override {
        return countedByZFail(frame, light, CountingMode::NearClip);
    }

    void count(FrameContext& frame, const LightFrame&, const VolumeCounter& counter) override {
        {
            const auto pass = frame.pass("near plane from the light");
            counter.begin(0);
            VolumeChoice before = withCaps();
            for (std::size_t i = 0; i < before.size(); ++i) before[i] = before[i] && volumes().casters()[i];
            frame.counter("casters before the near plane", double(std::count(before.begin(), before.end(), true)));
            counter.nearPlane(before);
        }
        const auto pass = frame.pass("shadow volumes");
        counter.zPass(volumes().casters(), false);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_zpplus, VolumeZPPlus,
    {.title = "Shadow volumes, ZP+",
     .summary = "Z-pass corrected at the near plane: the casters between it and the light are drawn onto it as the "
                "light sees them, and the count starts from there.",
     .papers = {"hornus2005zpplus", "heidmann1991", "crow1977", "kim2008volumes"},
     .limits = "Where the near plane cuts a volume, its cut and what the light draws are rounded apart: single wrong "
               "pixels along that line. Hard shadows of opaque triangles only.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = volumePasses(),
     .needsStencil = true})

}  // namespace ombrage
