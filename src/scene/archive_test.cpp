// SPDX-License-Identifier: MIT
#include "scene/archive.h"

#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "scene/loaded_scene.h"
#include "scene/scene_fields.h"

namespace ombrage {
namespace {

struct Bytes {
    std::vector<std::byte> bytes;
    void operator()(const void* data, std::size_t size) {
        const std::byte* first = static_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), first, first + size);
    }
};

/// Gives every member another value: a walk over the members like that of the archives, so none can be forgotten.
struct Filler {
    int next = 1;

    template <typename... T>
    void operator()(T&... values) {
        (fill(values), ...);
    }
    void fill(bool& value) { value = !value; }
    void fill(std::string& text) { text = "text " + std::to_string(next++); }
    template <typename T>
    void fill(std::optional<T>& value) {
        fill(value.emplace());
    }
    template <typename T>
    void fill(std::vector<T>& values) {
        values.resize(3);
        for (T& value : values) fill(value);
    }
    template <int N, typename T, glm::qualifier Q>
    void fill(glm::vec<N, T, Q>& v) {
        for (int i = 0; i < N; ++i) fill(v[i]);
    }
    void fill(glm::dmat4& m) {
        for (int i = 0; i < 4; ++i) fill(m[i]);
    }
    template <typename T>
    void fill(T& value) {
        if constexpr (std::is_arithmetic_v<T>)
            value = T(next++);
        else if constexpr (std::is_enum_v<T>)
            value = T(1);
        else
            fields(*this, value);
    }
};

template <typename T>
std::vector<std::byte> archived(const T& value) {
    Bytes sink;
    ArchiveWriter archive(sink);
    archive(value);
    return sink.bytes;
}

Scene filledScene() {
    Scene scene;
    Filler filler;
    filler(scene);
    return scene;
}

TEST(Archive, EveryMemberOfASceneComesBack) {
    const Scene scene = filledScene();
    const std::vector<std::byte> bytes = archived(scene);
    Scene back;
    ArchiveReader reader(bytes);
    reader(back);
    EXPECT_EQ(reader.left(), 0u);
    EXPECT_EQ(archived(back), bytes);
    EXPECT_EQ(contentHash(back), contentHash(scene));
    // A few known answers, in case both ways share a mistake.
    ASSERT_EQ(back.textures.size(), 3u);
    EXPECT_EQ(back.textures[2].rgba, scene.textures[2].rgba);
    EXPECT_FALSE(back.textures[2].srgb);
    EXPECT_EQ(back.meshes[1].indices, scene.meshes[1].indices);
    EXPECT_EQ(back.instances[2].worldFromLocal, scene.instances[2].worldFromLocal);
    EXPECT_EQ(back.cameras[0].orthoHeight_m, scene.cameras[0].orthoHeight_m);
    EXPECT_EQ(back.lights[1].excludedModels, scene.lights[1].excludedModels);
    EXPECT_EQ(back.warnings, scene.warnings);
    EXPECT_EQ(back.aoRadius_m, scene.aoRadius_m);
}

TEST(Archive, EveryShorterTextIsRefused) {
    const std::vector<std::byte> bytes = archived(filledScene());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
        Scene back;
        ArchiveReader reader(cut);
        EXPECT_THROW(reader(back), ArchiveError) << size << " of " << bytes.size();
    }
}

TEST(Archive, FalseCountsAllocateNothing) {
    // Counts near 2^64 and counts that overflow when multiplied by the element's size.
    for (const std::uint64_t count : {~std::uint64_t(0), std::uint64_t(1) << 62, std::uint64_t(1) << 40}) {
        const std::vector<std::byte> bytes = archived(count);
        std::string text;
        std::vector<glm::vec4> plain;
        std::vector<Mesh> structs;
        EXPECT_THROW(ArchiveReader{bytes}(text), ArchiveError);
        EXPECT_THROW(ArchiveReader{bytes}(plain), ArchiveError);
        EXPECT_THROW(ArchiveReader{bytes}(structs), ArchiveError);
    }
}

TEST(Archive, DamagedBytesNeverCrash) {
    const std::vector<std::byte> good = archived(filledScene());
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::byte> bytes = good;
        for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = std::byte(random());
        try {
            Scene back;
            ArchiveReader reader(bytes);
            reader(back);
            static_cast<void>(brokenRule(back));
        } catch (const ArchiveError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);  // most hits are in numbers, where they are values like others
}

TEST(Archive, AWholeSceneFileIsToldFromADamagedOne) {
    LoadedScene loaded{{"a.obj", "/tmp", false, true}, {}, loadScene("gap")};
    loaded.dependencies.push_back({Dependency::Kind::Search, "folder", "name", "answer", {1, 2}});
    std::FILE* const file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    ASSERT_TRUE(writeLoadedScene(fileno(file), loaded));
    std::fseek(file, 0, SEEK_END);
    std::vector<std::byte> bytes(std::size_t(std::ftell(file)));
    std::rewind(file);
    ASSERT_EQ(std::fread(bytes.data(), 1, bytes.size(), file), bytes.size());
    std::fclose(file);

    ASSERT_TRUE(isWholeArchive(bytes));
    EXPECT_EQ(readArchivedRequest(bytes).request, loaded.request);
    EXPECT_EQ(readArchivedRequest(bytes).dependencies.at(0).fingerprint, loaded.dependencies[0].fingerprint);
    EXPECT_EQ(contentHash(readLoadedScene(bytes).scene), contentHash(loaded.scene));
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        std::vector<std::byte> damaged = bytes;
        damaged[random() % bytes.size()] ^= std::byte(1u << (random() % 8));
        EXPECT_FALSE(isWholeArchive(damaged));
        EXPECT_FALSE(isWholeArchive(std::span(bytes).first(random() % bytes.size())));
    }
}

TEST(SceneRules, EachIsEnforced) {
    const Scene good = loadScene("gap");
    EXPECT_EQ(brokenRule(good), "");
    const auto breaks = [&](auto change) {
        Scene scene = good;
        change(scene);
        return !brokenRule(scene).empty();
    };
    EXPECT_TRUE(breaks([](Scene& s) { s.meshes[0].indices[2] = std::uint32_t(s.meshes[0].positions.size()); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.meshes[0].indices.pop_back(); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.meshes[0].normals.pop_back(); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.meshes[0].material = int(s.materials.size()); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.materials[0].normalTexture = 0; }));
    EXPECT_TRUE(breaks([](Scene& s) { s.materials[0].alphaMode = AlphaMode(7); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.textures.push_back({"t", 2, 2, true, std::vector<std::uint8_t>(15)}); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.textures.push_back({"t", 1 << 30, 1 << 30, true, {}}); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.instances[0].mesh = -1; }));
    EXPECT_TRUE(breaks([](Scene& s) { s.instances[0].model = 99; }));
    EXPECT_TRUE(breaks([](Scene& s) { s.instances[0].worldFromLocal[3][1] = std::nan(""); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.lights[0].type = LightType(9); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.lights[0].excludedModels = {-1}; }));
    EXPECT_TRUE(breaks([](Scene& s) { s.lights.clear(); }));
    EXPECT_TRUE(breaks([](Scene& s) { s.cameras.clear(); }));
}

}  // namespace
}  // namespace ombrage
