// SPDX-License-Identifier: MIT
// shadow/volume-zfail: stencil shadow volumes counted behind the visible surface (Carmack's reverse).
#include "techniques/shared/volume_technique.h"

namespace ombrage {

namespace {

struct VolumeZFailParams : VolumeParams {
    static ParamTable describe() { return volumeTable(); }
};

class VolumeZFail final : public VolumeTechniqueOf<VolumeZFailParams> {
    void count(FrameContext& frame, const LightFrame&, const VolumeCounter& counter) override {
        const auto pass = frame.pass("shadow volumes");
        counter.begin(0);
        counter.zFail(volumes().casters());
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_zfail, VolumeZFail,
    {.title = "Shadow volumes, z-fail",
     .summary = "Stencil shadow volumes of the casters' silhouettes, counted behind the visible surface, so that "
                "an eye in shadow needs no care (Carmack's reverse).",
     .papers = {"everitt2002volumes", "crow1977", "bergeron1986", "kim2008volumes"},
     .limits =
         "Hard shadows of opaque triangles only: holes of alpha-tested casters are filled, and the fill cost grows "
         "with the silhouettes on the screen.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = volumePasses(),
     .needsStencil = true})

}  // namespace ombrage
