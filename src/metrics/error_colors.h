// SPDX-License-Identifier: MIT
#pragma once

namespace ombrage {

/// The one scale of every error map. A signed error e in [-1,1] sits at sign(e) sqrt(|e|), so that an error of 0.01 is
/// seen beside one of 1; the report prints the same scale with its marks.
float errorScalePosition(float error);

/// Colour of a position in [-1,1], sRGB: blue where the picture is too dark, white where it is right, orange to brown
/// where it is too bright. Told apart by people with any of the usual colour-vision deficiencies.
void errorColor(float position, float rgb[3]);

/// Pixels that are not measured (sky, below the light's horizon, raster and rays disagree).
inline constexpr float kMaskedGrey = 0.45f;

/// Colours of the error classes, in the order of ErrorClass; names as metric keys. Okabe and Ito's palette.
struct ErrorClassColor {
    const char* name;
    float rgb[3];
};
inline constexpr ErrorClassColor kErrorClassColors[] = {
    {"right", {0.13f, 0.13f, 0.13f}},    {"contact_gap", {0.835f, 0.369f, 0.0f}}, {"alias", {0.337f, 0.706f, 0.914f}},
    {"penumbra", {0.0f, 0.62f, 0.451f}}, {"acne", {0.8f, 0.475f, 0.655f}},        {"other", {0.941f, 0.894f, 0.259f}},
};

}  // namespace ombrage
