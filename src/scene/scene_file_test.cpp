// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/scene.h>

#include "scene/test_files.h"

namespace ombrage {
namespace {

struct BadScene {
    const char* name;
    const char* text;     ///< "models" with one triangle is put in for @
    const char* where;    ///< behind the file's name
    const char* message;  ///< part of it
    const char* hint;     ///< part of it
};

const BadScene kBadScenes[] = {
    {"Syntax", "{\n \"models\": [ ,\n", ":2", "not valid JSON", ""},
    {"ZeroInName", "{\"models\": [\n{\"file\": \"t.obj\\u0000.png\"}]}", ":2: /models/0/file", "zero byte", ""},
    {"NumberOverflows", "{@,\n \"ambient\": 1e999}", ":3", "not valid JSON: number overflow parsing '1e999'", ""},
    {"DeepNesting", "{@,\n\"x\":[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]}", ":3: /x/0/0",
     "nested more than 32 deep", ""},
    {"NotAnObject", "[]", ":1: /", "expected an object, found a list", ""},
    {"NoModels", "{\n}", ":1: /", "the key 'models' is missing", ""},
    {"EmptyModels", "{\n \"models\": []}", ":2: /models", "at least one model", ""},
    {"UnknownKey", "{@,\n \"ligths\": []}", ":3: /ligths", "a scene has no key 'ligths'", "did you mean 'lights'?"},
    {"KeyTwice", "{@,\n \"name\": \"a\",\n \"name\": \"b\"}", ":4: /name", "given twice", ""},
    {"WrongType", "{@,\n \"ambient\": \"much\"}", ":3: /ambient", "expected a number, found a text", ""},
    {"OutOfRange", "{@,\n\n \"ambient\": -1}", ":4: /ambient", "-1 is out of range", "from 0"},
    {"ZeroRadius", "{@,\n \"ao_radius_m\": 0}", ":3: /ao_radius_m", "0 is out of range", "more than 0"},
    {"UnknownModelKey", "{\"models\": [{\"file\": \"t.obj\",\n \"scael\": 2}]}", ":2: /models/0/scael", "'scael'",
     "'scale'"},
    {"MissingFile", "{\"models\": [\n{\"file\": \"none.obj\"}]}", ":2: /models/0/file", "no file 'none.obj'", ""},
    {"BadModel", "{\"models\": [\n{\"file\": \"bad.obj\"}]}", ":2: /models/0/file", "bad.obj", ""},
    {"Outside", "{\"models\": [\n{\"file\": \"../t.obj\"}]}", ":2: /models/0/file", "outside", "--allow-outside"},
    {"ShortVector", "{\"models\": [{\"file\": \"t.obj\",\n\"position\": [1,\n2]}]}", ":2: /models/0/position",
     "expected 3 numbers, found 2", ""},
    {"VectorOfTexts", "{\"models\": [{\"file\": \"t.obj\",\"position\": [1,\n2,\n\"x\"]}]}", ":3: /models/0/position/2",
     "found a text", ""},
    {"ZeroScale", "{\"models\": [{\"file\": \"t.obj\",\n\"scale\": 0}]}", ":2: /models/0/scale", "flattens", ""},
    {"CastsType", "{\"models\": [{\"file\": \"t.obj\",\n\"casts\": 1}]}", ":2: /models/0/casts",
     "expected true or false", ""},
    {"FpsRange", "{\"models\": [{\"file\": \"t.obj\",\n\"fps\": 0}]}", ":2: /models/0/fps", "out of range", ""},
    {"ModelNameTwice", "{\"models\": [{\"name\":\"a\",\"file\": \"t.obj\"},\n{\"file\": \"t.obj\", \"name\":\"a\"}]}",
     ":2: /models/1/name", "'a' is taken", ""},
    {"LightType", "{@,\n \"lights\": [{\"type\": \"sunn\"}]}", ":3: /lights/0/type", "unknown light type 'sunn'",
     "'sun'"},
    {"LightWithoutType", "{@,\n \"lights\": [\n{}]}", ":4: /lights/0", "'type' is missing", ""},
    {"KeyOfOtherLight", "{@,\n \"lights\": [{\"type\": \"sun\",\n \"radius_m\": 1}]}", ":4: /lights/0/radius_m",
     "a sun light has no key 'radius_m'", ""},
    {"ZeroDirection", "{@,\n \"lights\": [{\"type\": \"sun\",\n \"direction\": [0,0,0]}]}", ":4: /lights/0/direction",
     "length 0", ""},
    {"WideInner", "{@,\n \"lights\": [{\"type\": \"spot\",\n \"inner_deg\": 40, \"outer_deg\": 30}]}",
     ":4: /lights/0/inner_deg", "wider", ""},
    {"ExcludeUnknown", "{@,\n \"lights\": [{\"type\": \"sun\",\n \"exclude\": [\"tt\"]}]}", ":4: /lights/0/exclude/0",
     "unknown model 'tt'", "'t'"},
    {"CameraAtTarget", "{@,\n \"cameras\": [{\"position\": [1,1,1], \"target\": [1,1,1]}]}", ":3: /cameras/0",
     "its own position", ""},
    {"CameraBoth", "{@,\n \"cameras\": [{\"position\": [1,1,1], \"fov_deg\": 40,\n \"ortho_height_m\": 2}]}",
     ":4: /cameras/0/ortho_height_m", "not both", ""},
    {"CameraFov", "{@,\n \"cameras\": [{\"position\": [1,1,1], \"fov_deg\": 180}]}", ":3: /cameras/0/fov_deg",
     "180 is out of range", "from 1 to 170"},
    {"AnimationType", "{@,\n \"animations\": [{\"type\": \"orbit-camra\"}]}", ":3: /animations/0/type",
     "unknown animation", "orbit-camera"},
    {"AnimationLight",
     "{@, \"lights\": [{\"type\": \"sun\", \"name\": \"lamp\"}],\n \"animations\": [{\"type\": \"orbit-light\", "
     "\"light\": \"lmap\"}]}",
     ":3: /animations/0/light", "unknown light", "lamp"},
    {"SwingModel",
     "{@,\n \"animations\": [{\"type\": \"swing\", \"models\": [\"dor\"], \"pivot\": [0, 0, 0], \"axis\": [0, 1, 0], "
     "\"amplitude_deg\": 30}]}",
     ":3: /animations/0/models/0", "unknown model 'dor'", ""},
    {"SwingAxis",
     "{@,\n \"animations\": [{\"type\": \"swing\", \"models\": [\"t\"], \"pivot\": [0, 0, 0], \"axis\": [0, 0, 0], "
     "\"amplitude_deg\": 30}]}",
     ":3: /animations/0/axis", "length 0", ""},
    {"AnimationPeriod", "{@,\n \"animations\": [{\"type\": \"orbit-camera\", \"period_s\": 0}]}",
     ":3: /animations/0/period_s", "out of range", ""},
    {"TechniqueId", "{@,\n \"techniques\": [\"shadw/map\"]}", ":3: /techniques/0", "unknown family 'shadw'", "shadow"},
    {"Deep", "{@,\n \"name\": [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]}",
     ":3: /name/0", "nested", ""},
};

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, NameFileLineAndPath) {
    const TestFolder folder;
    folder.write("t.obj", kTriangleObj);
    folder.write("scene/t.obj", kTriangleObj);
    folder.write("scene/bad.obj", "v 0 0 0\n");
    std::string text = GetParam().text;
    if (const std::size_t at = text.find('@'); at != std::string::npos)
        text.replace(at, 1, "\"models\": [\n{\"file\": \"t.obj\"}]");
    const std::string file = folder.write("scene/s.json", text);
    try {
        loadScene(file);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_EQ(error.where().substr(0, file.size() + std::string(GetParam().where).size()), file + GetParam().where)
            << error.where();
        EXPECT_NE(error.message().find(GetParam().message), std::string::npos) << error.message();
        EXPECT_NE(error.hint().find(GetParam().hint), std::string::npos) << error.hint();
    }
}

INSTANTIATE_TEST_SUITE_P(All, BadScenes, testing::ValuesIn(kBadScenes),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SceneFile, ZeroBytesBehindAreNotIgnored) {
    const TestFolder folder;
    folder.write("t.obj", kTriangleObj);
    const std::string file = folder.write("s.json", std::string("{\"models\": [{\"file\": \"t.obj\"}]}\n\0\0", 34));
    try {
        loadScene(file);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.where(), file + ":2");
    }
}

