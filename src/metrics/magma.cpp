// SPDX-License-Identifier: MIT
#include <algorithm>

#include <ombrage/metrics.h>

namespace ombrage {

void magma(float t, float rgb[3]) {
    // Ten colours at equal steps of van der Walt and Smith's map (2015, CC0), straight lines between: within 2/255 of
    // it.
    static constexpr int kColors[10] = {0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f,
                                        0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xfcfdbf};
    const float position = (t >= 0 ? std::min(t, 1.0f) : 0.0f) * 9;  // not a number is 0
    const int below = std::min(int(position), 8);
    const float f = position - float(below);
    for (int c = 0; c < 3; ++c) {
        const int shift = 16 - 8 * c;
        const float a = float((kColors[below] >> shift) & 255), b = float((kColors[below + 1] >> shift) & 255);
        rgb[c] = (a + (b - a) * f) / 255;
    }
}

}  // namespace ombrage
