// SPDX-License-Identifier: MIT
#include "lab/bench_json.h"

#include <ombrage/error.h>
#include <ombrage/version.h>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace ombrage {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "ombrage/bench/1";

/// A tenth of a microsecond is below what any of the clocks tells.
double rounded(double time_ms) {
    return std::round(time_ms * 1e4) / 1e4;
}

Json toJson(const BenchFigures& figures) {
    Json samples = Json::array();
    for (const double sample : figures.samples) samples.push_back(rounded(sample));
    return {{"median", rounded(figures.median)},
            {"p95", rounded(figures.p95)},
            {"mad", rounded(figures.mad)},
            {"samples", std::move(samples)}};
}

BenchFigures figuresFrom(const Json& json) {
    return {json.at("median").get<double>(), json.at("p95").get<double>(), json.at("mad").get<double>(),
            json.at("samples").get<std::vector<double>>()};
}

Json toJson(const std::optional<BenchDifference>& difference) {
    if (!difference) return nullptr;
    return {{"change", difference->change},
            {"low", difference->low},
            {"high", difference->high},
            {"verdict", difference->verdict}};
}

std::optional<BenchDifference> differenceFrom(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return BenchDifference{json.at("change").get<double>(), json.at("low").get<double>(), json.at("high").get<double>(),
                           json.at("verdict").get<std::string>()};
}

Json toJson(const BenchRun& run) {
    Json json{{"pipeline", run.pipeline},        {"label", run.label},
              {"gpu_ms", toJson(run.gpu_ms)},    {"process_ms", toJson(run.process_ms)},
              {"cpu_ms", toJson(run.cpu_ms)},    {"draws", run.draws},
              {"triangles", run.triangles},      {"gpu_bytes", run.gpuBytes},
              {"counters", Json::object()},      {"passes", Json::array()},
              {"to_first", toJson(run.toFirst)}, {"to_baseline", toJson(run.toBaseline)}};
    for (const auto& [name, value] : run.counters) json["counters"][name] = value;
    for (const BenchPass& pass : run.passes)
        json["passes"].push_back({{"name", pass.name},
                                  {"gpu_ms", toJson(pass.gpu_ms)},
                                  {"draws", pass.draws},
                                  {"triangles", pass.triangles}});
    return json;
}

BenchRun runFrom(const Json& json) {
    BenchRun run;
    run.pipeline = json.at("pipeline").get<std::string>();
    run.label = json.at("label").get<std::string>();
    run.gpu_ms = figuresFrom(json.at("gpu_ms"));
    run.process_ms = figuresFrom(json.at("process_ms"));
    run.cpu_ms = figuresFrom(json.at("cpu_ms"));
    run.draws = json.at("draws").get<std::uint64_t>();
    run.triangles = json.at("triangles").get<std::uint64_t>();
    run.gpuBytes = json.at("gpu_bytes").get<std::uint64_t>();
    for (const auto& [name, value] : json.at("counters").items()) run.counters[name] = value.get<double>();
    for (const Json& pass : json.at("passes"))
        run.passes.push_back({pass.at("name").get<std::string>(), figuresFrom(pass.at("gpu_ms")),
                              pass.at("draws").get<std::uint64_t>(), pass.at("triangles").get<std::uint64_t>()});
    run.toFirst = differenceFrom(json.at("to_first"));
    run.toBaseline = differenceFrom(json.at("to_baseline"));
    return run;
}

}  // namespace

Json benchGroupJson(const BenchGroup& group) {
    Json json{{"scene", group.scene},
              {"scene_hash", group.sceneHash},
              {"camera", group.camera},
              {"light", group.light.empty() ? Json(nullptr) : Json(group.light)},
              {"size", {group.width, group.height}},
              {"axis", group.axis.empty() ? Json(nullptr) : Json(group.axis)},
              {"value", group.value},
              {"x", group.x},
              {"runs", Json::array()}};
    for (const BenchRun& run : group.runs) json["runs"].push_back(toJson(run));
    return json;
}

BenchGroup benchGroupFromJson(const Json& json) {
    BenchGroup group;
    group.scene = json.at("scene").get<std::string>();
    group.sceneHash = json.at("scene_hash").get<std::string>();
    group.camera = json.at("camera").get<std::string>();
    if (json.at("light").is_string()) group.light = json.at("light").get<std::string>();
    group.width = json.at("size").at(0).get<int>();
    group.height = json.at("size").at(1).get<int>();
    if (json.at("axis").is_string()) group.axis = json.at("axis").get<std::string>();
    group.value = json.at("value").get<std::string>();
    group.x = json.at("x").get<double>();
    for (const Json& run : json.at("runs")) group.runs.push_back(runFrom(run));
    return group;
}

std::string BenchResult::json() const {
    Json json{{"schema", kSchema},
              {"version", versionString()},
              {"command", commandLine},
              {"device", {{"renderer", device.renderer}, {"version", device.version}, {"software", device.software}}},
              {"clock", device.clock},
              {"decided_by", decidedBy},
              {"rounds", rounds},
              {"frames_per_round", framesPerRound},
              {"groups", Json::array()},
              {"skipped", Json::array()},
              {"regressions", regressions},
              {"reused", reused},
              {"interrupted", interrupted}};
    for (const BenchGroup& group : groups) json["groups"].push_back(benchGroupJson(group));
    for (const SkippedPair& pair : skipped)
        json["skipped"].push_back({{"scene", pair.scene}, {"technique", pair.technique}, {"reason", pair.reason}});
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

BenchResult readBench(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw Error(ErrorCode::Input, "cannot read the baseline '" + file.string() + "'",
                    "'ombrage bench --export-json FILE' writes one", file.string());
    try {
        const Json json = Json::parse(std::string(std::istreambuf_iterator<char>(in), {}));
        if (json.at("schema").get<std::string>() != kSchema)
            throw Error(ErrorCode::Input, "'" + file.string() + "' is not of the schema " + kSchema,
                        "'ombrage bench --export-json FILE' writes a baseline", file.string());
        BenchResult result;
        result.device.renderer = json.at("device").at("renderer").get<std::string>();
        result.device.version = json.at("device").at("version").get<std::string>();
        result.device.software = json.at("device").at("software").get<bool>();
        result.device.clock = json.at("clock").get<std::string>();
        result.decidedBy = json.at("decided_by").get<std::string>();
        result.rounds = json.at("rounds").get<int>();
        result.framesPerRound = json.at("frames_per_round").get<int>();
        for (const Json& group : json.at("groups")) result.groups.push_back(benchGroupFromJson(group));
        if (result.framesPerRound < 1)
            throw Error(ErrorCode::Input, "the baseline '" + file.string() + "' has rounds without frames", "",
                        file.string());
        return result;
    } catch (const Json::exception&) {
        throw Error(ErrorCode::Input, "'" + file.string() + "' is no result of a bench",
                    "'ombrage bench --export-json FILE' writes a baseline", file.string());
    }
}

const BenchFigures& decidingFigures(const BenchResult& result, const BenchRun& run) {
    return result.decidedBy == "gpu_ms" ? run.gpu_ms : run.process_ms;
}

}  // namespace ombrage
