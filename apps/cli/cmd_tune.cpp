// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/tune.h>
#include <filesystem>
#include <fstream>

#include "commands.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

/// More than any frame takes, of milliseconds or MiB.
constexpr double kMost = 1e9;

TuneRequest requestOf(const Options& options) {
    TuneRequest request;
    request.scenes = options.texts("scene");
    if (request.scenes.empty())
        throw Error(ErrorCode::Usage, "no scene to tune on", "'ombrage list scenes' shows the built-in ones");
    request.technique = parseTechnique(requiredText(options, "technique", "technique to tune (--technique ID)"));
    request.outputDir = requiredText(options, "output", "folder for the results (-o DIR)");
    request.sceneOptions = sceneOptions(options);
    request.base = frameSettings(options);
    request.base.normals = normalSource(options);
    request.metric = options.text("metric", request.metric);
    request.truthSamples = int(options.integer("spp", 0, 0, 1 << 20));
    request.truthKind = options.text("truth");
    request.keep = options.texts("keep");
    request.holdout = options.texts("holdout");
    for (const std::string& weight : options.texts("weight")) request.weights.insert(parseTuneWeight(weight));
    if (options.has("budget")) request.budget_ms = options.number("budget", 0, 1e-6, kMost);
    if (options.has("memory")) request.budget_MiB = options.number("memory", 0, 1e-6, kMost);
    if (options.has("error-below")) {
        const auto [metric, bound] = parseErrorBelow(options.text("error-below"));
        if (options.has("metric") && options.text("metric") != metric)
            throw Error(ErrorCode::Usage, "--error-below bounds " + metric + ", --metric is " + request.metric,
                        "name one metric");
        request.metric = metric;
        request.errorBelow = bound;
    }
    request.pareto = options.flag("pareto");
    request.cost = options.choice("cost", {"time", "memory"}, 0) == 0 ? TuneCost::Time : TuneCost::Memory;
    request.evaluations = int(options.integer("evaluations", request.evaluations, 1, 1'000'000));
    request.seconds = options.number("seconds", 0, 1e-3, 1e9);
    request.again = options.flag("again");
    request.commandLine = commandLine();
    return request;
}

void writeExport(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text << '\n';
    out.close();
    if (!out)
        throw Error(ErrorCode::Environment, "cannot write '" + file.string() + "'",
                    "check the folder's permissions and the free space", file.string());
}

int runTune(const Options& options) {
    TuneRequest request = requestOf(options);
    const std::string engine = options.has("export") ? tuneEngines()[options.choice("export", tuneEngines(), 0)] : "";
    if (!engine.empty() && request.pareto)
        throw Error(ErrorCode::Usage, "a Pareto search has no one answer to export",
                    "choose one of them, and export it with --technique ID:its values --evaluations 1");
    Progress progress;
    request.progress = [&](const std::string& what, double share) { return progress(what, share); };
    const TuneResult result = tune(request, rendererOptions(options));
    Progress::clearLine();

    if (result.reused > 0)
        printMessage(fmt::format("{} of {} measurements were in the folder already (--again measures them anew)",
                                 result.reused, result.reused + result.measured));
    if (!engine.empty() && !result.interrupted) {
        const auto file = request.outputDir / ("tune-" + engine + ".json");
        writeExport(file, exportTuned(engine, request, result.winner.pipeline, rendererOptions(options)));
        printMessage("values for " + engine + ": " + file.string());
    }
    if (options.flag("json")) {
        printResult(result.json() + "\n");
    } else {
        printResult(result.sentence() + "\n");
        for (const TuneCandidate& candidate : result.front) {
            const TuneFigures figures = candidate.heldOut.value_or(candidate.searched);
            printResult(fmt::format("  {} {:.4g}  {}{:.1f} MiB  {}\n", result.metric, figures.error,
                                    figures.time_ms ? fmt::format("{:.2f} ms  ", *figures.time_ms) : "",
                                    figures.memory_MiB, candidate.pipeline));
        }
    }
    if (result.interrupted) {
        printMessage(
            fmt::format("interrupted after {} candidate(s); the same command goes on", result.searched.size()));
        return int(ErrorCode::Interrupted);
    }
    const bool isFound = result.pareto ? !result.front.empty() : result.winner.isWithinLimits;
    return isFound ? 0 : int(ErrorCode::GateFailed);
}

}  // namespace

Command tuneCommand() {
    const std::string shadow = exampleId(Family::Shadow), ao = exampleId(Family::Ao),
                      filter = exampleId(Family::Filter);
    return {"tune",
            "Searches a technique's parameters for the least error, within a budget",
            {"menger tree --technique " + shadow + " -o out",
             "cornell --technique " + ao + "+" + filter + " --budget 4 -o out",
             "gap --technique " + shadow + " --error-below rmse=0.05 --cost memory -o out",
             "gap --technique " + shadow + " --export threejs -o out"},
            [](Options& options) {
                options.add("scene", "built-in scenes, scene files (.json) or model files", Take::Many);
                options.add("--technique", "ID[:key=value,...] or A+B: where the search starts");
                options.add("-o,--output", "DIR: results.sqlite, tune.jsonl and tune.json go here");
                options.add("--metric", "KEY: the error to make least (rmse); 'ombrage list metrics' shows them");
                options.add("--budget", "MS: the answer takes no more time for a frame on any scene and camera");
                options.add("--memory", "MIB: its buffers take no more memory");
                options.add("--error-below", "KEY=X: the least cost with at most this error instead");
                options.add("--pareto", "everything that nothing beats in error and cost instead", Take::Flag);
                options.add("--cost", "time or memory, for --error-below and --pareto (time)");
                options.add("--holdout", "CAMERA: not searched on, decides; may be repeated (others, or made ones)",
                            Take::Many);
                options.add("--keep", "KEY or ID.KEY: a parameter that stays as it is; may be repeated", Take::Many);
                options.add("--weight", "SCENE=W: weight of a scene's error (1); may be repeated", Take::Many);
                options.add("--evaluations", "N: parameter values to try at most (200)");
                options.add("--seconds", "S: end the search after this time");
                options.add("--export", "threejs, godot, filament or gl: the answer in that engine's units, into DIR");
                options.add("--again", "measure also what DIR holds already, and replace it", Take::Flag);
                options.add("--spp", "N: samples per pixel of the truth");
                options.add("--truth", "shadow, self or area for shadows; T1 to T5, T5-ball, displaced or area for ao");
                addNormalsOption(options);
                addSceneOptions(options);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runTune};
}

}  // namespace ombrage::cli
