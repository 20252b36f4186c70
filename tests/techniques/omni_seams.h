// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ombrage/metrics.h>

#include "techniques/technique_case.h"

namespace ombrage::test {

struct SeamCount {
    double wrong = 0;                             ///< share of the valid pixels, as the metric
    std::size_t seamPixels = 0, wrongAtSeam = 0;  ///< valid ones within two texels of a seam between views
};

/// A technique on `room`. @param toSeam_rad of a unit direction from the light: its angle to the nearest seam
/// @param seam_rad two texels
inline SeamCount countSeams(const std::string& technique, const std::string& cameraName,
                            const std::function<double(const glm::dvec3&)>& toSeam_rad, double seam_rad) {
    Bench& bench = Bench::of("room");
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.camera = cameraName;
    settings.light = bench.scene().lights.front().name;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    const RenderResult result = renderScene(bench.scene(), settings);
    const std::vector<float> visibility = measuredPlane(result, Family::Shadow);
    ShadowTruth truth = bench.shadow(cameraName, settings.light, 0);
    const Receivers& receivers = bench.receivers(cameraName);
    maskDisagreement(truth.mask, truth.maskedShare, receivers, result.instance, result.triangle);

    SeamCount count;
    count.wrong = *measureShadow(visibility, truth, receivers).metrics.at("wrong");
    const std::vector<glm::dvec3> positions = Reference(bench.scene()).positions(receivers);
    const glm::dvec3 light = bench.scene().lights.front().position;
    for (std::size_t i = 0; i < visibility.size(); ++i) {
        if (truth.mask[i] != Mask::Valid || toSeam_rad(glm::normalize(positions[i] - light)) > seam_rad) continue;
        ++count.seamPixels;
        count.wrongAtSeam += std::abs(visibility[i] - truth.visibility[i]) > 0.5f ? 1 : 0;
    }
    return count;
}

/// The row's budget: as many texels as six of 1024^2 make at most 1.5 times as many wrong pixels, and seams are no
/// worse than shadows' edges are anyway: at most one in a hundred of their pixels.
inline void expectOmniBudget(const std::string& technique, const std::function<double(const glm::dvec3&)>& toSeam_rad,
                             double seam_rad) {
    std::size_t pixels = 0, wrong = 0;
    for (const char* camera : {"main", "left", "top"}) {
        const SeamCount cube = countSeams("shadow/map:resolution=1024", camera, toSeam_rad, seam_rad);
        const SeamCount omni = countSeams(technique, camera, toSeam_rad, seam_rad);
        EXPECT_LE(omni.wrong, 1.5 * cube.wrong) << camera;
        pixels += omni.seamPixels;
        wrong += omni.wrongAtSeam;
    }
    EXPECT_GE(pixels, 1000u);
    EXPECT_LE(double(wrong), 0.01 * double(pixels));
    testing::Test::RecordProperty("seam pixels", int(pixels));
    testing::Test::RecordProperty("wrong at seams", int(wrong));
}

}  // namespace ombrage::test
