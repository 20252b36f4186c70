// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_split.h"

#include <algorithm>

#include "techniques/shared/eye_contact.h"
#include "techniques/shared/near_clip.h"

namespace ombrage {

namespace {

bool clamps(const FrameContext& frame, CountingMode mode) {
    return mode == CountingMode::Clamp && !frame.view.orthographic;
}

}  // namespace

VolumeChoice countedByZFail(const FrameContext& frame, const LightFrame& light, CountingMode mode) {
    const NearClipVolume nearClip(frame.view, light.toward());
    VolumeChoice chosen(frame.gpuScene->flat().instances.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto& [lower, upper] = frame.gpuScene->instanceBounds(i);
        chosen[i] = clamps(frame, mode) ? !countsFromEye(frame, light, i)
                                        : isAlphaTested(frame, i) || nearClip.touches(lower, upper);
    }
    return chosen;
}

VolumeSplit::VolumeSplit(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, CountingMode mode,
                         const VolumeChoice& byZFail)
    : clampDepth(clamps(frame, mode)), zPass(volumes.casters()), zFail(byZFail) {
    for (std::size_t i = 0; i < zPass.size(); ++i) {
        zFail[i] = zFail[i] && zPass[i];
        zPass[i] = zPass[i] && !zFail[i];
    }
    if (clampDepth) atTheEye = volumes.around(frame, light, frame.view.eye, zPass);
    frame.counter("casters by z-pass", double(std::count(zPass.begin(), zPass.end(), true)));
    frame.counter("casters by z-fail", double(std::count(zFail.begin(), zFail.end(), true)));
    frame.counter("volumes around the eye", atTheEye);
}

void VolumeSplit::count(const VolumeCounter& counter) const {
    counter.zPass(zPass, clampDepth);
    counter.zFail(zFail);
}

}  // namespace ombrage
