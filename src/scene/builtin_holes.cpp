// SPDX-License-Identifier: MIT
// Casters with holes, hairs and panes.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/patterns.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

namespace {
/// Cut out by the texture's opacity.
Material cutOut(int texture) {
    Material material;
    material.baseColor = glm::vec3(1.0f);
    material.alphaMode = AlphaMode::Mask;
    material.baseColorTexture = texture;
    return material;
}

/// Two unit vectors across a third.
void perpendiculars(const glm::vec3& axis, glm::vec3& x, glm::vec3& y) {
    x = glm::normalize(glm::cross(std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), axis));
    y = glm::cross(axis, x);
}

/// Wood and leaves of a tree, grown from a seed of whole numbers.
struct Growth {
    Mesh wood, leaves;
    std::uint32_t count = 0;

    float random(std::uint32_t salt) { return patterns::noise(++count, salt); }

    void branch(const glm::vec3& from, const glm::vec3& direction, float length, float radius, int levels) {
        const glm::vec3 to = from + direction * length;
        shapes::append(wood, shapes::tube(from, to, radius, radius * 0.68f, levels > 2 ? 12 : 7));
        glm::vec3 x, y;
        perpendiculars(direction, x, y);
        if (levels <= 1) leavesAlong(from, direction, length);
        if (levels == 0) return;
        // Children leave the last third, turned about the branch by golden angles, a little upwards.
        const int children = levels > 2 ? 5 : 4;
        for (int i = 0; i < children; ++i) {
            const float turn_rad = 2.39996f * float(i) + 6.28f * random(1), bend = 0.55f + 0.35f * random(2);
            const glm::vec3 aside = x * std::cos(turn_rad) + y * std::sin(turn_rad);
            const glm::vec3 along = glm::normalize(direction + aside * bend * 1.3f + glm::vec3(0, 0.15f, 0));
            const float start = 0.62f + 0.38f * float(i + 1) / float(children);
            branch(from + direction * (length * start * 0.98f), along, length * (0.62f + 0.16f * random(3)),
                   radius * 0.62f, levels - 1);
        }
    }

    void leavesAlong(const glm::vec3& from, const glm::vec3& direction, float length) {
        for (int i = 0; i < 16; ++i) {
            const glm::vec3 stalk = from + direction * (length * (0.25f + 0.8f * random(4)));
            const glm::vec3 up =
                glm::normalize(glm::vec3(random(5) - 0.5f, random(6) - 0.35f, random(7) - 0.5f) + direction * 0.5f);
            glm::vec3 x, y;
            perpendiculars(up, x, y);
            const float turn_rad = 6.28f * random(8), size = 0.09f + 0.05f * random(9);
            const glm::vec3 across = (x * std::cos(turn_rad) + y * std::sin(turn_rad)) * size;
            shapes::append(leaves, shapes::card(stalk - across * 0.5f, across, up * size));
        }
    }
};

/// A strand of two segments that tapers to a point: three triangles without thickness.
void addHair(Mesh& fur, const glm::vec3& root, const glm::vec3& middle, const glm::vec3& tip, const glm::vec3& across) {
    const auto first = std::uint32_t(fur.positions.size());
    const glm::vec3 n = glm::normalize(glm::cross(across, middle - root));
    for (const glm::vec3& p : {root - across, root + across, middle - across * 0.7f, middle + across * 0.7f}) {
        fur.positions.push_back(p);
        fur.normals.push_back(n);
        fur.uvs.emplace_back(0.0f);
    }
    // The tip's segment bends and has a normal of its own.
    const glm::vec3 bent = glm::normalize(glm::cross(across, tip - middle));
    for (const glm::vec3& p : {middle - across * 0.7f, middle + across * 0.7f, tip}) {
        fur.positions.push_back(p);
        fur.normals.push_back(bent);
        fur.uvs.emplace_back(0.0f);
    }
    for (const std::uint32_t i : {0u, 1u, 3u, 0u, 3u, 2u, 4u, 5u, 6u}) fur.indices.push_back(first + i);
}
}  // namespace

Scene fence() {
    SceneBuilder builder("fence");
    const int lattice = builder.texture(patterns::lattice(0.25f));
    // Cells of 12.5 cm, slats of 3 cm: 32 cells along 4 m, 11 up.
    Mesh panel = shapes::card({-2.0f, 0.05f, 0.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 1.4f, 0.0f});
    for (glm::vec2& uv : panel.uvs) uv *= glm::vec2(32.25f, 11.25f);
    return builder.object("floor", shapes::floor(9.0f), kStone)
        .object("lattice", std::move(panel), cutOut(lattice), glm::dmat4(1.0))
        .object("post", shapes::box({-0.05f, -0.02f, -0.05f}, {0.05f, 1.55f, 0.05f}), kClay, {-2.05, 0.0, 0.0})
        .again("post 2", glm::translate(glm::dmat4(1.0), glm::dvec3(2.05, 0.0, 0.0)))
        .object("ball", shapes::sphere({0.0f, 0.35f, 0.0f}, 0.35f, 48, 24), kSea, {0.5, 0.0, 1.0})
        .sun("sun", {-0.35f, -1.0f, 1.0f}, 3.0f)
        .camera("main", {0.9, 1.7, 3.9}, {-0.15, 0.4, 0.5})
        .camera("left", {-3.0, 1.4, 2.6}, {0.0, 0.4, 0.4})
        .camera("top", {0.2, 4.4, 2.6}, {-0.1, 0.0, 0.7})
        .finish(0.4f);
}

