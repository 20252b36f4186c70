// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/ao_integrand.h>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A board beside a floor's point, seen from straight above: without end along y, from `near_m` to `far_m` aside, at
/// one height. From techniques that search the picture for horizons it hides what a closed form says.
struct StripOverFloor {
    double near_m = 1, far_m = 1e9, height_m = 1;

    /// The share of the cosine-weighted hemisphere under a line without end, this far aside and this high.
    static double under(double aside_m, double height) { return 0.5 * (1 - aside_m / std::hypot(aside_m, height)); }

    /// Where it takes everything below its front for closed.
    double underHorizon() const { return 1 - under(near_m, height_m); }
    /// Where it reaches `thickness_m` (less than its height) down: light passes under its far edge.
    double overGap(double thickness_m) const {
        return 1 - under(near_m, height_m) + under(far_m, height_m - thickness_m);
    }
};

/// The strip as an integrand may ask for it at the floor's point.
class StripProbe final : public AoProbe {
public:
    explicit StripProbe(const StripOverFloor& strip) : m_strip(strip) {}

    std::optional<double> distanceTo(const glm::dvec3&, double) const override { return std::nullopt; }
    std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const override {
        const bool isOver = offset.x >= m_strip.near_m && offset.x <= m_strip.far_m;
        return glm::dvec3(offset.x, offset.y, isOver ? m_strip.height_m : 0);
    }

private:
    const StripOverFloor m_strip;
};

/// The mean of an integrand over its u, at a point that an orthographic camera sees from above.
inline double meanOverFloor(const AoIntegrand& integrand, const AoProbe& probe, double radius_m) {
    AoReceiver receiver;
    receiver.normal = receiver.shadingNormal = receiver.toEye = glm::dvec3(0, 0, 1);
    receiver.sceneRadius_m = radius_m;
    constexpr int kSamples = 20000;
    double sum = 0;
    for (int i = 1; i <= kSamples; ++i) {
        // Powers of the root of x^5 = x + 1: even in four dimensions.
        glm::vec4 u;
        double power = 1;
        for (int k = 0; k < 4; ++k) {
            power /= 1.1673039782614187;
            u[k] = float(i * power - std::floor(i * power));
            if (u[k] >= 1) u[k] = 0;
        }
        sum += integrand.sample(receiver, probe, u);
    }
    return sum / kSamples;
}

/// The strip in a picture of one metre to the pixel: x from 0 to the left, seen from above.
struct StripPicture {
    static constexpr int kSize_px = 128;
    static constexpr float kHeight_m = 8;

    Scene scene = emptyScene(kSize_px);

    /// @param width_m of the strip; 0 leaves the floor bare
    explicit StripPicture(float width_m) {
        addQuad(scene, {{-99, -99, 0}, {99, -99, 0}, {99, 99, 0}, {-99, 99, 0}}, 0.1f);
        if (width_m > 0)
            addQuad(scene,
                    {{-width_m, -99, kHeight_m}, {0, -99, kHeight_m}, {0, 99, kHeight_m}, {-width_m, 99, kHeight_m}},
                    0.1f);
    }

    /// The row through the middle, from the first pixel to the right of the strip; pixel i is at x = i + 0.5.
    std::vector<float> row(const std::string& technique) const {
        RenderSettings settings = squareSettings(kSize_px);
        settings.ao = parsePipeline(Family::Ao, technique);
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.ao->plane(0);
        const auto first = plane.begin() + kSize_px / 2 * kSize_px + kSize_px / 2;
        return {first, first + kSize_px / 2};
    }
};

}  // namespace ombrage::test
