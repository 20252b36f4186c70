// SPDX-License-Identifier: MIT
// Interiors, bumpy walls and many lamps.
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
Material heightMapped(const glm::vec3& color_srgb, int texture, float scale_uv) {
    Material material = paint(color_srgb);
    material.heightTexture = texture;
    material.heightScale_uv = scale_uv;
    return material;
}

/// A column with a square plinth and capital, its shaft in them by 1 cm.
Mesh column(float height) {
    Mesh mesh = shapes::box({-0.42f, -0.05f, -0.42f}, {0.42f, 0.35f, 0.42f});
    shapes::append(mesh, shapes::cylinder({0, 0.34f, 0}, 0.28f, height - 0.68f, 32));
    shapes::append(mesh, shapes::box({-0.4f, height - 0.35f, -0.4f}, {0.4f, height, 0.4f}));
    return mesh;
}
}  // namespace

Scene bumpy() {
    SceneBuilder builder("bumpy");
    constexpr float kScale_uv = 0.03f, kTileScale_uv = 0.02f;
    const int bricks = builder.texture(patterns::brickHeights());
    const int brickNormals = builder.texture(patterns::normalsOf(patterns::brickHeights(), kScale_uv));
    const int tiles = builder.texture(patterns::tileHeights());
    const int tileNormals = builder.texture(patterns::normalsOf(patterns::tileHeights(), kTileScale_uv));
    const auto mapped = [](glm::vec3 color, int heights, int normals, float scale_uv) {
        Material material = heightMapped(color, heights, scale_uv);
        material.normalTexture = normals;
        return material;
    };
    return builder
        .object("floor", shapes::rectangle({0, 0, 6}, {6, 0, 0}, {0, 0, -6}, 6, 6),
                mapped(kStone, tiles, tileNormals, kTileScale_uv), glm::dmat4(1.0))
        .object("back wall", shapes::rectangle({0, 0, 0}, {6, 0, 0}, {0, 3, 0}, 6, 3),
                mapped(kClay, bricks, brickNormals, kScale_uv), glm::dmat4(1.0))
        .object("left wall", shapes::rectangle({0, 0, 6}, {0, 0, -6}, {0, 3, 0}, 6, 3),
                mapped(kClay, bricks, brickNormals, kScale_uv), glm::dmat4(1.0))
        .object("pipe", shapes::cylinder({0, -0.01f, 0}, 0.06f, 2.6f), kSlate, {0.45, 0.0, 0.9})
        .object("crate", shapes::box({-0.35f, -0.01f, -0.35f}, {0.35f, 0.6f, 0.35f}), kStraw, {1.3, 0.0, 0.75}, 25.0)
        .point("lamp", {2.3, 2.1, 1.9}, 10.0f)
        .camera("main", {2.5, 1.5, 2.9}, {0.55, 0.75, 0.5}, 55.0f)
        .camera("left", {1.0, 1.2, 3.4}, {0.4, 0.8, 0.2}, 55.0f)
        .camera("top", {2.4, 3.2, 2.4}, {0.6, 0.3, 0.6}, 55.0f)
        .finish(0.4f);
}

