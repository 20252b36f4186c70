// SPDX-License-Identifier: MIT
// Casters that touch, nearly touch, or hold the light.
#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

Scene thinWall() {
    // A shelter of boards 1 cm thick, open in front; the sun comes over its back. Boards overlap by 5 mm, so that no
    // faces coincide.
    Mesh shelter;
    for (const Mesh& board : {shapes::box({-1.5f, -0.01f, -1.0f}, {1.5f, 2.005f, -0.99f}),
                              shapes::box({-1.51f, -0.01f, -1.005f}, {-1.5f, 2.005f, 0.8f}),
                              shapes::box({1.5f, -0.01f, -1.005f}, {1.51f, 2.005f, 0.8f}),
                              shapes::box({-1.6f, 2.0f, -1.1f}, {1.6f, 2.01f, 0.9f})})
        shapes::append(shelter, board);
    return SceneBuilder("thin-wall")
        .object("floor", shapes::floor(9.0f), kStone)
        .object("shelter", std::move(shelter), kClay)
        .object("crate", shapes::box({-0.3f, -0.005f, -0.3f}, {0.3f, 0.5f, 0.3f}), kStraw, {-0.7, 0.0, -0.4}, 25.0)
        .sun("sun", {0.9f, -1.0f, 0.55f}, 3.0f)
        .camera("main", {-1.6, 1.7, 3.1}, {0.35, 0.75, -0.4})
        .camera("left", {-0.4, 1.3, 2.2}, {1.2, 0.5, -0.6})
        .camera("top", {0.6, 4.6, 4.2}, {0.2, 0.3, 0.2})
        .finish(0.4f);
}

Scene resting() {
    // Every foot lies exactly in the plane of what it stands on.
    return SceneBuilder("resting")
        .object("floor", shapes::floor(6.0f), kStone)
        .object("block", shapes::box({-0.5f, 0.0f, -0.5f}, {0.5f, 0.7f, 0.5f}), kSea, {0.0, 0.0, 0.0}, 20.0)
        .object("block on top", shapes::box({-0.25f, 0.7f, -0.25f}, {0.25f, 1.1f, 0.25f}), kClay, {0.05, 0.0, 0.05},
                50.0)
        .object("drum", shapes::cylinder({0.0f, 0.0f, 0.0f}, 0.3f, 0.45f), kStraw, {-1.1, 0.0, 0.5})
        .object("ball", shapes::sphere({0.0f, 0.22f, 0.0f}, 0.22f, 48, 24), kMoss, {0.75, 0.0, 0.95})
        .sun("sun", {-0.8f, -1.5f, 0.7f}, 3.0f)
        .camera("main", {-1.5, 1.6, 3.1}, {-0.2, 0.3, 0.3}, 45.0f)
        .camera("left", {-3.0, 0.9, 1.6}, {0.0, 0.35, 0.2})
        .camera("top", {-0.5, 4.2, 1.4}, {-0.2, 0.0, 0.2})
        .finish(0.4f);
}

Scene farOrigin() {
    // 4 km east and 3 km south of the origin a 32-bit world coordinate has steps of 0.24 mm, a quarter of the gap
    // under the crate.
    const glm::dvec3 place(4000.0, 0.0, 3000.0);
    return SceneBuilder("far-origin")
        .object("floor", shapes::floor(8.0f), kStone, place)
        .object("crate", shapes::box({-0.5f, 0.001f, -0.5f}, {0.5f, 0.901f, 0.5f}), kSea,
                place + glm::dvec3(0.2, 0.0, -0.3), 25.0)
        .object("ball", shapes::sphere({0.0f, 0.401f, 0.0f}, 0.4f), kClay, place + glm::dvec3(-1.2, 0.0, 0.3))
        .object("pole", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.03f, 1.8f), kStraw, place + glm::dvec3(1.2, 0.0, 0.4))
        .sun("sun", {-0.9f, -1.5f, 0.8f}, 3.0f)
        .point("lamp", place + glm::dvec3(1.5, 3.0, 2.0), 12.0f)
        .camera("main", place + glm::dvec3(-0.6, 1.9, 3.6), place + glm::dvec3(-0.1, 0.3, 0.2))
        .camera("left", place + glm::dvec3(-3.2, 1.2, 1.8), place + glm::dvec3(0.0, 0.3, 0.0))
        .camera("top", place + glm::dvec3(-0.4, 5.0, 1.6), place + glm::dvec3(-0.1, 0.0, 0.3))
        .finish(0.4f);
}

