// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <tuple>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/scene.h>
#include <nlohmann/json.hpp>

#include "scene/test_files.h"

namespace ombrage {
namespace {

using Json = nlohmann::json;

std::string base64(const std::string& bytes) {
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value = value << 8 | (i + k < bytes.size() ? (unsigned char)bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[value >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

template <typename T>
std::string bytesOf(std::initializer_list<T> values) {
    std::string bytes;
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return bytes;
}

/// Puts a glTF file together: one buffer, one mesh of one primitive, one node.
class Gltf {
public:
    Gltf() {
        json = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"name":"m","primitives":[{"attributes":{}}]}],"accessors":[],"bufferViews":[]})");
    }
    int view(const std::string& bytes, int stride = 0) {
        Json made{{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes.size()}};
        if (stride > 0) made["byteStride"] = stride;
        json["bufferViews"].push_back(made);
        m_bytes += bytes;
        m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');
        return int(json["bufferViews"].size()) - 1;
    }
    int accessor(int viewIndex, int componentType, int count, const char* type, bool normalized = false) {
        Json made{{"componentType", componentType}, {"count", count}, {"type", type}};
        if (viewIndex >= 0) made["bufferView"] = viewIndex;
        if (normalized) made["normalized"] = true;
        json["accessors"].push_back(made);
        return int(json["accessors"].size()) - 1;
    }
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    void attribute(const char* name, int accessorIndex) { primitive()["attributes"][name] = accessorIndex; }
    /// (0,0,0), (1,0,0), (0,1,0) and, behind them, (1,1,0).
    void square() {
        attribute("POSITION", accessor(view(bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})), 5126, 4, "VEC3"));
        primitive()["indices"] = accessor(view(bytesOf<std::uint16_t>({0, 1, 2, 2, 1, 3})), 5123, 6, "SCALAR");
    }
    std::string text() {
        json["buffers"] = {
            {{"byteLength", m_bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(m_bytes)}}};
        return json.dump();
    }
    std::string glb() {
        json["buffers"] = {{{"byteLength", m_bytes.size()}}};
        std::string head = json.dump();
        head.resize((head.size() + 3) / 4 * 4, ' ');
        const auto size = [](std::size_t n) { return std::uint32_t(n); };
        return "glTF" +
               bytesOf<std::uint32_t>({2, size(28 + head.size() + m_bytes.size()), size(head.size()), 0x4e4f534a}) +
               head + bytesOf<std::uint32_t>({size(m_bytes.size()), 0x004e4942}) + m_bytes;
    }
    Json json;

private:
    std::string m_bytes;
};

class GltfFile : public testing::Test {
protected:
    Scene load(Gltf& gltf) { return loadScene(m_folder.write("m.gltf", gltf.text())); }
    std::string refusal(Gltf& gltf) { return refusalOf(m_folder.write("m.gltf", gltf.text())); }
    static std::string refusalOf(const std::string& file) {
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
    /// The vertex at a position, which must be there.
    static std::size_t vertexAt(const Mesh& mesh, const glm::vec3& p) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (glm::length(mesh.positions[i] - p) < 1e-4f) return i;
        ADD_FAILURE() << "no vertex at " << p.x << " " << p.y << " " << p.z;
        return 0;
    }
    TestFolder m_folder;
};

TEST_F(GltfFile, DataUriFileAndGlb) {
    Gltf gltf;
    gltf.square();
    EXPECT_EQ(load(gltf).triangleCount(), 2u);
    const std::string glb = gltf.glb();
    EXPECT_EQ(loadScene(m_folder.write("m.glb", glb)).triangleCount(), 2u);
    for (std::size_t size = 0; size < glb.size(); size += 7) refusalOf(m_folder.write("t.glb", glb.substr(0, size)));
    gltf.text();
    gltf.json["buffers"][0]["uri"] = "my%20data.bin";
    EXPECT_NE(refusalOf(m_folder.write("f.gltf", gltf.json.dump())).find("/buffers/0/uri"), std::string::npos);
    m_folder.write("my data.bin",
                   bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}) + bytesOf<std::uint16_t>({0, 1, 2, 2, 1, 3}));
    EXPECT_EQ(loadScene(m_folder.write("f.gltf", gltf.json.dump())).triangleCount(), 2u);
}

