// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ombrage/reference.h>

#include "scene/shapes.h"

namespace ombrage::test {

/// A scene put together by hand: one grey material, one model and instance per mesh.
inline void add(Scene& scene, Mesh mesh, const glm::dvec3& at = glm::dvec3(0)) {
    if (scene.materials.empty()) scene.materials.emplace_back();
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    Instance instance;
    instance.mesh = int(scene.meshes.size());
    instance.model = int(scene.models.size());
    instance.worldFromLocal[3] = glm::dvec4(at, 1);
    scene.meshes.push_back(std::move(mesh));
    scene.models.emplace_back();
    scene.instances.push_back(instance);
}

/// A rectangle in the plane z = `height`, x from `x0` to `x1`, y from -`half` to `half`, facing up (+z).
inline Mesh slab(float x0, float x1, float half, float height) {
    return shapes::rectangle({x0, -half, height}, {x1 - x0, 0, 0}, {0, 2 * half, 0});
}

inline Light sun(const glm::vec3& direction, float angle_rad = 0) {
    Light light;
    light.direction = glm::normalize(direction);
    light.angle_rad = angle_rad;
    return light;
}

inline Light point(const glm::dvec3& position, float radius_m = 0) {
    Light light;
    light.type = LightType::Point;
    light.position = position;
    light.radius_m = radius_m;
    return light;
}

inline Camera camera(const glm::dvec3& from, const glm::dvec3& to, const glm::vec3& up = {0, 1, 0}) {
    Camera c;
    c.position = from;
    c.target = to;
    c.up = up;
    return c;
}

inline ReferenceOptions picture(int width, int height, int samples = 0) {
    ReferenceOptions options;
    options.width = width;
    options.height = height;
    options.samplesPerPixel = samples;
    return options;
}

/// The mean over 64 seeds: its standard error has some 450 degrees of freedom, so 3 of them are exceeded once in 360
/// trials; one run of 8 scramblings alone (7 degrees) would once in 50.
inline Reference::Estimate pooled(const std::function<Reference::Estimate(std::uint64_t seed)>& estimate) {
    constexpr int kSeeds = 64;
    Reference::Estimate sum;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const auto e = estimate(std::uint64_t(seed));
        sum.mean += e.mean / kSeeds;
        sum.standardError += e.standardError * e.standardError / (kSeeds * kSeeds);
    }
    return {sum.mean, std::sqrt(sum.standardError)};
}

/// Within 3 standard errors; `allowance` is what the scene itself deviates by from the closed form.
inline void expectClosedForm(const Reference::Estimate& e, double exact, double allowance = 0) {
    EXPECT_NEAR(e.mean, exact, 3 * e.standardError + allowance) << "standard error " << e.standardError;
}

}  // namespace ombrage::test
