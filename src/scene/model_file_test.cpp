// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/scene.h>

#include "core/strings.h"
#include "scene/mesh_build.h"
#include "scene/mtl_file.h"
#include "scene/shapes.h"
#include "scene/test_files.h"
#include "scene/texture_set.h"

namespace ombrage {
namespace {

bool warns(const Scene& scene, const std::string& part) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

TEST(MeshBuild, SmoothNormalsOfASphereAreItsRadii) {
    Mesh mesh = shapes::sphere({0, 0, 0}, 1.0f, 64, 32);
    mesh.normals.clear();
    mesh.uvs.clear();
    dropBadTriangles(mesh);
    joinVertices(mesh);
    completeNormals(mesh);
    // The angle-weighted mean of facets differs from the radius by the square of the facet's angle of 0.1.
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        ASSERT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 1.0f - 1e-4f);
}

TEST(MeshBuild, EdgesOfACubeStaySharp) {
    Mesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    const Mesh flat = mesh;
    mesh.normals.clear();
    mesh.uvs.clear();
    joinVertices(mesh);
    EXPECT_EQ(mesh.positions.size(), 8u);
    completeNormals(mesh);
    EXPECT_EQ(mesh.positions.size(), 24u);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c)
        EXPECT_EQ(mesh.normals[mesh.indices[c]], flat.normals[flat.indices[c]]);
}

TEST(MeshBuild, BadTrianglesGo) {
    Mesh mesh;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {2, 0, 0}};
    mesh.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 0, 1, 0, 1, 99};
    EXPECT_EQ(dropBadTriangles(mesh), 4u);
    joinVertices(mesh);
    EXPECT_EQ(mesh.positions.size(), 3u);
}

TEST(MeshBuild, TangentsFollowTheTexture) {
    // u to the right, v downwards on a square that faces +z: tangent +x, bitangent (to the top row) +y.
    Mesh mesh = shapes::rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    makeTangents(mesh);
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
    for (glm::vec2& uv : mesh.uvs) uv.x = -uv.x;
    makeTangents(mesh);
    EXPECT_EQ(mesh.tangents[0], glm::vec4(-1, 0, 0, -1));
}

TEST(MeshBuild, MirroredTextureSplitsTheSeam) {
    // Two triangles that share an edge, one with mirrored coordinates.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uvs = {{0, 1}, {0, 0}, {1, 1}, {1, 1}};
    mesh.indices = {0, 2, 1, 0, 1, 3};
    makeTangents(mesh);
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.tangents[mesh.indices[0]].w, 1.0f);
    EXPECT_EQ(mesh.tangents[mesh.indices[3]].w, -1.0f);
}

TEST(Mtl, ReadsMapsAndTheirOptions) {
    std::vector<std::string> warnings;
    const MtlLibrary library = parseMtl(
        "newmtl a b\r\nKd 0.1 0.2 0.3\r\nTr 0.25\r\nmap_Kd -s 2 2 1 -clamp on my tex.png\r\nbump -bm 0.5 h.png\r\nnorm "
        "n.png\n"
        "newmtl c\nKd red\nd 0.5\nmap_d -imfchan m d.png\n",
        "x.mtl", warnings);
    ASSERT_EQ(library.count("a b"), 1u);
    const MtlMaterial& a = library.at("a b");
    EXPECT_EQ(*a.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(*a.opacity, 0.75f);
    EXPECT_EQ(a.diffuseMap.file, "my tex.png");
    EXPECT_EQ(a.heightMap.file, "h.png");
    EXPECT_EQ(a.heightMap.bumpMultiplier, 0.5f);
    EXPECT_EQ(a.normalMap.file, "n.png");
    EXPECT_EQ(library.at("c").opacityMap.file, "d.png");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].substr(0, 8), "x.mtl:8:");
}

