// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <ombrage/metrics.h>

#include "technique_case.h"

namespace ombrage::test {

/// Pictures of a built-in scene's first camera in a smaller size than that of the benches, and their truth with many
/// samples. Receivers' normals are the truth's: of the geometry.
class AmbientMeasure {
public:
    static constexpr int kWidth_px = 128, kHeight_px = 72;

    AmbientMeasure(const std::string& scene, const std::string& truth, int samples)
        : m_scene(loadScene(scene)), m_reference(m_scene) {
        ReferenceOptions options;
        options.width = kWidth_px;
        options.height = kHeight_px;
        options.samplesPerPixel = samples;
        options.kind = truthKindFromName(truth, Quantity::Ao);
        m_receivers = m_reference.receivers(m_scene.cameras.front(), options);
        m_truth = m_reference.ao(m_receivers, m_scene.cameras.front(), options);
    }

    const Scene& scene() const { return m_scene; }
    const AoTruth& truth() const { return m_truth; }

    static RenderSettings settings(const std::string& pipeline) {
        RenderSettings settings;
        settings.width = kWidth_px;
        settings.height = kHeight_px;
        settings.normals = NormalSource::Geometry;
        settings.ao = parsePipeline(Family::Ao, pipeline);
        return settings;
    }

    /// The metrics of what a pipeline draws.
    Metrics of(const std::string& pipeline) const {
        const RenderResult result = renderScene(m_scene, settings(pipeline));
        AoTruth truth = m_truth;
        maskDisagreement(truth.mask, truth.maskedShare, m_receivers, result.instance, result.triangle);
        return measureAo(measuredPlane(result, Family::Ao), truth);
    }

private:
    const Scene m_scene;
    const Reference m_reference;
    Receivers m_receivers;
    AoTruth m_truth;
};

}  // namespace ombrage::test
