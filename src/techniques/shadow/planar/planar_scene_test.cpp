// SPDX-License-Identifier: MIT
// Planes of any orientation, that meet and cross, against rays.
#include <algorithm>

#include <gtest/gtest.h>

#include "techniques/shadow/planar/wall_fixture.h"

namespace ombrage::test {
namespace {

/// Floors side by side in one plane, a slope and a wall that cross them and each other, a box through the floor and a
/// mirrored one on it, seen from aside; receivers come first.
Scene crossingPlanes() {
    Scene scene = emptyScene(kSize);
    const auto addBox = [&](const glm::vec3& lower, const glm::vec3& upper) {
        const auto corner = [&](int x, int y, int z) {
            return glm::vec3(x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z);
        };
        for (const int side : {0, 1}) {
            addQuad(scene, {corner(side, 0, 0), corner(side, 1, 0), corner(side, 1, 1), corner(side, 0, 1)}, 0.2f);
            addQuad(scene, {corner(0, side, 0), corner(1, side, 0), corner(1, side, 1), corner(0, side, 1)}, 0.2f);
            addQuad(scene, {corner(0, 0, side), corner(1, 0, side), corner(1, 1, side), corner(0, 1, side)}, 0.2f);
        }
    };
    addQuad(scene, {{-6, 0, 5}, {-0.5, 0, 5}, {-0.5, 0, -5}, {-6, 0, -5}}, 0.5f);
    addQuad(scene, {{0.5, 0, 5}, {6, 0, 5}, {6, 0, -5}, {0.5, 0, -5}}, 0.5f);
    addQuad(scene, {{-5, -1, 3}, {5, -1, 3}, {5, 3, -4}, {-5, 3, -4}}, 0.5f);
    addQuad(scene, {{-5, -1, -2}, {5, -1, -2}, {5, 4, -2}, {-5, 4, -2}}, 0.5f);
    addBox({-2.5f, -0.5f, 2.2f}, {-1.5f, 1.5f, 3.2f});
    addBox({1, 0, 3}, {2.5f, 0.75f, 4});
    addBox({-0.5f, 2.5f, 0.5f}, {1, 2.6f, 2});
    // The second box stands on its head, left and right changed, where it stood.
    for (std::size_t i = 10; i < 16; ++i) {
        glm::dmat4& place = scene.instances[i].worldFromLocal;
        place[0][0] = -1;
        place[3][0] = 3.5;
    }
    for (Model& model : scene.models) model.receives = false;
    for (std::size_t i = 0; i < 4; ++i) scene.models[i].receives = true;
    Camera& camera = scene.cameras[0];
    camera.position = {5, 6, 11};
    camera.target = {0, 0.5, 0};
    camera.orthoHeight_m.reset();
    Light& light = scene.lights[0];
    light.position = {2, 6, 7};
    light.direction = glm::normalize(glm::vec3(-0.3f, -1, -0.8f));
    light.intensity = 100;
    light.outer_rad = 1.0f;
    return scene;
}

/// Pixels of receivers, those that rays say are in shadow, and those that they answer otherwise.
struct Agreement {
    int asked = 0, shaded = 0, differing = 0;
};

Agreement agreementWithRays(const Scene& scene, const RenderResult& planar, RenderSettings settings) {
    settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced");
    const RenderResult rays = renderFlat(scene, settings);
    Agreement agreement;
    for (std::size_t i = 0; i < rays.instance.size(); ++i) {
        if (rays.instance[i] > 3) continue;
        const float a = planar.visibility.at(0).plane(0)[i], b = rays.visibility.at(0).plane(0)[i];
        ++agreement.asked;
        agreement.shaded += b < 0.5f ? 1 : 0;
        agreement.differing += std::abs(a - b) > 0.5f ? 1 : 0;
    }
    return agreement;
}

TEST(ShadowPlanar, CrossingAndCoplanarPlanesAgreeWithRays) {
    RenderSettings settings = squareSettings(256);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/planar");
    for (const LightType type : {LightType::Sun, LightType::Spot, LightType::Point})
        for (const bool isOrthographic : {false, true}) {
            Scene scene = crossingPlanes();
            scene.lights[0].type = type;
            if (isOrthographic) scene.cameras[0].orthoHeight_m = 9.0f;
            const Agreement agreement = agreementWithRays(scene, renderFlat(scene, settings), settings);
            EXPECT_GT(agreement.asked, 20000);
            EXPECT_GT(agreement.shaded, 900);
            // Pixels whose middle an edge passes through: fewer than one in a thousand.
            EXPECT_LE(agreement.differing, agreement.asked / 1000) << int(type) << " " << isOrthographic;
        }
}

TEST(ShadowPlanar, FollowsLightsCastersAndReceiversThatMove) {
    RenderSettings settings = squareSettings(256);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/planar");
    Scene start = crossingPlanes();
    start.lights[0].type = LightType::Point;
    Renderer renderer;
    renderer.setScene(start);
    renderer.render(settings);
    Scene light = start, caster = start, receiver = start;
    light.lights[0].position = {-3, 5, 6};
    for (std::size_t i = 4; i < 10; ++i) caster.instances[i].worldFromLocal[3] = {1, 0.5, -1, 1};
    receiver.instances[2].worldFromLocal[3] = {0, 0.7, 0, 1};
    for (const Scene* moved : {&light, &caster, &receiver, &start}) {
        renderer.moveScene(*moved);
        const RenderResult result = renderer.render(settings);
        const Agreement agreement = agreementWithRays(*moved, result, settings);
        EXPECT_GT(agreement.shaded, 900);
        EXPECT_LE(agreement.differing, agreement.asked / 1000);
    }
    // The floors come up to a plane that is given.
    settings.shadow = parsePipeline(Family::Shadow, "shadow/planar:receivers=given,offset=0.25");
    const auto shadedOn = [&](const Scene& scene) {
        renderer.moveScene(scene);
        const RenderResult result = renderer.render(settings);
        const auto plane = result.visibility.at(0).plane(0);
        return std::count(plane.begin(), plane.end(), 0.0f);
    };
    Scene raised = start;
    for (std::size_t i = 0; i < 2; ++i) raised.instances[i].worldFromLocal[3] = {0, 0.25, 0, 1};
    EXPECT_EQ(shadedOn(start), 0);
    EXPECT_GT(shadedOn(raised), 300);
    EXPECT_EQ(shadedOn(start), 0);
}

}  // namespace
}  // namespace ombrage::test