TEST(ModelFile, ObjWithTexturesCutOutsAndOddPaths) {
    const TestFolder folder;
    Image color(2, 2, {"R", "G", "B", "A"}, ColorSpace::Srgb);
    for (float& a : color.plane("A")) a = 1.0f;
    color.plane("A")[3] = 0.0f;
    writeImage(folder.path() / "Tex/Leaf.PNG", color);
    folder.write("m.mtl", "newmtl leaf\nmap_Kd tex\\leaf.png\nnewmtl gone\nmap_Kd nowhere.png\nnewmtl glass\nd 0.4\n");
    const Scene scene =
        loadScene(folder.write("m.obj",
                               "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
                               "usemtl leaf\nf 1/1 2/2 3/3\nusemtl gone\nf 1 2 4\nusemtl glass\nf 1 3 4\n"));
    EXPECT_EQ(scene.triangleCount(), 3u);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].rgba[15], 0);
    EXPECT_TRUE(warns(scene, "nowhere.png"));
    const auto material = [&](const std::string& name) {
        return *std::find_if(scene.materials.begin(), scene.materials.end(),
                             [&](const Material& m) { return m.name == name; });
    };
    EXPECT_EQ(material("leaf").alphaMode, AlphaMode::Mask);
    EXPECT_EQ(material("leaf").baseColorTexture, 0);
    EXPECT_EQ(material("gone").baseColorTexture, -1);
    EXPECT_EQ(material("glass").alphaMode, AlphaMode::Blend);
    // v = 0 is the top row here, the bottom one in the file.
    const Mesh& leaf = scene.meshes[0];
    for (std::size_t i = 0; i < leaf.positions.size(); ++i) EXPECT_EQ(leaf.uvs[i].y, 1.0f - leaf.positions[i].y);
}

TEST(ModelFile, NormalMapInTheBumpSlotIsRecognised) {
    Texture normals{"n", 2, 1, false, {128, 128, 255, 255, 140, 120, 254, 255}};
    Texture heights{"h", 2, 1, false, {200, 200, 200, 255, 90, 90, 90, 255}};
    EXPECT_TRUE(looksLikeNormalMap(normals));
    EXPECT_FALSE(looksLikeNormalMap(heights));
}

TEST(ModelFile, UnusableFilesAreInputErrors) {
    const TestFolder folder;
    for (const std::string& file :
         {folder.write("empty.obj", ""), folder.write("points.obj", "v 0 0 0\nv 1 0 0\n"),
          folder.write("nan.obj", "v nan nan nan\nv nan 0 0\nv nan 1 0\nf 1 2 3\n"),
          folder.write("broken.gltf", "{\"asset\":{\"version\":\"2.0\"}"), folder.write("short.glb", "glTF"),
          folder.path().string() + "/absent.obj", folder.path().string()}) {
        try {
            loadScene(file);
            ADD_FAILURE() << "no error for " << file;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Input) << file;
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        }
    }
}

TEST(ModelFile, MissingMaterialFileIsAWarning) {
    const TestFolder folder;
    const Scene scene =
        loadScene(folder.write("t.obj", std::string("mtllib none.mtl\nusemtl x\n") + kTriangleObj + "f 1 1 2\n"));
    EXPECT_TRUE(warns(scene, "none.mtl"));
    EXPECT_TRUE(warns(scene, "1 triangles"));
    EXPECT_EQ(scene.triangleCount(), 1u);
}

/// A ball as an OBJ text.
std::string ballObj() {
    const Mesh mesh = shapes::sphere({1, 2, 3}, 2.0f, 64, 32);
    std::string text;
    for (const glm::vec3& p : mesh.positions)
        text += "v " + formatNumber(p.x) + " " + formatNumber(p.y) + " " + formatNumber(p.z) + "\n";
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        text += "f " + std::to_string(mesh.indices[i] + 1) + " " + std::to_string(mesh.indices[i + 1] + 1) + " " +
                std::to_string(mesh.indices[i + 2] + 1) + "\n";
    return text;
}

