// SPDX-License-Identifier: MIT
#include "lab/motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

Scene posed(const Scene& start, const std::string& motion, int frame, int light = 0) {
    Scene scene = start;
    const Motion parsed = parseMotion(motion);
    const Caster caster = parsed.movesCaster() ? chosenCaster(start, parsed.caster) : Caster{};
    poseScene(scene, start, parsed, 0, light, caster, frame);
    return scene;
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::min(glm::dot(glm::normalize(a), glm::normalize(b)), 1.0));
}

/// Directions are floats.
constexpr double kFloat = 1e-6;

TEST(MotionScripts, HaveTheirNamesAndGoBothWays) {
    std::vector<std::string> names;
    for (const MotionScript& script : motionScripts()) {
        names.push_back(script.name);
        EXPECT_EQ(toString(parseMotion(script.name)), script.name);
        EXPECT_LT(script.jumpAt, script.frames);
        EXPECT_FALSE(script.description.empty());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"camera-walk", "camera-turn", "sun-arc", "caster-move", "caster-jump",
                                               "light-jump"}));
    EXPECT_EQ(toString(parseMotion("caster-jump:a box")), "caster-jump:a box");
    EXPECT_EQ(parseMotions("sun-arc, caster-move:x").size(), 2u);
    for (const char* wrong : {"", "camera-wlak", "camera-walk:box", "caster-move:", "sun-arc,,light-jump"})
        EXPECT_THROW(parseMotions(wrong), Error) << wrong;
}

TEST(MotionScripts, EveryOneChangesTheSceneAndStartsFromIt) {
    const Scene start = loadScene("gap");
    for (const MotionScript& script : motionScripts()) {
        const std::string hash = contentHash(posed(start, script.name, 0));
        EXPECT_EQ(hash, contentHash(start)) << script.name;
        EXPECT_NE(contentHash(posed(start, script.name, script.frames - 1)), hash) << script.name;
        if (script.jumpAt == 0) continue;
        EXPECT_EQ(contentHash(posed(start, script.name, script.jumpAt - 1)), hash) << script.name;
        EXPECT_EQ(contentHash(posed(start, script.name, script.jumpAt)),
                  contentHash(posed(start, script.name, script.frames - 1)));
    }
}

TEST(MotionScripts, CamerasWalkLevelAndTurnInPlace) {
    const Scene start = loadScene("gap");
    const Camera& from = start.cameras[0];
    const Camera walked = posed(start, "camera-walk", 10).cameras[0];
    const glm::dvec3 step = walked.position - from.position;
    EXPECT_NEAR(glm::length(step), 10 * 0.0007 * start.bounds().diagonal(), 1e-12);
    EXPECT_EQ(step.y, 0.0);
    EXPECT_GT(glm::dot(step, from.target - from.position), 0.0);
    EXPECT_NEAR(glm::length(walked.target - from.target - step), 0.0, 1e-12);

    const Camera turned = posed(start, "camera-turn", 10).cameras[0];
    EXPECT_EQ(turned.position, from.position);
    const auto heading = [](const Camera& c) {
        return glm::dvec3(c.target.x - c.position.x, 0, c.target.z - c.position.z);
    };
    EXPECT_NEAR(angleBetween(heading(from), heading(turned)), 3 * kDegree, 1e-9);
    EXPECT_GT(glm::cross(heading(from), heading(turned)).y, 0.0) << "to the left";
    EXPECT_NEAR(turned.target.y, from.target.y, 1e-12);
}

TEST(MotionScripts, SunsClimbAndLampsGoSideways) {
    Scene start = loadScene("gap");
    start.lights[0].type = LightType::Sun;
    start.lights[0].direction = glm::normalize(glm::vec3(1, -1, 0.5f));
    const glm::dvec3 from(start.lights[0].direction), to(posed(start, "light-jump", 5).lights[0].direction);
    EXPECT_NEAR(angleBetween(from, to), 5 * kDegree, kFloat);
    EXPECT_LT(to.y, from.y) << "a higher sun shines more steeply";
    EXPECT_NEAR(to.z / to.x, 0.5, kFloat) << "the azimuth stays";

    start.lights[0].type = LightType::Point;
    start.lights[0].position = start.bounds().center() + glm::dvec3(1, 2, 0);
    const glm::dvec3 step = posed(start, "light-jump", 5).lights[0].position - start.lights[0].position;
    EXPECT_NEAR(glm::length(step), 0.03 * start.bounds().diagonal(), 1e-12);
    EXPECT_NEAR(step.x, 0.0, 1e-12);
    EXPECT_NEAR(step.y, 0.0, 1e-12);
    // Right above the middle no way is across: along +X.
    start.lights[0].position = start.bounds().center() + glm::dvec3(0, 2, 0);
    EXPECT_GT(posed(start, "light-jump", 5).lights[0].position.x, start.lights[0].position.x);
}

TEST(MotionScripts, CastersGoAcrossTheLight) {
    Scene start = loadScene("gap");
    start.lights[0].type = LightType::Sun;
    start.lights[0].direction = glm::normalize(glm::vec3(1, -1, 0));
    const Caster caster = chosenCaster(start, "");
    const Scene moved = posed(start, "caster-jump", 2);
    for (std::size_t i = 0; i < start.instances.size(); ++i) {
        const bool isCaster = std::count(caster.instances.begin(), caster.instances.end(), int(i)) > 0;
        const glm::dvec3 step(moved.instances[i].worldFromLocal[3] - start.instances[i].worldFromLocal[3]);
        EXPECT_NEAR(glm::length(step), isCaster ? 0.03 * start.bounds().diagonal() : 0.0, 1e-12);
        EXPECT_NEAR(step.x, 0.0, 1e-12);
        EXPECT_NEAR(step.y, 0.0, 1e-12);
    }
}

TEST(ChosenCaster, IsTheLargestThatIsNoRoomOrFloor) {
    Scene scene = loadScene("two-casters");
    const Caster chosen = chosenCaster(scene, "");
    ASSERT_EQ(chosen.instances.size(), 1u);
    // By name a model or a mesh, whatever its size.
    for (const Model& model : scene.models)
        if (model.casts) {
            EXPECT_EQ(chosenCaster(scene, model.name).name, model.name);
        }
    EXPECT_THROW(chosenCaster(scene, "nothing"), Error);

    // A model that does not cast is not chosen.
    scene.models[std::size_t(scene.instances[std::size_t(chosen.instances[0])].model)].casts = false;
    EXPECT_NE(chosenCaster(scene, "").name, chosen.name);
    EXPECT_THROW(chosenCaster(scene, chosen.name), Error);

    // All in one model that is as large as the scene: one of its meshes moves.
    Scene merged = loadScene("two-casters");
    for (Instance& instance : merged.instances) instance.model = 0;
    merged.models.resize(1);
    EXPECT_EQ(chosenCaster(merged, "").instances, chosen.instances);
}

}  // namespace
}  // namespace ombrage
