// SPDX-License-Identifier: MIT
// How often `ombrage bench` is right: the same technique twice, and once with 10 % of work planted in every frame, on
// this machine as busy as it is. Exit code 1 when fewer than 49 of 50 tries are right.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/process_time.h"
#include "core/whole_file.h"
#include "lab/statistics.h"
#include "lab/turns.h"

namespace ombrage::bench {
namespace {

constexpr int kFrames = TurnPlan{}.framesPerRound;

struct Options {
    std::string scene = "gap", shadow = "map", device, json;
    int width = 320, height = 180, tries = 50;
    double planted = 0.1;
};

/// Keeps one processor busy.
void spin(double time_ms) {
    const double end = processTime_ms() + time_ms;
    while (processTime_ms() < end) {
    }
}

int run(const Options& options) {
    RendererOptions rendererOptions;
    rendererOptions.device = options.device;
    const Scene scene = loadScene(options.scene);
    Renderer renderer(rendererOptions);
    renderer.setScene(scene);
    const bool software = renderer.device().software;
    RenderSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.shadow = parsePipeline(Family::Shadow, options.shadow);
    const auto costOf = [&](const FrameCosts& costs) {
        return costsOfRounds(software ? costs.process_ms : costs.gpu_ms, kFrames);
    };
    const double frame_ms = medianOf(costOf(drawFrames(renderer, settings, 50)));
    RenderSettings slowed = settings;
    slowed.progress = [&](double) {
        if (software) spin(options.planted * frame_ms);
        return true;
    };
    const Subject plain = [&](int frames) { return drawFrames(renderer, settings, frames); };
    const Subject planted = [&](int frames) {
        FrameCosts costs = drawFrames(renderer, slowed, frames);
        // No work of the processor lengthens a GPU's frame: there the time itself is.
        if (!software)
            for (double& time : costs.gpu_ms) time *= 1 + options.planted;
        return costs;
    };
    int twins = 0, found = 0;
    nlohmann::ordered_json tries = nlohmann::ordered_json::array();
    for (int i = 0; i < options.tries; ++i) {
        const auto differenceTo = [&](const Subject& other) {
            const auto costs = takeTurnsUntilClear(
                {plain, other}, {.deciding = software ? &FrameCosts::process_ms : &FrameCosts::gpu_ms}, [](int) {});
            return pairedDifference(costOf(costs[0]), costOf(costs[1]), 1);
        };
        const Difference same = differenceTo(plain), more = differenceTo(planted);
        twins += same.verdict == Difference::Verdict::None;
        found += more.verdict == Difference::Verdict::More;
        const auto asJson = [](const Difference& d) {
            return nlohmann::ordered_json{
                {"change", d.change}, {"low", d.low}, {"high", d.high}, {"verdict", verdictName(d.verdict)}};
        };
        tries.push_back({{"twin", asJson(same)}, {"planted", asJson(more)}});
        fmt::print(stderr, "{:3}: twin {:+.2f} % [{:+.2f}, {:+.2f}], planted {:+.2f} % [{:+.2f}, {:+.2f}]\n", i + 1,
                   100 * same.change, 100 * same.low, 100 * same.high, 100 * more.change, 100 * more.low,
                   100 * more.high);
    }
    fmt::print("{}: twins not told apart in {} of {} tries, {:g} % found in {}\n", renderer.device().renderer, twins,
               options.tries, 100 * options.planted, found);
    if (!options.json.empty())
        writeWhole(options.json, nlohmann::ordered_json{{"device", renderer.device().renderer},
                                                        {"decided_by", software ? "process_ms" : "gpu_ms"},
                                                        {"scene", options.scene},
                                                        {"technique", options.shadow},
                                                        {"size", {options.width, options.height}},
                                                        {"frame_ms", frame_ms},
                                                        {"planted", options.planted},
                                                        {"tries", options.tries},
                                                        {"twins_not_told_apart", twins},
                                                        {"planted_found", found},
                                                        {"differences", tries}}
                                         .dump(1) +
                                     "\n");
    return std::min(twins, found) * 50 >= 49 * options.tries ? 0 : 1;
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) {
    ombrage::bench::Options options;
    CLI::App app("How often a bench tells twins apart, and finds a planted slowdown");
    app.add_option("--scene", options.scene);
    app.add_option("--shadow", options.shadow, "pipeline, as for ombrage render");
    app.add_option("--width", options.width)->check(CLI::PositiveNumber);
    app.add_option("--height", options.height)->check(CLI::PositiveNumber);
    app.add_option("--tries", options.tries)->check(CLI::PositiveNumber);
    app.add_option("--planted", options.planted, "share of the frame's own cost (0.1)")->check(CLI::PositiveNumber);
    app.add_option("--device", options.device, "as for ombrage render");
    app.add_option("--json", options.json, "file to write");
    CLI11_PARSE(app, argc, argv);
    try {
        return ombrage::bench::run(options);
    } catch (const ombrage::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return int(error.code());
    }
}
