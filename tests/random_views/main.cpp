// SPDX-License-Identifier: MIT
// Exact shadow techniques on many random cameras and lights around a few models: a table of how wrong they are, and
// pictures of the worst views. The exit status is 1 when one view is over its budget.
#include <algorithm>
#include <cctype>
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

struct Outcome {
    std::string stage, technique;
    Arrangement arrangement;
    std::uint64_t seed = 0;
    ViewOutcome view;
    double budget = 0;
};

/// The worst so far of one technique, the worst first; only these keep their pictures.
class Worst {
public:
    explicit Worst(int most) : m_most(std::size_t(most)) {}

    void add(Outcome outcome) {
        const auto at =
            std::upper_bound(m_outcomes.begin(), m_outcomes.end(), outcome,
                             [](const Outcome& a, const Outcome& b) { return a.view.wrong > b.view.wrong; });
        m_outcomes.insert(at, std::move(outcome));
        if (m_outcomes.size() > m_most) m_outcomes.pop_back();
    }
    const std::vector<Outcome>& outcomes() const { return m_outcomes; }

private:
    std::size_t m_most;
    std::vector<Outcome> m_outcomes;
};

/// A technique's id as part of a file's name.
std::string fileNameOf(std::string technique) {
    std::replace_if(
        technique.begin(), technique.end(), [](char c) { return std::isalnum((unsigned char)(c)) == 0; }, '-');
    return technique;
}

/// A row of the table of the worst, with a link to the picture where one is written.
std::string rowOf(const Outcome& o, int place, const std::string& picture) {
    return fmt::format("| {} | {} | {} | {} | {} | {} | {:.6f} | {} |",
                       picture.empty() ? std::to_string(place) : fmt::format("[{}]({})", place, picture), o.stage,
                       o.seed, o.arrangement.camera, o.arrangement.light, o.view.valid, o.view.wrong, o.budget);
}

std::vector<std::string> defaultModels() {
    std::vector<std::string> models{"menger"};
    if (const char* data = std::getenv("OMBRAGE_DATA"))
        for (const char* file : {"stanford-bunny.obj", "teapot.obj", "suzanne.obj", "spider/spider.obj"})
            models.push_back(std::string(data) + "/meshes/" + file);
    return models;
}

}  // namespace

int main(int argc, char** argv) try {
    int views = 200, width = 640, most = 5;
    std::uint64_t firstSeed = 1;
    std::vector<std::string> techniques{"shadow/volume", "shadow/volume-zfail"}, models = defaultModels();
    std::string folder;
    CLI::App app("Exact shadow techniques on random cameras and lights");
    app.add_option("--views", views, "measured views of each model")->capture_default_str();
    app.add_option("--width", width, "of the pictures; they are 16 to 9")->capture_default_str();
    app.add_option("--seed", firstSeed, "of the first view")->capture_default_str();
    app.add_option("--technique", techniques, "pipelines to try");
    app.add_option("--model", models, "built-in scenes and model files (menger, and four of OMBRAGE_DATA)");
    app.add_option("--worst", most, "how many of the worst views of each technique are listed")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("-o", folder, "folder for their pictures");
    CLI11_PARSE(app, argc, argv);
    const int height = width * 9 / 16;

    Renderer renderer;
    std::vector<Worst> worst(techniques.size(), Worst(most));
    bool failed = false;
    fmt::print("{:<22} {:<34} {:>6} {:>9} {:>9} {:>7} {:>8}\n", "model", "technique", "views", "mean", "worst",
               "budget", "failing");
    for (const std::string& model : models) {
        Stage stage = makeStage(model);
        const double budget = stage.closed ? kClosedBudget : kOpenBudget;
        std::vector<std::vector<double>> wrong(techniques.size());
        const Reference reference(stage.scene);
        renderer.setScene(stage.scene);
        std::uint64_t seed = firstSeed;
        for (int measured = 0; measured < views; ++seed) {
            const Arrangement arrangement = arrange(stage, seed);
            std::vector<ViewOutcome> outcomes = measureView(renderer, reference, stage, techniques, width, height);
            const ViewOutcome& first = outcomes.front();
            if (double(first.valid) < kLeastValidShare * width * height || first.dark < kLeastDark) continue;
            ++measured;
            for (std::size_t t = 0; t < techniques.size(); ++t) {
                wrong[t].push_back(outcomes[t].wrong);
                failed = failed || outcomes[t].wrong > budget;
                worst[t].add({stage.name, techniques[t], arrangement, seed, std::move(outcomes[t]), budget});
            }
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
    }

    for (std::size_t t = 0; t < techniques.size(); ++t) {
        fmt::print("\nThe worst of {}:\n\n", techniques[t]);
        fmt::print(
            "| | model | seed | camera | light | pixels | wrong | budget |\n|--:|---|--:|---|---|--:|--:|--:|\n");
        int place = 0;
        for (const Outcome& o : worst[t].outcomes()) {
            std::string picture;
            if (!folder.empty() && !o.view.errors.empty()) {
                picture = fmt::format("{}-worst-{}.png", fileNameOf(techniques[t]), place + 1);
                writeImage(std::filesystem::path(folder) / picture, o.view.errors);
            }
            fmt::print("{}\n", rowOf(o, ++place, picture));
        }
    }
    return failed ? 1 : 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
}
