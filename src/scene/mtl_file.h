// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// A picture of a material with the options that count here.
struct MtlMap {
    std::string file;                     ///< as written; empty for none
    glm::vec2 scale{1.0f}, offset{0.0f};  ///< -s and -o: uv * scale + offset, v upwards
    float bumpMultiplier = 1.0f;          ///< -bm
    bool clamp = false;                   ///< -clamp on
    bool empty() const { return file.empty(); }
};

/// One material of a Wavefront .mtl file.
struct MtlMaterial {
    std::filesystem::path folder;  ///< where its file lies: pictures are looked for there first
    std::optional<glm::vec3> diffuse, specular, emissive;
    std::optional<float> shininess, opacity, roughness, metallic;
    MtlMap diffuseMap, opacityMap, emissiveMap, heightMap, normalMap;
};

using MtlLibrary = std::map<std::string, MtlMaterial>;

/// Reads newmtl, Kd, Ks, Ke, Ns, d, Tr, Pr, Pm, map_Kd, map_d, map_Ke, map_bump, bump, norm and map_norm, and their
/// options. Statements without meaning here are passed over; numbers that are none go to `warnings` with `name`:LINE.
MtlLibrary parseMtl(const std::string& text, const std::string& name, std::vector<std::string>& warnings);

}  // namespace ombrage
