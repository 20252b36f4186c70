// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/param_table.h"
#include "techniques/shared/silhouette.h"

namespace ombrage {

/// Who finds the silhouettes.
enum class SilhouetteSource { Cpu, Geometry, Compute };

/// How far volumes reach.
enum class VolumeExtrusion { Infinite, Distance };

template <>
struct EnumChoices<VolumeFaces> {
    static std::vector<std::string> names() { return {"all", "facing", "silhouette"}; }
};
template <>
struct EnumChoices<SilhouetteSource> {
    static std::vector<std::string> names() { return {"cpu", "geometry", "compute"}; }
};
template <>
struct EnumChoices<VolumeExtrusion> {
    static std::vector<std::string> names() { return {"infinite", "distance"}; }
};

/// What all techniques that count volumes in the stencil have in common. Parameter structs derive from it, with it as
/// their only base, and put volumeFields() before their own.
struct VolumeParams {
    VolumeFaces faces = VolumeFaces::Silhouette;
    SilhouetteSource silhouette = SilhouetteSource::Cpu;
    VolumeExtrusion extrude = VolumeExtrusion::Infinite;
    float distance_m = 100.0f;
    bool twoSided = true;
};

/// Their declarations, joined with those of the technique.
ParamTable volumeTable(const std::vector<ParamField>& own = {});
/// The same without `extrude` and `distance`, for techniques that decide where volumes end.
ParamTable volumeTableWithoutEnds(const std::vector<ParamField>& own = {});

}  // namespace ombrage
