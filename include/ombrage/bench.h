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

/// One thing varied over several values, everything else kept. The axis is a parameter of a technique ("resolution"), "size"
/// (the picture's height, its shape kept), or "triangles" or "lights" of a generated scene of spheres.
struct BenchSweep {
    std::string axis;
    std::vector<std::string> values;
};

/// "AXIS=A..B", doubling from A while not above B, or "AXIS=V,V,...". @throws Error(Usage)
BenchSweep parseSweep(const std::string& text);

/// "+5%" as 0.05. @throws Error(Usage)
double parseSlowdown(const std::string& text);

struct BenchRequest {
    std::vector<std::string> scenes;             ///< names or files; none for the sweeps that make their own
    SceneOptions sceneOptions;
    std::vector<std::pair<Family, Pipeline>> pipelines;   ///< in order; one may be there twice
    std::vector<Family> allOf;                   ///< every technique of these families that supports the lights
    RenderSettings base;                         ///< size, camera, light, seed ...
    /// Of each pipeline, in 25 rounds (fewer than 50 frames: in as many). While the differences are not known well enough
    /// as many again are drawn, at most 8 times.
    int frames = 125;
    int warmupFrames = 5;                        ///< of each pipeline, before the first round
    std::optional<BenchSweep> sweep;
    std::filesystem::path outputDir;             ///< results are kept and looked up here; empty: nowhere
    bool again = false;                          ///< measures also what the folder holds
    std::filesystem::path baseline;              ///< what json() wrote earlier; empty: none
    std::optional<double> failAbove;             ///< share by which a run may be slower than the baseline's
    std::vector<std::string> commandLine;
    Report progress;
};

struct BenchFigures {
    double median = 0, p95 = 0, mad = 0;         ///< mad: median distance from the median
    std::vector<double> samples;                 ///< of every frame, in order
};

struct BenchPass {
    std::string name;
    BenchFigures gpu_ms;
    std::uint64_t draws = 0, triangles = 0;
};

/// How much more one run costs than another, as a share, with the 99 % interval.
struct BenchDifference {
    double change = 0, low = 0, high = 0;
    /// "slower" and "faster" where the interval excludes 0 and the change is over 2 %, else "no significant difference";
    /// "too few rounds" below 8 of them.
    std::string verdict;
};

/// A pipeline on a scene.
struct BenchRun {
    std::string pipeline;                        ///< canonical text, the sweep's value included
    std::string label;                           ///< as it was asked for, numbered where it is there twice
    BenchFigures gpu_ms;                         ///< whole frames by BenchResult's clock
    BenchFigures process_ms;                     ///< processor time of all threads of the process, frame by frame
    BenchFigures cpu_ms;                         ///< processor time of the thread that gives the commands
    std::vector<BenchPass> passes;               ///< timed apart from the whole frames, as timing them slows them
    std::uint64_t draws = 0, triangles = 0, gpuBytes = 0;
    std::map<std::string, double> counters;
    std::optional<BenchDifference> toFirst;      ///< nothing for the first run
    std::optional<BenchDifference> toBaseline;
};

/// What was measured by turns.
struct BenchGroup {
    std::string scene, sceneHash, camera, light; ///< light: "" all of them
    int width = 0, height = 0;
    std::string axis, value;                     ///< of a sweep, or ""
    double x = 0;                                ///< the value as a number: triangles as counted
    std::vector<BenchRun> runs;
};

struct BenchResult {
    DeviceInfo device;
    std::string decidedBy;                       ///< "gpu_ms", or "process_ms" on a software renderer
    int rounds = 0;                              ///< the least; a group has a multiple of them
    int framesPerRound = 0;
    std::vector<BenchGroup> groups;
    std::vector<SkippedPair> skipped;
    std::vector<std::string> regressions;        ///< sentences: runs slower than the baseline by more than is allowed
    std::size_t reused = 0;                      ///< of the groups: those that the folder held already
    bool interrupted = false;
    std::vector<std::string> commandLine;

    /// Everything, raw samples as well: schema ombrage/bench/1.
    std::string json() const;
    /// One line for each run.
    std::string csv() const;
    /// Tables: whole frames and their differences, passes, and the growth along a sweep.
    std::string markdown() const;
    /// SVG pictures of cost growth by file name, one for each scene of a sweep over numbers.
    std::map<std::string, std::string> plots() const;
};

/// What a whole program that does nothing but draw takes.
struct ProgramFigures {
    std::string scene, technique;
    double fps = 0;                              ///< frames per second: the median of the seconds
    std::vector<double> fpsOfSeconds;            ///< averaged over each second
    double cpuPercent = 0;                       ///< processor time over time; 100 is one processor
    double memory_MiB = 0;                       ///< resident at the end
    double memoryPercent = 0;                    ///< the same, of the machine's memory
    DeviceInfo device;
};

/// Draws frames without reading them back for so many seconds, after one that is not counted. Memory is the whole
/// process's: a program that did other things before counts them too.
ProgramFigures measureProgram(const Scene& scene, const RenderSettings& settings, int seconds,
                              const RendererOptions& renderer);

/// Times every scene with every pipeline, by turns. @throws Error as the renderer, Error(Usage) for what does not fit,
/// Error(Input) for a baseline of another device or of nothing that is measured here.
BenchResult bench(const BenchRequest& request, const RendererOptions& renderer);

}  // namespace ombrage
