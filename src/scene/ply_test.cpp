// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/scene.h>

#include "scene/test_files.h"

namespace ombrage {
namespace {

std::string refusal(const std::string& file) {
    try {
        loadScene(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return {};
}

const char* const kAscii =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "property float u\nproperty float v\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 2\nproperty uchar flag\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 255 0 0\n2 0 0 1 0 255 255 255\n2 2 0 1 1 0 0 0\n0 2 0 0 1 188 188 188\n0 0 2 .5 .5 255 255 255\n"
    "7 4 0 1 2 3\n8 3 0 1 4\n";

TEST(Ply, AsciiWithPolygonsCoordinatesAndColors) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("a.ply", kAscii));
    EXPECT_EQ(scene.triangleCount(), 3u);
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    EXPECT_EQ(scene.materials[0].baseColor, glm::vec3(1.0f));
    bool sawGrey = false;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i] != glm::vec3(0, 2, 0)) continue;
        sawGrey = true;
        EXPECT_EQ(mesh.uvs[i], glm::vec2(0, 0));  // the file's v counts upwards
        EXPECT_EQ(mesh.colors[i].r, linearFromSrgb(188.0f / 255.0f));
    }
    EXPECT_TRUE(sawGrey);
}

template <typename T>
void put(std::string& bytes, T value, bool big) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big == (std::endian::native == std::endian::little)) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

/// A square and a triangle strip with normals, in either order of bytes, doubles and shorts among the types.
std::string binary(bool big) {
    std::string bytes =
        std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\r\nelement vertex 4\r\nproperty double x\r\nproperty float y\r\nproperty short z\r\n"
        "property float nx\r\nproperty float ny\r\nproperty float nz\r\n"
        "element odd 2\r\nproperty list ushort double stuff\r\n"
        "element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n";
    for (int i = 0; i < 4; ++i) {
        put(bytes, double(i % 2), big);
        put(bytes, float(i / 2), big);
        put(bytes, std::int16_t(-3), big);
        for (const float n : {0.0f, 0.0f, 1.0f}) put(bytes, n, big);
    }
    for (int i = 0; i < 2; ++i) {
        put(bytes, std::uint16_t(i), big);
        if (i == 1) put(bytes, 7.0, big);
    }
    put(bytes, std::int32_t(9), big);
    for (const std::int32_t index : {0, 1, 2, 3, -1, 3, 1, 2, -1}) put(bytes, index, big);
    return bytes;
}

TEST(Ply, BinaryInBothOrdersOfBytes) {
    const TestFolder folder;
    for (const bool big : {false, true}) {
        const Scene scene = loadScene(folder.write("b.ply", binary(big)));
        EXPECT_EQ(scene.triangleCount(), 3u);
        const Bounds bounds = scene.bounds();
        EXPECT_EQ(bounds.lower, glm::dvec3(0, 0, -3));
        EXPECT_EQ(bounds.upper, glm::dvec3(1, 1, -3));
        // The first two triangles of a strip face +z, as their normals say; the third was written the other way round.
        const Mesh& mesh = scene.meshes[0];
        int facing = 0;
        for (std::size_t i = 0; i < 9; i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]];
            const glm::vec3 n =
                glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
            facing += n.z > 0 ? 1 : -1;
        }
        EXPECT_EQ(facing, 1);
        EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    }
}

TEST(Ply, CornersWithCoordinatesOfTheirOwnAndATexture) {
    const TestFolder folder;
    Image image(1, 1, {"R", "G", "B"}, ColorSpace::Srgb);
    image.at(0, 0, 0) = 1.0f;
    writeImage(folder.path() / "skin.png", image);
    const Scene scene = loadScene(
        folder.write("c.ply",
                     "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\n"
                     "property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_index\n"
                     "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
                     "3 0 1 2 6 0 0 1 0 0 1\n3 2 1 0 6 .5 .5 .5 .5 .25 .25\n"));
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.materials[0].baseColorTexture, 0);
    EXPECT_EQ(scene.meshes[0].uvs[scene.meshes[0].indices[5]], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(scene.meshes[0].uvs[scene.meshes[0].indices[0]], glm::vec2(0.0f, 1.0f));
}

TEST(Ply, ErrorsNameThePlace) {
    const TestFolder folder;
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
    const std::pair<std::string, const char*> cases[] = {
        {head + "end_header\n" + corners, "point cloud"},
        {head + faces + corners + "3 0 1 3\n", "face 0: a vertex index is not between 0 and 2"},
        {head + faces + corners + "3 0 1 -1\n", "face 0: a vertex index"},
        {head + faces + corners + "3 0 1\n", "face 0: the file ends here"},
        {head + faces + corners + "4000000 0 1\n", "face 0: a list is longer than the file"},
        {head + faces + "0 0 0\n1 zero 0\n", "vertex 1: 'zero' is no number"},
        {"ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n" +
             faces,
         "4000000000 vertices do not fit"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", ":4: 'half' is no type"},
        {"ply\nformat text 1.0\n", ":2: 'text' is no format"},
        {"ply\nformat ascii 1.0\n", "no 'end_header'"},
        {"plyt\n", ":1: this is no PLY file"}};
    for (const auto& [text, message] : cases)
        EXPECT_NE(refusal(folder.write("x.ply", text)).find(message), std::string::npos) << message;
}

TEST(Ply, EveryTruncationIsAnError) {
    const TestFolder folder;
    for (const std::string& whole : {std::string(kAscii, std::strlen(kAscii) - 2), binary(true)})
        for (std::size_t size = 0; size < whole.size(); size += 3)
            refusal(folder.write("t.ply", whole.substr(0, size)));
}

}  // namespace
}  // namespace ombrage
