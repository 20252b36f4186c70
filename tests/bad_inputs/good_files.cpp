// SPDX-License-Identifier: MIT
#include "good_files.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include <ombrage/image.h>

namespace ombrage::bad_inputs {

namespace fs = std::filesystem;

namespace {
template <typename T>
void append(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

/// A wavy grid: enough text for 200 different cuts.
constexpr int kSide = 9;

float height(int x, int y) {
    return float((x * 7 + y * 5) % 4) / 4.0f;
}

std::string objText() {
    std::string text = "mtllib m.mtl\no grid\n";
    const auto number = [](int tenths) { return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10); };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            text += "v " + std::to_string(x) + " " + number(int(height(x, y) * 10)) + " " + std::to_string(y) + "\n";
            text += "vt " + number(x) + " " + number(y) + "\nvn 0 1 0\n";
        }
    text += "usemtl paint\ns 1\n";
    const auto corner = [](int i) {
        return " " + std::to_string(i) + "/" + std::to_string(i) + "/" + std::to_string(i);
    };
    for (int y = 0; y + 1 < kSide; ++y)
        for (int x = 0; x + 1 < kSide; ++x) {
            const int i = y * kSide + x + 1;
            text += "f" + corner(i) + corner(i + kSide) + corner(i + kSide + 1) + corner(i + 1) + "\n";
        }
    return text;
}

std::string mtlText(const std::string& texture) {
    return "newmtl paint\nKd 0.5 0.4 0.3\nKs 0.2 0.2 0.2\nNs 30\nd 1\nKe 0 0 0\nillum 2\nmap_Kd -s 1 1 1 " + texture +
           "\nmap_d " + texture + "\nnewmtl other\nKd 1 0 0\n";
}

std::string vertexBuffer() {
    std::string bytes;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (const float value : {float(x), height(x, y), float(y)}) append(bytes, value);
    for (int y = 0; y + 1 < kSide; ++y)
        for (int x = 0; x + 1 < kSide; ++x) {
            const int i = y * kSide + x;
            for (const int k : {i, i + kSide, i + 1, i + 1, i + kSide, i + kSide + 1}) append(bytes, std::uint16_t(k));
        }
    return bytes;
}

std::string gltfText(const std::string& uri) {
    const std::string positions = std::to_string(kSide * kSide * 12);
    const std::string indices = std::to_string((kSide - 1) * (kSide - 1) * 12);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,1,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.4,0.3,1]}}],
"buffers":[{)" +
           uri + "\"byteLength\":" + std::to_string(vertexBuffer().size()) + R"(}],
"bufferViews":[{"buffer":0,"byteLength":)" +
           positions + R"(},{"buffer":0,"byteOffset":)" + positions + R"(,"byteLength":)" + indices + R"(}],
"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
           std::to_string(kSide * kSide) + R"(,"type":"VEC3","min":[0,0,0],"max":[8,0.75,8]},
{"bufferView":1,"componentType":5123,"count":)" +
           std::to_string((kSide - 1) * (kSide - 1) * 6) + R"(,"type":"SCALAR"}]})";
}

std::string glbBytes() {
    std::string json = gltfText(""), buffer = vertexBuffer();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    append(bytes, std::uint32_t(2));
    append(bytes, std::uint32_t(12 + 8 + json.size() + 8 + buffer.size()));
    append(bytes, std::uint32_t(json.size()));
    bytes += "JSON" + json;
    append(bytes, std::uint32_t(buffer.size()));
    bytes += std::string("BIN\0", 4) + buffer;
    return bytes;
}

std::string plyBytes(bool binary) {
    const int quads = (kSide - 1) * (kSide - 1);
    std::string bytes = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                        " 1.0\ncomment a grid\nelement vertex " + std::to_string(kSide * kSide) +
                        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                        std::to_string(quads) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (binary)
                for (const float value : {float(x), height(x, y), float(y)}) append(bytes, value);
            else
                bytes += std::to_string(x) + " 0." + std::to_string(int(height(x, y) * 100)) + " " + std::to_string(y) +
                         "\n";
        }
    for (int y = 0; y + 1 < kSide; ++y)
        for (int x = 0; x + 1 < kSide; ++x) {
            const int i = y * kSide + x, corners[4] = {i, i + kSide, i + kSide + 1, i + 1};
            if (binary)
                bytes += '\4';
            else
                bytes += "4";
            for (const int corner : corners) {
                if (binary)
                    append(bytes, std::int32_t(corner));
                else
                    bytes += " " + std::to_string(corner);
            }
            if (!binary) bytes += "\n";
        }
    return bytes;
}

