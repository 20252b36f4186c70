// SPDX-License-Identifier: MIT
// ombrage_bench_scaling [--axis triangles|lights|pixels] [--json F] [--csv F] [--plots DIR]: what a frame costs against
// the triangles, the lights and the pixels, on generated scenes of spheres, and the exponent of each growth.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
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
#include "lab/log_plot.h"
#include "lab/spheres.h"

namespace ombrage::bench {
namespace {

/// Growth with an exponent up to here counts as linear: single points scatter by 10 to 20 % on a busy machine, which is
/// 0.1 in the slope over one to two decades.
constexpr double kLinear = 1.1;

/// What else the machine does only ever adds: the least of the frames is nearest to the frame's own cost.
double leastOf(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

struct Point {
    double x = 0, wall_ms = 0, cpu_ms = 0;
};

struct Series {
    std::string axis, technique, refused;
    std::vector<Point> points;
};

struct Options {
    std::vector<std::string> axes{"triangles", "lights", "pixels"};
    std::string json, csv, plots, device;
    int frames = 5;
    double largest = 4e6;
};

/// One point of a curve: what is drawn and how.
struct Setup {
    double x;
    std::size_t triangles;
    int lights, width, height, mapSize;
};

std::vector<Setup> setupsOf(const std::string& axis, double largest) {
    std::vector<Setup> setups;
    if (axis == "triangles")
        for (const double count : {1e4, 4e4, 16e4, 64e4, 2e6, 4e6})
            if (count <= largest) setups.push_back({count, std::size_t(count), 1, 640, 360, 1024});
    if (axis == "lights")
        for (const int count : {1, 4, 16, 64, 256}) setups.push_back({double(count), 5000, count, 320, 180, 256});
    if (axis == "pixels")
        for (const int height : {360, 720, 1080, 1440, 2160})
            setups.push_back({double(height * height * 16 / 9), 20000, 1, height * 16 / 9, height, 1024});
    return setups;
}

std::vector<std::string> techniquesOf(const std::string& axis) {
    std::vector<std::string> names{"none", "map", "volume-zfail"};
    if (axis == "triangles") names.push_back("ray-traced");
    return names;
}

Point measure(Renderer& renderer, const Setup& setup, const std::string& technique, int frames) {
    RenderSettings settings;
    settings.width = setup.width;
    settings.height = setup.height;
    // The map is drawn in every frame: kept, it would cost nothing and say nothing.
    const std::string map = fmt::format("map:cache=false,resolution={}", setup.mapSize);
    settings.shadow = parsePipeline(Family::Shadow, technique == "map" ? map : technique);
    settings.ambient = AmbientTerm::Constant;
    settings.timing = Timing::Frame;
    settings.warmupFrames = 1;
    settings.frames = frames + 1;
    // Called before each frame: the warm-up and the last one, with its readback, are not counted.
    std::vector<double> stamps;
    settings.progress = [&](double) {
        stamps.push_back(processTime_ms());
        return true;
    };
    std::vector<double> wall = renderer.render(settings).frames_ms, cpu;
    wall.pop_back();
    for (std::size_t i = 2; i < stamps.size(); ++i) cpu.push_back(stamps[i] - stamps[i - 1]);
    return {setup.x, leastOf(wall), leastOf(cpu)};
}

std::vector<Series> measureAxis(Renderer& renderer, const std::string& axis, const Options& options) {
    std::vector<Series> all;
    for (const std::string& technique : techniquesOf(axis)) all.push_back({axis, technique, "", {}});
    for (const Setup& setup : setupsOf(axis, options.largest)) {
        const Scene scene = spheresScene(setup.triangles, setup.lights);
        renderer.setScene(scene);
        for (Series& series : all) {
            if (!series.refused.empty()) continue;
            try {
                Point point = measure(renderer, setup, series.technique, options.frames);
                if (axis == "triangles") point.x = double(scene.triangleCount());
                series.points.push_back(point);
                fmt::print(stderr, "{:<10} {:>9.0f} {:<13} {:10.2f} ms wall {:10.2f} ms CPU\n", axis, point.x,
                           series.technique, point.wall_ms, point.cpu_ms);
            } catch (const Error& error) {
                series.refused = fmt::format("{:.0f}: {}", setup.x, error.message());
                fmt::print(stderr, "{} {}\n", series.technique, series.refused);
            }
        }
    }
    return all;
}

/// Exponent over the points from `first` on; all of them when fewer than three would be left.
double exponentFrom(const Series& series, std::size_t first, double Point::*cost) {
    std::vector<double> x, y;
    for (std::size_t i = std::min(first, series.points.size() - 3); i < series.points.size(); ++i) {
        x.push_back(series.points[i].x);
        y.push_back(series.points[i].*cost);
    }
    return fittedExponent(x, y);
}

/// The first point that costs twice as much as the cheapest: before it, what does not grow hides what does.
std::size_t firstGrown(const Series& series, double Point::*cost) {
    std::size_t first = 0;
    while (first + 1 < series.points.size() && series.points[first].*cost < 2 * series.points[0].*cost) ++first;
    return first;
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw Error(ErrorCode::Environment, "cannot write '" + file.string() + "'");
}

int run(const Options& options) {
    RendererOptions rendererOptions;
    rendererOptions.device = options.device;
    Renderer renderer(rendererOptions);
    // A software renderer's work is the process's own; a GPU's is not.
    const bool software = renderer.device().software;
    double Point::*const cost = software ? &Point::cpu_ms : &Point::wall_ms;
    const std::string clock = software ? "processor time of the process" : renderer.device().clock;

    nlohmann::ordered_json json{{"device", renderer.device().renderer}, {"clock", clock}, {"frames", options.frames}};
    std::string csv = "axis,technique,x,wall_ms,cpu_ms\n";
    bool linear = true;
    fmt::print("{}, {}\n", renderer.device().renderer, clock);
    for (const std::string& axis : options.axes) {
        std::vector<Curve> curves;
        for (const Series& series : measureAxis(renderer, axis, options)) {
            if (series.points.size() < 3) continue;
            const double whole = exponentFrom(series, 0, cost), tail = exponentFrom(series, 1000, cost);
            const double grown = exponentFrom(series, firstGrown(series, cost), cost);
            const bool fits = grown <= kLinear;
            linear = linear && fits;
            std::string row = fmt::format("{:<10} {:<13}", axis, series.technique);
            Curve curve{series.technique, {}, {}};
            for (const Point& p : series.points) {
                curve.x.push_back(p.x);
                curve.y.push_back(p.*cost);
                row += fmt::format(" {:>10.2f}", p.*cost);
            }
            fmt::print("{}   x^{:.2f}, grown x^{:.2f}, last three x^{:.2f}: {}{}\n", row, whole, grown, tail,
                       fits ? "no worse than linear" : "WORSE THAN LINEAR",
                       series.refused.empty() ? "" : "; refused " + series.refused);
            nlohmann::ordered_json points = nlohmann::ordered_json::array();
            for (const Point& p : series.points) {
                points.push_back({{"x", p.x}, {"wall_ms", p.wall_ms}, {"cpu_ms", p.cpu_ms}});
                csv += fmt::format("{},{},{},{:.4f},{:.4f}\n", axis, series.technique, p.x, p.wall_ms, p.cpu_ms);
            }
            json["series"].push_back({{"axis", axis},
                                      {"technique", series.technique},
                                      {"points", points},
                                      {"exponent", whole},
                                      {"grown_exponent", grown},
                                      {"tail_exponent", tail},
                                      {"refused", series.refused}});
            curves.push_back(std::move(curve));
        }
        if (!options.plots.empty() && !curves.empty())
            writeText(std::filesystem::path(options.plots) / ("scaling-" + axis + ".svg"),
                      logPlot("Frame against " + axis, axis, software ? "ms of processor time" : "ms", curves));
    }
    if (!options.json.empty()) writeText(options.json, json.dump(1) + "\n");
    if (!options.csv.empty()) writeText(options.csv, csv);
    return linear ? 0 : 1;
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) {
    ombrage::bench::Options options;
    CLI::App app(
        "What a frame costs against triangles, lights and pixels; exit code 1 when a growth is worse than linear");
    app.add_option("--axis", options.axes, "triangles, lights, pixels")
        ->check(CLI::IsMember({"triangles", "lights", "pixels"}));
    app.add_option("--frames", options.frames, "at each point, of which the least counts (5)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--largest", options.largest, "most triangles (4e6)")->check(CLI::PositiveNumber);
    app.add_option("--device", options.device, "as for ombrage render");
    app.add_option("--json", options.json, "file to write");
    app.add_option("--csv", options.csv, "file to write");
    app.add_option("--plots", options.plots, "folder for the SVG plots");
    CLI11_PARSE(app, argc, argv);
    try {
        return ombrage::bench::run(options);
    } catch (const ombrage::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return int(error.code());
    }
}
