// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_params.h"

namespace ombrage {

namespace {

using P = VolumeParams;

std::vector<ParamField> silhouetteFields() {
    return {
        field(&P::faces, "faces")
            .effect(ParamEffect::Host)
            .help("Extrude every triangle, the casting triangles, or their silhouette: the same picture for less and "
                  "less fill."),
        field(&P::silhouette, "silhouette")
            .effect(ParamEffect::Host)
            .help("Who finds the silhouette: the processor, a geometry shader in every frame, or a compute shader that "
                  "appends to an indirect draw. With other faces than silhouette always the processor."),
    };
}

std::vector<ParamField> endFields() {
    return {
        field(&P::extrude, "extrude")
            .effect(ParamEffect::Host)
            .help("Volumes reach to infinity, or end after a distance, which loses the shadow beyond it."),
        field(&P::distance_m, "distance", Unit::Metre)
            .range(0.01, 100000, Scale::Log)
            .effect(ParamEffect::Host)
            .help("Length of the volumes with extrude=distance."),
    };
}

ParamTable joined(std::vector<ParamField> all, const std::vector<ParamField>& own) {
    all.push_back(
        field(&P::twoSided, "two-sided")
            .effect(ParamEffect::Host)
            .help("One pass that counts front and back faces at once, instead of one pass each; the picture is the "
                  "same."));
    all.insert(all.end(), own.begin(), own.end());
    return ParamTable(std::move(all));
}

}  // namespace

ParamTable volumeTable(const std::vector<ParamField>& own) {
    std::vector<ParamField> fields = silhouetteFields();
    for (const ParamField& end : endFields()) fields.push_back(end);
    return joined(std::move(fields), own);
}

ParamTable volumeTableWithoutEnds(const std::vector<ParamField>& own) {
    return joined(silhouetteFields(), own);
}

}  // namespace ombrage
