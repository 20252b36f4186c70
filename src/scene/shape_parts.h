// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include <ombrage/scene.h>
#include <glm/gtc/constants.hpp>

namespace ombrage::shapes {

inline std::uint32_t addVertex(Mesh& mesh, const glm::vec3& p, const glm::vec3& n, const glm::vec2& uv) {
    mesh.positions.push_back(p);
    mesh.normals.push_back(n);
    mesh.uvs.push_back(uv);
    return std::uint32_t(mesh.positions.size() - 1);
}

inline void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Angle of step i of n around a full turn. The last step gives the bits of the first, so that seams close.
inline glm::vec2 circlePoint(int i, int n) {
    const double angle_rad = 2.0 * glm::pi<double>() * double(i % n) / double(n);
    return {float(std::cos(angle_rad)), float(std::sin(angle_rad))};
}

}  // namespace ombrage::shapes
