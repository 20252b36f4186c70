// SPDX-License-Identifier: MIT
#include "metrics/error_colors.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

float errorScalePosition(float error) {
    const float e = std::clamp(error, -1.0f, 1.0f);
    return std::copysign(std::sqrt(std::fabs(e)), e);
}

void errorColor(float position, float rgb[3]) {
    // Two ramps of equal lightness steps that meet in white.
    static constexpr float kDark[5][3] = {{0.97f, 0.97f, 0.97f},
                                          {0.57f, 0.77f, 0.87f},
                                          {0.26f, 0.58f, 0.76f},
                                          {0.13f, 0.40f, 0.67f},
                                          {0.02f, 0.19f, 0.38f}};
    static constexpr float kBright[5][3] = {{0.97f, 0.97f, 0.97f},
                                            {0.99f, 0.76f, 0.45f},
                                            {0.90f, 0.53f, 0.10f},
                                            {0.70f, 0.35f, 0.02f},
                                            {0.42f, 0.20f, 0.03f}};
    const float p = std::clamp(position, -1.0f, 1.0f);
    const auto& ramp = p < 0 ? kDark : kBright;
    const float t = std::fabs(p) * 4.0f;
    const int i = std::min(int(t), 3);
    for (int c = 0; c < 3; ++c) rgb[c] = ramp[i][c] + (ramp[i + 1][c] - ramp[i][c]) * (t - float(i));
}

const char* errorClassKey(ErrorClass errorClass) {
    static constexpr const char* kKeys[kErrorClassCount] = {
        "right", "missing", "contact_gap", "alias", "over_blur", "under_blur", "acne", "leak", "false_shadow", "other"};
    return kKeys[std::size_t(errorClass)];
}

}  // namespace ombrage
