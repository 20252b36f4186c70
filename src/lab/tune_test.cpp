// SPDX-License-Identifier: MIT
// What stands between the search and the renderer: parameters as dimensions, cameras, units of engines.
#include <ombrage/tune.h>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/tune_cases.h"
#include "lab/tune_export.h"
#include "lab/tune_space.h"

namespace ombrage::tuning {
namespace {

using Json = nlohmann::json;

Pipeline pipelineOf(const std::string& text) {
    return parseTechnique(text).second;
}

TEST(TuneSpace, TakesDeclaredRangesSwitchesAndChoicesOfAllElements) {
    const Space space(pipelineOf("ao/blocks:samples=64+filter/bilateral-separable:sigma=2.5"), {});
    const std::vector<std::string> names = space.names();
    const auto dimension = [&](const std::string& name) {
        const auto found = std::find(names.begin(), names.end(), name);
        EXPECT_NE(found, names.end()) << name;
        return space.dimensions()[std::size_t(found - names.begin())];
    };
    EXPECT_EQ(dimension("ao/blocks.samples").kind, Dimension::Kind::Integer);
    EXPECT_EQ(dimension("ao/blocks.samples").minimum, 8);
    EXPECT_EQ(dimension("ao/blocks.samples").maximum, 64);
    EXPECT_EQ(dimension("ao/blocks.kernel").kind, Dimension::Kind::Choice);
    EXPECT_EQ(dimension("filter/bilateral-separable.sigma").kind, Dimension::Kind::Real);
    EXPECT_TRUE(dimension("filter/bilateral-separable.sigma").logarithmic);

    // A point and its pipeline are the same thing said twice, the start included.
    EXPECT_EQ(toString(space.at(space.start())),
              toString(pipelineOf("ao/blocks:samples=64+filter/bilateral-separable:sigma=2.5")));
    EXPECT_EQ(toString(space.at(space.defaults())), "ao/blocks+filter/bilateral-separable");
    Point point = space.start();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == "ao/blocks.samples") point[i] = 17;
        if (names[i] == "filter/bilateral-separable.sigma") point[i] = 1.234;
    }
    EXPECT_EQ(toString(space.at(point)), "ao/blocks:samples=17+filter/bilateral-separable:sigma=1.234");
}

TEST(TuneSpace, KeepsWhatIsToStayAndRefusesWhatItDoesNotKnow) {
    const std::vector<std::string> names = Space(pipelineOf("shadow/map"), {"resolution", "shadow/map.cache"}).names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "shadow/map.resolution"), 0);
    EXPECT_EQ(std::count(names.begin(), names.end(), "shadow/map.cache"), 0);
    EXPECT_EQ(std::count(names.begin(), names.end(), "shadow/map.bias"), 1);
    EXPECT_THROW(Space(pipelineOf("shadow/map"), {"resolutoin"}), Error);
    EXPECT_THROW(Space(pipelineOf("shadow/none"), {}), Error);
    // A start outside of the tuning range, and within the parameter's, is a start.
    EXPECT_EQ(toString(Space(pipelineOf("shadow/map:constant-bias=32"), {})
                           .at(Space(pipelineOf("shadow/map:constant-bias=32"), {}).start())),
              "shadow/map:constant-bias=32");
}

