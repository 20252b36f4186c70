// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "lab/run_record.h"

namespace ombrage {

/// A record with something in every field, for tests.
inline RunRecord sampleRecord(const std::string& technique = "shadow/sample", double rmse = 0.0125) {
    RunRecord r;
    r.scene = "gap";
    r.sceneHash = "0123456789abcdef";
    r.camera = "main";
    r.light = "lamp";
    r.width = 640;
    r.height = 360;
    r.family = technique.substr(0, technique.find('/'));
    r.technique = technique;
    r.pipeline = technique;
    r.params = {{"resolution", std::int64_t(2048)},
                {"bias", 0.5},
                {"mode", std::string("slope")},
                {"cached", true},
                {"tint", Vec3Value{1, 0.5f, 0.25f}}};
    r.metrics = {{"rmse", rmse}, {"wrong", 0.002}, {"acne", std::nullopt}};
    r.truth = RunRecord::Truth{"shadow", 1024, 0.004, 0.01};
    r.passes = {{"light depth", {0.8, 0.9}, 3, 70000}};
    r.gpu_ms = {2.1, 2.4};
    r.frames_ms = {2.1, 2.0, 2.4};
    r.clock = "wall";
    r.cpu_ms = 0.4;
    r.gpuBytes = 16777216;
    r.counters = {{"rays", 1e6}};
    r.seed = 1;
    r.asked = {"gap"};
    r.version = "0.1.0";
    r.device = {"llvmpipe", "4.5", true};
    r.images = {{"visibility", "images/visibility.png"}, {"truth", "images/truth.png"}};
    r.warnings = {"a warning"};
    return r;
}

/// Adds a line to a file, as folders without a store have them.
inline void appendLine(const std::filesystem::path& file, const std::string& line) {
    std::ofstream(file, std::ios::binary | std::ios::app) << line << '\n';
}

}  // namespace ombrage