/// A tetrahedron in two frames with a skin's name.
std::string md2Bytes() {
    constexpr int kVertices = 4, kTriangles = 4, kFrameSize = 40 + 4 * kVertices;
    std::string bytes = "IDP2";
    const int skins = 68, coordinates = skins + 64, triangles = coordinates + 4 * kVertices,
              frames = triangles + 12 * kTriangles;
    const int commands = frames + 2 * kFrameSize, end = commands + 4;
    for (const int value : {8, 64, 64, kFrameSize, 1, kVertices, kVertices, kTriangles, 1, 2, skins, coordinates,
                            triangles, frames, commands, end})
        append(bytes, std::int32_t(value));
    std::string skin = "skin.pcx";
    skin.resize(64, '\0');
    bytes += skin;
    for (const int s : {0, 0, 63, 0, 0, 63, 63, 63}) append(bytes, std::int16_t(s));
    for (const auto& t : {std::array{0, 1, 2}, std::array{0, 3, 1}, std::array{0, 2, 3}, std::array{1, 3, 2}})
        for (int twice = 0; twice < 2; ++twice)
            for (const int corner : t) append(bytes, std::uint16_t(corner));
    for (int frame = 0; frame < 2; ++frame) {
        for (const float value : {0.1f, 0.1f, 0.1f, 0.0f, 0.0f, float(frame)}) append(bytes, value);
        std::string name = "stand" + std::to_string(frame);
        name.resize(16, '\0');
        bytes += name;
        for (const auto& v :
             {std::array{0, 0, 0}, std::array{200, 0, 0}, std::array{0, 200, 0}, std::array{0, 0, 200}}) {
            for (const int value : v) bytes += char(value);
            bytes += '\0';
        }
    }
    append(bytes, std::int32_t(0));
    return bytes;
}

/// 16 x 16 texels, 256 colours, runs of one.
std::string pcxBytes() {
    std::string bytes = {10, 5, 1, 8};
    for (const int value : {0, 0, 15, 15, 72, 72}) append(bytes, std::uint16_t(value));
    bytes.resize(65, '\0');
    bytes += '\1';
    append(bytes, std::uint16_t(16));
    append(bytes, std::uint16_t(1));
    bytes.resize(128, '\0');
    for (int i = 0; i < 256; ++i) bytes += char(i % 160);
    bytes += '\x0c';
    for (int i = 0; i < 768; ++i) bytes += char(i);
    return bytes;
}

std::string bmpBytes() {
    std::string bytes = "BM";
    append(bytes, std::uint32_t(54 + 16 * 16 * 3));
    append(bytes, std::uint32_t(0));
    append(bytes, std::uint32_t(54));
    for (const int value : {40, 16, 16}) append(bytes, std::uint32_t(value));
    append(bytes, std::uint16_t(1));
    append(bytes, std::uint16_t(24));
    for (const int value : {0, 16 * 16 * 3, 2835, 2835, 0, 0}) append(bytes, std::uint32_t(value));
    for (int i = 0; i < 16 * 16 * 3; ++i) bytes += char(i * 5);
    return bytes;
}

std::string tgaBytes() {
    std::string bytes("\0\0\2\0\0\0\0\0\0\0\0\0\x10\0\x10\0\x18\x20", 18);
    for (int i = 0; i < 16 * 16 * 3; ++i) bytes += char(i * 3);
    return bytes;
}

Image picture() {
    Image image(40, 40, {"R", "G", "B"}, ColorSpace::Srgb);
    for (int plane = 0; plane < 3; ++plane)
        for (std::size_t i = 0; i < image.pixelCount(); ++i)
            image.plane(plane)[i] = float((i * std::size_t(13 + 8 * plane)) % 251) / 250.0f;
    return image;
}