Scene nave() {
    // 8 x 24 m and 7.5 m high; the walls look inwards. Two rows of six columns carry arches; a lamp hangs low between
    // them.
    SceneBuilder builder("nave");
    const int bricks = builder.texture(patterns::brickHeights());
    builder.object("walls", shapes::box({-4.0f, 0.0f, -20.0f}, {4.0f, 7.5f, 4.0f}, true),
                   heightMapped(kStone, bricks, 0.03f), glm::dmat4(1.0));
    constexpr float kHeight = 3.4f, kSpan = 3.2f;
    const auto place = [](double x, double z, double turn_deg) {
        return glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z)), glm::radians(turn_deg),
                           glm::dvec3(0, 1, 0));
    };
    builder.object("column 1", column(kHeight), paint(kChalk), place(-2.2, 0.0, 0.0));
    for (int i = 1; i < 12; ++i)
        builder.again("column " + std::to_string(i + 1), place(i % 2 ? 2.2 : -2.2, -double(kSpan) * (i / 2), 0.0));
    const auto archPlace = [&](int i) {
        // From column to column along the nave, 2 cm inside the capitals.
        return glm::translate(place(i % 2 ? 2.2 + 0.3 : -2.2 + 0.3, -double(kSpan) * (i / 2), 90.0),
                              glm::dvec3(0.0, kHeight - 0.02, -0.6));
    };
    builder.object("arch 1", shapes::arch(kSpan, 0.5f, 0.6f), paint(kStone), archPlace(0));
    for (int i = 1; i < 10; ++i) builder.again("arch " + std::to_string(i + 1), archPlace(i));
    return builder.object("bench", shapes::box({-0.9f, 0.4f, -0.2f}, {0.9f, 0.48f, 0.2f}), kClay, {0.0, 0.0, -5.5})
        .part("bench foot", shapes::box({-0.8f, -0.01f, -0.15f}, {-0.7f, 0.41f, 0.15f}), kClay, place(0.0, -5.5, 0.0))
        .part("bench foot 2", shapes::box({0.7f, -0.01f, -0.15f}, {0.8f, 0.41f, 0.15f}), kClay, place(0.0, -5.5, 0.0))
        .point("lamp", {0.15, 2.6, -3.4}, 45.0f)
        .point("candles", {0.0, 1.4, -17.5}, 25.0f)
        .camera("main", {0.5, 1.75, 3.4}, {-0.25, 1.9, -6.0}, 60.0f)
        .camera("left", {-3.4, 1.8, 1.8}, {1.2, 1.6, -5.0}, 60.0f)
        .camera("top", {0.6, 6.6, 3.2}, {0.0, 1.0, -6.0}, 60.0f)
        .finish(0.5f);
}

Scene manyLights() {
    SceneBuilder builder("many-lights");
    builder.object("floor", shapes::floor(18.0f, 0.0f, 12), kStone);
    // Blocks and columns on a grid of 1.9 m, their heights from whole numbers.
    for (int i = 0; i < 36; ++i) {
        const float height = 0.5f + 1.3f * patterns::noise(std::uint32_t(i), 5u);
        const glm::dvec3 place(-4.75 + 1.9 * (i % 6), 0.0, -4.75 + 1.9 * double(i / 6));
        if (i % 3)
            builder.object("block " + std::to_string(i + 1), shapes::box({-0.3f, -0.01f, -0.3f}, {0.3f, height, 0.3f}),
                           kChalk, place, 20.0 * i);
        else
            builder.object("column " + std::to_string(i + 1),
                           shapes::cylinder({0, -0.01f, 0}, 0.25f, height + 0.4f, 24), kStraw, place);
    }
    // 32 lamps between them in eight colours, none reaching farther than 5 m.
    for (int i = 0; i < 32; ++i) {
        const double x = -5.7 + 1.9 * (i % 6) + 0.95 * ((i / 6) % 2), z = -5.7 + 1.9 * double(i / 6);
        builder.point("lamp " + std::to_string(i + 1),
                      {x, 1.5 + 0.9 * double(patterns::noise(std::uint32_t(i), 9u)), z}, 3.0f);
    }
    Scene scene = builder.camera("main", {3.4, 4.6, 9.4}, {-0.2, 0.2, 0.4}, 50.0f)
                      .camera("left", {-8.5, 3.4, 5.0}, {0.0, 0.3, 0.0})
                      .camera("top", {0.0, 12.0, 3.0}, {0.0, 0.0, 0.0})
                      .finish(0.5f);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const float hue = float(i % 8) / 8.0f * 6.2831853f;
        scene.lights[i].color = glm::vec3(0.62f + 0.38f * std::cos(hue), 0.62f + 0.38f * std::cos(hue - 2.0944f),
                                          0.62f + 0.38f * std::cos(hue + 2.0944f));
        scene.lights[i].range_m = 5.0f;
    }
    scene.ambient = 0.05f;
    return scene;
}

}  // namespace ombrage::builtin
