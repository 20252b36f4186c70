// SPDX-License-Identifier: MIT
#include "random_views/views.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <ombrage/metrics.h>
#include <ombrage/reference.h>
#include <glm/gtc/constants.hpp>

#include "random_views/picture.h"
#include "techniques/shared/silhouette.h"

namespace ombrage::test {

namespace {

/// The same numbers everywhere: the library's distributions differ between standard libraries.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : m_engine(seed) {}

    double within(double least, double most) { return least + (most - least) * double(m_engine() >> 11) * 0x1p-53; }
    bool oneIn(int n) { return within(0, n) < 1; }

    /// Uniform over the sphere.
    glm::dvec3 direction() {
        const double z = within(-1, 1), angle = within(0, glm::two_pi<double>()), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), z, r * std::sin(angle)};
    }

private:
    std::mt19937_64 m_engine;
};

/// A place around the model and above the floor.
glm::dvec3 placeAround(const Stage& stage, Numbers& numbers, double least, double most) {
    for (;;) {
        const glm::dvec3 p = stage.center + numbers.direction() * stage.radius_m * numbers.within(least, most);
        if (p.y > stage.floor_m + 0.02 * stage.radius_m) return p;
    }
}

}  // namespace

Stage makeStage(const std::string& nameOrFile) {
    Stage stage;
    stage.name = nameOrFile.substr(nameOrFile.find_last_of('/') + 1);
    const bool isFile = nameOrFile.find('.') != std::string::npos;
    stage.scene = loadScene(nameOrFile, {.ground = isFile, .cache = "off"});

    // The floor is the flattest mesh: the model is everything else.
    Bounds model;
    std::vector<bool> isModel(stage.scene.meshes.size());
    for (const Instance& instance : stage.scene.instances) {
        Bounds own;
        for (const glm::vec3& p : stage.scene.meshes[std::size_t(instance.mesh)].positions) {
            const glm::dvec3 w(instance.worldFromLocal * glm::dvec4(p, 1.0));
            own.lower = glm::min(own.lower, w);
            own.upper = glm::max(own.upper, w);
        }
        const glm::dvec3 size = own.upper - own.lower;
        if (size.y < 1e-6 * std::max(size.x, size.z)) {
            stage.floor_m = own.upper.y;
            continue;
        }
        isModel[std::size_t(instance.mesh)] = true;
        model.lower = glm::min(model.lower, own.lower);
        model.upper = glm::max(model.upper, own.upper);
    }
    stage.center = model.center();
    stage.radius_m = 0.5 * glm::length(model.upper - model.lower);
    stage.closed = true;
    for (std::size_t m = 0; m < isModel.size(); ++m)
        stage.closed = stage.closed && (!isModel[m] || MeshTopology(stage.scene.meshes[m]).closed());
    return stage;
}

Arrangement arrange(Stage& stage, std::uint64_t seed) {
    Numbers numbers(seed);
    Camera camera;
    camera.name = "random";
    camera.position = placeAround(stage, numbers, 0.9, 3);
    camera.target = stage.center + numbers.direction() * stage.radius_m * numbers.within(0, 0.5);
    camera.fovY_rad = float(glm::radians(numbers.within(30, 80)));
    if (numbers.oneIn(8)) camera.orthoHeight_m = float(stage.radius_m * numbers.within(1, 3));

    Light light;
    light.name = "random";
    light.type = std::array{LightType::Sun, LightType::Spot, LightType::Point}[std::size_t(numbers.within(0, 3))];
    const bool isClose = numbers.oneIn(10);
    light.position = placeAround(stage, numbers, isClose ? 0.2 : 1.05, isClose ? 1.0 : 4.0);
    const glm::dvec3 toward = stage.center + numbers.direction() * stage.radius_m * 0.3 - light.position;
    light.direction = glm::normalize(glm::vec3(toward));
    light.outer_rad = 0.9f;
    light.inner_rad = 0.7f;
    // As bright for the model from any distance, for the pictures.
    light.intensity = light.type == LightType::Sun ? 3.0f : 3.0f * float(glm::dot(toward, toward));
    if (numbers.oneIn(4)) light.range_m = float(glm::length(toward) * numbers.within(0.7, 2));
    stage.scene.cameras = {camera};
    stage.scene.lights = {light};
    stage.scene.animations.clear();
    return {camera.orthoHeight_m ? "orthographic" : "perspective",
            fmt::format("{}{}{}", isClose && light.type != LightType::Sun ? "close " : "", lightTypeName(light.type),
                        std::isfinite(light.range_m) && light.type != LightType::Sun ? " with a range" : "")};
}

std::vector<ViewOutcome> measureView(Renderer& renderer, const Reference& reference, const Stage& stage,
                                     const std::vector<std::string>& techniques, int width, int height) {
    const ReferenceOptions options{.width = width, .height = height};
    const Camera& camera = stage.scene.cameras[0];
    const Receivers receivers = reference.receivers(camera, options);
    const ShadowTruth truth = reference.shadow(receivers, camera, 0, options);

    std::vector<ViewOutcome> outcomes;
    renderer.moveScene(stage.scene);
    for (const std::string& technique : techniques) {
        RenderSettings settings;
        settings.width = width;
        settings.height = height;
        settings.shadow = parsePipeline(Family::Shadow, technique);
        const RenderResult result = renderer.render(settings);
        const auto plane = result.visibility.at(0).plane(0);
        const std::vector<float> visibility(plane.begin(), plane.end());

        ShadowTruth seen = truth;
        maskDisagreement(seen.mask, seen.maskedShare, receivers, result.instance, result.triangle);
        const ShadowMeasurement measured = measureShadow(visibility, seen, receivers);
        ViewOutcome outcome;
        outcome.valid = measured.validCount;
        outcome.wrong = measured.metrics.at("wrong").value_or(0.0);
        for (std::size_t i = 0; i < visibility.size(); ++i)
            outcome.dark += seen.mask[i] == Mask::Valid && seen.visibility[i] < 0.5f ? 1 : 0;
        outcome.dark /= double(std::max<std::size_t>(outcome.valid, 1));
        if (outcome.wrong > 0) outcome.errors = errorPicture(result.picture, visibility, seen);
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

}  // namespace ombrage::test
