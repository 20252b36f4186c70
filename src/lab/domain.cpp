// SPDX-License-Identifier: MIT
#include "lab/domain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scene/planar_surfaces.h"

namespace ombrage {

namespace {

/// Closed: every edge of the model is run through equally often in both directions. Vertices are one where their world
/// positions are equal to the bit, so a model may consist of several meshes.
bool isClosed(const Scene& scene, int model) {
    std::map<std::array<double, 3>, int> ids;
    std::map<std::pair<int, int>, int> balance;
    for (const Instance& instance : scene.instances) {
        if (instance.model != model) continue;
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        std::vector<int> idOf(mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::dvec4 p = instance.worldFromLocal * glm::dvec4(mesh.positions[v], 1.0);
            idOf[v] = ids.emplace(std::array{p.x, p.y, p.z}, int(ids.size())).first->second;
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            for (std::size_t e = 0; e < 3; ++e) {
                const int a = idOf[mesh.indices[i + e]], b = idOf[mesh.indices[i + (e + 1) % 3]];
                if (a != b) balance[std::minmax(a, b)] += a < b ? 1 : -1;
            }
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace

std::string unsupportedReason(const Pipeline& pipeline, const Light& light) {
    for (const TechniqueSpec& spec : pipeline)
        if (!supports(technique(spec.id).domain, light.type))
            return spec.id + " does not render " + lightTypeName(light.type) + " lights such as '" + light.name + "'";
    return {};
}

bool takesCentreOf(const Pipeline& pipeline, const Light& light) {
    return light.hasSize() && !technique(pipeline.front().id).domain.soft;
}

SceneTraits sceneTraits(const Scene& scene) {
    SceneTraits traits;
    for (std::size_t m = 0; m < scene.models.size(); ++m)
        if (scene.models[m].casts && !isClosed(scene, int(m))) traits.closedCasters = false;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        if (scene.models[std::size_t(instance.model)].casts &&
            scene.materials[std::size_t(mesh.material)].alphaMode == AlphaMode::Mask)
            traits.alphaCasters = true;
    }
    for (const std::uint8_t plane : findPlanarSurfaces(flatten(scene)).planeOf)
        traits.planarTriangle.push_back(plane != 0);
    return traits;
}

std::vector<bool> domainMask(const Pipeline& pipeline, const Light& light, const SceneTraits& traits,
                             const Receivers& receivers) {
    const std::size_t count = receivers.instance.size();
    bool planarOnly = false;
    for (const TechniqueSpec& spec : pipeline) {
        const Domain& domain = technique(spec.id).domain;
        if ((domain.closedCastersOnly && !traits.closedCasters) || (!domain.alphaTest && traits.alphaCasters))
            return std::vector<bool>(count, false);
        planarOnly = planarOnly || domain.planarReceiversOnly;
    }
    if (takesCentreOf(pipeline, light)) return std::vector<bool>(count, false);
    if (!planarOnly) return {};
    std::vector<bool> mask(count, false);
    for (std::size_t i = 0; i < count; ++i)
        mask[i] = receivers.triangle[i] != kNoHit && traits.planarTriangle[receivers.triangle[i]];
    return mask;
}

}  // namespace ombrage
