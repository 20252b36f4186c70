// SPDX-License-Identifier: MIT
// Exact shadow techniques on many random cameras and lights around a few models: a table of how wrong they are, and
// pictures of the worst views. The exit status is 1 when one view is over its budget.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <CLI/CLI.hpp>

#include "random_views/views.h"

namespace {

using namespace ombrage;
using namespace ombrage::test;

// Budgets of the rows for closed meshes, and for open ones.
constexpr double kClosedBudget = 0.0003, kOpenBudget = 0.002;
// What is measured has at least this share of the picture, and some shadow in it.
constexpr double kLeastValidShare = 10000.0 / (640 * 360), kLeastDark = 0.001;
constexpr int kWorst = 5;

struct Outcome {
    std::string stage, technique, words;
    std::uint64_t seed = 0;
    ViewOutcome view;
    double budget = 0;
};

std::vector<std::string> defaultModels() {
    std::vector<std::string> models{"menger"};
    if (const char* data = std::getenv("OMBRAGE_DATA"))
        for (const char* file : {"stanford-bunny.obj", "teapot.obj", "suzanne.obj", "spider/spider.obj"})
            models.push_back(std::string(data) + "/meshes/" + file);
    return models;
}

}  // namespace

int main(int argc, char** argv) try {
    int views = 200, width = 640;
    std::uint64_t firstSeed = 1;
    std::vector<std::string> techniques{"shadow/volume", "shadow/volume-zfail"}, models = defaultModels();
    std::string folder;
    CLI::App app("Exact shadow techniques on random cameras and lights");
    app.add_option("--views", views, "measured views of each model")->capture_default_str();
    app.add_option("--width", width, "of the pictures; they are 16 to 9")->capture_default_str();
    app.add_option("--seed", firstSeed, "of the first view")->capture_default_str();
    app.add_option("--technique", techniques, "pipelines to try");
    app.add_option("--model", models, "built-in scenes and model files (menger, and four of OMBRAGE_DATA)");
    app.add_option("-o", folder, "folder for pictures of the worst views");
    CLI11_PARSE(app, argc, argv);
    const int height = width * 9 / 16;

    Renderer renderer;
    std::vector<Outcome> all;
    fmt::print("{:<22} {:<34} {:>6} {:>9} {:>9} {:>7} {:>8}\n", "model", "technique", "views", "mean", "worst",
               "budget", "failing");
    for (const std::string& model : models) {
        Stage stage = makeStage(model);
        const double budget = stage.closed ? kClosedBudget : kOpenBudget;
        std::vector<std::vector<double>> wrong(techniques.size());
        std::uint64_t seed = firstSeed;
        for (int measured = 0; measured < views; ++seed) {
            const std::string words = arrange(stage, seed);
            bool counts = true;
            for (std::size_t t = 0; t < techniques.size() && counts; ++t) {
                Outcome outcome{stage.name, techniques[t], words, seed, {}, budget};
                outcome.view = measureView(renderer, stage, techniques[t], width, height);
                counts =
                    double(outcome.view.valid) >= kLeastValidShare * width * height && outcome.view.dark >= kLeastDark;
                if (!counts) break;
                wrong[t].push_back(outcome.view.wrong);
                if (outcome.view.wrong == 0) outcome.view.errors = {};
                all.push_back(std::move(outcome));
            }
            measured += counts ? 1 : 0;
        }
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            double sum = 0;
            for (const double w : wrong[t]) sum += w;
            fmt::print("{:<22} {:<34} {:>6} {:>9.6f} {:>9.6f} {:>7.4f} {:>8}\n", stage.name, techniques[t],
                       wrong[t].size(), sum / double(wrong[t].size()),
                       *std::max_element(wrong[t].begin(), wrong[t].end()), budget,
                       std::count_if(wrong[t].begin(), wrong[t].end(), [&](double w) { return w > budget; }));
        }
        std::fflush(stdout);
        std::sort(all.begin(), all.end(),
                  [](const Outcome& a, const Outcome& b) { return a.view.wrong > b.view.wrong; });
        // Pictures of those only that may be among the worst in the end.
        for (std::size_t i = kWorst; i < all.size(); ++i) all[i].view.errors = {};
    }

    fmt::print("\nThe worst:\n");
    for (std::size_t i = 0; i < std::min<std::size_t>(kWorst, all.size()); ++i) {
        const Outcome& o = all[i];
        fmt::print("{} seed {} {} ({}): {:.6f} of {} pixels\n", o.stage, o.seed, o.technique, o.words, o.view.wrong,
                   o.view.valid);
        if (folder.empty() || o.view.wrong == 0) continue;
        std::filesystem::create_directories(folder);
        writeImage(fmt::format("{}/worst-{}.png", folder, i + 1), o.view.errors);
    }
    return std::any_of(all.begin(), all.end(), [](const Outcome& o) { return o.view.wrong > o.budget; }) ? 1 : 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
}
