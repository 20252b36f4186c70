// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ombrage/ao_integrand.h>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A floor at z = 0 beside a step up to `kHeight_m` where x > 0, seen straight down: integrals over a disk of the
/// picture about a point of the floor are integrals over its part beyond the edge.
struct StepScene {
    static constexpr int kSize_px = 128;
    static constexpr double kHeight_m = 4, kRadius_m = 24;

    Scene scene = emptyScene(kSize_px);

    explicit StepScene(bool withStep = true) {
        addLevel(0, -99);
        if (withStep) addLevel(float(kHeight_m), 0);
        scene.aoRadius_m = float(kRadius_m);
    }

    void addLevel(float height_m, float left_m) {
        addQuad(scene, {{left_m, -99, height_m}, {99, -99, height_m}, {99, 99, height_m}, {left_m, 99, height_m}},
                0.1f);
    }

    /// Mean visibility of the pixels whose middles lie `distance_px` + 1/2 before the edge, without those that see the
    /// picture's border.
    double before(int distance_px, const std::string& technique) const {
        RenderSettings settings = squareSettings(kSize_px);
        settings.ao = parsePipeline(Family::Ao, technique);
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.ao->plane(0);
        const int margin = int(kRadius_m) + 1;
        double sum = 0;
        for (int y = margin; y < kSize_px - margin; ++y)
            sum += double(plane[std::size_t(y * kSize_px + kSize_px / 2 - 1 - distance_px)]);
        return sum / (kSize_px - 2 * margin);
    }
};

/// The same for integrands, without a picture: the receiver is the origin, the edge at x = `edge_m`.
class StepProbe final : public AoProbe {
public:
    explicit StepProbe(double edge_m) : m_edge_m(edge_m) {}

    std::optional<double> distanceTo(const glm::dvec3&, double) const override { return std::nullopt; }
    std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const override {
        return glm::dvec3(offset.x, offset.y, offset.x > m_edge_m ? StepScene::kHeight_m : 0.0);
    }

private:
    double m_edge_m;
};

/// A receiver of StepProbe.
inline AoReceiver stepReceiver() {
    AoReceiver receiver;
    receiver.normal = receiver.shadingNormal = {0, 0, 1};
    receiver.right = {1, 0, 0};
    receiver.up = {0, 1, 0};
    receiver.sceneRadius_m = StepScene::kRadius_m;
    return receiver;
}

/// The mean of an integrand over a grid of its first two numbers.
inline double meanOf(const AoIntegrand& integrand, const AoReceiver& receiver, const AoProbe& probe, int grid = 256) {
    double sum = 0;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j)
            sum += integrand.sample(receiver, probe,
                                    {(float(i) + 0.5f) / float(grid), (float(j) + 0.5f) / float(grid), 0.5f, 0.5f});
    return sum / (double(grid) * grid);
}

/// Midpoint rule.
inline double integral(double from, double to, const std::function<double(double)>& f) {
    constexpr int kParts = 4000;
    double sum = 0;
    for (int i = 0; i < kParts; ++i) sum += f(from + (to - from) * (i + 0.5) / kParts);
    return sum * (to - from) / kParts;
}

/// The mean over a disk of a function of the distance aside, beyond an edge at `edge_m`; `density` of that distance.
inline double meanBeyond(double edge_m, double radius_m, const std::function<double(double)>& density,
                         const std::function<double(double)>& f) {
    return integral(edge_m, radius_m, [&](double rho) {
        return f(rho) * density(rho) * std::acos(edge_m / rho) / 3.14159265358979323846;
    });
}

}  // namespace ombrage::test
