// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

const std::string kNoisy = "ao/blocks:samples=16,rotation=hash";

std::vector<float> aoWith(const Scene& scene, const std::string& pipeline, std::uint64_t seed, int frames = 1) {
    RenderSettings settings = squareSettings(kFilterPicture_px);
    settings.ao = parsePipeline(Family::Ao, pipeline);
    settings.seed = seed;
    settings.frames = frames;
    const RenderResult result = renderFlat(scene, settings);
    return {result.ao->plane(0).begin(), result.ao->plane(0).end()};
}

TEST(Temporal, AStillCameraConvergesToTheMeanOverSeeds) {
    const Scene scene = noisySlope();
    constexpr int kSeeds = 96;
    std::vector<float> mean(std::size_t(kFilterPicture_px * kFilterPicture_px), 0.0f);
    double single = 0;
    std::vector<std::vector<float>> pictures;
    for (int seed = 0; seed < kSeeds; ++seed) {
        pictures.push_back(aoWith(scene, kNoisy, std::uint64_t(1000 + seed)));
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += pictures.back()[i] / float(kSeeds);
    }
    for (int seed = 0; seed < 8; ++seed) single += rmseBetween(pictures[std::size_t(seed)], mean) / 8;
    ASSERT_GT(single, 0.01);
    // The plain mean of 33 frames (32 to settle and the one shown): the noise of one over root 33, beside that of the
    // mean of the seeds itself, over root 96; both are estimates from a picture's worth of pixels, good to a tenth or
    // two.
    const double expected = single * std::sqrt(1.0 / 33 + 1.0 / kSeeds);
    const double is = rmseBetween(aoWith(scene, kNoisy + "+filter/temporal:blend=0,gamma=64", 5), mean);
    EXPECT_LT(is, 1.25 * expected);
    EXPECT_GT(is, 0.75 * expected);
    // An exponential mean of weight b has b / (2 - b) of the variance.
    const double blended = rmseBetween(aoWith(scene, kNoisy + "+filter/temporal:blend=0.2,gamma=64", 5), mean);
    EXPECT_NEAR(blended, single * std::sqrt(0.2 / 1.8 + 1.0 / kSeeds), 0.2 * blended);
}

TEST(Temporal, WithoutHistoryNothingChanges) {
    // A constant image stays what it is, and a blend of 1 takes the new frame alone; the sky is not touched.
    for (const float v : aoWith(quadBeforeRibs(), "ao/none+filter/temporal", 1)) ASSERT_EQ(v, 1.0f);
    const auto blended = aoWith(quadBeforeRibs(), "ao/blocks:rotation=none+filter/temporal:blend=1", 1);
    EXPECT_EQ(blended, aoWith(quadBeforeRibs(), "ao/blocks:rotation=none", 1));
}

TEST(Temporal, WhatMovedAwayLeavesNoGhost) {
    // Two pixels from the new patch's edge the neighbourhood is dark throughout: the clamp leaves nothing at all.
    EXPECT_EQ(ghostsOfPatch("filter/temporal", 1).front(), 0.0);
}

TEST(Temporal, WhatWasHiddenTakesNothingFromWhatHidIt) {
    const std::string still = "ao/blocks:rotation=none";
    const auto raw = uncoveredByQuad(still);
    ASSERT_LT(*std::min_element(raw.begin(), raw.end()), 0.9f);
    EXPECT_EQ(uncoveredByQuad(still + "+filter/temporal:gamma=64"), raw);
    // With every depth taken for the same surface the quad's history stays behind.
    EXPECT_GT(rmseBetween(uncoveredByQuad(still + "+filter/temporal:gamma=64,depth-tolerance=1"), raw), 0.05);
}

TEST(Temporal, AMovingCameraKeepsItsHistory) {
    // Before ribs, whose occlusion changes from pixel to pixel, the camera goes by a pixel a frame to the right and by
    // 4 m back: pixels of one surface lie elsewhere and farther away than a frame ago.
    Scene moved = quadBeforeRibs();
    const auto render = [&](Renderer& renderer, const std::string& filter, int step) {
        RenderSettings settings = squareSettings(kFilterPicture_px);
        settings.ao = parsePipeline(Family::Ao, kNoisy + filter);
        settings.seed = 3;
        moved.cameras[0].position = {step, 0, 10 + 4 * step};
        moved.cameras[0].target = {step, 0, 0};
        if (step == 0) renderer.setScene(moved);
        renderer.moveScene(moved);
        const Image image = *renderer.render(settings).ao;
        // Without the columns that came into the picture on the way.
        std::vector<float> values;
        for (int y = 4; y < kFilterPicture_px - 4; ++y)
            for (int x = 4; x < kFilterPicture_px - 12; ++x)
                values.push_back(image.plane(0)[std::size_t(y * kFilterPicture_px + x)]);
        return values;
    };
    const std::string keeps = "+filter/temporal:blend=0,gamma=64,depth-tolerance=0.02";
    constexpr int kSteps = 8;
    Renderer walking, standing;
    std::vector<float> walked;
    for (int step = 0; step <= kSteps; ++step) walked = render(walking, keeps, step);
    standing.setScene(moved);
    const std::vector<float> still = render(standing, keeps, kSteps), single = render(standing, "", kSteps);
    const double noise = rmseBetween(single, still);
    ASSERT_GT(noise, 0.01);
    // Means of 41 and 33 frames differ by 0.23 of one frame's noise; measured 0.25.
    EXPECT_LT(rmseBetween(walked, still), 0.4 * noise);
}

}  // namespace
}  // namespace ombrage::test
