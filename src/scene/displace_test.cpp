// SPDX-License-Identifier: MIT
#include <ombrage/displace.h>

#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "scene/scene_builder.h"
#include "scene/shapes.h"
#include "scene/texture_lookup.h"

namespace ombrage {
namespace {

constexpr int kTexels = 16;
constexpr float kScale_uv = 0.1f;

/// A floor of `side` metres on which the map shows `repeats` times a side: a wave along u.
Scene wavyFloor(float side, float repeats, int texels = kTexels) {
    Texture heights;
    heights.width = heights.height = texels;
    heights.srgb = false;
    for (int i = 0; i < texels * texels; ++i) {
        const double wave = 0.5 + 0.5 * std::sin(6.283185307 * (i % texels + 0.5) / texels);
        heights.rgba.insert(heights.rgba.end(), 4, std::uint8_t(std::lround(255 * wave)));
    }
    Mesh floor = shapes::rectangle({0, 0, 0}, {side, 0, 0}, {0, 0, -side});
    for (glm::vec2& uv : floor.uvs) uv *= repeats / side;
    SceneBuilder builder("wavy");
    Material material;
    material.heightTexture = material.normalTexture = builder.texture(heights);
    material.heightScale_uv = kScale_uv;
    return builder.object("floor", floor, material, glm::dmat4(1.0))
        .object("plain", shapes::box({0, 1, 0}, {1, 2, 1}), Material{}, glm::dmat4(1.0))
        .camera("main", {0, 2, 3}, {0, 0, 0}, 50.0f)
        .point("lamp", {0, 3, 0}, 10.0f)
        .finish(0.4f);
}

// Positions are floats of at most a few metres: 1e-6 m is 8 of their steps at 1 m.
constexpr float kRounding_m = 1e-6f;

TEST(Displace, MovesVerticesByTheHeightOverTheMean) {
    for (const float side : {1.0f, 2.0f}) {
        const Scene flat = wavyFloor(side, 1), made = displaced(flat);
        const Mesh& mesh = made.meshes[0];
        const Texture& heights = flat.textures[0];
        double mean = 0;
        for (std::size_t i = 0; i < heights.rgba.size(); i += 4) mean += heights.rgba[i] / 255.0;
        mean /= double(heights.rgba.size() / 4);
        float lowest = 0, highest = 0;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const float over = textureColor(heights, mesh.uvs[v]).r - float(mean);
            EXPECT_NEAR(mesh.positions[v].y, over * kScale_uv * side, kRounding_m);
            EXPECT_NEAR(mesh.positions[v].x, mesh.uvs[v].x * side, kRounding_m);
            lowest = std::min(lowest, mesh.positions[v].y);
            highest = std::max(highest, mesh.positions[v].y);
        }
        // The wave's crests lie between texels whose heights are cos(pi / 16) of its own.
        EXPECT_NEAR(highest - lowest, kScale_uv * side, 0.02f * kScale_uv * side);
        EXPECT_EQ(made.materials[std::size_t(mesh.material)].heightTexture, -1);
        EXPECT_EQ(made.materials[std::size_t(mesh.material)].normalTexture, -1);
    }
}

TEST(Displace, DividesWithoutGapsAndFinelyEnough) {
    const Mesh mesh = displaced(wavyFloor(1, 1.5f)).meshes[0];
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    double area = 0;
    float longest_texels = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.indices[t + k], b = mesh.indices[t + (k + 1) % 3];
            ++uses[{a, b}];
            longest_texels = std::max(longest_texels, glm::length(mesh.uvs[a] - mesh.uvs[b]) * kTexels);
        }
        const glm::vec2 a = mesh.uvs[mesh.indices[t]], u = mesh.uvs[mesh.indices[t + 1]] - a,
                        v = mesh.uvs[mesh.indices[t + 2]] - a;
        area += std::abs(double(u.x) * v.y - double(u.y) * v.x) / 2;
    }
    EXPECT_LE(longest_texels, 1.5f);
    EXPECT_NEAR(area, 1.5 * 1.5, 1e-5);
    // Every edge is met from the other side but for the rim's.
    int rim = 0;
    double rimLength = 0;
    for (const auto& [edge, count] : uses) {
        EXPECT_EQ(count, 1);
        if (uses.count({edge.second, edge.first})) continue;
        ++rim;
        rimLength += glm::length(mesh.uvs[edge.first] - mesh.uvs[edge.second]);
    }
    EXPECT_GT(rim, 0);
    EXPECT_NEAR(rimLength, 4 * 1.5, 1e-5);
}

TEST(Displace, LeavesWhatHasNoHeights) {
    const Scene flat = wavyFloor(1, 1), made = displaced(flat);
    EXPECT_EQ(made.meshes[1].positions, flat.meshes[1].positions);
    EXPECT_EQ(made.meshes[1].indices, flat.meshes[1].indices);
    ASSERT_EQ(made.instances.size(), flat.instances.size());
    Scene bare = flat;
    bare.materials[0].heightTexture = -1;
    EXPECT_EQ(contentHash(displaced(bare)), contentHash(bare));
}

TEST(Displace, TurnsNormalsWithTheSurface) {
    const Mesh mesh = displaced(wavyFloor(1, 1, 64)).meshes[0];
    // The wave's steepest slope is pi * kScale_uv * 2 / 2; chords of a 64-texel wave fall short of it by less than a
    // percent.
    float most = 0;
    for (const glm::vec3& n : mesh.normals) most = std::max(most, std::abs(n.x) / n.y);
    EXPECT_NEAR(most, 3.14159f * kScale_uv, 0.03f * 3.14159f * kScale_uv);
}

TEST(Displace, RefusesWhatIsTooFine) {
    try {
        displaced(wavyFloor(1, 300, 64));
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_NE(std::string(error.message()).find("wavy"), std::string::npos);
        EXPECT_FALSE(std::string(error.hint()).empty());
    }
}

TEST(Displace, RefusesLongLinesInTheMapThatHaveNoArea) {
    // Coordinates on a line have no area in the map, but edges of any number of texels.
    Scene scene = wavyFloor(1, 1);
    for (std::size_t v = 0; v < scene.meshes[0].uvs.size(); ++v) scene.meshes[0].uvs[v] = glm::vec2(float(v) * 10);
    EXPECT_THROW(displaced(scene, 10000), Error);
}

}  // namespace
}  // namespace ombrage
