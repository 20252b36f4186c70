// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/metrics.h>

namespace ombrage {

/// The one scale of every error map. A signed error e in [-1,1] sits at sign(e) sqrt(|e|), so that an error of 0.01 is
/// seen beside one of 1; the report prints the same scale with its marks.
float errorScalePosition(float error);

/// Colour of a position in [-1,1], sRGB: blue where the picture is too dark, white where it is right, orange to brown
/// where it is too bright. Told apart by people with any of the usual colour-vision deficiencies.
void errorColor(float position, float rgb[3]);

/// Pixels that are not measured (sky, below the light's horizon, raster and rays disagree).
inline constexpr float kMaskedGrey = 0.45f;

/// Colours of the error classes, in the order of ErrorClass: Okabe and Ito's palette, a violet and a near white. No
/// two, masked and right pixels included, come near each other for any of the usual colour-vision deficiencies
/// (tested).
inline constexpr float kErrorClassColors[kErrorClassCount][3] = {
    {0.13f, 0.13f, 0.13f},     // right
    {0.90f, 1.0f, 1.0f},       // missing
    {0.835f, 0.369f, 0.0f},    // contact_gap
    {0.337f, 0.706f, 0.914f},  // alias
    {0.0f, 0.62f, 0.451f},     // over_blur
    {0.625f, 0.05f, 1.0f},     // under_blur
    {0.8f, 0.475f, 0.655f},    // acne
    {0.902f, 0.624f, 0.0f},    // leak
    {0.0f, 0.447f, 0.698f},    // false_shadow
    {0.941f, 0.894f, 0.259f},  // other
};

/// Right pixels that are lit in truth, so that the shadows can be seen behind their errors.
inline constexpr float kRightAndLit[3] = {0.22f, 0.22f, 0.22f};

}  // namespace ombrage
