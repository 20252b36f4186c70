// SPDX-License-Identifier: MIT
// What all techniques of shared/screen_ao.h have in common: pictures of which not every pixel is a receiver by itself.
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/technique_case.h"

namespace ombrage {
namespace {

/// Mean and greatest difference between two choices of `pixels` on a picture that is no multiple of 2 or 4.
struct Difference {
    double mean = 0, greatest = 0;
};

Difference between(const std::string& technique, const std::string& pixels) {
    const Scene scene = loadScene("corner");
    const auto picture = [&](const std::string& choice) {
        RenderSettings settings;
        settings.width = 125;
        settings.height = 67;
        settings.ao = parsePipeline(Family::Ao, technique + ",rotation=none,pixels=" + choice);
        return test::renderScene(scene, settings).ao.value();
    };
    const Image full = picture("full"), other = picture(pixels);
    Difference difference;
    for (std::size_t i = 0; i < full.pixelCount(); ++i) {
        const double here = std::abs(double(full.plane(0)[i]) - double(other.plane(0)[i]));
        difference.mean += here / double(full.pixelCount());
        difference.greatest = std::max(difference.greatest, here);
    }
    return difference;
}

// Without noise the walls' occlusion is smooth: what is filled in from receivers two pixels apart differs by what
// occlusion changes over such a distance: 1 % on the average. A picture put together wrongly differs by as much as a
// corner does from an open wall.
TEST(ScreenAo, HalfTheReceiversGiveNearlyTheSamePicture) {
    const Difference difference = between("ao/gtao:slices=4,steps=16", "half");
    EXPECT_GT(difference.mean, 0.0);
    EXPECT_LT(difference.mean, 0.01);
    EXPECT_LT(difference.greatest, 0.25);
}

// Samples lie up to two pixels beside their place. A part's pixels are four apart: beside a crease, half of whose wall
// lies within them, it may be missed.
TEST(ScreenAo, DeinterleavedPartsGiveNearlyTheSamePicture) {
    for (const char* technique : {"ao/gtao:slices=4,steps=16", "ao/hbao:directions=16,steps=16,jitter=false"}) {
        const Difference difference = between(technique, "deinterleaved");
        EXPECT_GT(difference.mean, 0.0) << technique;
        EXPECT_LT(difference.mean, 0.015) << technique;
        EXPECT_LT(difference.greatest, 0.5) << technique;
    }
}

}  // namespace
}  // namespace ombrage