TEST_F(GltfFile, QuantizedAndInterleaved) {
    Gltf gltf;
    gltf.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    gltf.json["nodes"][0]["scale"] = {2, 2, 2};
    // Every vertex: position as 3 shorts (normalised) and 2 bytes of padding, normal as 3 bytes and 1, uv as 2 shorts.
    std::string bytes;
    const std::int16_t positions[3][3] = {{0, 0, 0}, {32767, 0, 0}, {0, 32767, 0}};
    const std::uint16_t uvs[3][2] = {{0, 0}, {65535, 0}, {0, 65535}};
    for (int i = 0; i < 3; ++i)
        bytes += bytesOf<std::int16_t>({positions[i][0], positions[i][1], positions[i][2], 99}) +
                 bytesOf<std::int8_t>({0, 0, 127, 99}) + bytesOf<std::uint16_t>({uvs[i][0], uvs[i][1]});
    const int view = gltf.view(bytes, 16);
    gltf.attribute("POSITION", gltf.accessor(view, 5122, 3, "VEC3", true));
    const int normals = gltf.accessor(view, 5120, 3, "VEC3", true), uv = gltf.accessor(view, 5123, 3, "VEC2", true);
    gltf.json["accessors"][1]["byteOffset"] = 8;
    gltf.json["accessors"][2]["byteOffset"] = 12;
    gltf.attribute("NORMAL", normals);
    gltf.attribute("TEXCOORD_0", uv);
    const Scene scene = load(gltf);
    EXPECT_EQ(scene.bounds().upper, glm::dvec3(2, 2, 0));
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.uvs[vertexAt(mesh, {0, 1, 0})], glm::vec2(0, 1));
}

