// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A white half plane on black whose edge passes the picture's middle and leaves the vertical by a slope: what is true
/// is the share of every pixel that it covers.
struct SlantedEdge {
    static constexpr int kSize_px = 128;

    /// @param upright false: leaves the level line instead @param shift_px of the edge, to the right (upwards)
    static Scene scene(double slope, bool upright = true, double shift_px = 0) {
        // The half plane reaches beyond the picture on all other sides.
        Scene made = emptyScene(kSize_px);
        const float reach = kSize_px, lean = float(slope) * reach, shift = float(shift_px);
        const auto corner = [&](float along, float across) {
            return upright ? glm::vec3(across, along, 0) : glm::vec3(along, across, 0);
        };
        addQuad(made,
                {corner(-reach, shift - lean), corner(-reach, 2 * reach), corner(reach, 2 * reach),
                 corner(reach, shift + lean)},
                1.0f);
        return made;
    }

    static std::vector<float> picture(const Scene& made, const std::string& aa) {
        RenderSettings settings = squareSettings(kSize_px);
        settings.aa = parsePipeline(Family::Aa, aa);
        const RenderResult result = renderFlat(made, settings);
        return {result.picture.plane(0).begin(), result.picture.plane(0).end()};
    }

    /// Linear grey.
    static std::vector<float> picture(double slope, const std::string& aa, bool upright = true, double shift_px = 0) {
        return picture(scene(slope, upright, shift_px), aa);
    }

    /// Share of the pixel's area to the right of the edge x = slope * y + shift.
    static double coverage(double slope, int column, int row, double shift_px = 0) {
        constexpr int kGrid = 32;
        int inside = 0;
        for (int j = 0; j < kGrid; ++j)
            for (int i = 0; i < kGrid; ++i) {
                const double x = column + (i + 0.5) / kGrid - 0.5 * kSize_px,
                             y = 0.5 * kSize_px - row - (j + 0.5) / kGrid;
                inside += x > slope * y + shift_px ? 1 : 0;
            }
        return double(inside) / (kGrid * kGrid);
    }

    /// Against the coverage of the upright edge, leaving out `border_px` pixels on each side.
    static double rmse(const std::vector<float>& grey, double slope, int border_px = 0, double shift_px = 0) {
        double sum = 0;
        int count = 0;
        for (int row = border_px; row < kSize_px - border_px; ++row)
            for (int column = border_px; column < kSize_px - border_px; ++column, ++count) {
                const double e =
                    double(grey[std::size_t(row * kSize_px + column)]) - coverage(slope, column, row, shift_px);
                sum += e * e;
            }
        return std::sqrt(sum / count);
    }
};

}  // namespace ombrage::test
