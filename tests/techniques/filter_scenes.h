// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// Scenes that show what a filter does to visibility, in pictures of kFilterPicture_px pixels and metres.
inline constexpr int kFilterPicture_px = 96;

/// A dark trench far behind an open quad of 32x32 pixels: the wall at z = -60 carries ribs, so its occlusion is strong
/// right around the quad's outline, while nothing lies within reach of the quad.
inline Scene quadBeforeRibs() {
    Scene scene = emptyScene(kFilterPicture_px);
    const float r = kFilterPicture_px;
    addQuad(scene, {{-r, -r, -60}, {r, -r, -60}, {r, r, -60}, {-r, r, -60}}, 0.1f);
    for (int x = -46; x <= 46; x += 4) {
        const float at = float(x);
        addQuad(scene, {{at, -r, -52}, {at + 2, -r, -60}, {at + 2, r, -60}, {at, r, -52}}, 0.1f);
    }
    addQuad(scene, {{-16, -16, 0}, {16, -16, 0}, {16, 16, 0}, {-16, 16, 0}}, 0.1f);
    return scene;
}

/// Noise beside a wall that leans away, on a slope of 80 degrees: depth changes by 6 pixels from row to row.
inline Scene noisySlope() {
    Scene scene = emptyScene(kFilterPicture_px);
    addQuad(scene, {{-48, -40, -540}, {48, -40, -540}, {48, 40, -60}, {-48, 40, -60}}, 0.1f);
    addQuad(scene, {{0, -40, -540}, {0, 40, -60}, {-20, 0.6f, -53.4f}, {-20, -79.4f, -533.4f}}, 0.1f);
    return scene;
}

inline std::vector<float> aoOf(const Scene& scene, const std::string& pipeline) {
    RenderSettings settings = squareSettings(kFilterPicture_px);
    settings.ao = parsePipeline(Family::Ao, pipeline);
    const RenderResult result = renderFlat(scene, settings);
    return {result.ao->plane(0).begin(), result.ao->plane(0).end()};
}

/// Darkest value on the quad of quadBeforeRibs().
inline float darkestOnQuad(const std::vector<float>& image) {
    float value = 1;
    for (int i = 0; i < kFilterPicture_px * kFilterPicture_px; ++i) {
        const int x = i % kFilterPicture_px - kFilterPicture_px / 2, y = i / kFilterPicture_px - kFilterPicture_px / 2;
        if (x >= -16 && x < 16 && y >= -16 && y < 16) value = std::min(value, image[std::size_t(i)]);
    }
    return value;
}

/// Root of the sum of squared second differences down the columns where noisySlope() is noisiest.
inline double roughnessOfSlope(const std::string& pipeline) {
    const std::vector<float> image = aoOf(noisySlope(), pipeline);
    double sum = 0;
    for (int y = 20; y < kFilterPicture_px - 20; ++y)
        for (int x = 50; x < 54; ++x) {
            const std::size_t i = std::size_t(y * kFilterPicture_px + x);
            const double bend = double(image[i - std::size_t(kFilterPicture_px)]) - 2 * double(image[i]) +
                                double(image[i + std::size_t(kFilterPicture_px)]);
            sum += bend * bend;
        }
    return std::sqrt(sum);
}

/// A floor in shadow, seen from below the sheets that shade it. The sun shines straight down through what they leave
/// open: the pixels whose x and y, counted from the picture's middle to the right and up, lie in [x0, x1) and [y0, y1).
inline Scene lightThroughHole(float x0, float x1, float y0, float y1) {
    Scene scene = emptyScene(kFilterPicture_px);
    const float r = kFilterPicture_px;
    const auto add = [&](float left, float right, float low, float high, float z) {
        addQuad(scene, {{left, low, z}, {right, low, z}, {right, high, z}, {left, high, z}}, 0.1f);
    };
    add(-r, r, -r, r, 0);
    add(-2 * r, x0, -2 * r, 2 * r, 20);
    add(x1, 2 * r, -2 * r, 2 * r, 20);
    add(x0, x1, -2 * r, y0, 20);
    add(x0, x1, y1, 2 * r, 20);
    Light sun;
    sun.name = "sun";
    sun.type = LightType::Sun;
    sun.direction = {0, 0, -1};
    scene.lights = {sun};
    return scene;
}

