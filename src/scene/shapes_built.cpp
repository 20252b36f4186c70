// SPDX-License-Identifier: MIT
// Shapes put together from rings and outlines.
#include <cmath>
#include <utility>

#include "scene/shape_parts.h"
#include "scene/shapes.h"

namespace ombrage::shapes {

Mesh tube(const glm::vec3& start, const glm::vec3& end, float startRadius, float endRadius, int slices) {
    const float length = glm::length(end - start);
    const glm::vec3 axis = (end - start) / length;
    const glm::vec3 aside = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(aside, axis)), y = glm::cross(axis, x);

    // Both ends' rims, whose points sides and ends share.
    std::vector<glm::vec3> rims[2], outward;
    for (int i = 0; i <= slices; ++i) {
        const glm::vec2 c = circlePoint(i, slices);
        const glm::vec3 radial = x * c.x + y * c.y;
        rims[0].push_back(start + radial * startRadius);
        rims[1].push_back(end + radial * endRadius);
        outward.push_back(glm::normalize(radial * length + axis * (startRadius - endRadius)));
    }
    Mesh mesh;
    for (int i = 0; i <= slices; ++i) {
        const float turn_m = 6.2831853f * startRadius * float(i) / float(slices);
        addVertex(mesh, rims[0][std::size_t(i)], outward[std::size_t(i)], {turn_m, length});
        addVertex(mesh, rims[1][std::size_t(i)], outward[std::size_t(i)], {turn_m, 0});
    }
    for (std::uint32_t i = 0; i < std::uint32_t(slices); ++i) {
        addTriangle(mesh, 2 * i, 2 * i + 2, 2 * i + 3);
        addTriangle(mesh, 2 * i, 2 * i + 3, 2 * i + 1);
    }
    for (const std::size_t side : {0u, 1u}) {
        const glm::vec3 n = side ? axis : -axis;
        const std::uint32_t hub = addVertex(mesh, side ? end : start, n, {0, 0});
        for (int i = 0; i < slices; ++i) addVertex(mesh, rims[side][std::size_t(i)], n, circlePoint(i, slices) * 0.1f);
        for (std::uint32_t i = 0; i < std::uint32_t(slices); ++i) {
            const std::uint32_t a = hub + 1 + i, b = hub + 1 + (i + 1) % std::uint32_t(slices);
            if (side)
                addTriangle(mesh, hub, a, b);
            else
                addTriangle(mesh, hub, b, a);
        }
    }
    return mesh;
}

Mesh torus(const glm::vec3& center, float radius, float thickness, int slices, int sides) {
    Mesh mesh;
    for (int i = 0; i <= slices; ++i)
        for (int k = 0; k <= sides; ++k) {
            const glm::vec2 around = circlePoint(i, slices), section = circlePoint(k, sides);
            const glm::vec3 n(around * section.x, section.y);
            const glm::vec3 p = center + glm::vec3(around * radius, 0) + n * thickness;
            addVertex(mesh, p, n, {6.2831853f * radius * float(i) / float(slices), float(k) / float(sides) * 0.1f});
        }
    const auto at = [&](int i, int k) { return std::uint32_t(i * (sides + 1) + k); };
    for (int i = 0; i < slices; ++i)
        for (int k = 0; k < sides; ++k) {
            addTriangle(mesh, at(i, k), at(i + 1, k), at(i + 1, k + 1));
            addTriangle(mesh, at(i, k), at(i + 1, k + 1), at(i, k + 1));
        }
    return mesh;
}

Mesh prism(const std::vector<glm::vec2>& outline, float depth) {
    Mesh mesh;
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 a = outline[i], b = outline[(i + 1) % count];
        addFace(mesh, {a, 0}, {b, 0}, {b, depth}, {a, depth});
    }
    for (const bool front : {false, true}) {
        const glm::vec3 n(0, 0, front ? 1.0f : -1.0f);
        const auto first = std::uint32_t(mesh.positions.size());
        for (const glm::vec2& p : outline) addVertex(mesh, {p, front ? depth : 0.0f}, n, {front ? p.x : -p.x, -p.y});
        for (std::uint32_t i = 1; i + 1 < count; ++i) {
            if (front)
                addTriangle(mesh, first, first + i, first + i + 1);
            else
                addTriangle(mesh, first, first + i + 1, first + i);
        }
    }
    return mesh;
}

Mesh wallWithOpening(const glm::vec2& lower, const glm::vec2& upper, const glm::vec2& openingLower,
                     const glm::vec2& openingUpper, float depth) {
    const glm::vec2 outer[4] = {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    const glm::vec2 inner[4] = {
        openingLower, {openingUpper.x, openingLower.y}, openingUpper, {openingLower.x, openingUpper.y}};
    Mesh mesh;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        // Around the wall, around the opening, and a quarter of either face.
        addFace(mesh, {outer[i], 0}, {outer[j], 0}, {outer[j], depth}, {outer[i], depth});
        addFace(mesh, {inner[j], 0}, {inner[i], 0}, {inner[i], depth}, {inner[j], depth});
        addFace(mesh, {outer[i], depth}, {outer[j], depth}, {inner[j], depth}, {inner[i], depth});
        addFace(mesh, {outer[j], 0}, {outer[i], 0}, {inner[i], 0}, {inner[j], 0});
    }
    return mesh;
}

Mesh arch(float span, float thickness, float depth, int steps) {
    // Corners come from one formula, so that neighbours share the bits.
    const auto corner = [&](int i, bool isOuter, float z) {
        const double angle_rad = glm::pi<double>() * double(i) / double(steps);
        const float radius = 0.5f * (isOuter ? span + thickness : span - thickness);
        return glm::vec3(span * 0.5f + radius * float(std::cos(angle_rad)), radius * float(std::sin(angle_rad)), z);
    };
    Mesh mesh;
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 in0 = corner(i, false, 0), in1 = corner(i + 1, false, 0), out0 = corner(i, true, 0),
                        out1 = corner(i + 1, true, 0);
        const glm::vec3 front(0, 0, depth);
        addFace(mesh, in0 + front, out0 + front, out1 + front, in1 + front);
        addFace(mesh, in0, in1, out1, out0);
        addFace(mesh, out0, out1, out1 + front, out0 + front);
        addFace(mesh, in1, in0, in0 + front, in1 + front);
    }
    const glm::vec3 front(0, 0, depth);
    const glm::vec3 in0 = corner(0, false, 0), out0 = corner(0, true, 0), in1 = corner(steps, false, 0),
                    out1 = corner(steps, true, 0);
    addFace(mesh, in0, out0, out0 + front, in0 + front);
    addFace(mesh, out1, in1, in1 + front, out1 + front);
    return mesh;
}

Mesh card(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
    Mesh mesh;
    const glm::vec3 n = glm::normalize(glm::cross(u, v));
    addVertex(mesh, corner, n, {0, 1});
    addVertex(mesh, corner + u, n, {1, 1});
    addVertex(mesh, corner + u + v, n, {1, 0});
    addVertex(mesh, corner + v, n, {0, 0});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

}  // namespace ombrage::shapes
