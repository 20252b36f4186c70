// SPDX-License-Identifier: MIT
#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

Scene menger() {
    return SceneBuilder("menger")
        .object("floor", shapes::floor(8.0f), kStone)
        .object("sponge", shapes::mengerSponge(3, 2.0f, 0.2f), kStraw, {0.0, 0.0, 0.0}, 30.0)
        .sun("sun", {-1.0f, -1.7f, 0.1f}, 3.0f)
        .camera("main", {2.4, 2.7, 3.8}, {-0.1, 1.0, 0.0})
        .camera("left", {-3.8, 1.6, 2.2}, {0.0, 1.0, 0.0})
        .camera("top", {0.9, 5.6, 2.0}, {-0.2, 0.7, -0.1})
        .finish(0.5f);
}

Scene cornell() {
    // A room of 2 m without its front wall. Walls are single planes that look inwards; the lamp hangs 5 cm under the
    // ceiling.
    return SceneBuilder("cornell")
        .object("floor", shapes::rectangle({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 8, 8), kChalk)
        .object("ceiling", shapes::rectangle({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, 8, 8), kChalk)
        .object("back wall", shapes::rectangle({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, 8, 8), kChalk)
        .object("left wall", shapes::rectangle({-1, 0, 1}, {0, 0, -2}, {0, 2, 0}, 8, 8), kRed)
        .object("right wall", shapes::rectangle({1, 0, -1}, {0, 0, 2}, {0, 2, 0}, 8, 8), kGreen)
        .object("tall box", shapes::box({-0.3f, -0.005f, -0.3f}, {0.3f, 1.2f, 0.3f}), kChalk, {-0.35, 0.0, -0.35}, 17.0)
        .object("short box", shapes::box({-0.3f, -0.005f, -0.3f}, {0.3f, 0.6f, 0.3f}), kChalk, {0.37, 0.0, 0.35}, -17.0)
        .point("lamp", {0.0, 1.95, 0.0}, 4.0f)
        .camera("main", {0.0, 1.0, 3.9}, {0.0, 1.0, 0.0}, 39.0f)
        .camera("left", {-0.85, 1.4, 1.6}, {0.3, 0.5, -0.3}, 60.0f)
        .camera("top", {0.75, 1.85, 0.9}, {-0.2, 0.3, -0.2}, 65.0f)
        .finish(0.25f);
}

Scene corner() {
    // The walls are so long and high that they are endless for an occlusion radius of half a metre.
    return SceneBuilder("corner")
        .object("floor", shapes::rectangle({0, 0, 10}, {10, 0, 0}, {0, 0, -10}, 8, 8), kStone)
        .object("back wall", shapes::rectangle({0, 0, 0}, {10, 0, 0}, {0, 6, 0}, 8, 8), kStraw)
        .object("left wall", shapes::rectangle({0, 0, 10}, {0, 0, -10}, {0, 6, 0}, 8, 8), kSea)
        .sun("sun", {-1.0f, -1.6f, -0.7f}, 3.0f)
        .camera("main", {2.6, 1.7, 3.0}, {0.3, 0.4, 0.3})
        .camera("left", {1.2, 1.0, 3.6}, {0.2, 0.5, 0.2})
        .camera("top", {1.8, 3.6, 1.8}, {0.4, 0.0, 0.4})
        .finish(0.5f);
}

Scene disk() {
    // Radius 0.4 m at 0.3 m: the rim is exactly the occlusion radius of 0.5 m away from the point below the centre.
    return SceneBuilder("disk")
        .object("floor", shapes::floor(5.0f), kStone)
        .object("disk", shapes::disk({0.0f, 0.3f, 0.0f}, 0.4f), kRed)
        .sun("sun", {-1.0f, -2.0f, -0.7f}, 3.0f)
        .camera("main", {0.7, 0.9, 1.6}, {-0.05, 0.1, 0.0})
        .camera("left", {-1.5, 0.35, 0.7}, {0.0, 0.12, 0.0})
        .camera("top", {0.0, 2.4, 0.8}, {0.0, 0.0, 0.0})
        .finish(0.5f);
}

}  // namespace ombrage::builtin
