// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"
#include "reference/surface_color.h"

namespace ombrage {
Image Reference::picture(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const Scene& scene = m_impl->scene;
    const FlatScene& flat = m_impl->flat;
    const std::size_t count = receivers.triangle.size();

    // Each light and the occlusion is one stage of the progress.
    const double stages = double(scene.lights.size()) + 1;
    double stage = 0;
    ReferenceOptions part = options;
    if (options.progress) part.progress = [&](double share) { return options.progress((stage + share) / stages); };

    // Radiance of the surroundings, occluded; without a radius nothing is.
    std::vector<glm::vec3> arriving(count, glm::vec3(scene.ambient));
    if (scene.aoRadius_m > 0) {
        const AoTruth sky = ao(receivers, camera, part);
        for (std::size_t i = 0; i < count; ++i) arriving[i] *= sky.visibility[i];
    }

    // Direct light: what a Lambert surface sends back is irradiance / pi.
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        stage += 1;
        const Light& light = scene.lights[l];
        const float luminance = 0.2126f * light.color.r + 0.7152f * light.color.g + 0.0722f * light.color.b;
        if (!(luminance > 0)) continue;
        const ShadowTruth truth = shadow(receivers, camera, int(l), part);
        for (std::size_t i = 0; i < count; ++i)
            arriving[i] += light.color * (truth.irradiance[i] * truth.irradianceShare[i] / (luminance * 3.14159265f));
    }

    Image image = Image::rgb(receivers.width, receivers.height);
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 radiance(scene.ambient);
        if (receivers.triangle[i] != kNoHit) {
            const SurfaceColor color = surfaceColor(scene, flat, receivers.triangle[i], receivers.barycentric[i]);
            radiance = color.base * arriving[i] + color.emissive;
        }
        for (int c = 0; c < 3; ++c) image.plane(c)[i] = radiance[c];
    }
    return image;
}

}  // namespace ombrage
