// SPDX-License-Identifier: MIT
#include "lab/plan.h"

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <algorithm>

#include "lab/domain.h"

namespace ombrage {
namespace {

Scene twoLights() {
    Scene scene = loadScene("gap");
    Light light = scene.lights.front();
    light.name = "second";
    scene.lights.push_back(light);
    return scene;
}

CompareRequest requestAll(Family family) {
    CompareRequest request;
    request.allOf = {family};
    return request;
}

std::size_t countOf(Family family) {
    return std::size_t(std::count_if(techniques().begin(), techniques().end(),
                                     [&](const TechniqueInfo& t) { return t.family == family; }));
}

std::size_t reasonsWith(const ScenePlan& plan, const std::string& part) {
    return std::size_t(std::count_if(plan.skipped.begin(), plan.skipped.end(), [&](const SkippedPair& pair) {
        return pair.reason.find(part) != std::string::npos;
    }));
}

TEST(Plan, MotionsFollowTheStillPicturesOfALight) {
    const Scene scene = twoLights();
    CompareRequest request;
    request.pipelines = {parseTechnique("shadow/map"), parseTechnique("shadow/none"), parseTechnique("ao/blocks")};
    request.motions = parseMotions("camera-walk,light-jump,camera-walk");
    const ScenePlan plan = planScene(scene, request);
    // Two lights with two techniques, still and under two scripts each; occlusion still and for the camera alone.
    std::vector<std::string> order;
    for (const PlannedRun& run : plan.runs)
        order.push_back(std::to_string(run.light) + (run.motion ? " " + toString(*run.motion) : ""));
    EXPECT_EQ(order, (std::vector<std::string>{"0", "0", "0 camera-walk", "0 camera-walk", "0 light-jump",
                                               "0 light-jump", "1", "1", "1 camera-walk", "1 camera-walk",
                                               "1 light-jump", "1 light-jump", "-1", "-1 camera-walk"}));
    EXPECT_EQ(reasonsWith(plan, "changes nothing of ambient occlusion"), 1u);
    for (const PlannedRun& run : plan.runs)
        if (run.motion) {
            EXPECT_EQ(run.truths.size(), 1u);
        }
}

TEST(Plan, WhatIsNamedTwiceIsOneThing) {
    EXPECT_EQ(eachOnce({"tree", "gap", "tree", "gap"}), (std::vector<std::string>{"tree", "gap"}));
}

TEST(Plan, SaysWhatHasNoMotion) {
    CompareRequest request;
    request.pipelines = {parseTechnique("aa/fxaa"), parseTechnique("shadow/map")};
    request.motions = parseMotions("caster-move");
    EXPECT_EQ(reasonsWith(planScene(loadScene("gap"), request), "shadows and ambient occlusion alone"), 1u);
    request.pipelines = {parseTechnique("shadow/map")};
    request.truthKind = "area";
    EXPECT_EQ(reasonsWith(planScene(loadScene("gap"), request), "no truth of the kind 'area'"), 1u);
    request.truthKind.clear();

    // One mesh that is the whole scene has nothing to move before anything.
    Scene alone = loadScene("gap");
    alone.instances.resize(1);
    EXPECT_EQ(reasonsWith(planScene(alone, request), "no caster that could move"), 1u);
    request.motions = parseMotions("caster-move:bok");
    EXPECT_THROW(planScene(loadScene("gap"), request), Error);
}

TEST(Plan, ShadowsRunOncePerLightAndOcclusionOnce) {
    const Scene scene = twoLights();
    const ScenePlan shadows = planScene(scene, requestAll(Family::Shadow));
    EXPECT_EQ(shadows.runs.size() + shadows.skipped.size(), 2 * countOf(Family::Shadow));
    EXPECT_TRUE(std::is_sorted(shadows.runs.begin(), shadows.runs.end(), [](const auto& a, const auto& b) {
        return a.light < b.light;
    })) << "the truth of one light at a time is kept";
    const ScenePlan ao = planScene(scene, requestAll(Family::Ao));
    EXPECT_EQ(ao.runs.size(), countOf(Family::Ao));
    for (const PlannedRun& run : ao.runs) EXPECT_EQ(run.light, -1);
}

TEST(Plan, TakesTheChosenLightOnly) {
    CompareRequest request = requestAll(Family::Shadow);
    request.base.light = "second";
    for (const PlannedRun& run : planScene(twoLights(), request).runs) EXPECT_EQ(run.light, 1);
    request.base.light = "third";
    EXPECT_THROW(planScene(twoLights(), request), Error);
}

TEST(Plan, RunsNothingTwice) {
    CompareRequest request = requestAll(Family::Ao);
    request.allOf.push_back(Family::Ao);
    request.pipelines = {pipelinesOf(Family::Ao).front()};
    EXPECT_EQ(planScene(loadScene("gap"), request).runs.size(), countOf(Family::Ao));
}

TEST(Plan, FiltersFollowAnOcclusionTechnique) {
    for (const PlannedRun& run : planScene(loadScene("gap"), requestAll(Family::Filter)).runs) {
        EXPECT_EQ(run.family, Family::Ao);
        ASSERT_EQ(run.pipeline.size(), 2u);
        EXPECT_EQ(technique(run.pipeline[0].id).family, Family::Ao);
        EXPECT_EQ(technique(run.pipeline[1].id).family, Family::Filter);
    }
}

TEST(Plan, WarnsOfTechniquesThatTheSceneIsNotMeantFor) {
    Scene scene = loadScene("gap");
    scene.techniques = {"something/else"};
    CompareRequest request;
    request.pipelines = {pipelinesOf(Family::Shadow).front()};
    const ScenePlan plan = planScene(scene, request);
    EXPECT_EQ(plan.runs.size(), 1u) << "and goes on";
    ASSERT_EQ(plan.warnings.size(), 1u);
    EXPECT_NE(plan.warnings.front().find("something/else"), std::string::npos);
}

// A unit box of 12 triangles, counter-clockwise from outside.
Mesh box() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    mesh.normals.assign(8, glm::vec3(0, 1, 0));
    mesh.tangents.assign(8, glm::vec4(1, 0, 0, 1));
    mesh.uvs.assign(8, glm::vec2(0));
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

Scene sceneOf(const Mesh& mesh) {
    Scene scene;
    scene.materials.emplace_back();
    scene.meshes = {mesh};
    scene.models.emplace_back();
    scene.instances.emplace_back();
    return scene;
}

TEST(SceneTraits, ABoxIsClosedUntilATriangleIsMissing) {
    Mesh mesh = box();
    EXPECT_TRUE(sceneTraits(sceneOf(mesh)).closedCasters);
    mesh.indices.resize(33);
    EXPECT_FALSE(sceneTraits(sceneOf(mesh)).closedCasters);
    // What casts no shadow need not be closed.
    Scene scene = sceneOf(mesh);
    scene.models[0].casts = false;
    EXPECT_TRUE(sceneTraits(scene).closedCasters);
}

TEST(SceneTraits, AModelMayBeClosedByTwoMeshes) {
    Mesh lower = box(), upper = box();
    lower.indices.resize(18);
    upper.indices.erase(upper.indices.begin(), upper.indices.begin() + 18);
    Scene scene = sceneOf(lower);
    EXPECT_FALSE(sceneTraits(scene).closedCasters);
    scene.meshes.push_back(upper);
    Instance second;
    second.mesh = 1;
    scene.instances.push_back(second);
    EXPECT_TRUE(sceneTraits(scene).closedCasters);
}

TEST(SceneTraits, FindsPlanesAndAlphaTestedCasters) {
    Mesh mesh = box();
    mesh.indices.resize(6);  // one side: a square
    Scene scene = sceneOf(mesh);
    EXPECT_EQ(sceneTraits(scene).planarTriangle, std::vector<bool>(2, true));
    EXPECT_FALSE(sceneTraits(scene).alphaCasters);
    scene.materials[0].alphaMode = AlphaMode::Mask;
    EXPECT_TRUE(sceneTraits(scene).alphaCasters);
}

}  // namespace
}  // namespace ombrage
