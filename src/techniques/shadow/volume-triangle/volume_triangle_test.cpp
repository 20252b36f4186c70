// SPDX-License-Identifier: MIT
// What shadow/volume-triangle must share with shadow/ray-traced, pixel for pixel, and what its counters and pictures
// must say.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>
#include <ombrage/compare.h>

#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

RenderResult shoot(const Scene& scene, const std::string& technique, int width = kWidth, int height = kHeight,
                   std::vector<std::string> show = {}, bool countSavings = false) {
    RenderSettings settings;
    settings.countSavings = countSavings;
    settings.width = width;
    settings.height = height;
    settings.show = std::move(show);
    settings.shadow = parseTechnique(technique).second;
    RenderResult result = renderScene(scene, settings);
    EXPECT_TRUE(result.debugMessages.empty()) << result.debugMessages.front();
    return result;
}

/// Renders both ways under every light and expects the same bits. Rays decide wherever rounding could matter, so there
/// is no tolerance. Returns the share of dark pixels, so that the test asks something.
double expectRays(const Scene& scene, const std::string& params = "", int width = kWidth, int height = kHeight) {
    const RenderResult rays = shoot(scene, "shadow/ray-traced", width, height);
    const RenderResult volumes = shoot(scene, "shadow/volume-triangle" + params, width, height);
    std::size_t dark = 0, all = 0;
    for (const auto& [light, image] : rays.visibility) {
        const auto wanted = image.plane(0), got = volumes.visibility.at(light).plane(0);
        std::size_t different = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            different += wanted[i] != got[i] ? 1 : 0;
            dark += wanted[i] == 0.0f ? 1 : 0;
        }
        all += wanted.size();
        EXPECT_EQ(different, 0u) << scene.name << params << ", light " << light;
    }
    return double(dark) / double(all);
}

TEST(TriangleVolumes, AnswerAsRaysDoUnderEveryKindOfLight) {
    Scene scene = loadScene("in-shadow");
    const std::function<void(Light&)> kinds[] = {[](Light&) {},
                                                 [](Light& l) {
                                                     l.type = LightType::Point;
                                                     l.position = {2, 8, 2};
                                                 },
                                                 [](Light& l) {
                                                     l.type = LightType::Spot;
                                                     l.position = {2, 8, 2};
                                                     l.direction = {0, -1, 0};
                                                     l.inner_rad = 0.7f;
                                                     l.outer_rad = 0.9f;
                                                 },
                                                 [](Light& l) {
                                                     l.type = LightType::Point;
                                                     l.position = {2, 8, 2};
                                                     l.range_m = 9.0f;
                                                 },
                                                 // Far off: the sides of its volumes are nearly parallel.
                                                 [](Light& l) {
                                                     l.type = LightType::Point;
                                                     l.position = {20000, 80000, 20000};
                                                 }};
    for (const auto& kind : kinds) {
        Scene lit = scene;
        kind(lit.lights[0]);
        EXPECT_GT(expectRays(lit), 0.02);
    }
}

TEST(TriangleVolumes, AnswerAsRaysDoForMirroredUnevenAndSilentInstances) {
    Scene scene = loadScene("in-shadow");
    for (std::size_t i = 1; i < scene.instances.size(); ++i) {
        glm::dmat4& m = scene.instances[i].worldFromLocal;
        m[0] *= i % 2 == 0 ? -1.3 : 1.3;
        m[2] *= 0.6;
    }
    EXPECT_GT(expectRays(scene), 0.02);
    scene.models[1].casts = false;
    const double without = expectRays(scene);
    scene.lights[0].excludedModels = {2};
    EXPECT_LT(expectRays(scene), without);
}

TEST(TriangleVolumes, AnswerAsRaysDoUnderAnOrthographicCamera) {
    Scene scene = loadScene("room");
    scene.cameras[0].orthoHeight_m = 2.5f;
    EXPECT_GT(expectRays(scene), 0.02);
}

TEST(TriangleVolumes, SizesThatFillNoNodeAndEveryRoot) {
    // 1 to 3 pixels over a tile, a node of 64 and one of 512.
    const Scene scene = loadScene("fence");
    for (const char* root : {":root=64px", ":root=512px", ":root=4096px"}) {
        EXPECT_GT(expectRays(scene, root, 515, 67), 0.01);
        expectRays(scene, root, 9, 11);
    }
}

TEST(TriangleVolumes, ABatchThatFindsNoRoomIsAskedAgain) {
    const Scene scene = loadScene("tree");
    EXPECT_GT(expectRays(scene, ":queue=1024"), 0.01);
    EXPECT_GT(shoot(scene, "shadow/volume-triangle:queue=1024").counters.at("batches"), 8.0);
    EXPECT_EQ(shoot(scene, "shadow/volume-triangle").counters.at("batches"), 1.0);
}

