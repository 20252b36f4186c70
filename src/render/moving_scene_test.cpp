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

/// A ground that casts nothing and a box that does.
class KeptMapTest : public MovingSceneTest {
protected:
    void SetUp() override {
        MovingSceneTest::SetUp();
        scene = loadScene("gap");
        for (Instance& instance : scene.instances) {
            Model& model = scene.models[std::size_t(instance.model)];
            model.casts = model.name == "box";
            (model.casts ? box : receiver) = &instance;
        }
        ASSERT_TRUE(box != nullptr && receiver != nullptr);
        settings = small("map:resolution=256");
        settings.images = false;
        EXPECT_TRUE(drewTheMap(render(scene, settings))) << "nothing is kept yet";
    }

    /// Goes on with the scene as it stands now.
    bool drawsAfterMoving() {
        renderer().moveScene(scene);
        return drewTheMap(again(settings));
    }

    Scene scene;
    Instance *box = nullptr, *receiver = nullptr;
    RenderSettings settings;
};

TEST_F(KeptMapTest, APlainLoopDrawsItOnce) {
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(drewTheMap(again(settings)));
    // Nothing that the light's depth shows.
    scene.lights[0].intensity *= 2;
    scene.lights[0].color = {1, 0.5f, 0.25f};
    EXPECT_FALSE(drawsAfterMoving());
    settings.height *= 2;
    EXPECT_TRUE(drewTheMap(again(settings))) << "another size of picture starts anew";
    EXPECT_FALSE(drewTheMap(again(settings)));
}

TEST_F(KeptMapTest, ALightThatMovesDrawsItAnew) {
    scene.lights[0].direction = glm::normalize(scene.lights[0].direction + glm::vec3(0.3f, 0, 0));
    EXPECT_TRUE(drawsAfterMoving());
    EXPECT_FALSE(drawsAfterMoving());
    // A sun has no position.
    ASSERT_EQ(scene.lights[0].type, LightType::Sun);
    scene.lights[0].position.x += 1;
    EXPECT_FALSE(drawsAfterMoving());
}

TEST_F(KeptMapTest, ACasterThatMovesDrawsItAnewAndAReceiverDoesNot) {
    box->worldFromLocal[3].x += 0.2;
    EXPECT_TRUE(drawsAfterMoving());
    EXPECT_FALSE(drawsAfterMoving());
    // The ground turned in its own plane by nothing that moves its bounds: half a turn.
    receiver->worldFromLocal = receiver->worldFromLocal * glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                                                                     glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 0, 0, 1));
    EXPECT_FALSE(drawsAfterMoving());
    // A turn that leaves the box within the same bounds is a move all the same.
    box->worldFromLocal = box->worldFromLocal * glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                                                           glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 0, 0, 1));
    EXPECT_TRUE(drawsAfterMoving());
    const RenderResult moved = again(settings);
    EXPECT_EQ(moved.picture, render(scene, settings).picture) << "the same as without a past";
}

TEST_F(KeptMapTest, ParametersDrawItAnew) {
    settings.shadow = parsePipeline(Family::Shadow, "map:resolution=128");
    EXPECT_TRUE(drewTheMap(again(settings)));
    EXPECT_FALSE(drewTheMap(again(settings)));
    settings.shadow = parsePipeline(Family::Shadow, "map:resolution=128,cull=back");
    EXPECT_TRUE(drewTheMap(again(settings)));
    EXPECT_FALSE(drewTheMap(again(settings)));
    settings.shadow = parsePipeline(Family::Shadow, "map:resolution=128,cull=back,cache=false");
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(drewTheMap(again(settings))) << "it is asked to";
}

TEST_F(KeptMapTest, ACameraDrawsItAnewOnlyWhereTheMapIsFittedToTheView) {
    scene = loadScene("long-view");  // of which a camera never sees all casters
    for (const bool isFitted : {false, true}) {
        settings.shadow = parsePipeline(Family::Shadow, isFitted ? "map:resolution=64,fit=view" : "map:resolution=64");
        EXPECT_TRUE(drewTheMap(render(scene, settings)));
        EXPECT_FALSE(drewTheMap(again(settings)));
        scene.cameras[0].position.y += 5;
        scene.cameras[0].target.x += 5;
        EXPECT_EQ(drawsAfterMoving(), isFitted);
        EXPECT_FALSE(drawsAfterMoving());
    }
}

