// SPDX-License-Identifier: MIT
// Long distances, low suns, casters out of sight.
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/patterns.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

namespace {
glm::dmat4 at(double x, double z, double turn_deg = 0.0) {
    return glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z)), glm::radians(turn_deg),
                       glm::dvec3(0, 1, 0));
}

/// A poplar: a trunk and a slim crown, both closed.
Mesh poplar() {
    Mesh tree = shapes::tube({0, -0.05f, 0}, {0, 1.6f, 0}, 0.18f, 0.12f, 12);
    shapes::append(tree, shapes::tube({0, 1.2f, 0}, {0, 4.0f, 0}, 0.35f, 1.0f, 16));
    shapes::append(tree, shapes::tube({0, 3.95f, 0}, {0, 8.5f, 0}, 1.0f, 0.05f, 16));
    return tree;
}
}  // namespace

Scene longView() {
    // A road of 400 m. Fence posts are 12 cm thick, a texel of one map over all of it 30 cm and more.
    Mesh fence;
    for (const float side : {-3.0f, 3.0f}) {
        for (int i = 0; i < 134; ++i) {
            const float z = 3.0f - 3.0f * float(i);
            shapes::append(fence, shapes::box({side - 0.06f, -0.05f, z - 0.06f}, {side + 0.06f, 1.1f, z + 0.06f}));
        }
        // Rails end inside the first and the last post and stand out of their sides.
        for (const float height : {0.45f, 0.9f})
            shapes::append(fence, shapes::box({side + 0.03f, height, -396.02f}, {side + 0.09f, height + 0.09f, 3.02f}));
    }
    SceneBuilder builder("long-view");
    builder.object("floor", shapes::rectangle({-60, 0, 12}, {120, 0, 0}, {0, 0, -420}, 12, 42), kMoss)
        .object("fence", std::move(fence), kStraw)
        .object("tree 1", poplar(), paint(kGreen), at(-5.5, -9.0));
    for (int i = 1; i < 26; ++i)
        builder.again("tree " + std::to_string(i + 1), at(i % 2 ? 5.5 : -5.5, -9.0 - 15.0 * i, 37.0 * i));
    builder.object("barn 1", shapes::box({-4, -0.1f, -6}, {4, 5, 6}), paint(kClay), at(14.0, -40.0, 10.0));
    for (int i = 1; i < 6; ++i)
        builder.again("barn " + std::to_string(i + 1), at(i % 2 ? -15.0 : 16.0, -40.0 - 60.0 * i, 25.0 * i));
    return builder.sun("sun", {-0.85f, -0.75f, 0.25f}, 3.0f)
        .camera("main", {0.3, 1.7, 5.0}, {-0.35, 0.55, -8.0})
        .camera("left", {-8.0, 2.4, 4.0}, {2.0, 0.4, -14.0})
        .camera("top", {10.0, 22.0, 16.0}, {0.0, 0.0, -40.0})
        .finish(1.0f);
}

Scene lightAhead() {
    // The sun stands 17 degrees high, straight ahead of the camera: view and light are almost opposite.
    SceneBuilder builder("light-ahead");
    builder.object("floor", shapes::rectangle({-60, 0, 8}, {120, 0, 0}, {0, 0, -128}, 12, 12), kStone)
        .object("column 1", shapes::cylinder({0.0f, -0.05f, 0.0f}, 0.22f, 2.6f), paint(kClay), at(-1.6, -3.0));
    for (int i = 1; i < 24; ++i)
        builder.again("column " + std::to_string(i + 1),
                      at((i % 2 ? 1.6 : -1.6) * (1.0 + 0.08 * (i % 5)), -3.0 - 4.5 * (i / 2)));
    return builder
        .object("gate", shapes::wallWithOpening({-0.9f, -0.05f}, {0.9f, 2.2f}, {-0.6f, -0.02f}, {0.6f, 1.9f}, 0.3f),
                paint(kSea), at(-0.1, -6.2, 8.0))
        .sun("sun", {0.06f, -0.3f, 1.0f}, 5.0f)
        .camera("main", {0.0, 1.7, 5.5}, {0.0, 0.75, -6.0}, 45.0f)
        .camera("left", {-4.5, 1.8, 4.5}, {-0.5, 0.6, -6.0})
        .camera("top", {0.0, 12.0, 8.0}, {0.0, 0.0, -10.0})
        .finish(0.6f);
}

