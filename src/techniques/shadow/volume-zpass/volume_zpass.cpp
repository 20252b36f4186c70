// SPDX-License-Identifier: MIT
// shadow/volume-zpass: stencil shadow volumes counted between the near plane and the visible surface.
#include "techniques/shared/volume_technique.h"

namespace ombrage {

namespace {

struct VolumeZPassParams : VolumeParams {
    static ParamTable describe() { return volumeTable(); }
};

class VolumeZPass final : public VolumeTechniqueOf<VolumeZPassParams> {
    VolumeChoice needsCaps(const FrameContext& frame, const LightFrame&) const override {
        return VolumeChoice(frame.gpuScene->flat().instances.size(), false);
    }

    void count(FrameContext& frame, const LightFrame&, const VolumeCounter& counter) override {
        const auto pass = frame.pass("shadow volumes");
        counter.begin(0);
        counter.zPass(volumes().casters(), false);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_zpass, VolumeZPass,
    {.title = "Shadow volumes, z-pass",
     .summary = "Stencil shadow volumes of the casters' silhouettes, counted from the eye to the visible surface: the "
                "first and cheapest way, wrong wherever the near plane lies in or cuts a volume.",
     .papers = {"heidmann1991", "crow1977", "bergeron1986", "kim2008volumes"},
     .limits = "The count starts at 0 on the near plane: with the eye in shadow, lit and dark change places. Hard "
               "shadows of opaque triangles only.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = volumePasses(),
     .needsStencil = true})

}  // namespace ombrage
