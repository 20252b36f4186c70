// SPDX-License-Identifier: MIT
// Scenes whose lights, casters and cameras move between calls while techniques live on.
#include "render_fixture.h"

namespace ombrage {
namespace {

RenderSettings small(const std::string& shadow) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 36;
    settings.shadow = parsePipeline(Family::Shadow, shadow);
    return settings;
}

class MovingSceneTest : public RenderTest {
protected:
    static bool drewTheMap(const RenderResult& result) {
        for (const PassCost& pass : result.passes)
            if (pass.name == "light depth") return true;
        return false;
    }
};

void expectSame(const RenderResult& a, const RenderResult& b) {
    EXPECT_EQ(a.picture, b.picture);
    EXPECT_EQ(a.visibility, b.visibility);
    EXPECT_EQ(a.triangle, b.triangle);
}

TEST_F(MovingSceneTest, WhatMovesIsSeenAndWhatStaysIsKept) {
    for (const char* technique : {"map:resolution=256", "volume-zfail", "ray-traced", "planar"}) {
        const RenderSettings settings = small(technique);
        Scene scene = loadScene("gap");
        const RenderResult start = render(scene, settings);
        // Changed in place: a camera, a light, a caster.
        scene.cameras[0].position.x += 0.25;
        renderer().moveScene(scene);
        const RenderResult otherCamera = again(settings);
        EXPECT_NE(otherCamera.picture, start.picture);
        EXPECT_FALSE(drewTheMap(otherCamera)) << "the map is kept while neither light nor casters move";
        const Scene first = scene;
        scene.lights[0].direction = glm::normalize(scene.lights[0].direction + glm::vec3(0.3f, 0, 0));
        scene.lights[0].position.x += 0.3;
        renderer().moveScene(scene);
        const RenderResult otherLight = again(settings);
        EXPECT_NE(otherLight.visibility, otherCamera.visibility) << technique;
        for (Instance& instance : scene.instances)
            if (scene.models[std::size_t(instance.model)].name == "box") instance.worldFromLocal[3].x += 0.2;
        renderer().moveScene(scene);
        const RenderResult otherCaster = again(settings);
        EXPECT_NE(otherCaster.visibility, otherLight.visibility) << technique;

        // The same as without a past, and back again through another object.
        expectSame(otherCaster, render(scene, settings));
        renderer().moveScene(first);
        expectSame(otherCamera, again(settings));
    }
}

TEST_F(MovingSceneTest, AnotherSceneIsRefused) {
    Scene scene = loadScene("gap");
    const RenderSettings settings = small("map:resolution=256");
    const RenderResult start = render(scene, settings);
    Scene more = scene;
    more.instances.push_back(more.instances.front());
    EXPECT_THROW(renderer().moveScene(more), Error);
    Scene lit = scene;
    lit.lights.push_back(lit.lights.front());
    EXPECT_THROW(renderer().moveScene(lit), Error);
    expectSame(start, again(settings));
    Renderer fresh(options());
    EXPECT_THROW(fresh.moveScene(scene), Error);
}

TEST_F(MovingSceneTest, TheFitCameraMovesWhatTechniquesFitToAndNothingElse) {
    const Scene scene = loadScene("long-view");
    for (const char* fit : {"view", "scene"}) {
        RenderSettings settings = small("map:resolution=64,fit=" + std::string(fit));
        const RenderResult own = render(scene, settings);
        settings.fitCamera = scene.cameras[0];
        expectSame(own, again(settings));
        settings.fitCamera->position.y += 5;
        settings.fitCamera->target.x += 5;
        const RenderResult other = again(settings);
        EXPECT_EQ(other.triangle, own.triangle);
        if (std::string(fit) == "view") {
            EXPECT_NE(other.visibility, own.visibility);
        } else {
            EXPECT_EQ(other.visibility, own.visibility);
        }
    }
}

}  // namespace
}  // namespace ombrage
