// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <ombrage/image.h>
#include <ombrage/reference.h>

namespace ombrage::test {

/// Four pictures of one view, to see what is wrong: the technique's visibility and the truth's side by side, and under
/// them the rendered picture with a frame around every wrong pixel, and the neighbourhood with the most wrong pixels 16
/// times enlarged. Wrong pixels are red where shadow is missing and blue where there is too much; what is not measured
/// is slate in the visibilities. @param picture sRGB or linear, of the truth's size
Image errorPicture(const Image& picture, std::span<const float> visibility, const ShadowTruth& truth);

}  // namespace ombrage::test