Scene touching() {
    // The lamp burns inside a lantern of bars; the spark lies 1 mm above the plinth's top, beside the ball.
    Mesh lantern;
    for (int i = 0; i < 8; ++i) {
        const double angle_rad = 2.0 * 3.14159265358979323846 * i / 8.0;
        const float x = 0.2f * float(std::cos(angle_rad)), z = 0.2f * float(std::sin(angle_rad));
        shapes::append(lantern, shapes::tube({x, 0.58f, z}, {x, 1.12f, z}, 0.014f, 0.014f, 10));
    }
    shapes::append(lantern, shapes::cylinder({0.0f, 0.55f, 0.0f}, 0.24f, 0.04f, 48));
    shapes::append(lantern, shapes::cylinder({0.0f, 1.1f, 0.0f}, 0.24f, 0.04f, 48));
    return SceneBuilder("touching")
        .object("floor", shapes::floor(8.0f), kStone)
        .object("back wall", shapes::rectangle({-4, 0, -1.8f}, {8, 0, 0}, {0, 3, 0}, 8, 4), kChalk)
        .object("lantern", std::move(lantern), kSlate)
        .object("foot", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.1f, 0.57f), kSlate)
        .object("plinth", shapes::box({-0.5f, -0.01f, -0.5f}, {0.5f, 0.35f, 0.5f}), kClay, {1.5, 0.0, 0.1}, 20.0)
        .object("ball", shapes::sphere({0.0f, 0.5f, 0.0f}, 0.15f, 48, 24), kSea, {1.65, 0.0, -0.1})
        .object("crate", shapes::box({-0.3f, -0.01f, -0.3f}, {0.3f, 0.55f, 0.3f}), kStraw, {-1.3, 0.0, -0.3}, 35.0)
        .point("lamp", {0.03, 0.85, 0.02}, 6.0f)
        .point("spark", {1.35, 0.351, 0.1}, 1.5f)
        .camera("main", {0.7, 1.9, 3.7}, {0.1, 0.5, -0.2})
        .camera("left", {-2.6, 1.3, 2.4}, {0.2, 0.5, -0.2})
        .camera("top", {0.3, 4.2, 2.6}, {0.2, 0.2, -0.1})
        .finish(0.4f);
}

Scene headLamp() {
    // The lamp is worn on the forehead, 10 cm above the main camera's eye: all shadows hide behind their casters but
    // for a rim.
    SceneBuilder builder("head-lamp");
    builder.object("floor", shapes::floor(16.0f), kStone)
        .object("back wall", shapes::rectangle({-8, 0, -6}, {16, 0, 0}, {0, 5, 0}, 8, 4), kChalk);
    const struct {
        float x, z, radius;
    } trunks[] = {{-1.7f, -0.2f, 0.16f}, {-0.6f, -2.4f, 0.2f},  {0.55f, -0.6f, 0.13f},
                  {1.5f, -2.0f, 0.22f},  {-2.6f, -3.2f, 0.24f}, {2.9f, -3.6f, 0.26f}};
    for (std::size_t i = 0; i < std::size(trunks); ++i)
        builder.object("trunk " + std::to_string(i + 1),
                       shapes::cylinder({0.0f, -0.01f, 0.0f}, trunks[i].radius, 3.4f + 0.2f * float(i % 3)), kClay,
                       {trunks[i].x, 0.0, trunks[i].z});
    return builder
        .object("crate", shapes::box({-0.4f, -0.01f, -0.4f}, {0.4f, 0.6f, 0.4f}), kSea, {-0.4, 0.0, 0.4}, 25.0)
        .object("ball", shapes::sphere({0.0f, 0.35f, 0.0f}, 0.35f, 48, 24), kStraw, {1.4, 0.0, 0.3})
        .spot("lamp", {0.0, 1.75, 3.0}, {0.0f, -0.12f, -1.0f}, 34.0f, 48.0f, 60.0f)
        .camera("main", {0.0, 1.65, 3.0}, {0.0, 1.15, -1.2}, 55.0f)
        .camera("left", {-3.0, 2.2, 2.4}, {0.0, 0.8, -1.6}, 55.0f)
        .camera("top", {0.0, 6.0, 3.4}, {0.0, 0.4, -1.6}, 60.0f)
        .finish(0.5f);
}

}  // namespace ombrage::builtin
