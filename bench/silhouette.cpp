// SPDX-License-Identifier: MIT
// Silhouettes by the processor, by geometry shader and by compute shader: the time of extraction alone on the
// processor, and of whole small frames under a light that moves in every frame, so that nothing is kept. Meshes:
// spheres of 10k to 1M triangles, and files.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>
#include <CLI/CLI.hpp>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include "scene/mesh_build.h"
#include "scene/shapes.h"
#include "techniques/shared/silhouette.h"

namespace ombrage::bench {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double medianOf(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

Scene sphereScene(int triangles) {
    // Twice as many slices as stacks: 2 * slices * (stacks - 1) triangles.
    const int stacks = int(std::sqrt(triangles / 4.0)) + 1;
    Scene scene = loadScene("sphere");
    scene.name = fmt::format("sphere {}k", triangles / 1000);
    scene.meshes.back() = shapes::sphere({0, 1, 0}, 1.0f, 2 * (stacks - 1), stacks);
    makeTangents(scene.meshes.back());
    return scene;
}

/// Lights on a circle around the scene, at a height.
glm::dvec3 lightAt(const Scene& scene, int step) {
    const Bounds bounds = scene.bounds();
    const double angle = step * 0.61803398875 * glm::two_pi<double>(), far = bounds.diagonal();
    return bounds.center() + glm::dvec3(std::cos(angle), 0.8, std::sin(angle)) * far;
}

const Mesh& largestMesh(const Scene& scene) {
    return *std::max_element(scene.meshes.begin(), scene.meshes.end(),
                             [](const Mesh& a, const Mesh& b) { return a.indices.size() < b.indices.size(); });
}

struct Extraction {
    double topology_ms = 0, median_ms = 0, least_ms = 0;
    double withCaps_ms = 0;  ///< median
    std::size_t triangles = 0, edges = 0, silhouette = 0;
};

Extraction extract(const Scene& scene, int rounds) {
    const Mesh& mesh = largestMesh(scene);
    auto start = Clock::now();
    const MeshTopology topology(mesh);
    Extraction result{.topology_ms = millisecondsSince(start)};
    result.triangles = topology.triangleCount();
    result.edges = topology.edgeCount();
    std::vector<double> times, withCaps;
    for (int i = 0; i < rounds; ++i)
        for (const bool caps : {false, true}) {
            VolumeRequest request;
            request.light_local = glm::dvec4(lightAt(scene, i), 1.0);
            request.both = !topology.closed();
            request.caps = caps;
            VolumeTriangles out;
            start = Clock::now();
            appendVolume(topology, request, out);
            (caps ? withCaps : times).push_back(millisecondsSince(start));
            result.silhouette = out.edges;
        }
    result.withCaps_ms = medianOf(withCaps);
    result.median_ms = medianOf(times);
    result.least_ms = *std::min_element(times.begin(), times.end());
    return result;
}

/// Wall clock of a frame of 64 by 36 pixels with a moved light, shadows included.
double frame_ms(Renderer& renderer, Scene scene, const std::string& technique, int rounds) {
    scene.lights.resize(1);
    scene.lights[0].type = LightType::Point;
    renderer.setScene(scene);
    RenderSettings settings;
    settings.width = 64;
    settings.height = 36;
    settings.timing = Timing::Frame;
    settings.images = false;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    std::vector<double> times;
    for (int i = 0; i < rounds + 2; ++i) {
        scene.lights[0].position = lightAt(scene, i);
        renderer.moveScene(scene);
        const double ms = renderer.render(settings).gpu_ms.median;
        if (i >= 2) times.push_back(ms);
    }
    return medianOf(times);
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) try {
    using namespace ombrage;
    using namespace ombrage::bench;
    std::vector<std::string> files;
    std::vector<int> counts{10000, 30000, 100000, 300000, 1000000};
    int rounds = 15;
    std::string json;
    CLI::App app("Silhouette extraction");
    app.add_option("files", files, "models beside the spheres");
    app.add_option("--triangles", counts, "of the spheres");
    app.add_option("--rounds", rounds)->capture_default_str();
    app.add_option("--json", json, "file for the figures");
    CLI11_PARSE(app, argc, argv);

    std::vector<Scene> scenes;
    for (const int count : counts) scenes.push_back(sphereScene(count));
    for (const std::string& file : files) scenes.push_back(loadScene(file, {.cache = "off"}));

    Renderer renderer;
    nlohmann::json rows = nlohmann::json::array();
    fmt::print("{:<24} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9} | {:>9} {:>9} {:>9} {:>9}\n", "mesh", "triangles",
               "silhouette", "topology", "median", "least", "+ caps", "none", "cpu", "geometry", "compute");
    for (const Scene& scene : scenes) {
        const Extraction e = extract(scene, rounds);
        std::vector<double> frames{frame_ms(renderer, scene, "shadow/none", rounds)};
        for (const char* source : {"cpu", "geometry", "compute"})
            frames.push_back(
                frame_ms(renderer, scene, std::string("shadow/volume-zpass:silhouette=") + source, rounds) - frames[0]);
        fmt::print("{:<24} {:>9} {:>10} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} | {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n",
                   scene.name, e.triangles, e.silhouette, e.topology_ms, e.median_ms, e.least_ms, e.withCaps_ms,
                   frames[0], frames[1], frames[2], frames[3]);
        std::fflush(stdout);
        rows.push_back(
            {{"mesh", scene.name},
             {"triangles", e.triangles},
             {"edges", e.edges},
             {"silhouette_edges", e.silhouette},
             {"topology_ms", e.topology_ms},
             {"extraction_ms", {{"median", e.median_ms}, {"least", e.least_ms}, {"with_caps", e.withCaps_ms}}},
             {"frame_none_ms", frames[0]},
             {"frame_added_ms", {{"cpu", frames[1]}, {"geometry", frames[2]}, {"compute", frames[3]}}}});
    }
    if (!json.empty()) {
        std::FILE* out = std::fopen(json.c_str(), "w");
        if (out == nullptr) throw Error(ErrorCode::Environment, "cannot write '" + json + "'", "choose another file");
        fmt::print(out, "{}\n", rows.dump(2));
        std::fclose(out);
    }
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