TEST_F(GltfFile, SparseAccessorsOverZerosAndOverValues) {
    Gltf gltf;
    const int at = gltf.view(bytesOf<std::uint8_t>({1, 2})), values = gltf.view(bytesOf<float>({3, 0, 0, 0, 4, 0}));
    const Json sparse{
        {"count", 2}, {"indices", {{"bufferView", at}, {"componentType", 5121}}}, {"values", {{"bufferView", values}}}};
    gltf.attribute("POSITION", gltf.accessor(-1, 5126, 3, "VEC3"));
    gltf.json["accessors"][0]["sparse"] = sparse;
    EXPECT_EQ(load(gltf).bounds().upper, glm::dvec3(3, 4, 0));
    const int base = gltf.view(bytesOf<float>({-1, 0, 0, 9, 9, 9, 9, 9, 9}));
    gltf.json["accessors"][0]["bufferView"] = base;
    const Bounds bounds = load(gltf).bounds();
    EXPECT_EQ(bounds.lower, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(bounds.upper, glm::dvec3(3, 4, 0));
    gltf.json["accessors"][0]["sparse"]["count"] = 3;
    EXPECT_NE(refusal(gltf).find("/accessors/0/sparse/indices"), std::string::npos);
}

TEST_F(GltfFile, TextureTransformSetAndColors) {
    Gltf gltf;
    gltf.square();
    gltf.attribute("TEXCOORD_0", gltf.accessor(gltf.view(bytesOf<float>({9, 9, 9, 9, 9, 9, 9, 9})), 5126, 4, "VEC2"));
    gltf.attribute("TEXCOORD_1", gltf.accessor(gltf.view(bytesOf<float>({0, 0, 1, 0, 0, 1, 1, 1})), 5126, 4, "VEC2"));
    gltf.attribute("COLOR_0", gltf.accessor(gltf.view(bytesOf<std::uint8_t>(
                                                {255, 0, 0, 255, 0, 51, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255})),
                                            5121, 4, "VEC4", true));
    gltf.primitive()["material"] = 0;
    // A PNG inside the buffer.
    const auto png = encodePng(Image::rgb(1, 1, ColorSpace::Srgb));
    gltf.json["images"] = {{{"bufferView", gltf.view(std::string(png.begin(), png.end()))}, {"mimeType", "image/png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"] = Json::parse(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":0,
        "extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"rotation":1.5707963267948966,"scale":[2,3],"texCoord":1}}}}}])");
    gltf.json["extensionsRequired"] = {"KHR_texture_transform"};
    const Scene scene = load(gltf);
    ASSERT_EQ(scene.textures.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    // The extension's matrices: translation * rotation * scale, rotation by 90 degrees: (u, v) -> (3v, -2u) + offset.
    EXPECT_NEAR(glm::length(mesh.uvs[vertexAt(mesh, {1, 0, 0})] - glm::vec2(0.5f, 0.25f - 2.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(mesh.uvs[vertexAt(mesh, {0, 1, 0})] - glm::vec2(0.5f + 3.0f, 0.25f)), 0.0f, 1e-6f);
    // Colours are linear already.
    EXPECT_EQ(mesh.colors[vertexAt(mesh, {1, 0, 0})], glm::vec3(0, 0.2f, 0));
}

TEST_F(GltfFile, StripsFansAndBytesAsIndices) {
    for (const auto& [mode, order, facing] : {std::tuple{5, std::vector<std::uint8_t>{0, 1, 2, 3}, 1.0f},
                                              std::tuple{6, std::vector<std::uint8_t>{0, 1, 3, 2}, 1.0f}}) {
        Gltf gltf;
        gltf.square();
        gltf.primitive()["mode"] = mode;
        gltf.primitive()["indices"] =
            gltf.accessor(gltf.view(std::string(order.begin(), order.end())), 5121, int(order.size()), "SCALAR");
        const Scene scene = load(gltf);
        ASSERT_EQ(scene.triangleCount(), 2u) << mode;
        for (const glm::vec3& n : scene.meshes[0].normals) EXPECT_EQ(n.z, facing) << mode;
    }
    Gltf points;
    points.square();
    points.primitive()["mode"] = 0;
    EXPECT_NE(refusal(points).find("1 primitives of points or lines"), std::string::npos);
}

TEST_F(GltfFile, SkinsAndMorphTargetsStandAsTheFileSays) {
    Gltf gltf;
    gltf.square();
    // One joint, 5 m up and turned by 90 degrees about z; the mesh's own node does not count.
    gltf.json["nodes"] = Json::parse(R"([{"mesh":0,"skin":0,"translation":[100,0,0]},
        {"translation":[0,5,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])");
    gltf.json["scenes"][0]["nodes"] = {0, 1};
    gltf.json["skins"] = {{{"joints", {1}}}};
    gltf.attribute("JOINTS_0", gltf.accessor(gltf.view(std::string(16, '\0')), 5121, 4, "VEC4"));
    gltf.attribute(
        "WEIGHTS_0",
        gltf.accessor(gltf.view(bytesOf<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})), 5126, 4, "VEC4"));
    // A morph target at half its weight lifts the second corner by 2.
    gltf.primitive()["targets"] = {
        {{"POSITION",
          gltf.accessor(gltf.view(bytesOf<float>({0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0})), 5126, 4, "VEC3")}}};
    gltf.json["meshes"][0]["weights"] = {0.5};
    const Scene scene = load(gltf);
    vertexAt(scene.meshes[0], {0, 6, 2});
    vertexAt(scene.meshes[0], {-1, 5, 0});
    EXPECT_EQ(scene.instances[0].worldFromLocal, glm::dmat4(1.0));
}

TEST_F(GltfFile, ErrorsNameThePlace) {
    const auto expect = [&](const char* message, const std::function<void(Gltf&)>& damage) {
        Gltf gltf;
        gltf.square();
        damage(gltf);
        const std::string text = refusal(gltf);
        EXPECT_NE(text.find(message), std::string::npos) << text;
    };
    expect("/accessors/0: 400 elements", [](Gltf& g) { g.json["accessors"][0]["count"] = 400; });
    expect("/accessors/0: ", [](Gltf& g) { g.json["accessors"][0]["count"] = 9000000000000000000ull; });
    expect("/accessors/0/componentType", [](Gltf& g) { g.json["accessors"][0]["componentType"] = 5130; });
    expect("/accessors/0/count: it is no whole number", [](Gltf& g) { g.json["accessors"][0]["count"] = -3; });
    expect("/accessors/0/bufferView: 7 is not among the 2", [](Gltf& g) { g.json["accessors"][0]["bufferView"] = 7; });
    expect("/accessors/1/type: 1 components where 3", [](Gltf& g) { g.attribute("POSITION", 1); });
    expect("/bufferViews/0: 48 bytes from 40", [](Gltf& g) { g.json["bufferViews"][0]["byteOffset"] = 40; });
    expect("/bufferViews/0/byteStride: 4 is not", [](Gltf& g) { g.json["bufferViews"][0]["byteStride"] = 4; });
    expect("/meshes/0/primitives/0/indices: index 9 at 0", [](Gltf& g) {
        g.primitive()["indices"] = g.accessor(g.view(bytesOf<std::uint16_t>({9, 1, 2})), 5123, 3, "SCALAR");
    });
    expect("/meshes/0/primitives/0/material: 3 is not", [](Gltf& g) { g.primitive()["material"] = 3; });
    expect("/meshes/0/primitives/0/attributes/NORMAL: 6 values for 4",
           [](Gltf& g) { g.attribute("NORMAL", g.accessor(-1, 5126, 6, "VEC3")); });
    expect("/nodes/0/mesh: 5 is not among the 1 of /meshes", [](Gltf& g) { g.json["nodes"][0]["mesh"] = 5; });
    expect("node 0 has two parents, or is its own", [](Gltf& g) { g.json["nodes"][0]["children"] = {0}; });
    expect("/accessors/2/count: 4000000000 elements without a buffer view", [](Gltf& g) {
        g.attribute("NORMAL", g.accessor(-1, 5126, int(0), "VEC3")), g.json["accessors"][2]["count"] = 4000000000u;
    });
    expect("/extensionsRequired/0: the file requires 'KHR_draco_mesh_compression'",
           [](Gltf& g) { g.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; });
    expect("/asset/version: glTF version '1.0'", [](Gltf& g) { g.json["asset"]["version"] = "1.0"; });
    expect("/meshes: the file has no meshes",
           [](Gltf& g) { g.json.erase("meshes"), g.json["nodes"][0].erase("mesh"); });
    EXPECT_NE(refusalOf(m_folder.write("j.gltf", "{\"asset\":\n{,")).find("line 2"), std::string::npos);
}

TEST_F(GltfFile, OneAccessorUsedAgainAndAgainCannotFillTheMemory) {
    Gltf gltf;
    gltf.attribute("POSITION", gltf.accessor(-1, 5126, 1 << 24, "VEC3"));
    const Json primitive = gltf.primitive();
    for (int i = 0; i < 100; ++i) gltf.json["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_NE(refusal(gltf).find("vertices"), std::string::npos);
}

TEST_F(GltfFile, MeshesWithoutNodesStandAtTheOrigin) {
    Gltf gltf;
    gltf.square();
    gltf.json["nodes"] = Json::array();
    gltf.json["scenes"][0].erase("nodes");
    const Scene scene = load(gltf);
    EXPECT_EQ(scene.triangleCount(), 2u);
    EXPECT_FALSE(scene.warnings.empty());
}

}  // namespace
}  // namespace ombrage
