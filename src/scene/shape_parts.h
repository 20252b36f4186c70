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

/// A flat face of four corners, counter-clockwise, given so that neighbours share the bits.
inline void addFace(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    const glm::vec3 n = glm::normalize(glm::cross(b - a, d - a));
    const float width = glm::length(b - a), height = glm::length(d - a);
    const std::uint32_t first = addVertex(mesh, a, n, {0, height});
    addVertex(mesh, b, n, {width, height});
    addVertex(mesh, c, n, {width, 0});
    addVertex(mesh, d, n, {0, 0});
    addTriangle(mesh, first, first + 1, first + 2);
    addTriangle(mesh, first, first + 2, first + 3);
}

/// Angle of step i of n around a full turn. The last step gives the bits of the first, so that seams close.
inline glm::vec2 circlePoint(int i, int n) {
    const double angle_rad = 2.0 * glm::pi<double>() * double(i % n) / double(n);
    return {float(std::cos(angle_rad)), float(std::sin(angle_rad))};
}

}  // namespace ombrage::shapes