TEST(Framing, TheSphereFillsNineTenthsOfTheHeight) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("ball.obj", ballObj()));
    const Camera& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "main");
    EXPECT_FLOAT_EQ(camera.fovY_rad, 0.87266463f);
    const glm::dvec3 arm = camera.position - glm::dvec3(1, 2, 3);
    // Float corners.
    EXPECT_NEAR(glm::degrees(std::atan2(arm.x, arm.z)), 35.0, 1e-3);
    EXPECT_NEAR(glm::degrees(std::asin(arm.y / glm::length(arm))), 20.0, 1e-3);
    // The outline of a ball of 2 m stands at 0.9 of the half height.
    EXPECT_NEAR(std::tan(std::asin(2.0 / glm::length(arm))), 0.9 * std::tan(glm::radians(25.0)), 1e-5);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_NEAR(glm::length(scene.lights[0].direction - glm::normalize(glm::vec3(-1, -2, -0.7f))), 0.0f, 1e-6f);
    EXPECT_FALSE(scene.lights[0].hasSize());
    EXPECT_EQ(scene.ambient, 0.2f);
    EXPECT_NEAR(scene.aoRadius_m, 0.05 * std::sqrt(48.0), 1e-4);
}

TEST(Framing, ARoomGetsItsCameraInside) {
    const TestFolder folder;
    // A box of 10 x 3 x 4 m whose faces look inwards.
    const Scene scene =
        loadScene(folder.write("room.obj",
                               "v 0 0 0\nv 10 0 0\nv 10 3 0\nv 0 3 0\nv 0 0 4\nv 10 0 4\nv 10 3 4\nv 0 3 4\n"
                               "f 1 2 3 4\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 1 5 6 2\nf 4 3 7 8\n"));
    EXPECT_EQ(scene.cameras[0].position, glm::dvec3(2.0, 1.5, 2.0));
    EXPECT_EQ(scene.cameras[0].target, glm::dvec3(5.0, 1.5, 2.0));
}

TEST(Framing, GroundEyeAndTarget) {
    const TestFolder folder;
    SceneOptions options;
    options.ground = true;
    options.eye = glm::dvec3(1, 2, 30);
    options.target = glm::dvec3(0, 1, 0);
    const std::string file = folder.write("ball.obj", ballObj());
    const Scene scene = loadScene(file, options), plain = loadScene(file);
    EXPECT_EQ(scene.cameras[0].position, *options.eye);
    EXPECT_EQ(scene.cameras[0].target, *options.target);
    ASSERT_EQ(scene.models.size(), 2u);
    EXPECT_EQ(scene.models[1].name, "ground");
    const Bounds ground = scene.bounds(), content = plain.bounds();
    EXPECT_NEAR(ground.upper.x - ground.lower.x, 4.0 * content.diagonal(), 1e-4);  // the floor's float corners
    EXPECT_EQ(ground.lower.y, content.lower.y);
    EXPECT_EQ(scene.aoRadius_m, plain.aoRadius_m);
}

TEST(Framing, TheGroundLiesBelowAFloorOfTheModel) {
    const TestFolder folder;
    SceneOptions options;
    options.ground = true;
    const auto depth = [&](const std::string& name, const std::string& faces) {
        const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\n";
        const std::string file = folder.write(name + ".obj", corners + faces);
        return -loadScene(file, options).bounds().lower.y / loadScene(file).bounds().diagonal();
    };
    // In float steps of the transform nothing is lost: doubles to within their rounding.
    EXPECT_NEAR(depth("flat-up", "f 4 3 2 1\n"), 1e-3, 1e-9);
    EXPECT_NEAR(depth("flat-down", "f 1 2 3 4\n"), 1e-3, 1e-9);
    EXPECT_NEAR(depth("floor-and-wall", "f 4 3 2 1\nf 1 2 6 5\n"), 1e-3, 1e-9);
    EXPECT_EQ(depth("seen-from-below", "f 1 2 3 4\nf 1 2 6 5\n"), 0.0);
    EXPECT_EQ(depth("wall", "f 1 2 6 5\n"), 0.0);
}

struct RealModel {
    const char* file;
    std::size_t triangleCount;  ///< of the manifest, without area ones in
};

