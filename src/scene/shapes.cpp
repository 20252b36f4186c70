// SPDX-License-Identifier: MIT
#include "scene/shapes.h"

#include <array>
#include <cmath>

#include "scene/shape_parts.h"

namespace ombrage::shapes {

namespace {
/// A grid of (columns + 1) x (rows + 1) vertices. `point(column, row)` gives position, normal and uv; neighbouring rows
/// that meet in a pole give triangles instead of quads.
template <typename F>
Mesh grid(int columns, int rows, bool poleFirst, bool poleLast, F point) {
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const auto [p, n, uv] = point(column, row);
            addVertex(mesh, p, n, uv);
        }
    const auto at = [&](int column, int row) { return std::uint32_t(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(column, row), b = at(column + 1, row), c = at(column + 1, row + 1),
                                d = at(column, row + 1);
            if (!(poleFirst && row == 0)) addTriangle(mesh, a, b, c);
            if (!(poleLast && row == rows - 1)) addTriangle(mesh, a, c, d);
        }
    return mesh;
}

struct GridPoint {
    glm::vec3 p, n;
    glm::vec2 uv;
};
}  // namespace

Mesh rectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, int uCount, int vCount) {
    const glm::vec3 n = glm::normalize(glm::cross(u, v));
    const glm::vec2 size(glm::length(u), glm::length(v));
    return grid(uCount, vCount, false, false, [&](int column, int row) {
        const glm::vec2 s(float(column) / float(uCount), float(row) / float(vCount));
        return GridPoint{corner + u * s.x + v * s.y, n, glm::vec2(s.x, 1.0f - s.y) * size};
    });
}

Mesh floor(float size, float y, int count) {
    return rectangle({-0.5f * size, y, 0.5f * size}, {size, 0, 0}, {0, 0, -size}, count, count);
}

