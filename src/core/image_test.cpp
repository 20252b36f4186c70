// SPDX-License-Identifier: MIT
#include <ombrage/image.h>

#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

TEST(Image, PlanesLieOneAfterTheOtherRowByRow) {
    Image image(3, 2, {"a", "b"});
    float next = 0;
    for (int p = 0; p < 2; ++p)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x) image.at(p, x, y) = next++;
    EXPECT_EQ(image.plane("a")[5], 5);
    EXPECT_EQ(image.plane("b")[0], 6);
    EXPECT_EQ(image.plane(1)[4], 10) << "row 1, column 1";
    EXPECT_EQ(image.pixelCount(), 6u);
    EXPECT_EQ(image.findPlane("b"), 1);
    EXPECT_EQ(image.findPlane("c"), -1);
}

TEST(Image, StartsAsZerosAndEmptyMeansNoPixels) {
    EXPECT_TRUE(Image().empty());
    EXPECT_TRUE(Image(0, 5, {"Y"}).empty());
    const Image image = Image::rgb(2, 2);
    EXPECT_FALSE(image.empty());
    for (int p = 0; p < 3; ++p)
        for (float v : image.plane(p)) EXPECT_EQ(v, 0);
}

TEST(Image, RefusesSizesAndNamesThatMakeNoSense) {
    EXPECT_THROW(Image(-1, 2, {"Y"}), Error);
    EXPECT_THROW(Image(65537, 1, {"Y"}), Error);
    EXPECT_NO_THROW(Image(65536, 1, {"Y"}));
    EXPECT_THROW(Image(1, 1, {"Y", "Y"}), Error);
}

TEST(Image, AnUnknownPlaneSuggestsTheNearest) {
    const Image image = Image::grey(1, 1, "visibility");
    try {
        image.plane("visibilty");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Usage);
        EXPECT_NE(std::string(e.what()).find("did you mean 'visibility'?"), std::string::npos) << e.what();
    }
}

TEST(Srgb, MeetsTheStandardsValues) {
    // IEC 61966-2-1: 18 % grey encodes to 0.4613561 and the branches meet at 0.0031308; floats hold 7 digits and pow
    // costs one.
    EXPECT_NEAR(srgbFromLinear(0.18f), 0.4613561f, 1e-6f);
    EXPECT_NEAR(srgbFromLinear(0.0031308f), 0.04045f, 1e-6f);
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.2140411f, 1e-6f);
    EXPECT_FLOAT_EQ(srgbFromLinear(1), 1);
    EXPECT_EQ(srgbFromLinear(0), 0);
}

TEST(Srgb, IsOddAndGoesBeyondOne) {
    for (float v : {0.001f, 0.2f, 1.0f, 7.0f}) {
        EXPECT_EQ(srgbFromLinear(-v), -srgbFromLinear(v));
        EXPECT_NEAR(linearFromSrgb(srgbFromLinear(v)), v, 2e-6f * v) << "two pow calls";
    }
}

Image rgba(float value, ColorSpace space) {
    Image image(1, 1, {"R", "G", "B", "A"}, space);
    for (int p = 0; p < 4; ++p) image.at(p, 0, 0) = value;
    return image;
}

TEST(Image, ConversionLeavesAlphaAlone) {
    const Image encoded = toSrgb(rgba(0.5f, ColorSpace::Linear));
    EXPECT_EQ(encoded.colorSpace(), ColorSpace::Srgb);
    EXPECT_FLOAT_EQ(encoded.at(0, 0, 0), srgbFromLinear(0.5f));
    EXPECT_EQ(encoded.at(3, 0, 0), 0.5f);
    const Image back = toLinear(encoded);
    EXPECT_EQ(back.colorSpace(), ColorSpace::Linear);
    EXPECT_NEAR(back.at(1, 0, 0), 0.5f, 1e-6f);
    EXPECT_EQ(back.at(3, 0, 0), 0.5f);
}

TEST(Image, ConversionHappensOnceAndNeverToData) {
    const Image data = rgba(0.5f, ColorSpace::Data);
    EXPECT_EQ(toSrgb(data), data);
    EXPECT_EQ(toLinear(data), data);
    const Image encoded = rgba(0.5f, ColorSpace::Srgb);
    EXPECT_EQ(toSrgb(encoded), encoded);
    const Image linear = rgba(0.5f, ColorSpace::Linear);
    EXPECT_EQ(toLinear(linear), linear);
}

}  // namespace
}  // namespace ombrage