/// Triangles left plus those that the loader says it dropped.
std::size_t triangleCountOfFile(const Scene& scene) {
    std::size_t count = scene.triangleCount();
    for (const std::string& warning : scene.warnings)
        if (warning.find("triangles with non-finite") != std::string::npos ||
            warning.find("triangles that are there twice") != std::string::npos)
            count += std::stoul(warning);
    return count;
}

class RealModels : public testing::TestWithParam<RealModel> {};

TEST_P(RealModels, HaveTheirTriangles) {
    OMBRAGE_DATA_FILE(file, GetParam().file);
    const auto start = std::chrono::steady_clock::now();
    const Scene scene = loadScene(file);
    const double time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(triangleCountOfFile(scene), GetParam().triangleCount);
    for (const std::string& warning : scene.warnings) EXPECT_EQ(warning.find("texture"), std::string::npos) << warning;
    // Measured 0.3 to 1 s in a release build; sanitizers and busy machines take several times as long.
    EXPECT_LT(time_s, 20.0);
}

INSTANTIATE_TEST_SUITE_P(All, RealModels,
                         testing::Values(RealModel{"meshes/stanford-bunny.obj", 69451},
                                         RealModel{"gltf/FlightHelmet/FlightHelmet.gltf", 94722},
                                         RealModel{"scenes/sponza_dabrovic/sponza.obj", 66450},
                                         RealModel{"scenes/sibenik/sibenik.obj", 80479},
                                         RealModel{"gltf/CornellBox/CornellBox.glb", 36},
                                         RealModel{"meshes/spider/spider.obj", 1368}));

/// The rows of the data's manifest, "| FILE | TRIANGLES | ...", and every model in its folders has one.
TEST(RealModel, AllLoadWithTheTrianglesOfTheManifest) {
    OMBRAGE_DATA_FILE(manifest, "MANIFEST.md");
    const std::filesystem::path folder = std::filesystem::path(manifest).parent_path();
    std::map<std::string, std::size_t> counts;
    std::ifstream lines(manifest);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> cells = split(line, '|');
        long long count = 0;
        if (cells.size() > 3 && parseInt(trim(cells[2]), count)) counts[trim(cells[1])] = std::size_t(count);
    }
    std::size_t loaded = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = std::filesystem::relative(entry.path(), folder).generic_string();
        const std::string extension = entry.path().extension().string();
        if (name.rfind("malformed/", 0) == 0) continue;
        if (extension != ".obj" && extension != ".gltf" && extension != ".glb" && extension != ".ply" &&
            extension != ".md2")
            continue;
        ASSERT_EQ(counts.count(name), 1u) << name;
        const Scene scene = loadScene(entry.path().string());
        EXPECT_EQ(triangleCountOfFile(scene), counts[name]) << name;
        for (const std::string& warning : scene.warnings)
            EXPECT_EQ(warning.find("missing"), std::string::npos) << name << ": " << warning;
        for (const Mesh& mesh : scene.meshes) {
            ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << name;
            for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-4f) << name;
        }
        ++loaded;
    }
    EXPECT_GE(loaded, 50u);
}