TEST(TuneCases, CamerasAreDividedByNameOrByRule) {
    Scene scene = loadScene("gap");
    scene.cameras.resize(1);
    const std::string only = scene.cameras[0].name;
    const Cameras made = divideCameras(scene, "", {});
    EXPECT_EQ(made.searched, std::vector<std::string>{only});
    EXPECT_EQ(made.heldOut.size(), 2u);
    EXPECT_EQ(made.made, made.heldOut);
    ASSERT_EQ(scene.cameras.size(), 3u);
    for (std::size_t i : {1u, 2u}) {
        // On the orbit: as far from the target as before, and elsewhere.
        const Camera &a = scene.cameras[0], &b = scene.cameras[i];
        EXPECT_NEAR(glm::length(a.position - a.target), glm::length(b.position - b.target), 1e-9);
        EXPECT_GT(glm::length(a.position - b.position), 0.01);
        EXPECT_EQ(b.target, a.target);
    }
    // A scene's own cameras come before made ones.
    const Cameras own = divideCameras(scene, scene.cameras[1].name, {});
    EXPECT_EQ(own.searched, std::vector<std::string>{scene.cameras[1].name});
    EXPECT_EQ(own.heldOut, (std::vector<std::string>{only, scene.cameras[2].name}));
    EXPECT_TRUE(own.made.empty());
    // Named ones are held out, all others searched on.
    const Cameras named = divideCameras(scene, "", {only});
    EXPECT_EQ(named.heldOut, std::vector<std::string>{only});
    EXPECT_EQ(named.searched.size(), 2u);
    EXPECT_THROW(divideCameras(scene, only, {only}), Error);
}

TEST(TuneCases, AnOrbitEndsBeforeAWall) {
    const Scene scene = loadScene("gap");
    Camera camera = scene.cameras[0];
    const double free_m = glm::length(orbited(scene, camera, 0.4).position - camera.position);
    EXPECT_NEAR(
        free_m,
        2 * std::sin(0.2) *
            glm::length(glm::dvec3(camera.position.x - camera.target.x, 0, camera.position.z - camera.target.z)),
        1e-9);
    // About a horizontal axis the orbit would go through the floor.
    camera.position = camera.target + glm::dvec3(3, 0.3, 0);
    camera.up = {0, 0, 1};
    const double below_m = orbited(scene, camera, -0.4).position.y;
    EXPECT_GT(below_m, camera.target.y - 1e-3) << "the floor lies at or above the target's height less a little";
}

TEST(TuneExport, ExactValuesAreWhatTheDefinitionsGiveAndTheOthersSayWhy) {
    const Pipeline pipeline = pipelineOf("shadow/map:resolution=2000,bias=normal-offset,constant-bias=2");
    const std::vector<LightScale> lights{{"gap", "sun", 0.01, 20.0, 20.0, 50.0}, {"room", "lamp", {}, {}, {}, {}}};
    const auto settings = [&](const char* engine, int light) {
        return Json::parse(exportText(engine, Family::Shadow, pipeline, lights))["lights"][light]["settings"];
    };
    const Json three = settings("threejs", 0);
    EXPECT_EQ(three["shadow.mapSize"]["value"], Json::array({2000, 2000}));
    // 2 texels of 1 cm are 2 cm of 50 m, towards the light.
    EXPECT_DOUBLE_EQ(three["shadow.bias"]["value"].get<double>(), -0.0004);
    EXPECT_TRUE(three["shadow.bias"]["exact"].get<bool>());
    EXPECT_FALSE(three["shadow.normalBias"]["exact"].get<bool>());
    EXPECT_FALSE(three["shadow.normalBias"]["note"].get<std::string>().empty());
    EXPECT_EQ(three["shadow.camera"]["value"]["right"], 10.0);
    // 2000 is no power of two.
    const Json filament = settings("filament", 0);
    EXPECT_EQ(filament["ShadowOptions.mapSize"]["value"], 2048);
    EXPECT_FALSE(filament["ShadowOptions.mapSize"]["exact"].get<bool>());
    EXPECT_DOUBLE_EQ(filament["ShadowOptions.constantBias"]["value"].get<double>(), 0.02);
    // Godot counts in hundredths of the depth range.
    EXPECT_DOUBLE_EQ(settings("godot", 0)["shadow_bias"]["value"].get<double>(), 0.04);
    // Texels that grow have no one length.
    EXPECT_TRUE(settings("threejs", 1)["shadow.bias"]["value"].is_null());
    EXPECT_FALSE(settings("threejs", 1)["shadow.bias"]["exact"].get<bool>());
    // A program of one's own gets everything, others are told what is missing.
    EXPECT_EQ(Json::parse(exportText("gl", Family::Shadow, pipeline, lights))["uniforms"]["shadow/map.resolution"],
              2000);
    const Json missing = Json::parse(exportText("threejs", Family::Shadow, pipeline, lights))["without_counterpart"];
    EXPECT_TRUE(missing.contains("shadow/map.bias"));
    EXPECT_FALSE(missing.contains("shadow/map.resolution"));
    EXPECT_THROW(exportText("unreal", Family::Shadow, pipeline, lights), Error);
}

