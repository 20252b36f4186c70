// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/bench.h>
#include <ombrage/error.h>
#include <filesystem>
#include <fstream>

#include "commands.h"
#include "progress.h"
#include "whole_program.h"

namespace ombrage::cli {

namespace {

/// A file that the user named, as it is.
void writeText(const std::filesystem::path& file, const std::string& text) {
    std::error_code ignored;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out)
        throw Error(ErrorCode::Environment, "cannot write '" + file.string() + "'",
                    "check the folder's permissions and the free space", file.string());
}

BenchRequest requestOf(const Options& options) {
    BenchRequest request;
    request.scenes = options.texts("scene");
    for (const std::string& text : options.texts("technique")) request.pipelines.push_back(parseTechnique(text));
    for (const std::string& family : options.texts("all")) request.allOf.push_back(familyFromName(family));
    request.sceneOptions = sceneOptions(options);
    request.base = frameSettings(options);
    request.frames = int(options.integer("frames", request.frames, 8, 1'000'000));
    request.warmupFrames = int(options.integer("warmup", request.warmupFrames, 1, 1'000'000));
    if (options.has("sweep")) request.sweep = parseSweep(options.text("sweep"));
    request.outputDir = options.text("output");
    request.again = options.flag("again");
    request.baseline = options.text("baseline");
    if (options.has("fail-on")) request.failAbove = parseSlowdown(options.text("fail-on"));
    request.commandLine = commandLine();
    return request;
}

int runBench(const Options& options) {
    if (options.flag("program")) return runWholeProgram(options);
    if (options.has("seconds"))
        throw Error(ErrorCode::Usage, "--seconds goes with --program only", "a bench takes --frames");
    BenchRequest request = requestOf(options);
    Progress progress;
    request.progress = [&](const std::string& what, double share) { return progress(what, share); };
    const BenchResult result = bench(request, rendererOptions(options));
    Progress::clearLine();

    for (const SkippedPair& pair : result.skipped)
        printMessage("skipped: " + pair.scene + ", " + pair.technique + ": " + pair.reason);
    if (result.reused > 0)
        printMessage(fmt::format("{} of {} measurements were in the folder already (--again measures them anew)",
                                 result.reused, result.groups.size()));
    if (options.has("export-json")) writeText(options.text("export-json"), result.json() + "\n");
    if (options.has("export-csv")) writeText(options.text("export-csv"), result.csv());
    if (options.has("export-markdown")) writeText(options.text("export-markdown"), result.markdown());
    const std::string plots = options.text("plots", options.text("output"));
    if (!plots.empty())
        for (const auto& [name, svg] : result.plots()) writeText(std::filesystem::path(plots) / name, svg);
    printResult(options.flag("json") ? result.json() + "\n" : result.markdown());
    for (const std::string& sentence : result.regressions) printMessage("slower: " + sentence);
    if (result.interrupted) {
        printMessage(fmt::format("interrupted after {} measurement(s)", result.groups.size()));
        return int(ErrorCode::Interrupted);
    }
    return result.regressions.empty() ? 0 : int(ErrorCode::GateFailed);
}

}  // namespace

Command benchCommand() {
    const std::string shadow = exampleId(Family::Shadow), ao = exampleId(Family::Ao);
    return {
        "bench",
        "Times techniques by turns and says which differences are real",
        {"gap menger --all shadow", "gap --technique " + shadow + " --technique " + ao + " --export-json times.json",
         "gap --technique " + shadow + " --baseline times.json --fail-on +5%",
         "--sweep triangles=10000..1000000 --technique " + shadow + " --plots out", "menger --program --all shadow"},
        [](Options& options) {
            options.add("scene", "built-in scenes, scene files (.json) or model files", Take::Many);
            options.add("--technique",
                        "ID[:key=value,...] or A+B; may be repeated; the first is what others differ from", Take::Many);
            options.add("--all", "FAMILY: every technique of it that supports the lights; may be repeated", Take::Many);
            options.add("--frames", "N: frames of each technique (125), by turns in 25 rounds");
            options.add("--warmup", "N: frames of each technique before that (5)");
            options.add("--sweep",
                        "AXIS=A..B (doubling) or AXIS=V,V,...: a parameter, size (height), triangles or lights");
            options.add("-o,--output", "DIR: keep results there and take from there what it holds");
            options.add("--again", "measure also what DIR holds already, and replace it", Take::Flag);
            options.add("--baseline", "FILE: an earlier --export-json to hold the times against");
            options.add("--fail-on", "+P%: exit 1 when a run is that much slower than in the baseline");
            options.add("--export-json", "FILE: everything, raw samples as well");
            options.add("--export-csv", "FILE: one line for each run");
            options.add("--export-markdown", "FILE: what is printed");
            options.add("--plots", "DIR: SVG pictures of a sweep (the folder of -o)");
            options.add("--program", "frames per second, processor and memory of a whole program instead", Take::Flag);
            options.add("--seconds", "N: how long --program draws (3)");
            addSceneOptions(options);
            options.add("--json", "one JSON document on standard output", Take::Flag);
        },
        runBench};
}

}  // namespace ombrage::cli
