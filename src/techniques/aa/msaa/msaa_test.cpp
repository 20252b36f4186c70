// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "techniques/slanted_edge.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

constexpr int kSize = SlantedEdge::kSize_px;

RenderResult renderSmall(const std::string& scene, const std::string& aa, const std::string& shadow = "shadow/none",
                         std::vector<std::string> show = {}) {
    RenderSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.shadow = parsePipeline(Family::Shadow, shadow);
    settings.aa = parsePipeline(Family::Aa, aa);
    settings.show = std::move(show);
    RenderResult result = renderScene(Bench::of(scene).scene(), settings);
    EXPECT_TRUE(result.debugMessages.empty()) << result.debugMessages.front();
    return result;
}

std::vector<std::string> passNames(const RenderResult& result) {
    std::vector<std::string> names;
    for (const PassCost& pass : result.passes) names.push_back(pass.name);
    return names;
}

std::uint64_t drawsOf(const RenderResult& result, const std::string& name) {
    for (const PassCost& pass : result.passes)
        if (pass.name == name) return pass.draws;
    return 0;
}

TEST(Msaa, AnEdgeHasTheShareOfItsSamples) {
    for (const double slope : {0.0, 0.03, 0.37, 0.8}) {
        const auto hard = SlantedEdge::picture(slope, "aa/none", true, 0.21),
                   soft = SlantedEdge::picture(slope, "aa/msaa", true, 0.21);
        for (const float grey : soft) ASSERT_EQ(grey * 4, std::round(grey * 4));
        // Drivers place four samples so that no two share a row, a column or a diagonal: an eighth of a pixel off at
        // the worst, where one sample is half a pixel off.
        EXPECT_LT(SlantedEdge::rmse(soft, slope, 0, 0.21), 0.4 * SlantedEdge::rmse(hard, slope, 0, 0.21)) << slope;
    }
    // An upright edge at 16 places in a pixel: five grades.
    std::set<float> grades;
    for (int i = 0; i < 16; ++i)
        grades.insert(SlantedEdge::picture(0, "aa/msaa", true, 0.01 + i / 16.0)[std::size_t(64 * kSize + 64)]);
    EXPECT_EQ(grades.size(), 5u);
}

TEST(Msaa, AHoleOfATextureIsCutAsAnOutlineIs) {
    // A texture of a hole and a white texel whose border runs where the slanted edge does.
    const double slope = 0.37;
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-99, -99, 0}, {99, -99, 0}, {99, 99, 0}, {-99, 99, 0}}, 1.0f);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3& p = scene.meshes[0].positions[i];
        scene.meshes[0].uvs[i] = {0.5f + (p.x - float(slope) * p.y) / 512.0f, 0.5f};
    }
    scene.textures.push_back({"holes", 2, 1, true, {255, 255, 255, 0, 255, 255, 255, 255}});
    scene.materials[0].alphaMode = AlphaMode::Mask;
    scene.materials[0].baseColorTexture = 0;

    const auto differing = [&](const std::string& aa, const std::string& outline) {
        const auto holes = SlantedEdge::picture(scene, aa), edge = SlantedEdge::picture(slope, outline);
        std::size_t count = 0;
        for (std::size_t i = 0; i < holes.size(); ++i) count += holes[i] != edge[i] ? 1 : 0;
        return count;
    };
    // Rounding decides where an edge meets a sample: at every 100th row of 37 columns, both above and below the middle.
    EXPECT_LE(differing("aa/msaa", "aa/msaa"), 4u);
    EXPECT_LE(differing("aa/msaa:alpha-to-coverage=false", "aa/none"), 4u);
    EXPECT_GT(differing("aa/msaa", "aa/none"), 100u);
}

TEST(Msaa, SurfacesAreAsGoodAsWithEverySampleLit) {
    // Without shadows there is nothing but outlines: as near to the truth as whole frames for each of four samples.
    for (const char* scene : {"fence", "bicycle", "comb"}) {
        const auto errorOf = [&, truth = renderSmall(scene, "aa/ssaa:grid=8").picture](const std::string& aa) {
            const Image picture = renderSmall(scene, aa).picture;
            double sum = 0;
            for (int p = 0; p < 3; ++p)
                for (std::size_t i = 0; i < picture.plane(p).size(); ++i) {
                    const double e = double(picture.plane(p)[i]) - double(truth.plane(p)[i]);
                    sum += e * e;
                }
            return std::sqrt(sum);
        };
        // Measured 1.10, 1.02 and 0.98 of it: other places of the samples, and normals and textures of one point a
        // surface.
        EXPECT_LT(errorOf("aa/msaa"), 1.2 * errorOf("aa/ssaa:grid=2,pattern=rotated")) << scene;
    }
}