Scene tree() {
    SceneBuilder builder("tree");
    const int leaf = builder.texture(patterns::leaf());
    Growth growth;
    growth.branch({0, -0.1f, 0}, glm::normalize(glm::vec3(0.05f, 1.0f, 0.0f)), 1.7f, 0.17f, 4);
    return builder.object("floor", shapes::floor(14.0f), kMoss)
        .object("wood", std::move(growth.wood), kClay)
        .object("leaves", std::move(growth.leaves), cutOut(leaf), glm::dmat4(1.0))
        .sun("sun", {-0.75f, -1.5f, 0.55f}, 3.0f)
        .camera("main", {1.9, 2.2, 6.6}, {-0.7, 1.8, 0.3}, 50.0f)
        .camera("left", {-4.6, 1.6, 4.2}, {-0.4, 1.6, 0.2})
        .camera("top", {-1.0, 8.5, 4.0}, {-0.7, 0.6, 0.4})
        .finish(0.4f);
}

Scene fur() {
    // 24,000 hairs of 1 mm on a ball of 25 cm, evenly by the golden angle.
    constexpr int kHairs = 24000;
    const glm::vec3 center(0, 0.3f, 0);
    Mesh hairs;
    for (int i = 0; i < kHairs; ++i) {
        const auto k = std::uint32_t(i);
        const float y = 1.0f - 2.0f * (float(i) + 0.5f) / float(kHairs), ring = std::sqrt(1.0f - y * y);
        const float turn_rad = float(std::fmod(2.399963229728653 * i, 6.283185307179586));
        const glm::vec3 n(ring * std::cos(turn_rad), y, ring * std::sin(turn_rad));
        if (y < -0.85f) continue;
        // Combed downwards and to one side, with a little disorder.
        const glm::vec3 disorder(patterns::noise(k, 1) - 0.5f, patterns::noise(k, 2) - 0.5f,
                                 patterns::noise(k, 3) - 0.5f);
        const glm::vec3 comb = glm::vec3(0.35f, -0.55f, 0.15f) + disorder * 0.9f;
        const float length = 0.045f + 0.02f * patterns::noise(k, 4);
        const glm::vec3 root = center + n * 0.248f, middle = root + (n + comb * 0.25f) * (length * 0.55f);
        const glm::vec3 tip = middle + (n * 0.7f + comb) * (length * 0.5f);
        const glm::vec3 across = glm::normalize(glm::cross(n, comb + n * 0.01f)) * 0.0005f;
        addHair(hairs, root, middle, tip, across);
    }
    return SceneBuilder("fur")
        .object("floor", shapes::floor(2.4f), kStone)
        .object("skin", shapes::sphere(center, 0.25f, 64, 32), kSlate)
        .object("hair", std::move(hairs), kStraw)
        .object("rod", shapes::tube({-0.3f, 0.62f, 0.35f}, {0.42f, 0.7f, 0.1f}, 0.012f, 0.012f), kSlate)
        .sun("sun", {-0.7f, -1.2f, -0.25f}, 3.0f)
        .camera("main", {0.32, 0.62, 0.86}, {-0.09, 0.25, 0.0}, 45.0f)
        .camera("left", {-0.8, 0.45, 0.5}, {-0.05, 0.22, 0.0})
        .camera("top", {-0.1, 1.2, 0.5}, {-0.08, 0.2, 0.0})
        .finish(0.06f);
}

Scene glass() {
    SceneBuilder builder("glass");
    builder.object("floor", shapes::floor(6.0f), kChalk);
    const struct {
        const char* name;
        glm::vec3 color;
        float x;
    } panes[] = {{"red pane", {0.85f, 0.16f, 0.14f}, -0.95f},
                 {"green pane", {0.2f, 0.68f, 0.26f}, 0.0f},
                 {"blue pane", {0.18f, 0.34f, 0.85f}, 0.95f}};
    for (const auto& pane : panes) {
        Material material = paint(pane.color);
        material.alphaMode = AlphaMode::Blend;
        material.alpha = 0.4f;
        const glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(pane.x, 0.0, 0.15 * pane.x)),
                                             glm::radians(12.0), glm::dvec3(0, 1, 0));
        builder.object(pane.name, shapes::box({-0.4f, 0.02f, -0.005f}, {0.4f, 1.1f, 0.005f}), material, place);
    }
    return builder.object("ball", shapes::sphere({0.0f, 0.2f, 0.0f}, 0.2f, 48, 24), kSlate, {0.6, 0.0, 0.8})
        .sun("sun", {-0.55f, -1.0f, 0.75f}, 3.0f)
        .camera("main", {0.5, 1.8, 2.9}, {-0.3, 0.3, 0.35})
        .camera("left", {-2.6, 1.1, 2.2}, {0.0, 0.35, 0.3})
        .camera("top", {0.2, 3.6, 2.2}, {-0.1, 0.0, 0.5})
        .finish(0.3f);
}

}  // namespace ombrage::builtin
