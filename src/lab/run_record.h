// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ombrage/params.h>

namespace ombrage {

/// What one run measured: a technique, a scene, a camera and, for shadows, a light. The form on disk is one record of
/// the store and one line of DIR/records.jsonl, schema ombrage/record/1 (design section 8); `pipeline`, `family`,
/// `time_s`, `normals` and `asked` are additions to it.
struct RunRecord {
    struct Timing {
        double median = 0, p95 = 0;
        bool operator==(const Timing&) const = default;
    };
    struct Pass {
        std::string name;
        Timing gpu_ms;
        std::uint64_t draws = 0, triangles = 0;
        bool operator==(const Pass&) const = default;
    };
    struct Truth {
        std::string kind;  ///< "shadow", "T1"
        int spp = 0;
        double standard_error = 0;  ///< mean over valid pixels
        double masked = 0;          ///< share of the pixels that are not sky
        bool operator==(const Truth&) const = default;
    };
    struct Device {
        std::string renderer, version;
        bool software = false;
        bool operator==(const Device&) const = default;
    };

    std::string scene, sceneHash, camera;
    std::string light;            ///< "" (null on disk) where the family has none
    double time_s = 0;            ///< of the scene's animations
    std::string normals = "map";  ///< what shading normals came from, by normalSourceName()
    std::string motion;  ///< script that was played, as parseMotion takes it; "" (null on disk) for a still picture
    int width = 0, height = 0;
    std::string family;
    std::string technique;  ///< ids joined by '+'
    std::string pipeline;   ///< canonical text, parameters that differ from their defaults included
    std::vector<std::pair<std::string, ParamValue>>
        params;  ///< all of them; "ID.key" where the pipeline has several ids
    std::map<std::string, std::optional<double>> metrics;
    std::optional<Truth> truth;  ///< nothing: the family has no truth yet
    std::vector<Pass> passes;
    Timing gpu_ms;
    std::vector<double> frames_ms;  ///< GPU time of every frame after the warm-up, in order
    std::string clock;              ///< "timestamp" or "wall"
    double cpu_ms = 0;
    std::uint64_t gpuBytes = 0;
    std::map<std::string, double> counters;
    std::uint64_t seed = 0;
    /// The scene as a command asks for it: name or file, and the options that make it another ("--ground", "--time",
    /// "2"). Empty where nobody asked by a command line.
    std::vector<std::string> asked;
    std::string version;
    Device device;
    std::map<std::string, std::string> images;  ///< kind -> path relative to the folder
    std::vector<std::string> warnings;

    bool operator==(const RunRecord&) const = default;

    /// One line of JSON without a line end.
    std::string toJson() const;

    /// @param where named in errors ("records.jsonl:3"). @throws Error(Input) for what is not an ombrage/record/1.
    static RunRecord fromJson(const std::string& text, const std::string& where);
};

/// What a report takes for the same run: scene, camera, light, time, motion, size, seed, pipeline and truth. Of two the
/// later counts.
std::string identityOf(const RunRecord& record);

/// What one call of compare() leaves beside its records: one note of the store and
/// one line of DIR/runs.jsonl, schema ombrage/run/1.
struct RunNote {
    struct Skipped {
        std::string scene, technique, reason;
        bool operator==(const Skipped&) const = default;
    };
    std::vector<std::string> command;
    std::vector<Skipped> skipped;
    std::vector<std::string> failedGates;
    bool interrupted = false;

    bool operator==(const RunNote&) const = default;

    std::string toJson() const;
    static RunNote fromJson(const std::string& text, const std::string& where);
};

inline constexpr const char* kRecordsFile = "records.jsonl";
inline constexpr const char* kRunsFile = "runs.jsonl";

/// The whole lines of a file; a last one without a line end is left out. Nothing when there is no such file.
std::vector<std::string> readLines(const std::filesystem::path& file);

}  // namespace ombrage
