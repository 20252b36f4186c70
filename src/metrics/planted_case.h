// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <ombrage/metrics.h>

namespace ombrage::test {

inline constexpr int kWidth = 64, kHeight = 48;
inline constexpr std::size_t kCount = std::size_t(kWidth) * kHeight;

/// A level floor seen from above, in shadow from column `umbra` on; pixels of 1 cm, a sun overhead.
struct Case {
    Receivers receivers;
    ShadowTruth truth;
    std::vector<float> picture;

    explicit Case(int umbra = kWidth / 2) {
        receivers.width = truth.width = kWidth;
        receivers.height = truth.height = kHeight;
        receivers.instance.assign(kCount, 0);
        receivers.triangle.assign(kCount, 0);
        receivers.barycentric.assign(kCount, glm::vec2(0));
        receivers.normal.assign(kCount, glm::vec3(0, 1, 0));
        receivers.shadingNormal = receivers.normal;
        receivers.distance_m.assign(kCount, 5.0f);
        receivers.pixelSize_m.assign(kCount, 0.01f);
        truth.visibility.assign(kCount, 1.0f);
        truth.standardError.assign(kCount, 0.0f);
        truth.irradianceShare.assign(kCount, 1.0f);
        truth.irradiance.assign(kCount, 1.0f);
        truth.cosine.assign(kCount, 1.0f);
        truth.lightDistance_m.assign(kCount, std::numeric_limits<float>::infinity());
        truth.mask.assign(kCount, Mask::Valid);
        for (int y = 0; y < kHeight; ++y)
            for (int x = umbra; x < kWidth; ++x) truth.visibility[at(x, y)] = 0;
        // For cases that give the light a size.
        truth.centreSeen.assign(truth.visibility.begin(), truth.visibility.end());
        picture = truth.visibility;
    }

    static std::size_t at(int x, int y) { return std::size_t(y) * kWidth + std::size_t(x); }

    ShadowMeasurement measure(const ShadowQuestion& question = {}) const {
        return measureShadow(picture, truth, receivers, question);
    }
};

/// A measurement with nothing known but the technique's texels.
inline ShadowQuestion withTexels(const TexelFootprint& footprint) {
    ShadowQuestion question;
    question.footprint = footprint;
    return question;
}

/// Features that give one answer everywhere but for single pixels' blockers, and remember what they were asked.
struct Answers {
    LightSurroundings around;
    int layers = 1;
    std::vector<float> blockerDistance_m = std::vector<float>(kCount, 1.0f);
    std::vector<std::uint32_t> asked, askedBlockers;
    ShadowFeatures features;

    Answers() {
        features.shadingCosine.assign(kCount, 1.0f);
        features.surroundings = [this](const std::vector<std::uint32_t>& pixels, const std::vector<float>& reach_m) {
            EXPECT_EQ(pixels.size(), reach_m.size());
            asked = pixels;
            return std::vector<LightSurroundings>(pixels.size(), around);
        };
        features.layers = [this](const std::vector<std::uint32_t>& pixels) {
            return std::vector<int>(pixels.size(), layers);
        };
        features.blockers = [this](const std::vector<std::uint32_t>& pixels) {
            askedBlockers.insert(askedBlockers.end(), pixels.begin(), pixels.end());
            std::vector<Blocker> found;
            for (const std::uint32_t i : pixels) found.push_back({blockerDistance_m[i], 1});
            return found;
        };
    }
    Answers(const Answers&) = delete;
    Answers& operator=(const Answers&) = delete;

    ShadowQuestion question(const TexelFootprint& footprint) const {
        ShadowQuestion q = withTexels(footprint);
        q.features = &features;
        return q;
    }
};

/// Texels that are as fine as the pixels of the case.
inline const TexelFootprint kFineTexels{0.005, 0, 0};

}  // namespace ombrage::test