TEST(Msaa, MaterialsLightsAndOcclusionReachTheSamples) {
    // Lamps with their own reflections, and occlusion in the place of the ambient term, of every sample's own surface.
    const auto shownAs = [](const std::string& scene, const std::string& aa) {
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shading = Shading::Pbr;
        settings.ambient = AmbientTerm::Ao;
        settings.ao = parsePipeline(Family::Ao, "ao/blocks:rotation=none");
        settings.aa = parsePipeline(Family::Aa, aa);
        RenderResult result = renderScene(Bench::of(scene).scene(), settings);
        EXPECT_TRUE(result.debugMessages.empty()) << result.debugMessages.front();
        // A half vector along the view may be longer than 1 by rounding: Fresnel's power of that was no number.
        for (const float v : result.picture.plane(1)) EXPECT_TRUE(std::isfinite(v)) << aa;
        return result.picture;
    };
    for (const char* scene : {"many-lights", "nave"}) {
        const Image truth = shownAs(scene, "aa/ssaa:grid=8");
        const auto errorOf = [&](const std::string& aa) {
            const Image picture = shownAs(scene, aa);
            double sum = 0;
            for (std::size_t i = 0; i < picture.plane(1).size(); ++i) {
                const auto seen = [i](const Image& image) {
                    return double(srgbFromLinear(std::clamp(image.plane(1)[i], 0.0f, 1.0f)));
                };
                sum += (seen(picture) - seen(truth)) * (seen(picture) - seen(truth));
            }
            return std::sqrt(sum);
        };
        // Measured 0.35 and 0.43 (bumps are lit once a pixel), four whole frames 0.34 and 0.28.
        EXPECT_LT(errorOf("aa/msaa"), 0.5 * errorOf("aa/none")) << scene;
    }
}

/// Share of the pixels of one surface whose light multisampling changes.
double changedShare(const std::string& scene, const std::string& shadow) {
    const RenderResult one = renderSmall(scene, "aa/none", shadow),
                       four = renderSmall(scene, "aa/msaa", shadow, {"msaa-edges"});
    const auto edges = four.shownRaw.at("msaa-edges").plane(0);
    const auto was = one.picture.plane(0), is = four.picture.plane(0);
    double differing = 0, inside = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i] > 0) continue;
        ++inside;
        differing += std::abs(was[i] - is[i]) > 0.02f * (1 + was[i]) ? 1 : 0;
    }
    EXPECT_GT(inside, double(edges.size()) / 2);
    return differing / inside;
}

TEST(Msaa, PixelsOfOneSurfaceStayWhatTheyAreForEveryShadow) {
    // What techniques see of a pixel is made of its samples: depth at its centre, and the surface itself. Depths differ
    // by rounding, which moves a hard shadow's edge where it passes near to a pixel's centre: 6 to 13 pixels of 54621.
    for (const TechniqueInfo& info : techniques())
        if (info.family == Family::Shadow && info.id != "shadow/none" && supports(info.domain, LightType::Sun)) {
            EXPECT_LE(changedShare("menger", info.id), 1.0 / 2000) << info.id;
        }
}

TEST(Msaa, VolumesBeginAtTheSurfacesThatTheyBeginAt) {
    // Every lit surface is the cap of its own volume: a depth that rounds behind it would shade it. Without a shadow
    // what changes are textures along the seams of triangles, read inside of them.
    for (const char* scene : {"plane-grazing", "long-view", "nave", "resting", "far-origin", "sphere"})
        EXPECT_LE(changedShare(scene, "shadow/volume-zfail"), changedShare(scene, "shadow/none") + 1.0 / 2000) << scene;
}

/// A post of grey 0.5 in the light of the sun before a wall, which it shades along the post's right side.
Scene shadingPost() {
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-99, -99, -8}, {99, -99, -8}, {99, 99, -8}, {-99, 99, -8}}, 0.0f);
    addQuad(scene, {{-11, -60, 0}, {-3, -60, 0}, {19, 60, 0}, {11, 60, 0}}, 0.0f);
    scene.materials[0].baseColor = glm::vec3(1.0f);
    scene.materials[1].baseColor = glm::vec3(0.5f);
    scene.ambient = 0.125f;
    scene.lights[0].direction = glm::normalize(glm::vec3(1, 0, -1));
    scene.lights[0].intensity = 3;
    return scene;
}

TEST(Msaa, ASampleTakesTheVisibilityOfItsOwnSurface) {
    const Scene scene = shadingPost();
    for (const Composite composite : {Composite::Lighting, Composite::Modulate}) {
        RenderSettings settings = squareSettings(kSize);
        settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced");
        settings.aa = parsePipeline(Family::Aa, "aa/msaa");
        settings.composite = composite;
        const Image picture = renderFlat(scene, settings).picture;
        settings.aa = parsePipeline(Family::Aa, "aa/none");
        const Image hard = renderFlat(scene, settings).picture;
        std::size_t graded = 0;
        for (int y = 20; y < kSize - 20; ++y) {
            const auto row = picture.plane(0).subspan(std::size_t(y * kSize), kSize);
            const auto hardRow = hard.plane(0).subspan(std::size_t(y * kSize), kSize);
            // The post's right side; two pixels to either side are of one surface, the right ones in its shadow.
            int x = kSize - 1;
            const double axis = 0.5 * kSize - y - 0.5;
            x = int(std::floor(0.5 * kSize + 7.5 + axis * 11 / 60 - 0.5));
            const double post = double(hardRow[std::size_t(x - 3)]), shade = double(hardRow[std::size_t(x + 3)]);
            ASSERT_GT(post, 2 * shade);
            for (int i = x - 1; i <= x + 1; ++i) {
                const double share = (double(row[std::size_t(i)]) - shade) / (post - shade);
                // Quarters, to the rounding of half floats.
                ASSERT_NEAR(share * 4, std::round(share * 4), 0.02) << "row " << y << " column " << i;
                graded += share > 0.1 && share < 0.9 ? 1 : 0;
            }
        }
        EXPECT_GT(graded, 20u);
    }
}