Scene behind() {
    // A gate and a flagpole stand behind the camera, a slab beside it; only their shadows are seen.
    return SceneBuilder("behind")
        .object("floor", shapes::floor(30.0f), kStone)
        .object("gate", shapes::wallWithOpening({-1.5f, -0.05f}, {1.5f, 5.6f}, {-0.9f, -0.02f}, {0.9f, 4.7f}, 0.4f),
                paint(kClay), at(0.0, 3.6, 0.0))
        .object("flagpole", shapes::cylinder({0.0f, -0.05f, 0.0f}, 0.05f, 5.6f), paint(kSlate), at(2.6, 2.6))
        .object("flag", shapes::box({0.0f, 4.3f, -0.01f}, {1.1f, 5.3f, 0.01f}), paint(kRed), at(2.6, 2.6, 8.0))
        .object("slab", shapes::box({-0.2f, -0.05f, -1.0f}, {0.2f, 2.4f, 1.0f}), paint(kSea), at(-4.6, -0.6, 20.0))
        .object("stone", shapes::box({-0.35f, -0.05f, -0.35f}, {0.35f, 0.5f, 0.35f}), paint(kMoss),
                at(-0.7, -3.6, 30.0))
        .sun("sun", {-0.12f, -1.0f, -1.35f}, 3.0f)
        .camera("main", {0.0, 1.7, 1.2}, {0.0, 0.25, -2.6}, 55.0f)
        .camera("left", {-1.5, 1.5, 1.0}, {0.6, 0.2, -3.0}, 55.0f)
        .camera("top", {0.0, 5.0, 1.5}, {0.0, 0.0, -2.0}, 55.0f)
        .finish(0.6f);
}

Scene window() {
    // A room of 5 x 6 m, its walls 20 cm thick; the sun enters through an opening of 60 x 80 cm with a cross of
    // glazing bars.
    const glm::dmat4 eastWall = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(2.5, 0.0, 0.0)),
                                            glm::radians(90.0), glm::dvec3(0, 1, 0));
    Mesh bars = shapes::box({-0.31f, 1.59f, 0.08f}, {0.31f, 1.62f, 0.11f});
    shapes::append(bars, shapes::box({-0.015f, 1.19f, 0.07f}, {0.015f, 2.01f, 0.12f}));
    return SceneBuilder("window")
        .object("floor", shapes::floor(8.0f), kStraw)
        .object("east wall", shapes::wallWithOpening({-3.2f, -0.1f}, {3.2f, 2.8f}, {-0.3f, 1.2f}, {0.3f, 2.0f}, 0.2f),
                paint(kChalk), eastWall)
        .object("glazing bars", std::move(bars), paint(kSlate), eastWall)
        .object("west wall", shapes::box({-2.7f, -0.1f, -3.2f}, {-2.5f, 2.8f, 3.2f}), kChalk)
        .object("north wall", shapes::box({-2.6f, -0.11f, -3.2f}, {2.6f, 2.79f, -3.0f}), kSea)
        .object("south wall", shapes::box({-2.6f, -0.11f, 3.0f}, {2.6f, 2.79f, 3.2f}), kSea)
        .object("roof", shapes::box({-2.75f, 2.7f, -3.25f}, {2.75f, 2.9f, 3.25f}), kChalk)
        .object("table", shapes::box({-0.5f, 0.68f, -0.35f}, {0.5f, 0.72f, 0.35f}), kClay, {-0.3, 0.0, -0.9}, 15.0)
        .object("leg", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.06f, 0.7f), kClay, {-0.3, 0.0, -0.9})
        .sun("sun", {-1.0f, -0.72f, -0.3f}, 8.0f)
        .camera("main", {1.6, 1.6, 2.6}, {-0.6, 0.6, -0.9}, 60.0f)
        .camera("left", {-2.2, 1.7, 2.4}, {0.6, 0.7, -0.8}, 65.0f)
        .camera("top", {-1.2, 2.5, 1.6}, {0.1, 0.1, -0.6}, 70.0f)
        .finish(0.5f);
}

Scene penumbraRamp() {
    // A pole 3 cm thick and a ladder-like sign: with a light that is given a size, their shadows widen from the foot
    // on.
    Mesh sign;
    for (int i = 0; i < 5; ++i) {
        const float y = 0.5f + 0.4f * float(i);
        shapes::append(sign, shapes::box({-0.25f, y, -0.012f}, {0.25f, y + 0.05f, 0.012f}));
    }
    return SceneBuilder("penumbra-ramp")
        .object("floor", shapes::floor(9.0f), kStone)
        .object("pole", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.015f, 2.6f), kSlate, {1.3, 0.0, -0.3})
        .object("rungs", std::move(sign), kClay, {1.3, 0.0, -0.3}, -60.0)
        .object("thick pole", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.08f, 2.0f), kSea, {1.5, 0.0, -1.4})
        .sun("sun", {-1.0f, -0.85f, 0.4f}, 3.0f)
        .camera("main", {-0.4, 2.1, 3.2}, {-0.1, 0.35, -0.2})
        .camera("left", {-3.3, 1.4, 1.5}, {0.4, 0.4, -0.4})
        .camera("top", {-0.2, 4.8, 1.2}, {0.0, 0.0, 0.0})
        .finish(0.4f);
}

}  // namespace ombrage::builtin
