// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ombrage/bench.h>
#include <nlohmann/json_fwd.hpp>

namespace ombrage {

nlohmann::ordered_json benchGroupJson(const BenchGroup& group);

/// @throws nlohmann::json::exception for what is no group
BenchGroup benchGroupFromJson(const nlohmann::ordered_json& json);

/// What json() of a result wrote. @throws Error(Input) naming the file
BenchResult readBench(const std::filesystem::path& file);

/// What decides, of a run.
const BenchFigures& decidingFigures(const BenchResult& result, const BenchRun& run);

}  // namespace ombrage
