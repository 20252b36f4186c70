// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "techniques/shared/volume_counter.h"

namespace ombrage {

/// How a caster's volume is counted.
enum class CountingMode { NearClip, Clamp };

template <>
struct EnumChoices<CountingMode> {
    static std::vector<std::string> names() { return {"near-clip", "clamp"}; }
};

/// The instances that z-fail is to count. Orthographic cameras, which have no eye to start from, are split by the
/// near-clip volume whatever the mode.
VolumeChoice countedByZFail(const FrameContext& frame, const LightFrame& light, CountingMode mode);

/// Which casters' volumes are counted by z-pass and which by z-fail, and where the count starts.
struct VolumeSplit {
    bool clampDepth = false;
    VolumeChoice zPass, zFail;
    int atTheEye = 0;  ///< volumes that hold the eye, of those by z-pass

    /// Reports itself into the record. @param byZFail  what countedByZFail() said of this mode
    VolumeSplit(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, CountingMode mode,
                const VolumeChoice& byZFail);

    /// Counts them, after begin(atTheEye).
    void count(const VolumeCounter& counter) const;
};

}  // namespace ombrage