TEST(TuneExport, ARadiusOfZeroIsTheScenesOwn) {
    const Pipeline pipeline = parsePipeline(Family::Ao, "ao/blocks");
    const auto radius = [&](const std::map<std::string, double>& radii_m) {
        return Json::parse(exportText("threejs", Family::Ao, pipeline, {}, radii_m))["settings"]["GTAOPass.radius"];
    };
    EXPECT_EQ(radius({{"cornell", 0.25}})["value"], 0.25);
    // Two scenes of one radius agree, others do not.
    EXPECT_EQ(radius({{"cornell", 0.25}, {"corner", 0.25}})["value"], 0.25);
    const Json several = radius({{"cornell", 0.25}, {"tree", 0.5}});
    EXPECT_TRUE(several["value"].is_null());
    EXPECT_EQ(several["note"], "0 stands for each scene's own: cornell 0.25 m, tree 0.5 m");
    const Json missing = Json::parse(exportText("godot", Family::Ao, pipeline, {}, {{"cornell", 0.25}}));
    EXPECT_FALSE(missing["without_counterpart"].contains("ao/blocks.radius"));
}

TEST(TuneText, WeightsAndBoundsAreChecked) {
    EXPECT_EQ(parseTuneWeight("menger=2.5"), std::make_pair(std::string("menger"), 2.5));
    for (const char* wrong : {"menger", "=1", "menger=0", "menger=-1", "menger=two"})
        EXPECT_THROW(parseTuneWeight(wrong), Error) << wrong;
    EXPECT_EQ(parseErrorBelow("rmse=0.05"), std::make_pair(std::string("rmse"), 0.05));
    EXPECT_EQ(parseErrorBelow("gain_db=-1").second, -1);
    for (const char* wrong : {"rmse", "rmze=0.05", "rmse=low", "rmse=-1", "bias=-0.1"})
        EXPECT_THROW(parseErrorBelow(wrong), Error) << wrong;
}

TEST(TuneText, TheSentenceSaysWhatWasGained) {
    TuneResult result;
    result.metric = "rmse";
    result.start = {"shadow/map", {0.2, {}, 4}, TuneFigures{0.25, {}, 4}, true};
    result.winner = {"shadow/map:bias=slope", {0.1, {}, 4}, TuneFigures{0.2, {}, 4}, true};
    EXPECT_EQ(
        result.sentence(),
        "Take shadow/map:bias=slope: on the held-out cameras it has rmse 0.2 instead of 0.25 (20.0 % less), at 4.0 "
        "MiB instead of 4.0 MiB.");
    result.winner = result.start;
    EXPECT_EQ(result.sentence().rfind("Keep shadow/map:", 0), 0u);
    result.winner.isWithinLimits = false;
    EXPECT_EQ(result.sentence().rfind("Nothing within the limits", 0), 0u);
    result.pareto = true;
    EXPECT_EQ(result.sentence().rfind("Nothing within the limits", 0), 0u);
    result.front = {result.start};
    EXPECT_EQ(result.sentence(), "Nothing beats shadow/map with rmse 0.25 at 4.0 MiB on the held-out cameras.");
    result.front.push_back({"shadow/map:bias=slope", {0.1, {}, 8}, TuneFigures{0.2, {}, 8}, true});
    EXPECT_EQ(result.sentence(),
              "Nothing beats these 2 on the held-out cameras: from shadow/map with rmse 0.25 at 4.0 MiB to "
              "shadow/map:bias=slope with rmse 0.2 at 8.0 MiB.");
}

}  // namespace
}  // namespace ombrage::tuning
