// SPDX-License-Identifier: MIT
#pragma once

namespace ombrage {

/// How often a pixel's geometry is sampled.
struct GeometrySamples {
    int count = 1;           ///< in each pixel; over 1 the surfaces are drawn once, multisampled
    bool alphaTest = false;  ///< the alpha test is made at every sample, not once in the pixel
    bool operator==(const GeometrySamples&) const = default;
};

}  // namespace ombrage
