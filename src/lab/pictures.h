// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <ombrage/image.h>
#include <ombrage/metrics.h>

namespace ombrage {

/// The signed error on the shared scale (metrics/error_colors.h); pixels that are not measured are grey. sRGB.
Image errorPicture(std::span<const float> measured, std::span<const float> truth, const std::vector<Mask>& mask,
                   int width, int height);

/// The class of every error in its colour (metrics/error_colors.h) on a dark ground that tells light from shadow;
/// pixels that are not measured are grey. sRGB.
Image classPicture(const std::vector<ErrorClass>& classes, std::span<const float> truth, const std::vector<Mask>& mask,
                   int width, int height);

/// One plane of plain numbers as an image.
Image greyPicture(std::span<const float> values, int width, int height);

/// Linear picture as a display shows it: sRGB-encoded and saturated.
Image displayed(const Image& linear);

/// Means of squares of grid x grid pixels. The size is a multiple of the grid.
Image averagedOverPixels(const Image& fine, int grid);

/// Writes values of a picture `width` wide into one point (counted row by row of the grid) of every pixel of the fine
/// one.
void spreadOverPixels(std::span<const float> values, int width, int part, int grid, Image& fine);

/// Mean of the only plane.
double meanOf(const Image& image);

/// Lower-case letters, digits and '-' only; never empty. For file names.
std::string fileSlug(const std::string& text);

}  // namespace ombrage
