// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/ambient_measure.h"
#include "techniques/ao/depth-maps/directions.h"
#include "techniques/corner_picture.h"

namespace ombrage::test {
namespace {

bool hasPass(const RenderResult& result, const std::string& name) {
    return std::any_of(result.passes.begin(), result.passes.end(),
                       [&](const PassCost& pass) { return pass.name == name; });
}

TEST(DepthMapDirections, CoverTheSphereEvenly) {
    for (const int count : {8, 64, 256, 1024}) {
        const auto directions = depth_maps::evenDirections(count);
        ASSERT_EQ(int(directions.size()), count);
        // A surface's cosines over the sphere are a quarter of all directions. Fibonacci points err by some 1 / count
        // where the integrand bends; 3 / count leaves out any set with a gap.
        for (const glm::vec3& n : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::normalize(glm::vec3(-1, 2, 3))}) {
            double sum = 0;
            for (const glm::vec3& l : directions) {
                EXPECT_NEAR(glm::length(l), 1, 1e-6);
                sum += std::max(0.0, double(glm::dot(n, l)));
            }
            EXPECT_NEAR(sum / count, 0.25, 3.0 / count) << count;
        }
        // None is much nearer to another than squares of its share of the sphere are to each other.
        float nearest = 2;
        for (std::size_t i = 0; i < directions.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                nearest = std::min(nearest, glm::distance(directions[i], directions[k]));
        EXPECT_GE(nearest, 0.7f * std::sqrt(4 * 3.1415927f / float(count))) << count;
    }
}

TEST(DepthMaps, AWallHasItsClosedForm) {
    // Texels of up to half a metre: the first metre in front of the wall is left out. 1024 directions leave 0.01; the
    // wall ends after 100 m, which at 30 m lets in less than that.
    const CornerPicture picture(20, 100);
    const std::vector<float> row = picture.row("ao/depth-maps:maps=1024,resolution=512");
    for (std::size_t i = 1; i < row.size(); ++i)
        EXPECT_NEAR(row[i], CornerPicture::highWall(double(i) + 0.5, 20), 0.02) << i;
}

TEST(DepthMaps, AreKeptWhileTheSceneStandsStill) {
    const Scene scene = loadScene("cornell");
    Renderer renderer;
    renderer.setScene(scene);
    RenderSettings settings = AmbientMeasure::settings("ao/depth-maps:maps=16,resolution=64");
    EXPECT_TRUE(hasPass(renderer.render(settings), "depth maps"));
    settings.camera = "top";
    const RenderResult second = renderer.render(settings);
    EXPECT_FALSE(hasPass(second, "depth maps"));

    Scene moved = scene;
    moved.instances.back().worldFromLocal[3].x -= 0.2;
    renderer.moveScene(moved);
    const RenderResult third = renderer.render(settings);
    EXPECT_TRUE(hasPass(third, "depth maps"));
    EXPECT_NE(measuredPlane(third, Family::Ao), measuredPlane(second, Family::Ao));
    EXPECT_EQ(measuredPlane(third, Family::Ao), measuredPlane(renderScene(moved, settings), Family::Ao));
}

TEST(DepthMaps, WhatNothingIsOverIsOpen) {
    // A floor alone: no map may shade it, whatever its slope to the rays.
    Scene scene = emptyScene(64);
    addQuad(scene, {{-40, -40, 0}, {40, -40, 5}, {40, 40, 5}, {-40, 40, 0}}, 0.0f);
    RenderSettings settings = squareSettings(64);
    settings.ao = parsePipeline(Family::Ao, "ao/depth-maps:maps=64");
    const RenderResult result = renderFlat(scene, settings);
    for (const float v : result.ao->plane(0)) ASSERT_GE(v, 0.999f);
}

}  // namespace
}  // namespace ombrage::test
