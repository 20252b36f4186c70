// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/motion.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>

namespace ombrage {

/// Progress of long work: a line to show and the share done in [0,1]. Returning false stops it with Error(Interrupted).
using Report = std::function<bool(const std::string& what, double share)>;

/// The text of `--technique`: as parsePipeline, with the family told from the first id, or from its name where one family
/// alone has it. A pipeline that starts with a filter is refused: a filter needs something to clean.
/// @throws Error(Usage) as parsePipeline.
std::pair<Family, Pipeline> parseTechnique(const std::string& text);

/// "METRIC OP NUMBER" with an optional technique: "shadow/map.wrong>0.01", "rmse>=0.2". Meets a record when it is true.
struct Gate {
    std::string text;
    std::string technique;   ///< full id (or pipeline text); empty: every one
    std::string metric;
    char op = '>';           ///< '>' or '<'
    bool orEqual = false;
    double bound = 0;
};

/// @throws Error(Usage) naming the unknown metric or technique.
Gate parseGate(const std::string& text);

struct CompareRequest {
    std::vector<std::string> scenes;             ///< names or files
    SceneOptions sceneOptions;
    std::vector<std::pair<Family, Pipeline>> pipelines;   ///< asked for by name: an unsupported light is an error
    std::vector<Family> allOf;                   ///< every technique of these families that supports the light
    RenderSettings base;                         ///< size, camera, light, seed, shading ...
    int truthSamples = 0;                        ///< 0: the truth's own default
    std::vector<Motion> motions;                 ///< each pipeline is measured under each of these too
    std::string truthKind;                       ///< "" by family; "shadow" or "T1"
    std::vector<Gate> failOn;
    std::filesystem::path outputDir;             ///< results.sqlite, pictures, records.jsonl, report.html
    bool again = false;                          ///< measures also what the folder holds already, and replaces it
    std::vector<std::string> commandLine;        ///< for the report
    Report progress;
};

struct SkippedPair {
    std::string scene, technique, reason;
};

struct CompareResult {
    std::vector<std::string> records;            ///< one JSON document each: ombrage/record/1
    std::vector<SkippedPair> skipped;
    std::vector<std::string> failedGates;        ///< sentences
    std::filesystem::path report;
    std::size_t reused = 0;                      ///< of the records: those that the folder held already
    bool interrupted = false;
    /// {"schema":"ombrage/records/1","records":[...],"skipped":[...]}
    std::string json() const;
};

/// Renders every scene with every pipeline, holds each against the ray-traced truth of the same scene and light, and writes
/// pictures, error maps, records and the report. What the folder holds already, measured by the same program on the same
/// device, is taken from there. Work done before an interruption of any kind is kept; several processes may share a folder.
CompareResult compare(const CompareRequest& request, const RendererOptions& renderer);

/// Forgets the records in a folder, where it has some; pictures stay. @throws Error(Environment), Error(Input)
void clearResults(const std::filesystem::path& folder);

/// The pictures of a report: shrunk until the file is below 8 MB, or all as they are.
enum class ReportPictures { Fitting, Full };

/// Makes report.html from a folder that compare() wrote. @throws Error(Input) when there are no records.
std::filesystem::path writeReport(const std::filesystem::path& folder, const std::filesystem::path& output = {},
                                  ReportPictures pictures = ReportPictures::Fitting);

}  // namespace ombrage
