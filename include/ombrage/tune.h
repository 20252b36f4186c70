// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ombrage/compare.h>

namespace ombrage {

/// What a technique costs: milliseconds of a frame, or MiB of its buffers.
enum class TuneCost { Time, Memory };

struct TuneRequest {
    std::vector<std::string> scenes;             ///< names or files
    SceneOptions sceneOptions;
    std::pair<Family, Pipeline> technique;       ///< its parameters are the start, and what the result is held against
    std::vector<std::string> keep;               ///< "key" or "ID.key": parameters that stay as they are
    std::map<std::string, double> weights;       ///< by scene, of its error; 1 where nothing is said
    std::vector<std::string> holdout;            ///< cameras that decide; empty: by rule (docs/user/tune.md)
    RenderSettings base;                         ///< size, camera to search on, light, seed (of the search as well) ...
    std::string metric = "rmse";                 ///< the error
    int truthSamples = 0;                        ///< 0: the truth's own default
    std::string truthKind;                       ///< "" by family; "shadow" or "T1"
    std::optional<double> budget_ms, budget_MiB; ///< the answer costs no more on any scene and camera
    std::optional<double> errorBelow;            ///< least cost with at most this error; none: least error
    bool pareto = false;                         ///< everything that nothing beats in error and cost
    TuneCost cost = TuneCost::Time;              ///< what errorBelow makes least and pareto shows
    int evaluations = 200;                       ///< different parameter values at most
    double seconds = 0;                          ///< ends the search after this time; 0: no end
    int finalists = 5;                           ///< how many, beside the start, the held-out cameras choose from
    std::filesystem::path outputDir;             ///< results.sqlite, tune.jsonl, tune.json
    bool again = false;                          ///< measures also what the folder holds already
    std::vector<std::string> commandLine;
    Report progress;
};

/// What one set of parameter values gave.
struct TuneFigures {
    double error = 0;                            ///< of the metric as it is, over the scenes by their weights
    std::optional<double> time_ms;               ///< on the slowest scene and camera; nothing where it was not asked for
    double memory_MiB = 0;                       ///< on the largest
};

struct TuneCandidate {
    std::string pipeline;                        ///< canonical text, to be given to --technique, --shadow ...
    TuneFigures searched;                        ///< on the cameras that the search saw
    std::optional<TuneFigures> heldOut;          ///< nothing where it was no finalist, or after an interruption
    bool isWithinLimits = true;                  ///< of the budget and the error bound, held-out cameras included
};

/// A scene, camera and light, and whether the search saw it.
struct TuneCase {
    std::string scene, camera, light;
    bool isHeldOut = false;
    bool isMade = false;                         ///< the camera is none of the scene's own
};

struct TuneResult {
    std::string metric;
    bool lowerIsBetter = true;
    TuneCandidate start, winner;
    std::vector<TuneCandidate> front;            ///< of a Pareto search: by cost
    std::vector<TuneCandidate> searched;         ///< every one, in order
    std::vector<TuneCase> cases;
    std::vector<std::string> parameters;         ///< "ID.key" of what was varied
    DeviceInfo device;
    std::string clock;                           ///< of time_ms
    std::size_t measured = 0, reused = 0;        ///< renders that were held against the truth; found in the folder
    bool interrupted = false;
    bool pareto = false;
    std::vector<std::string> commandLine;

    /// The answer in one sentence.
    std::string sentence() const;
    /// Schema ombrage/tune/1.
    std::string json() const;
};

/// Searches the technique's declared tuning ranges, its switches and its choices for the least error within the budgets, the
/// least cost under an error bound, or all that nothing beats. The start is the first candidate, and the answer unless
/// the held-out cameras say that another one is better. Each measurement is kept in the folder, and the same request
/// goes on where an earlier one ended.
/// @throws Error(Usage) for what does not fit, and as the renderer.
TuneResult tune(const TuneRequest& request, const RendererOptions& renderer);

/// "SCENE=WEIGHT". @throws Error(Usage)
std::pair<std::string, double> parseTuneWeight(const std::string& text);
/// "METRIC=NUMBER". @throws Error(Usage) naming the unknown metric.
std::pair<std::string, double> parseErrorBelow(const std::string& text);

/// "threejs", "godot", "filament", "gl".
const std::vector<std::string>& tuneEngines();

/// The winner's values in an engine's own units, as JSON, each with whether the mapping is exact, and why not. Looks at
/// the lights' views of the request's scenes. @throws Error(Usage) for an unknown engine.
std::string exportTuned(const std::string& engine, const TuneRequest& request, const std::string& pipeline,
                        const RendererOptions& renderer);

}  // namespace ombrage