TEST(SceneFile, ARectLightNeedsAnArea) {
    const TestFolder folder;
    folder.write("t.obj", kTriangleObj);
    for (const char* size : {"", R"(, "size_m": [2, 0])"}) {
        const std::string file = folder.write("s.json", std::string(R"({"models": [{"file": "t.obj"}],
          "lights": [{"type": "rect")") + size + "}]}");
        try {
            loadScene(file);
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("area"), std::string::npos) << error.what();
            EXPECT_NE(error.where().find("/lights/0"), std::string::npos) << error.where();
        }
    }
}

TEST(SceneFile, ReadsEveryKey) {
    const TestFolder folder;
    folder.write("t.obj", kTriangleObj);
    const std::string file = folder.write("s.json", R"({
      "$schema": "x", "name": "all", "description": "d", "ambient": 0.5, "ao_radius_m": 0.25,
      "models": [ {"file": "t.obj", "position": [1, 2, 3], "rotation_deg": [90, 90, 0], "scale": 2, "casts": false},
                  {"file": "t.obj", "receives": false, "fps": 10, "clip": "walk", "path": [[0,0,0],[1,0,0]]} ],
      "lights": [ {"name": "lamp", "type": "point", "position": [2,4,1], "color": [1,0.5,0], "intensity": 40, "radius_m": 0.1, "range_m": 9},
                  {"type": "sun", "direction": [0,-2,0], "angle_deg": 90, "exclude": ["t-2"]},
                  {"type": "spot", "inner_deg": 10, "outer_deg": 45}, {"type": "rect", "size_m": [1, 0.5]} ],
      "cameras": [ {"name": "main", "position": [4,3,5], "target": [0,1,0], "up": [0,0,2], "fov_deg": 90},
                   {"position": [0,9,0], "ortho_height_m": 3} ],
      "animations": [ {"type": "orbit-camera", "period_s": 12}, {"type": "orbit-light", "light": "lamp"},
                      {"type": "swing", "models": ["t-2"], "pivot": [1, 2, 3], "axis": [0, 0, 2], "amplitude_deg": 90,
                       "period_s": 2, "phase": 0.25} ],
      "techniques": ["shadow/map", "ao/blocks"] })");
    const Scene scene = loadScene(file);
    EXPECT_EQ(scene.name, "all");
    EXPECT_EQ(scene.ambient, 0.5f);
    EXPECT_EQ(scene.aoRadius_m, 0.25f);
    ASSERT_EQ(scene.models.size(), 2u);
    EXPECT_EQ(scene.models[0].name, "t");
    EXPECT_EQ(scene.models[1].name, "t-2");
    EXPECT_FALSE(scene.models[0].casts);
    EXPECT_TRUE(scene.models[0].receives);
    EXPECT_FALSE(scene.models[1].receives);
    EXPECT_EQ(scene.meshes.size(), 1u) << "a file used twice is read once";
    // X first: (0,1,0) * 2 -> (0,0,2); then Y: -> (2,0,0); then moved. Sines of right angles are good to 1e-15.
    const glm::dvec4 moved = scene.instances[0].worldFromLocal * glm::dvec4(0, 1, 0, 1);
    EXPECT_NEAR(glm::length(glm::dvec3(moved) - glm::dvec3(3, 2, 3)), 0.0, 1e-12);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("fps, clip, path"), std::string::npos);

    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[0].radius_m, 0.1f);
    EXPECT_EQ(scene.lights[0].range_m, 9.0f);
    EXPECT_EQ(scene.lights[0].intensity, 40.0f);
    EXPECT_EQ(scene.lights[1].direction, glm::vec3(0, -1, 0));
    EXPECT_FLOAT_EQ(scene.lights[1].angle_rad, 1.5707963f);
    EXPECT_EQ(scene.lights[1].excludedModels, std::vector<int>{1});
    EXPECT_FLOAT_EQ(scene.lights[2].outer_rad, 0.78539816f);
    EXPECT_EQ(scene.lights[3].size_m, glm::vec2(1.0f, 0.5f));
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_FLOAT_EQ(scene.cameras[0].fovY_rad, 1.5707963f);
    EXPECT_EQ(scene.cameras[0].up, glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.cameras[1].orthoHeight_m, 3.0f);
    ASSERT_EQ(scene.animations.size(), 3u);
    EXPECT_EQ(scene.animations[2].instances, std::vector<int>{1});
    EXPECT_EQ(scene.animations[2].pivot, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.animations[2].axis, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(scene.animations[2].amplitude_rad, 1.5707963267948966);
    EXPECT_EQ(scene.animations[2].phase, 0.25);
    EXPECT_EQ(scene.techniques, (std::vector<std::string>{"shadow/map", "ao/blocks"}));
}

