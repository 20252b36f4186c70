// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// One material of a Wavefront .mtl file; a map is a path as written, empty for none.
struct MtlMaterial {
    std::optional<glm::vec3> diffuse, specular, emissive;
    std::optional<float> shininess, opacity, roughness, metallic;
    std::string diffuseMap, opacityMap, emissiveMap, heightMap, normalMap;
    float bumpMultiplier = 1.0f;  ///< option -bm of the height map
};

using MtlLibrary = std::map<std::string, MtlMaterial>;

/// Reads newmtl, Kd, Ks, Ke, Ns, d, Tr, Pr, Pm, map_Kd, map_d, map_Ke, map_bump, bump, norm and map_norm, and their
/// options. Statements without meaning here are passed over; numbers that are none go to `warnings` with `name`:LINE.
MtlLibrary parseMtl(const std::string& text, const std::string& name, std::vector<std::string>& warnings);

/// The libraries that the mtllib statements of an OBJ text name, in order.
std::vector<std::string> mtlLibrariesOf(const std::string& objText);

}  // namespace ombrage
