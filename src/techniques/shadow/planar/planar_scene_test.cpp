// SPDX-License-Identifier: MIT
// Planes of any orientation, that meet and cross, against rays.
#include <algorithm>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

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

Agreement agreementWithRays(const Scene& scene, const RenderResult& planar, RenderSettings settings,
                            int receivers = 4) {
    settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced");
    const RenderResult rays = renderFlat(scene, settings);
    Agreement agreement;
    for (std::size_t i = 0; i < rays.instance.size(); ++i) {
        if (int(rays.instance[i]) >= receivers) continue;
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

// The slope and the wall are planes 2 and 3.
TEST(ShadowPlanar, PlanesThatAreLeftOutHaveNoShadow) {
    Scene scene = crossingPlanes();
    scene.lights[0].type = LightType::Point;
    RenderSettings settings = squareSettings(256);
    const auto rendered = [&](const char* technique) {
        settings.shadow = parsePipeline(Family::Shadow, technique);
        return renderFlat(scene, settings);
    };
    const RenderResult all = rendered("shadow/planar"), floors = rendered("shadow/planar:planes=1");
    int onFloors = 0, beyond = 0;
    for (std::size_t i = 0; i < all.instance.size(); ++i) {
        const float a = all.visibility.at(0).plane(0)[i], b = floors.visibility.at(0).plane(0)[i];
        const bool isFloor = all.instance[i] < 2;
        onFloors += isFloor && a < 0.5f ? 1 : 0;
        beyond += !isFloor && a < 0.5f ? 1 : 0;
        ASSERT_EQ(b, isFloor ? a : 1.0f) << i << " of instance " << all.instance[i];
    }
    EXPECT_GT(onFloors, 300);
    EXPECT_GT(beyond, 300);
}

/// A closed room, x and z from -3 to 3, y from 0 to 3, with a board in it; floor and walls come first. The ceiling and
/// the wall at x = 3 receive nothing: a lamp in them grazes them, and rays see rounding.
Scene roomWithBoard() {
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}, 0.5f);
    addQuad(scene, {{-3, 3, -3}, {3, 3, -3}, {3, 3, 3}, {-3, 3, 3}}, 0.5f);
    addQuad(scene, {{-3, 0, -3}, {3, 0, -3}, {3, 3, -3}, {-3, 3, -3}}, 0.5f);
    addQuad(scene, {{3, 0, 3}, {-3, 0, 3}, {-3, 3, 3}, {3, 3, 3}}, 0.5f);
    addQuad(scene, {{-3, 0, 3}, {-3, 0, -3}, {-3, 3, -3}, {-3, 3, 3}}, 0.5f);
    addQuad(scene, {{3, 0, -3}, {3, 0, 3}, {3, 3, 3}, {3, 3, -3}}, 0.5f);
    addQuad(scene, {{-1, 0.8f, -0.5f}, {0.5f, 0.8f, -0.5f}, {0.5f, 1.6f, 0.5f}, {-1, 1.6f, 0.5f}}, 0.2f);
    for (const std::size_t i : {1, 5, 6}) scene.models[i].receives = false;
    Camera& camera = scene.cameras[0];
    camera.position = {2.5, 1.5, 2.5};
    camera.target = {-0.5, 1.5, -0.5};
    camera.orthoHeight_m.reset();
    camera.fovY_rad = 1.5f;
    scene.lights[0].type = LightType::Point;
    scene.lights[0].intensity = 100;
    return scene;
}

// Flattened, the ceiling or wall that a lamp lies in is a line that reaches to infinity; turned, nothing of it is
// exact. Rays go to 20 um inside of the room, for the lamp itself may be rounded to without.
TEST(ShadowPlanar, CastersInWhosePlaneALampLiesThrowNoShadow) {
    RenderSettings settings = squareSettings(256);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/planar");
    // In the ceiling, on its diagonal, in a wall, in both, and just within: more than the tolerance.
    for (const glm::dvec3& place : {glm::dvec3(0.4, 3, 0.6), glm::dvec3(0.6, 3, 0.6), glm::dvec3(3, 2.5, 0.6),
                                    glm::dvec3(3, 3, 0.5), glm::dvec3(0.4, 2.99999, 0.6)})
        for (const double turn_rad : {0.0, 0.4, 1.1}) {
            Scene scene = roomWithBoard();
            const glm::dmat4 turned = glm::rotate(glm::dmat4(1), turn_rad, glm::normalize(glm::dvec3(1, 2, 3)));
            const auto turn = [&](const glm::dvec3& p) { return glm::dvec3(turned * glm::dvec4(p, 1)); };
            for (Instance& instance : scene.instances) instance.worldFromLocal = turned;
            scene.lights[0].position = turn(place);
            Camera& camera = scene.cameras[0];
            camera.position = turn(camera.position);
            camera.target = turn(camera.target);
            const RenderResult planar = renderFlat(scene, settings);
            scene.lights[0].position = turn(glm::min(place, glm::dvec3(3 - 2e-5)));
            const Agreement agreement = agreementWithRays(scene, planar, settings, 6);
            EXPECT_GT(agreement.shaded, 500);
            // Pixels whose middle an edge passes through.
            EXPECT_LE(agreement.differing, agreement.asked / 2000) << place.x << " " << place.y << " " << turn_rad;
        }
}

TEST(ShadowPlanar, WarnsOfAGivenPlaneThatNoSurfaceLiesIn) {
    RenderSettings settings = squareSettings(kSize);
    const auto warningsOf = [&](const char* technique) {
        settings.shadow = parsePipeline(Family::Shadow, technique);
        return renderFlat(crossingPlanes(), settings).warnings;
    };
    EXPECT_TRUE(warningsOf("shadow/planar:receivers=given").empty());
    const std::vector<std::string> warnings = warningsOf("shadow/planar:receivers=given,normal=(0;0.5;0),offset=1000");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("normal=(0;0.5;0),offset=1000"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace ombrage::test
