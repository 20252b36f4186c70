// SPDX-License-Identifier: MIT
#include "lab/pictures.h"

#include <gtest/gtest.h>
#include <limits>

#include "metrics/error_colors.h"

namespace ombrage {
namespace {

TEST(ErrorScale, IsTheSignedSquareRoot) {
    EXPECT_EQ(errorScalePosition(0.0f), 0.0f);
    EXPECT_EQ(errorScalePosition(0.25f), 0.5f);
    EXPECT_EQ(errorScalePosition(-0.25f), -0.5f);
    EXPECT_EQ(errorScalePosition(1.0f), 1.0f);
    EXPECT_EQ(errorScalePosition(-7.0f), -1.0f);
}

TEST(ErrorScale, IsWhiteAtZeroBlueBelowOrangeAboveAndEverDarker) {
    float rgb[3], last = 2;
    errorColor(0, rgb);
    EXPECT_GT(rgb[0], 0.95f);
    EXPECT_EQ(rgb[0], rgb[2]);
    for (int sign : {-1, 1}) {
        last = 2;
        for (int i = 0; i <= 20; ++i) {
            errorColor(float(sign * i) / 20, rgb);
            const float luma = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
            EXPECT_LT(luma, last) << sign * i;
            last = luma;
            if (i > 0) {
                EXPECT_GT(rgb[sign < 0 ? 2 : 0], rgb[sign < 0 ? 0 : 2]) << sign * i;
            }
        }
    }
}

TEST(ErrorPicture, ShowsSignMaskAndNotANumber) {
    const std::vector<float> measured{1, 0, 0.5f, 1, std::numeric_limits<float>::quiet_NaN()};
    const std::vector<float> truth{0, 1, 0.5f, 0, 0.5f};
    const std::vector<Mask> mask{Mask::Valid, Mask::Valid, Mask::Valid, Mask::Sky, Mask::Valid};
    const Image image = errorPicture(measured, truth, mask, 5, 1);
    EXPECT_GT(image.at(0, 0, 0), image.at(2, 0, 0)) << "too bright is orange";
    EXPECT_LT(image.at(0, 1, 0), image.at(2, 1, 0)) << "too dark is blue";
    EXPECT_GT(image.at(1, 2, 0), 0.95f) << "right is white";
    EXPECT_EQ(image.at(0, 3, 0), kMaskedGrey);
    for (int p = 0; p < 3; ++p) EXPECT_EQ(image.at(p, 4, 0), image.at(p, 0, 0)) << "not a number is as wrong as can be";
}

TEST(ClassPicture, HasOneColourPerClass) {
    const std::vector<ErrorClass> classes{ErrorClass::None, ErrorClass::Acne, ErrorClass::Other};
    const std::vector<Mask> mask{Mask::Valid, Mask::Valid, Mask::Disagree};
    const std::vector<float> truth{0, 1, 1};
    const Image image = classPicture(classes, truth, mask, 3, 1);
    EXPECT_EQ(image.at(0, 1, 0), kErrorClassColors[std::size_t(ErrorClass::Acne)][0]);
    EXPECT_STREQ(errorClassKey(ErrorClass::Acne), "acne");
    EXPECT_EQ(image.at(0, 2, 0), kMaskedGrey);
    EXPECT_NE(image.at(0, 0, 0), image.at(0, 1, 0));
    // The ground tells light from shadow.
    EXPECT_GT(classPicture({ErrorClass::None}, std::vector<float>{1}, {Mask::Valid}, 1, 1).at(0, 0, 0),
              image.at(0, 0, 0));
}

TEST(Pictures, DisplayedIsEncodedAndSaturated) {
    Image linear = Image::rgb(2, 1);
    linear.at(0, 0, 0) = 4.0f;
    linear.at(0, 1, 0) = 0.2140f;  // half of the display's range, by the sRGB formula
    const Image shown = displayed(linear);
    EXPECT_EQ(shown.at(0, 0, 0), 1.0f);
    EXPECT_NEAR(shown.at(0, 1, 0), 0.5f, 1e-3f);  // 0.2140 is rounded to 4 digits
}

TEST(FileSlug, KeepsLettersAndDigits) {
    EXPECT_EQ(fileSlug("Menger sponge / 2"), "menger-sponge-2");
    EXPECT_EQ(fileSlug("../.."), "unnamed");
    EXPECT_EQ(fileSlug("a+b:c=0.5"), "a-b-c-0-5");
}

}  // namespace
}  // namespace ombrage
