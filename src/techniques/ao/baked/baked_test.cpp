// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "techniques/ambient_measure.h"
#include "techniques/ao/baked/layout.h"
#include "techniques/corner_picture.h"

namespace ombrage::test {
namespace {

using baked::Block;
using baked::Layout;
using baked::Store;

Layout layoutOf(const FlatScene& flat, Store store, std::uint64_t samples, int largest = 8192) {
    return baked::makeLayout(flat, std::vector<bool>(flat.instances.size(), true), store, samples, largest);
}

TEST(BakedLayout, CornersOfABlockAreThoseOfItsTriangle) {
    const Block block{0, 7, 3};
    EXPECT_EQ(baked::weightsOf(block, 0, 0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(baked::weightsOf(block, 7, 0), glm::dvec3(0, 1, 0));
    // The last row is one point.
    for (const int i : {0, 4, 7}) EXPECT_EQ(baked::weightsOf(block, i, 3), glm::dvec3(0, 0, 1));
    const glm::dvec3 w = baked::weightsOf(block, 2, 1);
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-15);
    EXPECT_NEAR(w.y, 2.0 / 3 * 2 / 7, 1e-15);
}

TEST(BakedLayout, BlocksOfBothSidesLieApart) {
    const FlatScene flat = flatten(loadScene("cornell"));
    const Layout layout = layoutOf(flat, Store::Texel, 50000);
    std::vector<bool> taken(std::size_t(layout.width) * std::size_t(layout.height), false);
    std::size_t texels = 0;
    for (const Block& block : layout.blocks)
        for (const glm::uvec2& place : block.place)
            for (unsigned y = place.y; y <= place.y + block.up; ++y)
                for (unsigned x = place.x; x <= place.x + block.across; ++x) {
                    ASSERT_LT(int(x), layout.width);
                    ASSERT_LT(int(y), layout.height);
                    ASSERT_FALSE(taken[y * std::size_t(layout.width) + x]);
                    taken[y * std::size_t(layout.width) + x] = true;
                    ++texels;
                }
    // As many as were asked for, less what rounding up to whole texels takes.
    EXPECT_LE(texels, 50000u);
    EXPECT_GE(texels, 40000u);
}

TEST(BakedLayout, TexelsAreAsFarApartAsItSays) {
    const FlatScene flat = flatten(loadScene("cornell"));
    const Layout layout = layoutOf(flat, Store::Texel, 50000);
    for (std::size_t t = 0; t < layout.blocks.size(); ++t) {
        const Block& block = layout.blocks[t];
        const auto corner = [&](int k) { return flat.positions[flat.triangles[t][(block.first + k) % 3]]; };
        EXPECT_LE(glm::distance(corner(0), corner(1)) / float(block.across), layout.spacing_m * 1.00001f);
        for (const int k : {0, 1})
            EXPECT_LE(glm::distance(corner(k), corner(2)) / float(block.up), layout.spacing_m * 1.00001f);
    }
}

TEST(BakedLayout, VerticesNeedBlocksOfOneTexelAside) {
    const FlatScene flat = flatten(loadScene("cornell"));
    for (const Block& block : layoutOf(flat, Store::Vertex, 50000).blocks) EXPECT_TRUE(block.isCoarse());
}

TEST(BakedLayout, SaysWhatDoesNotFit) {
    const FlatScene flat = flatten(loadScene("menger"));
    EXPECT_THROW(layoutOf(flat, Store::Texel, 8000000, 1024), Error);
}

TEST(Baked, AWallHasItsClosedForm) {
    // Texels of less than a metre on 128 m of floor and wall; the curve bends by less than 0.01 between them but for
    // the first metre. 256 rays leave 0.01.
    const CornerPicture picture(20, 64);
    const std::vector<float> row = picture.row("ao/baked:radius=16,samples=256,texels=100000");
    for (std::size_t i = 0; i < row.size(); ++i)
        EXPECT_NEAR(row[i], CornerPicture::nearWall(double(i) + 0.5, 16), i == 0 ? 0.03 : 0.015) << i;
}

TEST(Baked, EachSideOfASheetHasItsOwn) {
    // A sheet that hangs 1 m over another, its front up or down: seen from above it is open either way.
    for (const bool isFrontUp : {true, false}) {
        Scene scene = emptyScene(64);
        addQuad(scene, {{-60, -60, 0}, {60, -60, 0}, {60, 60, 0}, {-60, 60, 0}}, 0.0f);
        std::vector<glm::vec3> sheet{{-50, -50, 1}, {50, -50, 1}, {50, 50, 1}, {-50, 50, 1}};
        if (!isFrontUp) std::reverse(sheet.begin(), sheet.end());
        addQuad(scene, sheet, 0.0f);
        RenderSettings settings = squareSettings(64);
        settings.ao = parsePipeline(Family::Ao, "ao/baked:texels=10000,samples=1024");
        const RenderResult above = renderFlat(scene, settings);
        for (const float v : above.ao->plane(0)) ASSERT_EQ(v, 1.0f) << isFrontUp;

        // An eye between both sees what rays of 8 m to a plane 1 m away leave: c^2 = 1/64. Four deviations of 1024
        // rays.
        scene.cameras[0].position.z = 0.5;
        scene.cameras[0].target.z = 10;
        scene.cameras[0].up = {0, 1, 0};
        const RenderResult between = renderFlat(scene, settings);
        for (const float v : between.ao->plane(0)) ASSERT_NEAR(v, 1.0 / 64, 4 * 0.124 / 32) << isFrontUp;
    }
}

/// A cache folder that goes away with the test; the environment names it meanwhile.
class TemporaryFolder {
public:
    TemporaryFolder() {
        char name[] = "/tmp/ombrage-baked-XXXXXX";
        m_path = mkdtemp(name);
        if (const char* before = std::getenv("OMBRAGE_CACHE")) m_before = before;
        setenv("OMBRAGE_CACHE", m_path.c_str(), 1);
    }
    ~TemporaryFolder() {
        if (m_before)
            setenv("OMBRAGE_CACHE", m_before->c_str(), 1);
        else
            unsetenv("OMBRAGE_CACHE");
        std::filesystem::remove_all(m_path);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::vector<std::filesystem::path> bakes() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(m_path))
            if (entry.path().extension() == ".ao") found.push_back(entry.path());
        return found;
    }

private:
    std::filesystem::path m_path;
    std::optional<std::string> m_before;
};

TEST(Baked, IsKeptWithTheSceneAndReused) {
    const TemporaryFolder folder;
    const Scene scene = loadScene("cornell");
    const RenderSettings settings = AmbientMeasure::settings("ao/baked:texels=20000,samples=16");
    const auto draw = [&](const Scene& shown) {
        Renderer renderer;
        renderer.setScene(shown);
        return measuredPlane(renderer.render(settings), Family::Ao);
    };
    const std::vector<float> first = draw(scene);
    ASSERT_EQ(folder.bakes().size(), 1u);
    EXPECT_EQ(draw(scene), first);

    // What the file says is what is shown: another run has no need to bake.
    const std::filesystem::path file = folder.bakes().front();
    const auto size = std::filesystem::file_size(file);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << std::string(size, '\0');
    const std::vector<float> empty = draw(scene);
    EXPECT_EQ(*std::min_element(empty.begin(), empty.end()), 0.0f);
    for (std::size_t i = 0; i < empty.size(); ++i) ASSERT_TRUE(empty[i] == 0.0f || first[i] == 1.0f) << i;
    // One of another length is made again.
    std::filesystem::resize_file(file, size / 2);
    EXPECT_EQ(draw(scene), first);
    EXPECT_EQ(std::filesystem::file_size(file), size);

    // Lights and cameras change no occlusion, geometry does.
    Scene other = scene;
    other.lights[0].position.x += 0.1;
    draw(other);
    EXPECT_EQ(folder.bakes().size(), 1u);
    other.instances.back().worldFromLocal[3].x += 0.1;
    draw(other);
    EXPECT_EQ(folder.bakes().size(), 2u);
}

TEST(Baked, WhatMovesIsBakedAnewAndNotKept) {
    const TemporaryFolder folder;
    const Scene scene = loadScene("cornell");
    Renderer renderer;
    renderer.setScene(scene);
    const RenderSettings settings = AmbientMeasure::settings("ao/baked:texels=20000,samples=16");
    const std::vector<float> before = measuredPlane(renderer.render(settings), Family::Ao);
    Scene moved = scene;
    moved.instances.back().worldFromLocal[3].x -= 0.2;
    renderer.moveScene(moved);
    const std::vector<float> after = measuredPlane(renderer.render(settings), Family::Ao);
    EXPECT_NE(after, before);
    EXPECT_EQ(folder.bakes().size(), 1u);
    EXPECT_EQ(after, measuredPlane(renderScene(moved, settings), Family::Ao));
}

TEST(Baked, TexelsHoldWhatVerticesCannot) {
    // Few large triangles hold no contact at their vertices.
    const AmbientMeasure measure("sphere", "T1", 512);
    EXPECT_GE(*measure.of("ao/baked").at("psnr"), 24.0);
    EXPECT_LT(*measure.of("ao/baked:store=vertex").at("psnr"), *measure.of("ao/baked").at("psnr"));
}

}  // namespace
}  // namespace ombrage::test
