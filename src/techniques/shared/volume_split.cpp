// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_split.h"

#include <algorithm>

#include "techniques/shared/near_clip.h"

namespace ombrage {

VolumeSplit::VolumeSplit(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, CountingMode mode)
    : clampDepth(mode == CountingMode::Clamp && !frame.view.orthographic),
      zPass(volumes.casters()),
      zFail(volumes.casters()) {
    const NearClipVolume nearClip(frame.view, light.toward());
    for (std::size_t i = 0; i < zPass.size(); ++i) {
        const auto& [lower, upper] = frame.gpuScene->instanceBounds(i);
        const bool fails = clampDepth ? frame.gpuScene->isWithin(i, frame.view.eye, frame.view.nearReach_m())
                                      : nearClip.touches(lower, upper);
        zPass[i] = zPass[i] && !fails;
        zFail[i] = zFail[i] && fails;
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
