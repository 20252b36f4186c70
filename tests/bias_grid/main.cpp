// SPDX-License-Identifier: MIT
// Shadow maps from a centimetre to a kilometre, near the origin and far from it: whether the defaults need a hand.
// Prints the worst of every combination and every one over its budget; the exit status is 1 when there is one.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <CLI/CLI.hpp>

#include "bias_grid/grid.h"

namespace {

using namespace ombrage;
using namespace ombrage::test;

// Budgets of shadow/map's row at its defaults.
const std::vector<std::pair<std::string, double>> kBudgets{{"acne", 0.0005}, {"contact_gap", 0.002}};
constexpr std::size_t kLeastValid = 1000;  // fewer pixels say nothing of shares below 0.0005

double valueOf(const GridCell& cell, const std::string& metric) {
    return cell.metrics.at(metric).value_or(0);
}

bool exceeds(const GridCell& cell) {
    return std::any_of(kBudgets.begin(), kBudgets.end(),
                       [&](const auto& budget) { return valueOf(cell, budget.first) > budget.second; });
}

/// A place on the grid, all scenes together.
std::string placeOf(const GridCell& cell) {
    return fmt::format("{:<30} {:>5} {:>4} {:>7} {:>7}", cell.technique, cell.resolution, cell.format, cell.size_m,
                       cell.shift_m);
}

void printWorst(const std::vector<GridCell>& cells) {
    fmt::print("{:<30} {:>5} {:>4} {:>7} {:>7}  {:<38} {:<38} {:>4}\n", "technique", "res", "fmt", "size_m", "shift_m",
               "worst acne", "worst contact_gap", "over");
    std::vector<std::string> places;
    for (const GridCell& cell : cells)
        if (std::find(places.begin(), places.end(), placeOf(cell)) == places.end()) places.push_back(placeOf(cell));
    for (const std::string& place : places) {
        std::string line = place + " ";
        int over = 0;
        for (const auto& [metric, budget] : kBudgets) {
            const GridCell* worst = nullptr;
            for (const GridCell& cell : cells)
                if (placeOf(cell) == place && (!worst || valueOf(cell, metric) > valueOf(*worst, metric)))
                    worst = &cell;
            line += fmt::format(" {:<38}",
                                fmt::format("{:.5f} {}, {}", valueOf(*worst, metric), worst->scene, worst->light));
        }
        for (const GridCell& cell : cells) over += placeOf(cell) == place && exceeds(cell) ? 1 : 0;
        fmt::print("{} {:>4}\n", line, over);
    }
}

void printAll(const std::vector<GridCell>& cells, bool onlyExceeding) {
    for (const GridCell& cell : cells) {
        if (onlyExceeding && !exceeds(cell)) continue;
        fmt::print("{:<14} {:<12} {}", cell.scene, cell.light, placeOf(cell));
        for (const char* metric : {"acne", "contact_gap", "leak", "leak_mass", "false_shadow", "wrong"})
            fmt::print(" {} {:.5f}", metric, valueOf(cell, metric));
        fmt::print("\n");
    }
}

}  // namespace

int main(int argc, char** argv) try {
    GridAxes axes;
    int width = 640;
    bool all = false;
    std::vector<std::string> scenes, kindNames;
    CLI::App app("Shadow maps at all scales and resolutions");
    app.add_option("--scene", scenes, "built-in scenes; all of them where none is named");
    app.add_option("--light", kindNames, "each scene's first light also as these: sun, spot, point");
    app.add_option("--technique", axes.techniques, "pipelines to measure")->capture_default_str();
    app.add_option("--resolution", axes.resolutions, "of the maps")->capture_default_str();
    app.add_option("--format", axes.formats, "16, 24, 32f")->capture_default_str();
    app.add_option("--extent", axes.sizes_m, "longest side of the scene's bounds in metres; 0: as it is")
        ->capture_default_str();
    app.add_option("--shift", axes.shifts_m, "metres from the origin")->capture_default_str();
    app.add_option("--width", width, "of the pictures; they are 16 to 9")->capture_default_str();
    app.add_flag("--all", all, "prints every combination, not only those over a budget");
    CLI11_PARSE(app, argc, argv);
    if (scenes.empty())
        for (const BuiltinScene& scene : builtinScenes()) scenes.push_back(scene.name);
    std::vector<LightType> kinds;
    for (const std::string& name : kindNames)
        for (const LightType type : {LightType::Sun, LightType::Spot, LightType::Point})
            if (name == lightTypeName(type)) kinds.push_back(type);
    if (kinds.size() != kindNames.size()) throw Error(ErrorCode::Usage, "--light takes sun, spot and point");

    std::vector<GridCell> cells;
    for (const std::string& name : scenes)
        for (const GridScene& scene : gridScenes(name, kinds)) {
            std::vector<GridCell> own = measureGrid(scene, axes, width, width * 9 / 16);
            own.erase(std::remove_if(own.begin(), own.end(), [](const GridCell& c) { return c.valid < kLeastValid; }),
                      own.end());
            printAll(own, !all);
            std::fflush(stdout);
            cells.insert(cells.end(), own.begin(), own.end());
        }
    fmt::print("\n");
    printWorst(cells);
    return std::any_of(cells.begin(), cells.end(), exceeds) ? 1 : 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
}
