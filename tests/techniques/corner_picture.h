// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A floor seen from above, one pixel a metre, and a wall of a height in metres on it along x = 0, whose lit side faces
/// +x. Both are so long that they have no end for what is asked in the middle row.
struct CornerPicture {
    static constexpr int kSize_px = 64;
    Scene scene = emptyScene(kSize_px);

    explicit CornerPicture(float height_m, float end_m = 4000) {
        addQuad(scene, {{-end_m, -end_m, 0}, {end_m, -end_m, 0}, {end_m, end_m, 0}, {-end_m, end_m, 0}}, 0.0f);
        addQuad(scene, {{0, -end_m, 0}, {0, end_m, 0}, {0, end_m, height_m}, {0, -end_m, height_m}}, 0.0f);
        // Over the wall's top.
        scene.cameras[0].position.z = double(height_m) + 10;
    }

    /// The visibilities of the middle row at the floor's pixels x = 0.5, 1.5, ... m away from the wall.
    std::vector<float> row(const std::string& pipeline) const {
        RenderSettings settings = squareSettings(kSize_px);
        settings.ao = parsePipeline(Family::Ao, pipeline);
        const Image image = renderFlat(scene, settings).ao.value();
        const auto from = image.plane(0).begin() + kSize_px / 2 * kSize_px + kSize_px / 2;
        return {from, from + kSize_px / 2};
    }

    /// Rays of length R, the wall at least that high.
    static double nearWall(double d_m, double radius_m) {
        const double c = std::min(1.0, d_m / radius_m);
        return 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / 3.14159265358979;
    }
    /// Rays without end, the wall of height H.
    static double highWall(double d_m, double height_m) { return 1 - 0.5 * (1 - d_m / std::hypot(d_m, height_m)); }
};

}  // namespace ombrage::test
