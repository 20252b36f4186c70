// SPDX-License-Identifier: MIT
// Wall time of whole frames, techniques and the minimal loop by turns in one process: medians of each round, and
// medians over the rounds of the ratios to the first subject in the same round.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/process_time.h"
#include "lab/statistics.h"
#include "shared/minimal_loop.h"

namespace ombrage::bench {
namespace {

struct Times {
    std::vector<double> wall_ms, cpu_ms;
};

/// Something that draws frames, and the medians over its frames in each round.
struct Subject {
    std::string name;
    std::function<Times(int frames)> run;
    std::vector<double> rounds_ms, ratios, cpuRounds_ms, cpuRatios;
    double least_ms = INFINITY, cpuLeast_ms = INFINITY;  ///< of all frames: what others on the machine disturb least
};

struct Options {
    std::string scene, shaderDir, device;
    std::vector<std::string> shadows{"none"};
    bool yardstick = false, images = false, json = false;
    int width = 1280, height = 720, rounds = 5, frames = 12, mapSize = 2048;
};

int run(const Options& options) {
    const Scene scene = loadScene(options.scene);
    RendererOptions device;
    device.shaderDir = options.shaderDir;
    device.device = options.device;
    Renderer renderer(device);
    renderer.setScene(scene);
    std::unique_ptr<MinimalLoop> loop;
    std::vector<Subject> subjects;
    if (options.yardstick) {
        loop = std::make_unique<MinimalLoop>(scene, options.width, options.height, options.mapSize, options.device);
        for (bool shadows : {false, true})
            subjects.push_back({shadows ? "minimal loop, hard" : "minimal loop, none", [&, shadows](int frames) {
                                    Times times;
                                    for (int i = 0; i < frames; ++i) {
                                        const double start = processTime_ms();
                                        times.wall_ms.push_back(loop->frame(shadows));
                                        times.cpu_ms.push_back(processTime_ms() - start);
                                    }
                                    return times;
                                }});
    }
    for (const std::string& text : options.shadows)
        subjects.push_back({"shadow/" + text, [&, text](int frames) {
                                RenderSettings settings;
                                settings.width = options.width;
                                settings.height = options.height;
                                settings.shadow = parsePipeline(Family::Shadow, text);
                                settings.ambient = AmbientTerm::Constant;
                                settings.images = options.images;
                                settings.timing = Timing::Frame;
                                settings.frames = frames + 1;
                                // Called before each frame: the last one, with its readback, is not counted.
                                std::vector<double> stamps;
                                settings.progress = [&](double) {
                                    stamps.push_back(processTime_ms());
                                    return true;
                                };
                                Times times{renderer.render(settings).frames_ms, {}};
                                times.wall_ms.pop_back();
                                for (std::size_t i = 1; i < stamps.size(); ++i)
                                    times.cpu_ms.push_back(stamps[i] - stamps[i - 1]);
                                return times;
                            }});

    for (Subject& subject : subjects) subject.run(2);
    for (int round = 0; round < options.rounds; ++round) {
        for (Subject& subject : subjects) {
            const Times times = subject.run(options.frames);
            subject.rounds_ms.push_back(medianOf(times.wall_ms));
            subject.cpuRounds_ms.push_back(medianOf(times.cpu_ms));
            for (double ms : times.wall_ms) subject.least_ms = std::min(subject.least_ms, ms);
            for (double ms : times.cpu_ms) subject.cpuLeast_ms = std::min(subject.cpuLeast_ms, ms);
            subject.ratios.push_back(subject.rounds_ms.back() / subjects.front().rounds_ms.back());
            subject.cpuRatios.push_back(subject.cpuRounds_ms.back() / subjects.front().cpuRounds_ms.back());
        }
    }
    if (!options.json) fmt::print("{:40s} {:>8s}    ratio to the first\n", "", "wall");
    nlohmann::json records = nlohmann::json::array();
    for (const Subject& subject : subjects) {
        const double ms = medianOf(subject.rounds_ms), ratio = medianOf(subject.ratios);
        const auto [low, high] = std::minmax_element(subject.ratios.begin(), subject.ratios.end());
        if (!options.json)
            fmt::print("{:40s} {:8.2f} ms {:6.2f} [{:.2f} .. {:.2f}]   {:8.2f} ms of CPU {:6.2f}, least {:.2f}\n",
                       subject.name, ms, ratio, *low, *high, medianOf(subject.cpuRounds_ms),
                       medianOf(subject.cpuRatios), subject.cpuLeast_ms);
        records.push_back({{"subject", subject.name},
                           {"ms_median", ms},
                           {"ms_least", subject.least_ms},
                           {"rounds_ms", subject.rounds_ms},
                           {"ratio", ratio},
                           {"cpu_ms_median", medianOf(subject.cpuRounds_ms)},
                           {"cpu_ms_least", subject.cpuLeast_ms},
                           {"cpu_ratio", medianOf(subject.cpuRatios)}});
    }
    if (options.json)
        fmt::print("{}\n", nlohmann::json{{"scene", scene.name},
                                          {"size", {options.width, options.height}},
                                          {"renderer", renderer.device().renderer},
                                          {"subjects", records}}
                               .dump(1));
    return 0;
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) {
    ombrage::bench::Options options;
    CLI::App app("Frame times of shadow techniques and of a minimal loop, by turns");
    app.add_option("scene", options.scene, "built-in scene or file")->required();
    app.add_option("--shadow", options.shadows, "pipelines, as for ombrage render")->delimiter('\0');
    app.add_flag("--yardstick", options.yardstick, "also the minimal loop, first");
    app.add_flag("--images", options.images, "visibility is kept as an image, as where it is measured");
    app.add_option("--shader-dir", options.shaderDir, "read shaders from here");
    app.add_option("--device", options.device, "software, or the index of an EGL device");
    app.add_option("--width", options.width);
    app.add_option("--height", options.height);
    app.add_option("--rounds", options.rounds)->check(CLI::PositiveNumber);
    app.add_option("--frames", options.frames, "of each subject in each round")->check(CLI::PositiveNumber);
    app.add_flag("--json", options.json);
    CLI11_PARSE(app, argc, argv);
    try {
        return ombrage::bench::run(options);
    } catch (const ombrage::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