TEST_F(KeptMapTest, AnimationsDrawItAnewWhereTheyMoveTheLight) {
    scene.animations = {{"orbit-camera", "", 12}};
    render(scene, settings);
    for (const double time_s : {1.0, 2.0, 2.0, 0.0}) {
        settings.time_s = time_s;
        EXPECT_FALSE(drewTheMap(again(settings))) << time_s;
    }
    scene.animations = {{"orbit-light", scene.lights[0].name, 12}};
    settings.time_s = 0;
    render(scene, settings);
    for (const double time_s : {1.0, 2.0}) {
        settings.time_s = time_s;
        EXPECT_TRUE(drewTheMap(again(settings))) << time_s;
        EXPECT_FALSE(drewTheMap(again(settings))) << time_s;
    }
    const RenderResult later = again(settings);
    EXPECT_EQ(later.picture, render(scene, settings).picture) << "the same as without a past";
}

/// One caster of several that moves, without changing what the light's views cover.
class StillCastersTest : public MovingSceneTest {
protected:
    struct Drawn {
        std::uint64_t moving = 0, still = 0;  ///< triangles
        bool operator==(const Drawn&) const = default;
    };
    static Drawn drawn(const RenderResult& result) {
        Drawn drawn;
        for (const PassCost& pass : result.passes) {
            if (pass.name == "light depth") drawn.moving += pass.triangles;
            if (pass.name == "static depth") drawn.still += pass.triangles;
        }
        return drawn;
    }

    void start(const std::string& sceneName, const std::string& caster) {
        scene = loadScene(sceneName);
        mover = nullptr;
        for (Instance& instance : scene.instances) {
            const Model& model = scene.models[std::size_t(instance.model)];
            const std::uint64_t triangles = scene.meshes[std::size_t(instance.mesh)].triangleCount();
            if (model.name == caster) {
                mover = &instance;
                movers = triangles;
            } else if (model.casts)
                others = others + triangles;
        }
        ASSERT_NE(mover, nullptr) << caster;
        settings = small("map:resolution=256");
        EXPECT_EQ(drawn(render(scene, settings)), (Drawn{movers + others, 0}));
    }

    /// A frame later, held against the same scene without a past.
    Drawn step(double by_m) {
        mover->worldFromLocal[3].x += by_m;
        renderer().moveScene(scene);
        const RenderResult result = again(settings);
        Renderer fresh(options());
        fresh.setScene(scene);
        EXPECT_EQ(result.visibility, fresh.render(settings).visibility);
        bytes = result.gpuBytes;
        return drawn(result);
    }

    Scene scene;
    Instance* mover = nullptr;
    RenderSettings settings;
    std::uint64_t movers = 0, others = 0, bytes = 0;
};

TEST_F(StillCastersTest, AreKeptUnderThoseThatMove) {
    for (const auto& [name, caster] : {std::pair("room", "ball"), std::pair("window", "table")}) {
        SCOPED_TRACE(name);
        others = 0;
        start(name, caster);
        // All of them once more, for it may be a single move; then what stands still on its own, and then no more.
        EXPECT_EQ(step(0.01), (Drawn{movers + others, 0}));
        const std::uint64_t before = bytes;
        EXPECT_EQ(step(0.01), (Drawn{movers, others}));
        EXPECT_GT(bytes, before);
        EXPECT_EQ(step(0.01), (Drawn{movers, 0}));
        EXPECT_EQ(step(-0.02), (Drawn{movers, 0}));
        // A pause costs nothing, and does not forget what stands still.
        EXPECT_EQ(step(0), (Drawn{0, 0}));
        EXPECT_EQ(step(0.01), (Drawn{movers, 0}));
        // A long one gives the memory back.
        for (int i = 0; i < 40; ++i) again(settings);
        step(0);
        EXPECT_EQ(bytes, before);
        EXPECT_EQ(step(0.01), (Drawn{movers + others, 0}));
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
