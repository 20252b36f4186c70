// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "metrics/error_classes.h"
#include "techniques/technique_case.h"

namespace ombrage::test {

/// A built-in scene whose first light has the given size: the radius of a lamp in metres, the tangent of half a sun's
/// angle.
inline Scene withSizedLight(const std::string& name, float size) {
    Scene scene = loadScene(name);
    Light& light = scene.lights.front();
    light.radius_m = size;
    light.angle_rad = 2 * std::atan(size);
    return scene;
}

/// A technique's picture of a scene's first light from its first camera.
inline RenderResult renderFirstLight(const Scene& scene, const std::string& technique) {
    RenderSettings settings;
    settings.width = kWidth / 2;
    settings.height = kHeight / 2;
    settings.light = scene.lights.front().name;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    return renderScene(scene, settings);
}

/// What measures say of that picture against `samples` rays a pixel.
inline Metrics measureFirstLight(const Scene& scene, const std::string& technique, int samples) {
    const RenderResult result = renderFirstLight(scene, technique);
    const Reference reference(scene);
    ReferenceOptions options;
    options.width = kWidth / 2;
    options.height = kHeight / 2;
    options.samplesPerPixel = samples;
    const Receivers receivers = reference.receivers(scene.cameras.front(), options);
    ShadowTruth truth = reference.shadow(receivers, scene.cameras.front(), 0, options);
    maskDisagreement(truth.mask, truth.maskedShare, receivers, result.instance, result.triangle);
    const ShadowFeatures features = reference.shadowFeatures(receivers, 0, options);
    ShadowQuestion question;
    question.footprint = result.footprint.begin()->second;
    question.features = &features;
    return measureShadow(measuredPlane(result, Family::Shadow), truth, receivers, question).metrics;
}

}  // namespace ombrage::test
