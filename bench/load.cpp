// SPDX-License-Identifier: MIT
// ombrage_bench_load FILE... [--runs N]: how long a scene takes to load, read in this process, by the guarded one, the
// first time with the cache and the second. The ways run in turn; medians over the runs.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/scene.h>
#include <CLI/CLI.hpp>

namespace {

namespace fs = std::filesystem;

double load_ms(const std::string& file, const std::string& importer, const std::string& cache) {
    ombrage::SceneOptions options;
    options.importer = importer;
    options.cache = cache;
    const auto start = std::chrono::steady_clock::now();
    ombrage::loadScene(file, options);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void measure(const std::string& file, int runs, const fs::path& cache) {
    std::vector<double> here, guarded, first, second, ratio, cost;
    for (int i = 0; i < runs; ++i) {
        here.push_back(load_ms(file, "off", "off"));
        guarded.push_back(load_ms(file, "", "off"));
        fs::remove_all(cache);
        first.push_back(load_ms(file, "", cache.string()));
        second.push_back(load_ms(file, "", cache.string()));
        ratio.push_back(first.back() / second.back());
        cost.push_back(guarded.back() - here.back());
    }
    fmt::print("{:<28} {:>10.1f} {:>10.1f} {:>10.1f} {:>10.1f} {:>10.1f} {:>9.1f}\n",
               fs::path(file).filename().string(), median(here), median(guarded), median(first), median(second),
               median(cost), median(ratio));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How long scenes take to load, in ms");
    std::vector<std::string> files;
    int runs = 9;
    app.add_option("files", files, "scene or model files")->required();
    app.add_option("--runs", runs, "loads of each kind (9)")->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    std::string pattern = (fs::temp_directory_path() / "ombrage-load-XXXXXX").string();
    const fs::path folder = ::mkdtemp(pattern.data());
    int code = 0;
    try {
        fmt::print("{:<28} {:>10} {:>10} {:>10} {:>10} {:>10} {:>9}\n", "file", "unguarded", "guarded", "first",
                   "second", "guard +", "1st/2nd");
        for (const std::string& file : files) measure(file, runs, folder / "cache");
    } catch (const ombrage::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        code = int(error.code());
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return code;
}
