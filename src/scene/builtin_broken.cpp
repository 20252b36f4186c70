// SPDX-License-Identifier: MIT
// Geometry and placements that programs get wrong.
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

namespace {
glm::dmat4 placed(const glm::dvec3& position, double turn_deg, const glm::dvec3& scale) {
    return glm::scale(
        glm::rotate(glm::translate(glm::dmat4(1.0), position), glm::radians(turn_deg), glm::dvec3(0, 1, 0)), scale);
}

/// What exporters leave behind: triangles with a corner that is no number or endless, without area, or there twice.
void spoil(Mesh& mesh) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
    const auto count = std::uint32_t(mesh.positions.size());
    for (const glm::vec3& p : {glm::vec3(nan, 0.5f, 0.0f), glm::vec3(0.0f, endless, 0.0f)}) {
        mesh.positions.push_back(p);
        mesh.normals.emplace_back(nan);
        mesh.uvs.emplace_back(nan);
    }
    const std::vector<std::uint32_t> sound = mesh.indices;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (std::size_t i = 0; i + 2 < sound.size(); i += 60) {
        add(sound[i], sound[i + 1], count);
        add(sound[i], count + 1, sound[i + 2]);
        add(sound[i], sound[i + 1], sound[i + 1]);
        add(sound[i + 1], sound[i + 2], sound[i]);
    }
}
}  // namespace

Scene degenerate() {
    Mesh ball = shapes::sphere({0.0f, 0.6f, 0.0f}, 0.5f, 48, 24),
         block = shapes::box({-0.4f, -0.01f, -0.4f}, {0.4f, 0.8f, 0.4f});
    Mesh floor = shapes::floor(6.0f);
    for (Mesh* mesh : {&ball, &block, &floor}) spoil(*mesh);
    return SceneBuilder("degenerate")
        .object("floor", std::move(floor), kStone)
        .object("ball", std::move(ball), kClay, {-0.7, 0.0, 0.2})
        .object("block", std::move(block), kSea, {0.8, 0.0, -0.2}, 25.0)
        .sun("sun", {-0.8f, -1.5f, 0.7f}, 3.0f)
        .camera("main", {-0.6, 1.9, 3.5}, {-0.1, 0.35, 0.1})
        .camera("left", {-3.0, 1.1, 1.8}, {0.0, 0.35, 0.0})
        .camera("top", {-0.4, 4.2, 1.4}, {-0.1, 0.0, 0.2})
        .finish(0.4f);
}

Scene mirrored() {
    // Stairs that tell left from right, five times: as they are, mirrored, stretched, both, and mirrored in all axes.
    std::vector<glm::vec2> outline = {{0.0f, 0.0f}, {0.9f, 0.0f}};
    for (int step = 0; step < 3; ++step) {
        outline.emplace_back(0.9f - 0.3f * float(step), 0.3f * float(step + 1));
        outline.emplace_back(0.6f - 0.3f * float(step), 0.3f * float(step + 1));
    }
    outline.pop_back();
    outline.emplace_back(0.0f, 0.9f);
    return SceneBuilder("mirrored")
        .object("floor", shapes::floor(9.0f), kStone)
        .object("stairs", shapes::prism(outline, 0.5f), paint(kSea), placed({-1.9, 0.001, 0.5}, 15.0, {1, 1, 1}))
        .again("stairs mirrored", placed({1.9, 0.001, 0.7}, -15.0, {-1, 1, 1}))
        .again("stairs stretched", placed({-1.6, 0.001, -1.6}, 10.0, {1.5, 0.6, 0.7}))
        .again("stairs mirrored and stretched", placed({1.7, 0.001, -1.3}, -10.0, {-0.7, 1.5, 1.6}))
        .again("stairs mirrored in all axes", placed({0.4, 1.9, -1.5}, 200.0, {-0.8, -0.8, -1.2}))
        .object("ball", shapes::sphere({0, 0.5f, 0}, 0.5f, 48, 24), paint(kClay),
                placed({0.0, 0.005, 0.9}, 30.0, {-0.5, 0.9, 0.8}))
        .sun("sun", {-0.75f, -1.5f, 0.55f}, 3.0f)
        .camera("main", {-0.4, 2.5, 4.6}, {-0.15, 0.4, -0.2})
        .camera("left", {-4.0, 1.5, 2.4}, {0.0, 0.4, -0.3})
        .camera("top", {0.0, 5.8, 2.2}, {-0.1, 0.2, -0.2})
        .finish(0.4f);
}

Scene threeCasters() {
    // One lamp straight above three slabs: where their shadows overlap a map's texel sees three depths and the floor.
    return SceneBuilder("three-casters")
        .object("floor", shapes::floor(8.0f), kStone)
        .object("high slab", shapes::box({-0.35f, 4.4f, -0.35f}, {0.35f, 4.45f, 0.35f}), kClay, {-0.3, 0.0, -0.1})
        .object("middle slab", shapes::box({-0.55f, 2.4f, -0.55f}, {0.55f, 2.45f, 0.55f}), kMoss, {0.2, 0.0, 0.25},
                30.0)
        .object("low slab", shapes::box({-0.8f, 0.6f, -0.8f}, {0.8f, 0.65f, 0.8f}), kSea, {0.15, 0.0, -0.2}, 12.0)
        .spot("lamp", {0.0, 6.0, 0.0}, {0.0f, -1.0f, 0.0f}, 25.0f, 32.0f, 110.0f)
        .camera("main", {3.0, 2.6, 4.2}, {0.0, 0.5, 0.0})
        .camera("left", {-4.2, 1.9, 2.0}, {0.0, 0.4, 0.0})
        .camera("top", {-1.4, 3.6, -3.0}, {0.0, 0.0, 0.1})
        .finish(0.5f);
}

}  // namespace ombrage::builtin
