// SPDX-License-Identifier: MIT
#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

Scene inShadow() {
    // The roof hangs 3 m above the floor; every camera but `top` is in its shadow and looks out of it.
    return SceneBuilder("in-shadow")
        .object("floor", shapes::floor(16.0f), kStone)
        .object("roof", shapes::box({-3.0f, 3.0f, -3.0f}, {3.0f, 3.3f, 3.0f}), kClay)
        .object("block", shapes::box({-0.5f, -0.01f, -0.5f}, {0.5f, 1.0f, 0.5f}), kSea, {-1.2, 0.0, -2.4}, 30.0)
        .object("tower", shapes::box({-0.4f, -0.01f, -0.4f}, {0.4f, 2.2f, 0.4f}), kMoss, {2.4, 0.0, -4.2}, 10.0)
        .object("ball", shapes::sphere({0.0f, 0.7f, 0.0f}, 0.7f, 48, 24), kStraw, {-3.4, 0.0, -4.4})
        .object("column", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.25f, 2.4f), kPlum, {0.6, 0.0, -2.6})
        .sun("sun", {-0.5f, -2.0f, -0.35f}, 3.0f)
        .camera("main", {0.6, 1.6, 1.4}, {-0.4, 0.8, -4.0}, 60.0f)
        .camera("left", {-2.2, 1.5, 0.6}, {1.2, 0.7, -3.8}, 60.0f)
        .camera("top", {6.5, 7.5, 6.5}, {-0.6, 0.4, -1.2})
        .finish(0.5f);
}

Scene twoCasters() {
    // The lamp shines straight down, so both slabs are parallel to its map; their shadows overlap around x = 0.
    return SceneBuilder("two-casters")
        .object("floor", shapes::floor(8.0f), kStone)
        .object("high slab", shapes::box({-0.4f, 4.0f, -0.4f}, {0.4f, 4.05f, 0.4f}), kClay, {-0.25, 0.0, 0.0})
        .object("low slab", shapes::box({-0.8f, 0.5f, -0.8f}, {0.8f, 0.55f, 0.8f}), kSea, {0.3, 0.0, 0.2})
        .spot("lamp", {0.0, 6.0, 0.0}, {0.0f, -1.0f, 0.0f}, 25.0f, 32.0f, 110.0f)
        .camera("main", {3.2, 2.6, 4.4}, {-0.1, 0.4, 0.0})
        .camera("left", {-4.4, 1.8, 2.0}, {0.0, 0.3, 0.0})
        .camera("top", {-1.2, 3.4, -3.0}, {0.0, 0.0, 0.1})
        .finish(0.5f);
}

Scene room() {
    // The walls look inwards. Pillars reach through floor and ceiling, blocks a little into the floor.
    return SceneBuilder("room")
        .object("walls", shapes::box({-4.0f, 0.0f, -5.0f}, {4.0f, 3.0f, 5.0f}, true), kStone)
        .object("pillar a", shapes::cylinder({0.0f, -0.1f, 0.0f}, 0.22f, 3.2f), kClay, {-2.0, 0.0, -2.2})
        .object("pillar b", shapes::cylinder({0.0f, -0.1f, 0.0f}, 0.22f, 3.2f), kClay, {2.0, 0.0, -2.2})
        .object("pillar c", shapes::box({-0.2f, -0.1f, -0.2f}, {0.2f, 3.1f, 0.2f}), kSea, {-2.0, 0.0, 2.0}, 15.0)
        .object("pillar d", shapes::box({-0.2f, -0.1f, -0.2f}, {0.2f, 3.1f, 0.2f}), kSea, {2.0, 0.0, 2.0}, -20.0)
        .object("table", shapes::box({-0.8f, 0.7f, -0.4f}, {0.8f, 0.78f, 0.4f}), kStraw, {0.0, 0.0, -0.6}, 12.0)
        .object("crate", shapes::box({-0.35f, -0.01f, -0.35f}, {0.35f, 0.7f, 0.35f}), kMoss, {1.2, 0.0, -3.4}, 35.0)
        .object("ball", shapes::sphere({0.0f, 0.4f, 0.0f}, 0.4f, 48, 24), kPlum, {-0.9, 0.05, -2.6})
        .object("chest", shapes::box({-0.5f, -0.01f, -0.3f}, {0.5f, 0.5f, 0.3f}), kMoss, {-1.0, 0.0, 2.6}, -10.0)
        .point("lamp", {0.1, 1.9, 0.05}, 12.0f)
        .camera("main", {0.4, 1.65, 4.6}, {-0.1, 1.1, -1.5}, 65.0f)
        .camera("left", {-3.7, 1.8, -0.2}, {1.0, 0.9, -1.6}, 65.0f)
        .camera("top", {3.6, 2.8, 3.2}, {-0.6, 0.3, -1.4}, 65.0f)
        .finish(0.5f);
}

