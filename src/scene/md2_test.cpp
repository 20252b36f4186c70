// SPDX-License-Identifier: MIT
#include "scene/md2_file.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/image.h>

#include "scene/test_files.h"
#include "scene/texture_set.h"

namespace ombrage {
namespace {

template <typename T>
void put(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One triangle of 3 corners in two frames; the skin's name is given.
std::string smallMd2(const std::string& skin) {
    std::string bytes = "IDP2";
    const int frameBytes = 40 + 4 * 3;
    put<std::int32_t>(bytes, {8, 64, 32, frameBytes, 1, 3, 3, 1, 0, 2, 68, 132, 144, 156, 0, 156 + 2 * frameBytes});
    std::string name = skin;
    name.resize(64, '\0');
    bytes += name;
    put<std::int16_t>(bytes, {0, 0, 32, 0, 0, 16});
    put<std::uint16_t>(bytes, {0, 1, 2, 0, 1, 2});
    for (const char* frame : {"stand01", "stand02"}) {
        put<float>(bytes, {32.0f, 32.0f, 32.0f, 0.0f, 0.0f, 32.0f});
        std::string frameName = frame;
        frameName.resize(16, '\0');
        bytes += frameName;
        // Quake's X forward, Y left, Z up; clockwise seen from +X.
        put<std::uint8_t>(bytes, {1, 0, 0, 0, 1, 2, 0, 0, 1, 1, 1, 0});
    }
    return bytes;
}

std::string refusal(const std::string& content) {
    try {
        parseMd2(content, "x.md2");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_EQ(error.where(), "x.md2");
        return error.message();
    }
    ADD_FAILURE() << "no error";
    return {};
}

std::string with(std::string content, std::size_t word, std::int32_t value) {
    std::memcpy(content.data() + 4 * word, &value, 4);
    return content;
}

TEST(Md2, TablesAndAxes) {
    const Md2File file = parseMd2(smallMd2("models/player/skin.pcx"), "x.md2");
    EXPECT_EQ(file.skinWidth, 64);
    EXPECT_EQ(file.skinHeight, 32);
    EXPECT_EQ(file.skins, std::vector<std::string>{"models/player/skin.pcx"});
    ASSERT_EQ(file.frames.size(), 2u);
    EXPECT_EQ(file.frames[1].name, "stand02");
    // 32 units are 1 m; forward becomes +Z, left +X, up +Y.
    const auto positions = file.positions(0);
    EXPECT_EQ(positions[0], glm::vec3(0, 1, 1));
    EXPECT_EQ(positions[1], glm::vec3(2, 1, 1));
    EXPECT_EQ(positions[2], glm::vec3(1, 2, 1));
}

TEST(Md2, FrontFacesAndTextureCoordinates) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("a.md2", smallMd2("nowhere")));
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.triangleCount(), 1u);
    // Stored as 0, 1, 2, which is counter-clockwise from the front here: Quake shows its other side.
    EXPECT_LT(mesh.normals[0].z, -0.99f);
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (mesh.positions[i] != glm::vec3(2, 1, 1)) continue;
        ++found;
        EXPECT_EQ(mesh.uvs[i], glm::vec2(32.5f / 64, 0.5f / 32));
    }
    EXPECT_EQ(found, 1u);
    EXPECT_TRUE(std::any_of(scene.warnings.begin(), scene.warnings.end(),
                            [](const std::string& w) { return w.find("'nowhere' is missing") != std::string::npos; }));
}

TEST(Md2, SkinsAreFoundBesideTheModel) {
    const TestFolder folder;
    Image red = Image::rgb(2, 2, ColorSpace::Srgb), green = red;
    for (float& v : red.plane(0)) v = 1.0f;
    for (float& v : green.plane(1)) v = 1.0f;
    writeImage(folder.path() / "Skin.png", red);
    writeImage(folder.path() / "own.png", green);
    const auto firstTexel = [](const Scene& scene) {
        const auto& rgba = scene.textures.at(0).rgba;
        return rgba[0] > 128 ? 'r' : (rgba[1] > 128 ? 'g' : '?');
    };
    // By name in whatever folder and with whatever extension; with the game's leading dot; by the model's own name.
    EXPECT_EQ(firstTexel(loadScene(folder.write("own.md2", smallMd2("models/x/skin.pcx")))), 'r');
    EXPECT_EQ(firstTexel(loadScene(folder.write("own.md2", smallMd2(".skin")))), 'r');
    EXPECT_EQ(firstTexel(loadScene(folder.write("own.md2", smallMd2("missing.pcx")))), 'g');
    // A scene file chooses another one, and the same model twice may wear two.
    folder.write("s.json", R"({"models": [{"file": "own.md2"}, {"file": "own.md2", "skin": "Skin.png"}]})");
    const Scene scene = loadScene((folder.path() / "s.json").string());
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_GT(scene.textures[0].rgba[1], 128);
    EXPECT_GT(scene.textures[1].rgba[0], 128);
    folder.write("t.json", R"({"models": [{"file": "own.md2", "skin": "none.png"}]})");
    EXPECT_THROW(loadScene((folder.path() / "t.json").string()), Error);
}

TEST(Md2, DamagedTablesAreRefused) {
    const std::string good = smallMd2("");
    EXPECT_NE(refusal("IDP3" + good.substr(4)).find("IDP2"), std::string::npos);
    EXPECT_NE(refusal(with(good, 1, 7)).find("version 7"), std::string::npos);
    EXPECT_NE(refusal(with(good, 4, 51)).find("frames of 51 bytes"), std::string::npos);
    EXPECT_NE(refusal(with(good, 6, 0)).find("corners"), std::string::npos);
    EXPECT_NE(refusal(with(good, 6, 2)).find("triangle 0: corner 2 of 2"), std::string::npos);
    EXPECT_NE(refusal(with(good, 7, 2)).find("triangle 0: texture coordinate 2 of 2"), std::string::npos);
    EXPECT_NE(refusal(with(good, 8, 0x7fffffff)).find("triangles lies outside"), std::string::npos);
    EXPECT_NE(refusal(with(good, 8, -1)).find("no triangles"), std::string::npos);
    EXPECT_NE(refusal(with(good, 10, 0)).find("no frames"), std::string::npos);
    EXPECT_NE(refusal(with(good, 10, 3)).find("frames lies outside"), std::string::npos);
    EXPECT_NE(refusal(with(good, 14, -64)).find("frames lies outside"), std::string::npos);
    EXPECT_NE(refusal(with(good, 2, 0)).find("no size"), std::string::npos);
    for (std::size_t size = 0; size < good.size(); ++size) refusal(good.substr(0, size));
}

TEST(Md2, SydneyStandsUprightInHerSkin) {
    OMBRAGE_DATA_FILE(path, "md2/sydney/sydney.md2");
    const Scene scene = loadScene(path);
    const Bounds bounds = scene.bounds();
    const glm::dvec3 size = bounds.upper - bounds.lower;
    // A grown-up: between 1.6 and 1.9 m, taller than wide.
    EXPECT_GT(size.y, 1.6);
    EXPECT_LT(size.y, 1.9);
    EXPECT_GT(size.y, 1.5 * std::max(size.x, size.z));
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].width, 308);
    EXPECT_EQ(scene.textures[0].height, 193);
    // The PCX was made from the BMP: the same colours.
    OMBRAGE_DATA_FILE(bmp, "md2/sydney/sydney.bmp");
    EXPECT_EQ(toTexture(readImage(bmp), "bmp", true).rgba, scene.textures[0].rgba);
}

}  // namespace
}  // namespace ombrage