const char* const kSceneText = R"({
  "name": "table", "description": "a scene to cut",
  "models": [ { "name": "grid", "file": "m.obj", "position": [0, 0.5, 0], "rotation_deg": [0, 20, 0], "scale": [1, 2, 1] } ],
  "lights": [
    { "name": "lamp", "type": "point", "position": [0.8, 2.2, 0.9], "intensity": 14, "radius_m": 0.08 },
    { "name": "sun", "type": "sun", "direction": [-1, -2, -0.7], "angle_deg": 0.53, "exclude": ["grid"] } ],
  "cameras": [ { "name": "main", "position": [2.1, 8.5, 12.3], "target": [4, 0.4, 4], "fov_deg": 45 } ],
  "animations": [ { "type": "orbit-light", "light": "lamp", "period_s": 8 } ],
  "techniques": ["shadow/none"], "ambient": 0.2, "ao_radius_m": 0.3
}
)";
}  // namespace

void writeFile(const fs::path& file, const std::string& content) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

std::string readFile(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<GoodFile> writeGoodFiles(const fs::path& folder) {
    std::vector<GoodFile> files;
    const auto add = [&](const std::string& kind, const std::string& opened, const std::string& cut) {
        files.push_back({kind, opened, cut, folder / kind});
        return folder / kind;
    };
    writeFile(add("obj", "m.obj", "m.obj") / "m.obj", objText());
    fs::path place = add("mtl", "m.obj", "m.mtl");
    writeFile(place / "m.obj", objText());
    writeFile(place / "m.mtl", mtlText("t.png"));
    place = add("gltf", "m.gltf", "m.gltf");
    writeFile(place / "m.gltf", gltfText("\"uri\":\"m.bin\","));
    writeFile(place / "m.bin", vertexBuffer());
    place = add("gltf-buffer", "m.gltf", "m.bin");
    writeFile(place / "m.gltf", gltfText("\"uri\":\"m.bin\","));
    writeFile(place / "m.bin", vertexBuffer());
    writeFile(add("glb", "m.glb", "m.glb") / "m.glb", glbBytes());
    writeFile(add("ply-ascii", "m.ply", "m.ply") / "m.ply", plyBytes(false));
    writeFile(add("ply-binary", "m.ply", "m.ply") / "m.ply", plyBytes(true));
    writeFile(add("md2", "m.md2", "m.md2") / "m.md2", md2Bytes());
    place = add("scene", "s.json", "s.json");
    writeFile(place / "s.json", kSceneText);
    writeFile(place / "m.obj", objText());
    // Textures, by way of a material.
    for (const char* kind : {"png", "jpg", "bmp", "tga", "pcx", "exr"}) {
        const std::string texture = std::string("t.") + kind;
        place = add(kind, "m.obj", texture);
        writeFile(place / "m.obj", objText());
        writeFile(place / "m.mtl", mtlText(texture));
        if (kind == std::string("bmp"))
            writeFile(place / texture, bmpBytes());
        else if (kind == std::string("tga"))
            writeFile(place / texture, tgaBytes());
        else if (kind == std::string("pcx"))
            writeFile(place / texture, pcxBytes());
        else
            writeImage(place / texture, picture());
    }
    place = add("md2-skin", "m.md2", "skin.pcx");
    writeFile(place / "m.md2", md2Bytes());
    writeFile(place / "skin.pcx", pcxBytes());
    return files;
}

std::vector<GoodFile> realFiles(const fs::path& data) {
    std::vector<GoodFile> files;
    const auto add = [&](const char* folder, const char* opened, const char* cut) {
        if (fs::exists(data / folder / opened) && fs::exists(data / folder / cut))
            files.push_back({std::string("real ") + cut, opened, cut, data / folder});
    };
    add("scenes/cornell_box", "cornell_box.obj", "cornell_box.obj");
    add("meshes", "suzanne.obj", "suzanne.obj");
    add("meshes", "dragon_vrip_res4.ply", "dragon_vrip_res4.ply");
    add("gltf", "Fox.glb", "Fox.glb");
    add("gltf/BoxTextured", "BoxTextured.gltf", "BoxTextured.gltf");
    add("md2/ufoai_crocodile", "croc.md2", "croc.md2");
    add("md2/sydney", "sydney.md2", "sydney.pcx");
    return files;
}

}  // namespace ombrage::bad_inputs