/// Visibility of exact shadows after a filter, row 0 at the top.
inline std::vector<float> filteredShadow(const Scene& scene, const std::string& filter) {
    RenderSettings settings = squareSettings(kFilterPicture_px);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced+" + filter);
    settings.light = scene.lights.front().name;
    const RenderResult result = renderFlat(scene, settings);
    const auto plane = result.visibility.begin()->second.plane(0);
    return {plane.begin(), plane.end()};
}

/// The lit patch that is 10 pixels wide on a floor in shadow, moved by 20 pixels at once: the brightest pixel of where
/// it was, two pixels and more from where it is, in each of the frames that follow.
inline std::vector<double> ghostsOfPatch(const std::string& filter, int frames) {
    const Scene before = lightThroughHole(-20, -10, -20, 20);
    RenderSettings settings = squareSettings(kFilterPicture_px);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced+" + filter);
    settings.light = "sun";
    Renderer renderer;
    Scene moved = before;
    renderer.setScene(moved);
    renderer.render(settings);
    for (std::size_t i = 1; i < moved.instances.size(); ++i)
        moved.instances[i].worldFromLocal[3] = glm::dvec4(20, 0, 0, 1);
    renderer.moveScene(moved);
    std::vector<double> ghosts;
    for (int n = 0; n < frames; ++n) {
        const Image image = renderer.render(settings).visibility.begin()->second;
        double largest = 0;
        for (int x = -20; x < -11; ++x)
            largest = std::max(largest, double(image.plane(0)[std::size_t(48 * kFilterPicture_px + 48 + x)]));
        ghosts.push_back(largest);
    }
    return ghosts;
}

/// The quad of quadBeforeRibs() goes to the left by 3 pixels a frame: the three columns that the last frame uncovers,
/// which have no history.
inline std::vector<float> uncoveredByQuad(const std::string& pipeline) {
    const Scene scene = quadBeforeRibs();
    RenderSettings settings = squareSettings(kFilterPicture_px);
    settings.ao = parsePipeline(Family::Ao, pipeline);
    Renderer renderer;
    renderer.setScene(scene);
    Scene moved = scene;
    Image image;
    for (int i = 0; i < 6; ++i) {
        moved.instances.back().worldFromLocal[3] = glm::dvec4(-3.0 * i, 0, 0, 1);
        renderer.moveScene(moved);
        image = *renderer.render(settings).ao;
    }
    std::vector<float> values;
    for (int y = 36; y < 60; ++y)
        for (int x = 49; x < 52; ++x) values.push_back(image.plane(0)[std::size_t(y * kFilterPicture_px + x)]);
    return values;
}

inline double rmseBetween(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (double(a[i]) - double(b[i])) * (double(a[i]) - double(b[i]));
    return std::sqrt(sum / double(a.size()));
}

/// What a filter makes of one lit pixel in the middle of a plane in shadow: value dx to the right and dy up of it.
class ImpulseResponse {
public:
    explicit ImpulseResponse(const std::string& filter)
        : m_image(filteredShadow(lightThroughHole(0, 1, 0, 1), filter)) {}
    double at(int dx, int dy) const {
        return double(
            m_image[std::size_t((kFilterPicture_px / 2 - 1 - dy) * kFilterPicture_px + kFilterPicture_px / 2 + dx)]);
    }

private:
    std::vector<float> m_image;
};

/// Weights of a Gaussian over 2 radius + 1 pixels; their sum is 1.
inline std::vector<double> gaussianWeights(int radius, double sigma) {
    std::vector<double> weights;
    double total = 0;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        total += weights.back();
    }
    for (double& w : weights) w /= total;
    return weights;
}

}  // namespace ombrage::test
