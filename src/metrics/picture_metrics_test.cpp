// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/metrics.h>

namespace ombrage {
namespace {

double meanOf(const Image& image) {
    const auto values = image.plane(0);
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

Image constant(int width, int height, float r, float g, float b, ColorSpace space = ColorSpace::Linear) {
    Image image = Image::rgb(width, height, space);
    const float color[3] = {r, g, b};
    for (int c = 0; c < 3; ++c) std::fill(image.plane(c).begin(), image.plane(c).end(), color[c]);
    return image;
}

TEST(Flip, KnownPairOfPictures) {
    const char* data = std::getenv("OMBRAGE_DATA");
    if (!data) GTEST_SKIP() << "OMBRAGE_DATA is not set: the known pair of FLIP is not checked";
    const std::filesystem::path folder = std::filesystem::path(data) / "refs" / "flip";
    const Image map = flip(readImage(folder / "tree-ref.png"), readImage(folder / "tree-test.png"), 67);
    // 0.1333 comes from an error map in 8 bits: half a step of 1/255.
    EXPECT_NEAR(meanOf(map), 0.1333, 0.002);
}

TEST(Flip, EqualPicturesHaveNone) {
    Image a = Image::rgb(40, 30);
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < a.pixelCount(); ++i)
            a.plane(c)[i] = float((i * 31 + std::size_t(c) * 17) % 97) / 96;
    const Image map = flip(a, a);
    EXPECT_EQ(*std::max_element(map.plane(0).begin(), map.plane(0).end()), 0);
}

TEST(Flip, GreenAgainstBlueIsTheLargest) {
    // The colour difference that defines 1; without features. 1e-5: powers in float.
    const Image map = flip(constant(32, 32, 0, 1, 0), constant(32, 32, 0, 0, 1));
    EXPECT_NEAR(meanOf(map), 1, 1e-5);
}

TEST(Flip, BlackAgainstWhiteByHand) {
    // Hunt-adjusted HyAB distance is 100 in lightness: d = 100^0.7 = 25.119 beyond the cut-off 0.4 cmax. cmax is the
    // distance of green (L 87.735, a -86.183, b 83.180) and blue (L 32.301, a 79.195, b -107.855), CIELAB of the sRGB
    // primaries under D65: chroma times L/100, 55.434 + hypot(101.19, 107.82) = 203.30, to the power 0.7 = 41.27.
    const double cmax =
        std::pow(55.434 + std::hypot(0.87735 * 86.183 + 0.32301 * 79.195, 0.87735 * 83.180 + 0.32301 * 107.855), 0.7);
    const double d = std::pow(100.0, 0.7), expected = 0.95 + (d - 0.4 * cmax) / (0.6 * cmax) * 0.05;
    // 1e-3: the primaries' CIELAB are given to three digits.
    EXPECT_NEAR(meanOf(flip(constant(32, 32, 0, 0, 0), constant(32, 32, 1, 1, 1))), expected, 1e-3);
}

TEST(Flip, IsSymmetricAndSeesEdges) {
    Image flat = constant(64, 64, 0.5f, 0.5f, 0.5f), edge = flat;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 32; x < 64; ++x) edge.at(c, x, y) = 0.6f;
    const Image ab = flip(flat, edge), ba = flip(edge, flat);
    EXPECT_EQ(ab, ba);
    // At the edge the feature raises the error over that of the same colours elsewhere.
    EXPECT_GT(ab.at(0, 33, 32), ab.at(0, 60, 32) * 1.05f);
    EXPECT_LT(ab.at(0, 5, 32), 1e-3f);
}

TEST(Flip, LinearAndEncodedPicturesAgree) {
    const Image linear = constant(16, 16, 0.2f, 0.4f, 0.1f), other = constant(16, 16, 0.3f, 0.3f, 0.1f);
    // 1e-5: the transfer function and back.
    EXPECT_NEAR(meanOf(flip(linear, other)), meanOf(flip(toSrgb(linear), toSrgb(other))), 1e-5);
}

TEST(Flip, RefusesOtherSizes) {
    EXPECT_THROW(flip(Image::rgb(3, 3), Image::rgb(3, 4)), Error);
    EXPECT_THROW(flip(Image::rgb(3, 3), Image::rgb(3, 3), 0), Error);
}

TEST(Diff, EveryMetricOfEqualImages) {
    const Image a = constant(20, 20, 0.2f, 0.5f, 0.9f, ColorSpace::Srgb);
    for (const char* metric : {"flip", "rmse", "mae", "psnr", "ssim"}) {
        const DiffResult r = diffImages(a, a, metric);
        EXPECT_EQ(r.metric, metric);
        EXPECT_TRUE(r.exact);
        EXPECT_EQ(r.max, 0) << metric;
        EXPECT_EQ(r.p95, 0) << metric;
        if (std::string(metric) == "psnr")
            EXPECT_FALSE(r.value);
        else
            EXPECT_EQ(*r.value, std::string(metric) == "ssim" ? 1.0 : 0.0) << metric;
    }
}

TEST(Diff, HandComputedCase) {
    Image a = Image::grey(2, 1), b = a;
    b.at(0, 0, 0) = 0.5f;
    EXPECT_DOUBLE_EQ(*diffImages(a, b, "mae").value, 0.25);
    EXPECT_DOUBLE_EQ(*diffImages(a, b, "rmse").value, std::sqrt(0.125));
    EXPECT_DOUBLE_EQ(*diffImages(a, b, "psnr").value, -10 * std::log10(0.125));
    const DiffResult r = diffImages(a, b, "mae");
    EXPECT_FALSE(r.exact);
    EXPECT_EQ(r.max, 0.5);
    EXPECT_EQ(r.p95, 0.5);
    EXPECT_EQ(r.map.at(0, 0, 0), 0.5f);
    EXPECT_EQ(r.map.at(0, 1, 0), 0.0f);
}

TEST(Diff, LightInTwoEncodingsIsTheSame) {
    const Image a = constant(4, 4, 0.2f, 0.4f, 0.1f);
    EXPECT_LT(*diffImages(a, toSrgb(a), "mae").value, 1e-6);
}

TEST(Diff, InfinityEqualsItself) {
    Image a = Image::grey(2, 2), b = a;
    a.at(0, 1, 0) = b.at(0, 1, 0) = INFINITY;
    EXPECT_TRUE(diffImages(a, b, "rmse").exact);
    b.at(0, 1, 0) = 0;
    EXPECT_THROW(diffImages(a, b, "rmse"), Error);
}

TEST(Diff, RefusesWhatCannotBeCompared) {
    const Image a = Image::rgb(2, 2);
    EXPECT_THROW(diffImages(a, Image::rgb(2, 3), "mae"), Error);
    EXPECT_THROW(diffImages(a, Image::grey(2, 2), "mae"), Error);
    EXPECT_THROW(diffImages(Image(), Image(), "mae"), Error);
    try {
        diffImages(a, a, "rmes");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Usage);
        EXPECT_NE(e.hint().find("rmse"), std::string::npos) << e.hint();
    }
}

TEST(Magma, KnownColours) {
    const float t[3] = {0, 0.5f, 1};
    // The published table at 0, 128/255 (within half a step of 0.5) and 255/255.
    const double expected[3][3] = {
        {0.001462, 0.000466, 0.013866}, {0.716387, 0.214982, 0.475290}, {0.987053, 0.991438, 0.749504}};
    for (int i = 0; i < 3; ++i) {
        float rgb[3];
        magma(t[i], rgb);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(rgb[c]), expected[i][c], 0.01) << t[i] << " " << c;
    }
    float below[3], none[3];
    magma(-1, below);
    magma(std::nanf(""), none);
    EXPECT_TRUE(std::equal(below, below + 3, none));
}

}  // namespace
}  // namespace ombrage
