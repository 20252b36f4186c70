// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/slanted_edge.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

double rmseBetween(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (double(a[i]) - double(b[i])) * (double(a[i]) - double(b[i]));
    return std::sqrt(sum / double(a.size()));
}

TEST(Taa, AStillEdgeBecomesItsCoverage) {
    for (const double slope : {0.03, 0.37, 1.0}) {
        const double hard = SlantedEdge::rmse(SlantedEdge::picture(slope, "aa/none", true, 0.21), slope, 0, 0.21);
        // Without clipping: an exponential mean over the last ten of 16 samples or so is off by a tenth in the edge's
        // pixels.
        const auto grey = SlantedEdge::picture(slope, "aa/taa:gamma=8", true, 0.21);
        EXPECT_LT(SlantedEdge::rmse(grey, slope, 0, 0.21), 0.35 * hard) << slope;
        // With it, what a sample's neighbourhood does not hold is cut off.
        EXPECT_LT(SlantedEdge::rmse(SlantedEdge::picture(slope, "aa/taa", true, 0.21), slope, 0, 0.21), 0.4 * hard);
        // Without history every frame is one sample again.
        EXPECT_GT(SlantedEdge::rmse(SlantedEdge::picture(slope, "aa/taa:blend=1", true, 0.21), slope, 0, 0.21),
                  0.8 * hard);
    }
}

/// A white post before a dark ground, and the picture after it has moved by 12 pixels in one frame.
TEST(Taa, WhatMovedAwayLeavesNoGhost) {
    const auto sceneAt = [](float x) {
        Scene scene = emptyScene(SlantedEdge::kSize_px);
        addQuad(scene, {{-99, -99, -5}, {99, -99, -5}, {99, 99, -5}, {-99, 99, -5}}, 0.1f);
        addQuad(scene, {{-4, -60, 0}, {4, -60, 0}, {4, 60, 0}, {-4, 60, 0}}, 1.0f);
        scene.instances.back().worldFromLocal[3] = glm::dvec4(x, 0, 0, 1);
        return scene;
    };
    const Scene before = sceneAt(-6), after = sceneAt(6);
    RenderSettings settings = squareSettings(SlantedEdge::kSize_px);
    const auto ghost = [&](const std::string& aa) {
        settings.aa = parsePipeline(Family::Aa, aa);
        Renderer renderer;
        renderer.setScene(before);
        renderer.render(settings);
        renderer.moveScene(after);
        const Image picture = renderer.render(settings).picture;
        // Where the post stood, two pixels and more from where it stands: the ground's grey.
        double largest = 0;
        for (int x = -9; x < 0; ++x)
            largest =
                std::max(largest, double(picture.plane(0)[std::size_t(64 * SlantedEdge::kSize_px + 64 + x)]) - 0.1);
        return largest;
    };
    // The neighbourhood is of one grey, so clipping leaves nothing but rounding to half floats; without it 0.8 would stay.
    EXPECT_LT(ghost("aa/taa"), 0.002);
}

TEST(Taa, AWalkingCameraKeepsItsHistory) {
    // Sideways before a wall of slanted stripes: what has no history is as rough as one sample.
    Scene scene = emptyScene(SlantedEdge::kSize_px);
    addQuad(scene, {{-199, -99, -5}, {199, -99, -5}, {199, 99, -5}, {-199, 99, -5}}, 0.1f);
    for (int i = -12; i < 12; ++i) {
        const float x = 12.0f * float(i);
        addQuad(scene, {{x - 20, -80, 0}, {x - 14, -80, 0}, {x + 26, 80, 0}, {x + 20, 80, 0}}, 0.8f);
    }
    const auto walk = [&](const std::string& aa, double step_px) {
        RenderSettings settings = squareSettings(SlantedEdge::kSize_px);
        settings.aa = parsePipeline(Family::Aa, aa);
        Renderer renderer;
        renderer.setScene(scene);
        std::vector<float> last;
        Scene moved = scene;
        for (int i = 0; i < 8; ++i) {
            moved.cameras[0].position.x = moved.cameras[0].target.x = step_px * i;
            renderer.moveScene(moved);
            const Image picture = renderer.render(settings).picture;
            last.assign(picture.plane(0).begin(), picture.plane(0).end());
        }
        return last;
    };
    const auto error = [&](const std::string& aa, double step_px) {
        return rmseBetween(walk(aa, step_px), walk("aa/ssaa:grid=8", step_px));
    };
    // By whole pixels the history is read at its own: as good as under a camera that stands still (measured 0.29 and
    // 0.25).
    const double hard = error("aa/none", 1);
    EXPECT_LT(error("aa/taa", 1), 0.4 * hard);
    EXPECT_GT(error("aa/taa:blend=1", 1), 0.8 * hard);
    // By half ones it is read between them in every frame, the worst case of blur: measured 0.86, and 1.01 read
    // linearly.
    EXPECT_LT(error("aa/taa", 0.5), 0.95 * hard);
    EXPECT_GT(error("aa/taa:history-filter=bilinear", 0.5), 1.1 * error("aa/taa", 0.5));
}

}  // namespace
}  // namespace ombrage::test