/// Oddities that the manifest calls valid, and what must be refused, by the file of the malformed set.
TEST(RealModel, OddFilesLoadAndDamagedOnesAreRefused) {
    OMBRAGE_DATA_FILE(set, "malformed/");
    for (const char* name : {"assimp/OBJ/box.obj",
                             "assimp/OBJ/box_longline.obj",
                             "assimp/OBJ/box_without_lineending.obj",
                             "assimp/OBJ/concave_polygon.obj",
                             "assimp/OBJ/multiple_spaces.obj",
                             "assimp/OBJ/only_a_part_of_vertexcolors.obj",
                             "assimp/OBJ/regr_3429812.obj",
                             "tinyobj/cube-vertexcol.obj",
                             "tinyobj/issue-161-inconsistent-f.obj",
                             "tinyobj/issue-246-usemtl-whitespace.obj",
                             "tinyobj/issue-295-trianguation-failure.obj",
                             "tinyobj/missing_material_file.obj",
                             "tinyobj/no_material.obj",
                             "tinyobj/norm-texopt.obj",
                             "tinyobj/texture-options-issue-85.obj",
                             "tinyobj/tr-and-d-issue-43.obj",
                             "tinyobj/usemtl-issue-104.obj",
                             "synth/md2_ok_2frames.md2",
                             "synth/obj_crlf_backslash.obj",
                             "synth/obj_degenerate_tris.obj"})
        EXPECT_GT(loadScene(set + name).triangleCount(), 0u) << name;
    const std::pair<const char*, const char*> refused[] = {
        {"tinyobj/line-prim.obj", "points, lines and curves"},
        {"tinyobj/issue-140-zero-face-idx.obj", "issue-140-zero-face-idx.obj:16"},
        {"magnum/invalid-numbers.obj", "invalid-numbers.obj:14"},
        {"assimp/gltf_IndexOutOfRange/IndexOutOfRange.gltf", "/meshes/0/primitives/0/indices: index 255"},
        {"assimp/gltf_MissingBin/BoxTextured.gltf", "/buffers/0/uri: there is no file"},
        {"synth/md2_frames_past_eof.md2", "the table of 1000 frames"},
        {"synth/obj_negative_index_oob.obj", "obj_negative_index_oob.obj:4"}};
    for (const auto& [name, part] : refused) {
        try {
            loadScene(set + name);
            ADD_FAILURE() << "no error for " << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Input) << name;
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

TEST(RealModel, FirNeedlesAreCutOut) {
    OMBRAGE_DATA_FILE(file, "foliage/fir.obj");
    const Scene scene = loadScene(file);
    const Material& material = scene.materials[std::size_t(scene.meshes[0].material)];
    EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
    ASSERT_GE(material.baseColorTexture, 0);
    EXPECT_TRUE(hasHoles(scene.textures[std::size_t(material.baseColorTexture)]));
}

TEST(RealModel, SponzaIsAnInteriorWithNormalMaps) {
    OMBRAGE_DATA_FILE(file, "scenes/sponza_dabrovic/sponza.obj");
    const Scene scene = loadScene(file);
    const Bounds bounds = scene.bounds();
    EXPECT_NEAR(scene.cameras[0].position.x, bounds.lower.x + 0.2 * (bounds.upper.x - bounds.lower.x), 1e-9);
    EXPECT_GE(std::count_if(scene.materials.begin(), scene.materials.end(),
                            [](const Material& m) { return m.normalTexture >= 0; }),
              10);
}

TEST(RealModel, SibenikHasHeightMaps) {
    OMBRAGE_DATA_FILE(file, "scenes/sibenik/sibenik.obj");
    const Scene scene = loadScene(file);
    EXPECT_GE(std::count_if(scene.materials.begin(), scene.materials.end(),
                            [](const Material& m) { return m.heightTexture >= 0; }),
              5);
    EXPECT_GE(std::count_if(scene.materials.begin(), scene.materials.end(),
                            [](const Material& m) { return m.alphaMode == AlphaMode::Blend; }),
              1);
}

TEST(RealModel, LightsOfAGltfFileReplaceTheSun) {
    OMBRAGE_DATA_FILE(file, "gltf/MixedLightingExample/MixedLightingExample.gltf");
    const Scene scene = loadScene(file);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "Sun");
    EXPECT_EQ(scene.lights[0].type, LightType::Sun);
    // -z turned by the node's quaternion (-0.4886, 0.1165, -0.2006, 0.8411): -(2(xz+wy), 2(yz-wx), 1-2(xx+yy)).
    EXPECT_NEAR(glm::length(scene.lights[0].direction - glm::vec3(-0.3921f, -0.7752f, -0.4954f)), 0.0f, 1e-3f);
    EXPECT_TRUE(warns(scene, "lights are scaled"));
}

}  // namespace
}  // namespace ombrage