Scene openMesh() {
    Scene scene =
        SceneBuilder("open-mesh")
            .object("floor", shapes::floor(7.0f), kStone)
            .object("half tube", shapes::halfTube({0.0f, 0.05f, 0.0f}, 0.8f, 2.0f), kClay, {-0.9, 0.0, -0.3}, 25.0)
            .object("bowl", shapes::bowl({0.0f, 0.75f, 0.0f}, 0.6f), kSea, {1.2, 0.0, 0.4})
            .sun("sun", {-0.9f, -1.6f, 0.6f}, 3.0f)
            .camera("main", {1.6, 2.0, 4.0}, {-0.1, 0.4, 0.0})
            .camera("left", {-3.6, 1.4, 2.6}, {-0.1, 0.4, 0.0})
            .camera("top", {0.4, 4.8, 1.6}, {-0.1, 0.2, 0.0})
            .finish(0.5f);
    // Who culls faces loses shadows here, which the truth has.
    for (Material& material : scene.materials) material.doubleSided = false;
    return scene;
}

Scene areaOverlap() {
    // Two boards at different heights under a lamp of 0.6 m: their penumbrae overlap on the floor.
    Scene scene =
        SceneBuilder("area-overlap")
            .object("floor", shapes::floor(8.0f), kStone)
            .object("high board", shapes::box({-0.55f, 1.6f, -0.5f}, {0.55f, 1.65f, 0.5f}), kClay, {-0.35, 0.0, 0.0})
            .object("low board", shapes::box({-0.4f, 0.7f, -0.5f}, {0.4f, 0.75f, 0.5f}), kSea, {0.5, 0.0, -0.2})
            .point("lamp", {0.3, 4.0, 0.1}, 40.0f)
            .camera("main", {2.6, 2.4, 3.8}, {0.0, 0.4, 0.0})
            .camera("left", {-3.6, 1.8, 2.0}, {0.0, 0.3, 0.0})
            .camera("top", {-1.2, 3.4, -3.0}, {0.0, 0.0, 0.1})
            .finish(0.5f);
    scene.lights[0].radius_m = 0.3f;
    return scene;
}

Scene penumbrae() {
    // Casters far enough from one another that their penumbrae do not meet: a box on the floor, a ball and a leaning
    // board in the air, a thin pole. One light of each kind, each with a size.
    Scene scene =
        SceneBuilder("penumbrae")
            .object("floor", shapes::floor(9.0f), kStone)
            .object("box", shapes::box({-0.35f, 0.0f, -0.35f}, {0.35f, 0.7f, 0.35f}), kSea, {-1.5, 0.0, 0.5}, 25.0)
            .object("ball", shapes::sphere({0.0f, 0.8f, 0.0f}, 0.35f, 64, 32), kClay, {-0.2, 0.0, -1.1})
            .object("board", shapes::box({-0.4f, 0.9f, -0.3f}, {0.4f, 0.94f, 0.3f}), kMoss, {1.5, 0.0, 0.1}, -20.0)
            .object("pole", shapes::cylinder({0.0f, -0.01f, 0.0f}, 0.04f, 1.1f), kSlate, {0.2, 0.0, 1.0})
            .point("lamp", {0.4, 4.2, 0.8}, 45.0f)
            .sun("sun", {-0.45f, -1.5f, -0.5f}, 3.0f)
            .spot("spot", {-0.6, 4.0, 1.4}, {0.15f, -1.0f, -0.35f}, 32.0f, 40.0f, 45.0f)
            .point("panel", {0.5, 3.8, -0.6}, 45.0f)
            .camera("main", {2.2, 2.7, 4.2}, {0.0, 0.2, -0.3})
            .camera("left", {-3.9, 1.7, 2.4}, {-0.2, 0.3, -0.3})
            .camera("top", {-0.8, 5.0, -2.2}, {0.0, 0.0, -0.1})
            .finish(0.5f);
    scene.lights[0].radius_m = 0.2f;
    scene.lights[1].angle_rad = 0.08f;
    scene.lights[2].radius_m = 0.25f;
    Light& panel = scene.lights[3];
    panel.type = LightType::Rect;
    panel.size_m = {0.8f, 0.3f};
    panel.intensity = 45.0f / (panel.size_m.x * panel.size_m.y);
    panel.direction = glm::normalize(glm::vec3(-0.1f, -1.0f, 0.1f));
    return scene;
}

}  // namespace ombrage::builtin
