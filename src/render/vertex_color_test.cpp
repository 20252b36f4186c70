// SPDX-License-Identifier: MIT
#include <ombrage/image.h>

#include "render_fixture.h"

namespace ombrage {
namespace {

class VertexColorTest : public RenderTest {};

TEST_F(VertexColorTest, MultiplyTheBaseColor) {
    // A wall whose left side is red and whose right side is green, in front of an uncoloured grey one.
    Scene scene = hand::wallScene(hand::matte(glm::vec3(0.5f)));
    scene.meshes[0].colors = {{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}};
    hand::add(scene, hand::wall(), hand::matte(glm::vec3(0.25f)), hand::moved({0, 1.2, 0.1}));
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.show = {"albedo"};
    const Image albedo = toLinear(render(scene, settings).shown.at("albedo"));
    const auto at = [&](int x, int y) { return glm::vec3(albedo.at(0, x, y), albedo.at(1, x, y), albedo.at(2, x, y)); };
    // 32 pixels show 1.6 m of the 2 m wide wall: the colour at a pixel's centre is a straight line between both sides.
    for (const int x : {0, 8, 16, 31}) {
        const float green = 0.5f + ((float(x) + 0.5f) / 32.0f - 0.5f) * 0.8f;
        // The G-buffer keeps 8 bits of sRGB: half a step is at most 0.005 in linear light.
        EXPECT_NEAR(glm::length(at(x, 28) - 0.5f * glm::vec3(1.0f - green, green, 0.0f)), 0.0f, 0.006f) << x;
        EXPECT_NEAR(glm::length(at(x, 2) - glm::vec3(0.25f)), 0.0f, 0.006f) << x;
    }
}

}  // namespace
}  // namespace ombrage