Mesh box(const glm::vec3& lower, const glm::vec3& upper, bool inward) {
    // Corners by number: bits 0, 1 and 2 choose the upper x, y and z; all faces share their bits.
    const auto corner = [&](int i) {
        return glm::vec3(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z);
    };
    constexpr int kFaces[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    Mesh mesh;
    for (const auto& f : kFaces) {
        // The same face from the other side: start at the second corner and walk back.
        if (inward)
            addFace(mesh, corner(f[1]), corner(f[0]), corner(f[3]), corner(f[2]));
        else
            addFace(mesh, corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
    }
    return mesh;
}

Mesh sphere(const glm::vec3& center, float radius, int slices, int stacks) {
    return grid(slices, stacks, true, true, [&](int column, int row) {
        const double polar_rad = glm::pi<double>() * double(stacks - row) / double(stacks);
        // Exact poles, so that their triangles close.
        const bool pole = row == 0 || row == stacks;
        const float sine = pole ? 0.0f : float(std::sin(polar_rad)), cosine = float(std::cos(polar_rad));
        const glm::vec2 c = circlePoint(column, slices);
        const glm::vec3 n(sine * c.x, cosine, -sine * c.y);
        return GridPoint{
            center + n * radius, n, {float(column) / float(slices) * 4.0f, 2.0f - float(row) / float(stacks) * 2.0f}};
    });
}

Mesh cylinder(const glm::vec3& foot, float radius, float height, int slices) {
    Mesh mesh = grid(slices, 1, false, false, [&](int column, int row) {
        const glm::vec2 c = circlePoint(column, slices);
        const glm::vec3 n(c.x, 0, -c.y);
        const float turn_m = 6.2831853f * radius * float(column) / float(slices);
        return GridPoint{foot + n * radius + glm::vec3(0, row ? height : 0.0f, 0), n, {turn_m, row ? 0.0f : height}};
    });
    for (const bool top : {false, true}) {
        const glm::vec3 middle = foot + glm::vec3(0, top ? height : 0.0f, 0), n(0, top ? 1.0f : -1.0f, 0);
        const std::uint32_t hub = addVertex(mesh, middle, n, {radius, radius});
        for (int i = 0; i < slices; ++i) {
            const glm::vec2 c = circlePoint(i, slices);
            addVertex(mesh, middle + glm::vec3(c.x, 0, -c.y) * radius, n, glm::vec2(1.0f + c.x, 1.0f - c.y) * radius);
        }
        for (int i = 0; i < slices; ++i) {
            const std::uint32_t a = hub + 1 + std::uint32_t(i), b = hub + 1 + std::uint32_t((i + 1) % slices);
            if (top)
                addTriangle(mesh, hub, a, b);
            else
                addTriangle(mesh, hub, b, a);
        }
    }
    return mesh;
}

Mesh disk(const glm::vec3& center, float radius, int slices, int rings) {
    return grid(slices, rings, true, false, [&](int column, int row) {
        // Row 0 is the centre; walking outwards and backwards around keeps the face up.
        const glm::vec2 c = circlePoint(column, slices) * (radius * float(row) / float(rings));
        return GridPoint{center + glm::vec3(c.x, 0, c.y), {0, 1, 0}, glm::vec2(radius) + c};
    });
}

Mesh halfTube(const glm::vec3& center, float radius, float length, int slices, int segments) {
    return grid(segments, slices, false, false, [&](int column, int row) {
        const double angle_rad = glm::pi<double>() * double(row) / double(slices);
        const glm::vec3 n(0, float(std::sin(angle_rad)), float(std::cos(angle_rad)));
        const float x = (float(column) / float(segments) - 0.5f) * length;
        const float arc_m = float(angle_rad) * radius;
        return GridPoint{center + n * radius + glm::vec3(x, 0, 0), n, {x + 0.5f * length, 3.1415927f * radius - arc_m}};
    });
}

Mesh bowl(const glm::vec3& center, float radius, int slices, int stacks) {
    return grid(slices, stacks, true, false, [&](int column, int row) {
        const double angle_rad = 0.5 * glm::pi<double>() * double(row) / double(stacks);
        const glm::vec2 c = circlePoint(column, slices);
        const float sine = row == 0 ? 0.0f : float(std::sin(angle_rad));
        const glm::vec3 n(sine * c.x, -float(std::cos(angle_rad)), -sine * c.y);
        return GridPoint{
            center + n * radius, n, {float(column) / float(slices) * 3.0f, 1.0f - float(row) / float(stacks)}};
    });
}

Mesh mengerSponge(int level, float side, float bottom) {
    int cells = 1;
    for (int i = 0; i < level; ++i) cells *= 3;
    // A cell is a hole when at some level two or more of its base-3 digits are in the middle.
    const auto solid = [&](glm::ivec3 c) {
        for (int i = 0; i < 3; ++i)
            if (c[i] < 0 || c[i] >= cells) return false;
        for (int i = 0; i < level; ++i, c /= 3)
            if (int(c.x % 3 == 1) + int(c.y % 3 == 1) + int(c.z % 3 == 1) >= 2) return false;
        return true;
    };
    // Every corner comes from one formula on whole numbers, so that neighbours share the same bits.
    const auto corner = [&](const glm::ivec3& c) {
        return glm::vec3(glm::vec3(c) * (side / float(cells))) + glm::vec3(-0.5f * side, bottom, -0.5f * side);
    };
    const std::array<std::array<glm::ivec3, 3>, 6> sides = {{{{{1, 0, 1}, {0, 0, -1}, {0, 1, 0}}},
                                                             {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
                                                             {{{0, 1, 1}, {1, 0, 0}, {0, 0, -1}}},
                                                             {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                                                             {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
                                                             {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}}}};
    Mesh mesh;
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                const glm::ivec3 cell(x, y, z);
                if (!solid(cell)) continue;
                for (const auto& [start, u, v] : sides) {
                    const glm::ivec3 n(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
                    if (solid(cell + n)) continue;
                    const glm::ivec3 corners[4] = {cell + start, cell + start + u, cell + start + u + v,
                                                   cell + start + v};
                    std::uint32_t index[4];
                    for (int k = 0; k < 4; ++k) {
                        const glm::vec3 p = corner(corners[k]);
                        const glm::vec2 uv(glm::dot(p, glm::vec3(u)), -glm::dot(p, glm::vec3(v)));
                        index[k] = addVertex(mesh, p, glm::vec3(n), uv);
                    }
                    addTriangle(mesh, index[0], index[1], index[2]);
                    addTriangle(mesh, index[0], index[2], index[3]);
                }
            }
    return mesh;
}

}  // namespace ombrage::shapes
