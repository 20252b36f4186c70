// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/renderer.h>

#include "render/geometry_samples.h"

namespace ombrage {

/// Settings that were checked against a scene.
struct RenderRequest {
    int camera = 0;
    std::vector<int> lights;
    bool needsStencil = false;
    bool needsMaterial = false;         ///< of the G-buffer
    GeometrySamples samples;            ///< likewise
    std::vector<std::string> places;    ///< of TechniqueSlots
    std::vector<std::string> warnings;
};

/// @throws Error(Usage) naming what does not fit: sizes, names, pipelines, unsupported lights, pictures to show.
RenderRequest checkRequest(const Scene& scene, const RenderSettings& settings);

/// Every name that RenderSettings::show takes with these settings.
std::vector<PassInfo> showNamesOf(const RenderSettings& settings);

}  // namespace ombrage
