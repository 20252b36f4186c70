// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_params.h"

namespace ombrage {

ParamTable volumeTable(const std::vector<ParamField>& own) {
    using P = VolumeParams;
    std::vector<ParamField> all{
        field(&P::faces, "faces")
            .effect(ParamEffect::Host)
            .help("Extrude every triangle, the casting triangles, or their silhouette: the same picture for less and "
                  "less fill."),
        field(&P::silhouette, "silhouette")
            .effect(ParamEffect::Host)
            .help("Who finds the silhouette: the processor, a geometry shader in every frame, or a compute shader that "
                  "appends to an indirect draw. With other faces than silhouette always the processor."),
        field(&P::extrude, "extrude")
            .effect(ParamEffect::Host)
            .help("Volumes reach to infinity, or end after a distance, which loses the shadow beyond it."),
        field(&P::distance_m, "distance", Unit::Metre)
            .range(0.01, 100000, Scale::Log)
            .effect(ParamEffect::Host)
            .help("Length of the volumes with extrude=distance."),
        field(&P::twoSided, "two-sided")
            .effect(ParamEffect::Host)
            .help("One pass that counts front and back faces at once, instead of one pass each; the picture is the "
                  "same."),
    };
    all.insert(all.end(), own.begin(), own.end());
    return ParamTable(std::move(all));
}

}  // namespace ombrage
