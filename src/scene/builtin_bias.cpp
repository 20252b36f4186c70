// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

Scene planeGrazing() {
    // The sun travels along +x, 4 degrees below level; the box stands near the far end, so its 5.7 m shadow falls off
    // the floor.
    const double elevation_rad = 4.0 * 3.14159265358979323846 / 180.0;
    const glm::vec3 direction(float(std::cos(elevation_rad)), -float(std::sin(elevation_rad)), 0.0f);
    return SceneBuilder("plane-grazing")
        .object("floor", shapes::floor(20.0f, 0.0f, 16), kStone)
        .object("box", shapes::box({-0.2f, -0.01f, -0.2f}, {0.2f, 0.4f, 0.2f}), kClay, {6.5, 0.0, -3.0}, 25.0)
        .sun("sun", direction, 25.0f)
        .camera("main", {1.5, 2.2, 3.5}, {6.0, 0.0, -3.2})
        .camera("left", {8.5, 1.2, 3.0}, {5.5, 0.0, -4.0})
        .camera("top", {0.0, 16.0, 9.0}, {0.0, 0.0, 0.0})
        .finish(0.5f);
}

Scene gap() {
    return SceneBuilder("gap")
        .object("floor", shapes::floor(6.0f), kStone)
        .object("box", shapes::box({-0.5f, 0.001f, -0.5f}, {0.5f, 1.001f, 0.5f}), kSea, {0.0, 0.0, 0.0}, 20.0)
        .sun("sun", {-0.8f, -1.6f, 0.9f}, 3.0f)
        .camera("main", {-1.3, 1.5, 2.9}, {-0.1, 0.3, 0.1})
        .camera("left", {-2.6, 0.9, 1.4}, {0.0, 0.3, 0.0})
        .camera("top", {-0.6, 4.2, 0.9}, {-0.2, 0.0, -0.1})
        .finish(0.5f);
}

Scene sphere() {
    return SceneBuilder("sphere")
        .object("floor", shapes::floor(8.0f), kStone)
        .object("sphere", shapes::sphere({0.0f, 1.2f, 0.0f}, 1.0f), kClay)
        .sun("sun", {-1.0f, -1.2f, 0.35f}, 3.0f)
        .camera("main", {0.9, 1.9, 4.2}, {-0.3, 0.9, 0.0})
        .camera("left", {-3.6, 1.8, 2.0}, {-0.2, 0.9, 0.0})
        .camera("top", {-0.6, 5.6, 2.4}, {-0.5, 0.3, 0.2})
        .finish(0.5f);
}

Scene comb() {
    // The scene's 7 m across 1024 texels make texels of about 7 mm; a tooth is 2 mm wide and 10 mm deep, the
    // pitch 20 mm.
    constexpr int kTeeth = 120;
    constexpr float kPitch = 0.02f, kHalfWidth = 0.001f;
    Mesh teeth;
    for (int i = 0; i < kTeeth; ++i) {
        const float x = (float(i) - 0.5f * float(kTeeth - 1)) * kPitch;
        shapes::append(teeth, shapes::box({x - kHalfWidth, 0.05f, -0.005f}, {x + kHalfWidth, 0.8f, 0.005f}));
    }
    // The teeth end 10 mm above the lower face of the beam, inside it: no faces coincide.
    return SceneBuilder("comb")
        .object("floor", shapes::floor(5.0f), kStone)
        .object("teeth", std::move(teeth), kStraw)
        .object("beam", shapes::box({-1.25f, 0.79f, -0.05f}, {1.25f, 0.9f, 0.05f}), kSea)
        .sun("sun", {-0.35f, -1.0f, 0.8f}, 3.0f)
        .camera("main", {1.2, 1.3, 2.3}, {-0.15, 0.2, 0.2})
        .camera("left", {-2.1, 0.9, 1.2}, {-0.1, 0.2, 0.2})
        .camera("top", {0.0, 3.4, 1.3}, {-0.1, 0.0, 0.3})
        .finish(0.5f);
}

}  // namespace ombrage::builtin