TEST(SceneFile, MissingPartsGetTheDefaultsOfAModelFile) {
    const TestFolder folder;
    const std::string model = folder.write("t.obj", kTriangleObj);
    const Scene scene = loadScene(folder.write("s.json", R"({"models": [{"file": "t.obj"}]})"));
    const Scene direct = loadScene(model);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].position, direct.cameras[0].position);
    EXPECT_EQ(scene.lights[0].direction, direct.lights[0].direction);
    EXPECT_EQ(scene.aoRadius_m, direct.aoRadius_m);
    EXPECT_EQ(scene.name, "s");
}

TEST(SceneFile, OutsideIsAllowedWhenAsked) {
    const TestFolder folder;
    folder.write("t.obj", kTriangleObj);
    const std::string file = folder.write("scene/s.json", R"({"models": [{"file": "../t.obj"}]})");
    SceneOptions options;
    options.allowOutside = true;
    EXPECT_EQ(loadScene(file, options).triangleCount(), 1u);
    const std::string absolute =
        folder.write("scene/a.json", "{\"models\": [{\"file\": \"" + (folder.path() / "t.obj").string() + "\"}]}");
    EXPECT_EQ(loadScene(absolute).triangleCount(), 1u);
}

TEST(SceneFile, ALinkOutOfTheFolderIsOutside) {
    const TestFolder folder;
    const std::string target = folder.write("t.obj", kTriangleObj);
    const std::string file = folder.write("scene/s.json", R"({"models": [{"file": "link.obj"}]})");
    std::filesystem::create_symlink(target, folder.path() / "scene/link.obj");
    EXPECT_THROW(loadScene(file), Error);
}

}  // namespace
}  // namespace ombrage