TEST(Msaa, BrightSamplesCountLessWithWeights) {
    Scene scene = SlantedEdge::scene(0.37);
    scene.materials[0].emissive = glm::vec3(100.0f);
    const auto plain = SlantedEdge::picture(scene, "aa/msaa"),
               weighted = SlantedEdge::picture(scene, "aa/msaa:luma-weights=true");
    std::size_t graded = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        // k of four samples of luma 100 before black: weights 1/101 and 1.
        const double k = std::round(double(plain[i]) / 25);
        const double expected = k * 100 / 101 / (k / 101 + 4 - k);
        ASSERT_NEAR(double(weighted[i]), expected, 0.001 * (1 + expected)) << k;
        graded += k > 0 && k < 4 ? 1 : 0;
    }
    EXPECT_GT(graded, 50u);
}

TEST(Msaa, FacetsOfABallAreOneSurfaceAndInstancesAreNot) {
    const auto edgesOf = [](const Scene& scene) {
        RenderSettings settings = squareSettings(kSize);
        settings.aa = parsePipeline(Family::Aa, "aa/msaa");
        settings.show = {"msaa-edges"};
        const RenderResult result = renderFlat(scene, settings);
        const auto edges = result.shownRaw.at("msaa-edges").plane(0);
        return std::count_if(edges.begin(), edges.end(), [](float v) { return v > 0; });
    };
    // Two triangles in one plane are one surface: no pixel of the picture is lit twice.
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-99, -99, 0}, {99, -99, 0}, {99, 99, 0}, {-99, 99, 0}}, 1.0f);
    EXPECT_EQ(edgesOf(scene), 0);
    // One as like it that lies on it is another instance, which lights may treat in another way.
    addQuad(scene, {{-20, -20, 0.01f}, {20.4f, -20, 0.01f}, {20.4f, 20, 0.01f}, {-20, 20, 0.01f}}, 1.0f);
    EXPECT_NEAR(double(edgesOf(scene)), 40, 2);
}

TEST(Msaa, GeometryIsDrawnOnceAndWithoutItNothingIsAdded) {
    const RenderResult before = renderSmall("menger", "aa/none", "shadow/ray-traced");
    const RenderResult four = renderSmall("menger", "aa/msaa", "shadow/ray-traced");
    const RenderResult after = renderSmall("menger", "aa/none", "shadow/ray-traced");
    EXPECT_EQ(drawsOf(four, "g-buffer"), drawsOf(before, "g-buffer"));
    EXPECT_EQ(drawsOf(four, "lighting of edges"), 1u);
    // A frame without anti-aliasing is drawn by its own passes alone, also after one that had samples.
    EXPECT_EQ(passNames(before), (std::vector<std::string>{"g-buffer", "clear visibility", "shadow rays", "lighting"}));
    EXPECT_EQ(passNames(after), passNames(before));
    EXPECT_EQ(after.gpuBytes, before.gpuBytes);
    EXPECT_EQ(SlantedEdge::picture(0.37, "aa/msaa:samples=1"), SlantedEdge::picture(0.37, "aa/none"));
}

TEST(Msaa, WhatTheDeviceDoesNotOfferIsRefused) {
    try {
        SlantedEdge::picture(0.3, "aa/msaa:samples=3");
        FAIL() << "three samples were taken for another number";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Environment);
        EXPECT_NE(error.message().find("3 samples"), std::string::npos) << error.message();
        EXPECT_NE(error.hint().find('4'), std::string::npos) << error.hint();
    }
    // The renderer goes on after it.
    EXPECT_EQ(SlantedEdge::picture(0.0, "aa/msaa").size(), std::size_t(kSize * kSize));
    EXPECT_THROW(SlantedEdge::picture(0.3, "aa/fxaa+aa/msaa"), Error);
    EXPECT_THROW(SlantedEdge::picture(0.3, "aa/msaa+aa/ssaa"), Error);
    EXPECT_NE(SlantedEdge::picture(0.3, "aa/msaa+aa/fxaa"), SlantedEdge::picture(0.3, "aa/msaa"));
}

}  // namespace
}  // namespace ombrage::test
