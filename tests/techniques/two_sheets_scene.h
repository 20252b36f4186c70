// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A floor under a sun that shines straight down, seen from between it and two sheets: the upper one, at 20 m, ends at
/// x = 0; the lower one, at 11 m, covers everything or nothing. A texel of the map is a pixel and, but for its border
/// of one part in a thousand, a metre; the edge lies between two of them.
struct TwoSheets {
    static constexpr int kSize_px = 128, kMap_texels = 96;
    static constexpr float kUpper_m = 20, kLower_m = 11, kHalf_m = 48;

    Scene scene = emptyScene(kSize_px);

    explicit TwoSheets(bool withLower) {
        addLevel(0, -99, 99, 99);
        addLevel(kUpper_m, -kHalf_m, 0, kHalf_m);
        // The map reaches from the upper sheet's end to this one's.
        addLevel(kUpper_m, kHalf_m - 4, kHalf_m, kHalf_m);
        if (withLower) addLevel(kLower_m, -kHalf_m, kHalf_m, kHalf_m);
        Light light;
        light.name = "light";
        light.type = LightType::Sun;
        light.direction = {0, 0, -1};
        scene.lights = {light};
    }

    void addLevel(float height_m, float left_m, float right_m, float half_m) {
        addQuad(scene,
                {{left_m, -half_m, height_m},
                 {right_m, -half_m, height_m},
                 {right_m, half_m, height_m},
                 {left_m, half_m, height_m}},
                0.1f);
    }

    /// Parameters for lookups in the middle of texels, without bias, under a box of 31 texels.
    static std::string plain(const std::string& technique, const std::string& more = "") {
        return technique +
               ":resolution=96,kernel=31,blur=box,mipmaps=false,bias=constant,constant-bias=0,crease=0,bleeding=0" +
               more;
    }

    std::vector<float> picture(const std::string& technique) const {
        RenderSettings settings = squareSettings(kSize_px);
        settings.shadow = parsePipeline(Family::Shadow, technique);
        settings.light = "light";
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        return {plane.begin(), plane.end()};
    }

    /// The row through the middle; pixel i is at x = i + 0.5 - 64.
    std::vector<float> row(const std::string& technique) const {
        const std::vector<float> all = picture(technique);
        const auto first = all.begin() + kSize_px / 2 * kSize_px;
        return {first, first + kSize_px};
    }

    /// The share of the box about a pixel that lies beside the upper sheet.
    static double freeShare(int pixel) {
        const double x_texels = (pixel + 0.5 - kSize_px / 2) * kMap_texels / (2 * double(kHalf_m) * 1.002);
        return std::clamp((x_texels + 15.5) / 31, 0.0, 1.0);
    }

    /// z of a height, in [-1,1] from the upper sheet to the floor, with the range's border of one part in a thousand.
    static double depthOf(double height_m) { return 0.998 * (1 - 2 * height_m / double(kUpper_m)); }
};

}  // namespace ombrage::test