TEST(TriangleVolumes, MovedCastersLightsAndCamerasAreFollowed) {
    Scene scene = loadScene("gap");
    const Scene start = scene;
    Renderer renderer({.device = "software", .debugContext = true});
    renderer.setScene(scene);
    RenderSettings settings;
    settings.width = 160;
    settings.height = 90;
    settings.shadow = parseTechnique("shadow/volume-triangle").second;
    renderer.render(settings);
    scene.cameras[0].position.x += 0.25;
    scene.lights[0].direction = glm::normalize(scene.lights[0].direction + glm::vec3(0.3f, 0, 0));
    for (Instance& instance : scene.instances)
        if (scene.models[std::size_t(instance.model)].name == "box") instance.worldFromLocal[3].x += 0.2;
    renderer.moveScene(scene);
    const RenderResult moved = renderer.render(settings);
    EXPECT_EQ(moved.visibility.at(0), shoot(scene, "shadow/volume-triangle", 160, 90).visibility.at(0));
    EXPECT_NE(moved.visibility.at(0), shoot(start, "shadow/volume-triangle", 160, 90).visibility.at(0));
}

TEST(TriangleVolumes, CountersSayWhatEachPartSaves) {
    const Scene scene = loadScene("in-shadow");
    const auto counters = [&](const char* params) {
        return shoot(scene, std::string("shadow/volume-triangle:skip-dark=false") + params).counters;
    };
    const auto all = counters(""), pixelwise = counters(",whole-nodes=false"),
               sides = counters(",root=4096px,corner-planes=false"), large = counters(",root=4096px"),
               small = counters(",root=64px");
    // Every pixel that a node spoke for is spared one test at least.
    const RenderResult shown =
        shoot(scene, "shadow/volume-triangle:skip-dark=false", kWidth, kHeight, {"shadow-level"});
    const auto levels = shown.shownRaw.at("shadow-level").plane(0);
    const auto spared = std::count_if(levels.begin(), levels.end(), [](float level) { return level > 1.0f; });
    EXPECT_GT(spared, 10000);
    EXPECT_GE(pixelwise.at("pixel tests"), all.at("pixel tests") + double(spared));
    // Half of a large triangle's bounds lie beside its corners.
    EXPECT_GT(sides.at("node tests"), large.at("node tests"));
    EXPECT_GT(sides.at("pixel tests"), large.at("pixel tests"));
    EXPECT_GT(small.at("node tests"), large.at("node tests"));
    EXPECT_EQ(large.at("pixel tests"), small.at("pixel tests"));
    // What is saved and what is made add up to every pixel against every triangle, however it was done.
    EXPECT_EQ(all.at("pixel tests") + all.at("pixel tests saved"),
              pixelwise.at("pixel tests") + pixelwise.at("pixel tests saved"));
    EXPECT_LT(all.at("pixel tests"), 0.1 * all.at("pixel tests saved"));

    // Beside z-fail on the same picture: the fragments that z-fail itself counts, less the tests.
    const auto beside = [&](const char* technique) {
        return shoot(scene, technique, kWidth, kHeight, {}, true).counters;
    };
    const double fill = beside("shadow/volume-zfail").at("fill");
    const auto savings = beside("shadow/volume-triangle");
    EXPECT_GT(fill, 0.0);
    EXPECT_EQ(savings.at("fill of z-fail"), fill);
    EXPECT_EQ(savings.at("fill saved"), fill - savings.at("pixel tests"));
    EXPECT_EQ(savings.at("pixel tests"), all.at("pixel tests"));
    EXPECT_EQ(all.count("fill saved"), 0u);
}

TEST(TriangleVolumes, PicturesSayWhichLevelDecidedAndHowOftenAPixelWasTested) {
    const Scene scene = loadScene("in-shadow");
    const std::vector<std::string> show{"shadow-level", "pixel-tests"};
    const RenderResult whole = shoot(scene, "shadow/volume-triangle", kWidth, kHeight, show);
    const RenderResult pixelwise = shoot(scene, "shadow/volume-triangle:whole-nodes=false", kWidth, kHeight, show);
    const auto levels = whole.shownRaw.at("shadow-level").plane(0),
               flat = pixelwise.shownRaw.at("shadow-level").plane(0);
    const auto visibility = whole.visibility.at(0).plane(0);
    for (std::size_t i = 0; i < visibility.size(); ++i) {
        ASSERT_EQ(levels[i] > 0.0f, visibility[i] == 0.0f) << i;
        ASSERT_EQ(flat[i], levels[i] > 0.0f ? 1.0f : 0.0f) << i;
    }
    EXPECT_GE(*std::max_element(levels.begin(), levels.end()), 2.0f);

    double tests = 0;
    for (const float count : whole.shownRaw.at("pixel-tests").plane(0)) tests += double(count);
    EXPECT_EQ(tests, whole.counters.at("pixel tests"));
}

}  // namespace
}  // namespace ombrage::test
