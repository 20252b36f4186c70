// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/scene.h>

#include "scene/mtl_file.h"
#include "scene/test_files.h"

namespace ombrage {
namespace {

bool warns(const Scene& scene, const std::string& part) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

std::string refusal(const std::string& file) {
    try {
        loadScene(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(Obj, IndicesLineEndsAndContinuations) {
    const TestFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n";
    // Absolute, relative to the end, with and without the other indices, and over three lines.
    for (const char* face :
         {"f 1 2 3 4\n", "f -4 -3 -2 -1\n", "f 1//1 2//-1 3//1 4//1\n", "f 1/1/1 -3/1/1 3/-1/1 4/1/1",
          "f 1/1 2/1 3/1 4/1 # square\n", "f 1 2 \\\n 3\\\n\\\n 4\n", "  f\t1 2  3 4  \n"})
        for (const char* end : {"\n", "\r\n", "\r"}) {
            std::string text = vertices + face, changed;
            for (const char c : text) changed += c == '\n' ? std::string(end) : std::string(1, c);
            const Scene scene = loadScene(folder.write("m.obj", changed));
            EXPECT_EQ(scene.triangleCount(), 2u) << face;
            EXPECT_EQ(scene.bounds().upper, glm::dvec3(1, 1, 0)) << face;
            EXPECT_TRUE(scene.warnings.empty()) << face << scene.warnings[0];
        }
}

TEST(Obj, AByteOrderMarkIsNoPartOfTheFirstLine) {
    const TestFolder folder;
    folder.write("m.mtl", "\xEF\xBB\xBFnewmtl red\nKd 1 0 0\n");
    const Scene scene =
        loadScene(folder.write("m.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib m.mtl\nusemtl red\nf 1 2 3\n"));
    EXPECT_EQ(scene.triangleCount(), 1u);
    EXPECT_EQ(scene.materials[0].baseColor, glm::vec3(1, 0, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Obj, ConcavePolygonsAreFilledOnce) {
    const TestFolder folder;
    const Scene scene =
        loadScene(folder.write("l.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 5 6 1 2 3 4\n"));
    const Mesh& mesh = scene.meshes[0];
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        area += 0.5 * double(glm::length(glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                                    mesh.positions[mesh.indices[i + 2]] - a)));
    }
    EXPECT_EQ(area, 3.0);  // whole numbers: exact; a fan from the first corner would cover 5
}

TEST(Obj, VertexColors) {
    const TestFolder folder;
    const Scene scene = loadScene(
        folder.write("c.obj", "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 0 0 1\nv 1 1 0\nf 1 2 3\nusemtl b\nf 2 4 3\n"));
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            glm::vec3 expected(1.0f);  // a vertex without a colour is white
            if (mesh.positions[i] == glm::vec3(1, 0, 0)) expected = {1, linearFromSrgb(0.5f), 0};
            if (mesh.positions[i] == glm::vec3(0, 1, 0)) expected = {0, 0, 1};
            EXPECT_EQ(mesh.colors[i], expected);
        }
    }
}

TEST(Obj, WhatIsPassedOverIsSaid) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write(
        "w.obj", std::string(kTriangleObj) + "l 1 2\np 1\nf 1 2\nbleh 3\nusemtl gone\ns off\ng a b\no c\nf 1 3 2\n"));
    EXPECT_TRUE(warns(scene, "2 points, lines and curves are left out, the first in w.obj:5"));
    EXPECT_TRUE(warns(scene, "1 faces of fewer than 3 corners are left out, the first in w.obj:7"));
    EXPECT_TRUE(warns(scene, "1 statements that no OBJ file has are left out, the first in w.obj:8: 'bleh'"));
    EXPECT_EQ(scene.warnings.size(), 3u);
    EXPECT_NE(refusal(folder.write("l.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")).find("points, lines and curves"),
              std::string::npos);
}

TEST(Obj, ErrorsNameFileAndLine) {
    const TestFolder folder;
    const std::pair<const char*, const char*> cases[] = {
        {"v 0 0 0\nv 1 0 0\n\nv 0 one 0\n", "x.obj:4: 'one' is no number"},
        {"v 0 0\n", "x.obj:1: a vertex needs 3 numbers"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "x.obj:4: vertex 4 is not among the 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "x.obj:4: vertex 0 is not among the 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "x.obj:4: vertex -4 is not among the 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n", "x.obj:4: texture coordinate 1 is not among the 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//9 2 3\n", "x.obj:4: normal 9 is not among the 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3x\n", "x.obj:4: '3x' is no index"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", "x.obj:4: vertex 99999999999999999999"}};
    for (const auto& [text, message] : cases)
        EXPECT_NE(refusal(folder.write("x.obj", text)).find(message), std::string::npos)
            << message << "\n"
            << refusal(folder.write("x.obj", text));
}

TEST(Obj, HugePolygonsEnd) {
    // A star of 50,000 points: cutting ears would take the square of that.
    std::string text, face = "f";
    for (int i = 1; i <= 50000; ++i) {
        text += "v " + std::to_string(i % 7) + " " + std::to_string(i % 11) + " " + std::to_string(i % 3) + "\n";
        face += " " + std::to_string(i);
    }
    const TestFolder folder;
    const auto start = std::chrono::steady_clock::now();
    loadScene(folder.write("huge.obj", text + face + "\n"));
    // The bound for bad input is 10 s, also under sanitizers.
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10.0);
}

TEST(Mtl, OptionsBehindTheNameAndPlacement) {
    std::vector<std::string> warnings;
    const MtlLibrary library = parseMtl(
        "newmtl a\nmap_Kd -s 2 3 1 -o 0.5 0.25 -clamp on wood -2.png\nbump my bump.jpg -bm 1.5\nmap_d d.png -imfchan "
        "m\n",
        "x.mtl", warnings);
    const MtlMaterial& a = library.at("a");
    EXPECT_EQ(a.diffuseMap.file, "wood -2.png");
    EXPECT_EQ(a.diffuseMap.scale, glm::vec2(2, 3));
    EXPECT_EQ(a.diffuseMap.offset, glm::vec2(0.5f, 0.25f));
    EXPECT_TRUE(a.diffuseMap.clamp);
    EXPECT_EQ(a.heightMap.file, "my bump.jpg");
    EXPECT_EQ(a.heightMap.bumpMultiplier, 1.5f);
    EXPECT_EQ(a.opacityMap.file, "d.png");
    EXPECT_TRUE(warnings.empty());
}

TEST(Obj, TexturesLieBesideTheirMaterialFile) {
    const TestFolder folder;
    writeImage(folder.path() / "mats/wood.png", Image::rgb(1, 1, ColorSpace::Srgb));
    folder.write("mats/m.mtl", "newmtl a\nmap_Kd -s 2 3 -o 0.5 0.25 wood.png\n");
    const Scene scene =
        loadScene(folder.write("m.obj",
                               "mtllib none.mtl mats\\m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                               "usemtl a\nf 1/1 2/2 3/3\n"));
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_TRUE(warns(scene, "'none.mtl' is missing"));
    // uv * scale + offset with v upwards; here v counts downwards.
    const Mesh& mesh = scene.meshes[0];
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(mesh.uvs[i], glm::vec2(mesh.positions[i].x * 2 + 0.5f, 1 - (mesh.positions[i].y * 3 + 0.25f)));
}

TEST(Obj, SaysWhatStandsInAFilesPlace) {
    const TestFolder folder;
    folder.write("mats/m.mtl", "newmtl a\nmap_Kd .\nnewmtl b\nmap_Kd gone.png\nnewmtl c\nmap_Kd /dev/null\n");
    const Scene scene =
        loadScene(folder.write("m.obj",
                               "mtllib mats\nmtllib mats/m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl a\n"
                               "f 1 2 3\nusemtl b\nf 2 3 4\nusemtl c\nf 1 3 4\n"));
    EXPECT_TRUE(warns(scene, "material file 'mats' is a folder"));
    EXPECT_TRUE(warns(scene, "texture '.' is a folder"));
    EXPECT_TRUE(warns(scene, "texture 'gone.png' is missing"));
    EXPECT_TRUE(warns(scene, "texture '/dev/null' is no file but a pipe, a socket or a device"));
}

TEST(Obj, NumbersOutOfTheirRangeAreSaid) {
    std::vector<std::string> warnings;
    const MtlLibrary library =
        parseMtl("newmtl a\nNs -5\nd 7\nnewmtl b\nNs 0\nd 1\nPr 1\nPm 0\nTr 0\nnewmtl c\nTr 1.5\nPr -1\nPm 2\n",
                 "m.mtl", warnings);
    EXPECT_EQ(library.at("a").shininess, 0.0f);
    EXPECT_EQ(library.at("a").opacity, 1.0f);
    EXPECT_EQ(library.at("c").opacity, 0.0f);
    EXPECT_EQ(library.at("c").roughness, 0.0f);
    EXPECT_EQ(library.at("c").metallic, 1.0f);
    ASSERT_EQ(warnings.size(), 5u);
    EXPECT_EQ(warnings[0], "m.mtl:2: 'ns' of -5 is out of its range; 0 is used");
    EXPECT_EQ(warnings[1], "m.mtl:3: 'd' of 7 is out of its range; 1 is used");
    EXPECT_EQ(warnings[2], "m.mtl:11: 'tr' of 1.5 is out of its range; 1 is used");
}

TEST(Obj, TwoTexturesOfOneNameInTwoFoldersStayApart) {
    const TestFolder folder;
    Image red = Image::rgb(1, 1, ColorSpace::Srgb);
    red.at(0, 0, 0) = 1.0f;
    writeImage(folder.path() / "a/t.png", red);
    writeImage(folder.path() / "b/t.png", Image::rgb(1, 1, ColorSpace::Srgb));
    folder.write("a/m.mtl", "newmtl a\nmap_Kd t.png\n");
    folder.write("b/m.mtl", "newmtl b\nmap_Kd t.png\n");
    const Scene scene = loadScene(folder.write(
        "m.obj", "mtllib a/m.mtl\nmtllib b/m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 2\n"));
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[std::size_t(scene.materials[0].baseColorTexture)].rgba[0], 255);
    EXPECT_EQ(scene.textures[std::size_t(scene.materials[1].baseColorTexture)].rgba[0], 0);
}

}  // namespace
}  // namespace ombrage
