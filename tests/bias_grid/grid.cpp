// SPDX-License-Identifier: MIT
#include "bias_grid/grid.h"

#include <algorithm>

#include <ombrage/reference.h>
#include <ombrage/renderer.h>
#include <ombrage/technique.h>

namespace ombrage::test {

namespace {

constexpr std::size_t kMostLights = 4;

Renderer& sharedRenderer() {
    static Renderer renderer;
    return renderer;
}

}  // namespace

Scene placed(Scene scene, double scale, const glm::dvec3& shift) {
    glm::dmat4 move(scale);
    move[3] = glm::dvec4(shift, 1);
    for (Instance& instance : scene.instances) instance.worldFromLocal = move * instance.worldFromLocal;
    for (Light& light : scene.lights) {
        light.position = light.position * scale + shift;
        light.radius_m *= float(scale);
        light.size_m *= float(scale);
        light.range_m *= float(scale);
        // Candela fall off with the square of the distance, lux and nits do not.
        if (light.type == LightType::Point || light.type == LightType::Spot) light.intensity *= float(scale * scale);
    }
    for (Camera& camera : scene.cameras) {
        camera.position = camera.position * scale + shift;
        camera.target = camera.target * scale + shift;
        if (camera.orthoHeight_m) *camera.orthoHeight_m *= float(scale);
    }
    scene.aoRadius_m *= float(scale);
    scene.animations.clear();
    return scene;
}

double scaleTo(const Scene& scene, double size_m) {
    if (size_m == 0) return 1;
    const Bounds bounds = scene.bounds();
    const glm::dvec3 size = bounds.upper - bounds.lower;
    return size_m / std::max({size.x, size.y, size.z});
}

Scene litBy(Scene scene, LightType type) {
    Light light = scene.lights[0];
    const Bounds bounds = scene.bounds();
    if (light.type == LightType::Sun)
        light.position = bounds.center() - glm::dvec3(light.direction) * (1.5 * bounds.diagonal());
    else
        light.direction = glm::normalize(glm::vec3(bounds.center() - light.position));
    const glm::dvec3 away = bounds.center() - light.position;
    light.type = type;
    light.name = std::string("as ") + lightTypeName(type);
    light.intensity = type == LightType::Sun ? 3.0f : 3.0f * float(glm::dot(away, away));
    light.outer_rad = 0.9f;
    light.inner_rad = 0.7f;
    light.radius_m = light.angle_rad = 0;
    scene.lights = {light};
    return scene;
}

std::vector<GridScene> gridScenes(const std::string& name, const std::vector<LightType>& kinds) {
    const Scene loaded = loadScene(name, {.cache = "off"});
    std::vector<GridScene> made;
    const std::size_t own = loaded.lights.size() > kMostLights ? 1 : loaded.lights.size();
    for (std::size_t l = 0; l < own; ++l) {
        if (loaded.lights[l].type == LightType::Rect) continue;
        GridScene one{name, loaded.lights[l].name, loaded.lights[l].type, loaded};
        one.scene.lights = {loaded.lights[l]};
        made.push_back(std::move(one));
    }
    for (const LightType type : kinds) {
        if (loaded.lights[0].type == type) continue;
        GridScene one{name, "", type, litBy(loaded, type)};
        one.light = one.scene.lights[0].name;
        made.push_back(std::move(one));
    }
    return made;
}

std::vector<GridCell> measureGrid(const GridScene& at, const GridAxes& axes, int width, int height) {
    std::vector<GridCell> cells;
    ReferenceOptions options;
    options.width = width;
    options.height = height;
    for (const double size_m : axes.sizes_m)
        for (const double shift_m : axes.shifts_m) {
            // One truth for each place; nothing of it is carried over, so that it rounds as its own scene does.
            const Scene scene =
                placed(at.scene, scaleTo(at.scene, size_m), glm::normalize(glm::dvec3(3, 1, -2)) * shift_m);
            const Reference reference(scene);
            const Camera& camera = scene.cameras[0];
            const Receivers receivers = reference.receivers(camera, options);
            const ShadowTruth truth = reference.shadow(receivers, camera, 0, options);
            const ShadowFeatures features = reference.shadowFeatures(receivers, 0, options);
            const std::vector<glm::dvec3> positions = reference.positions(receivers);
            sharedRenderer().setScene(scene);
            for (const std::string& name : axes.techniques) {
                const Pipeline pipeline = parsePipeline(Family::Shadow, name);
                if (!supports(technique(pipeline[0].id).domain, at.type)) continue;
                for (const std::string& format : axes.formats)
                    for (const int resolution : axes.resolutions) {
                        RenderSettings settings;
                        settings.width = width;
                        settings.height = height;
                        settings.shadow = pipeline;
                        settings.shadow[0].params.emplace_back("resolution", std::to_string(resolution));
                        settings.shadow[0].params.emplace_back("format", format);
                        const RenderResult result = sharedRenderer().render(settings);

                        ShadowTruth seen = truth;
                        maskDisagreement(seen.mask, seen.maskedShare, receivers, result.instance, result.triangle);
                        ShadowQuestion question;
                        question.footprint = result.footprint.begin()->second;
                        question.inRange = inRange(result.range.begin()->second, positions, camera);
                        question.features = &features;
                        const ShadowMeasurement measured =
                            measureShadow(result.visibility.at(0).plane(0), seen, receivers, question);
                        cells.push_back({at.name, at.light, name, format, resolution, size_m, shift_m, measured.metrics,
                                         measured.validCount});
                    }
            }
        }
    return cells;
}

}  // namespace ombrage::test
