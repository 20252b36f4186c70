// SPDX-License-Identifier: MIT
// What a question about shadows names: a light, a kind of truth, and with them the casters.
#include <ombrage/error.h>

#include "reference/reference_impl.h"

namespace ombrage {

const Light& checkedLight(const Scene& scene, int light) {
    if (light < 0 || std::size_t(light) >= scene.lights.size())
        throw Error(ErrorCode::Usage, "there is no light " + std::to_string(light),
                    "The scene has " + std::to_string(scene.lights.size()) + " lights, counted from 0.");
    return scene.lights[std::size_t(light)];
}

TruthKind checkedShadowKind(const ReferenceOptions& options) {
    const TruthKind kind = options.kind.value_or(truthKindsOf(Quantity::Shadow).front());
    truthKindFromName(truthKindName(kind), Quantity::Shadow);
    if (kind == TruthKind::Area)
        throw Error(ErrorCode::Usage, "the truth 'area' has receivers of its own", "Use Reference::areaShadow.");
    return kind;
}

std::vector<std::vector<bool>> castersByModel(const FlatScene& flat, const Scene& scene, const Light& light,
                                              TruthKind kind) {
    std::vector<std::vector<bool>> casters(1, shadingInstances(flat, light));
    if (kind != TruthKind::Self) return casters;
    const std::vector<bool> all = casters.front();
    casters.assign(scene.models.size(), std::vector<bool>(all.size(), false));
    for (std::size_t i = 0; i < all.size(); ++i) casters[std::size_t(flat.instances[i].model)][i] = all[i];
    return casters;
}

}  // namespace ombrage
