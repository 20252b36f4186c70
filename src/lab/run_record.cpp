// SPDX-License-Identifier: MIT
#include "lab/run_record.h"

#include <ombrage/error.h>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace ombrage {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRecordSchema = "ombrage/record/1";
constexpr const char* kRunSchema = "ombrage/run/1";

Json toJsonValue(const ParamValue& value) {
    return std::visit(
        [](const auto& v) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vec3Value>)
                return Json::array({v.x, v.y, v.z});
            else
                return v;
        },
        value);
}

ParamValue toParamValue(const Json& json) {
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number_integer()) return json.get<std::int64_t>();
    if (json.is_number()) return json.get<double>();
    if (json.is_array()) return Vec3Value{json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
    return json.get<std::string>();
}

Json timing(const RunRecord::Timing& t) {
    return {{"median", t.median}, {"p95", t.p95}};
}

RunRecord::Timing toTiming(const Json& json) {
    return {json.at("median").get<double>(), json.at("p95").get<double>()};
}

/// Parses one document, checks its schema and hands it to `read`; every failure becomes Error(Input).
template <typename Read>
auto readDocument(const std::string& text, const std::string& where, const char* schema, Read read) {
    try {
        const Json json = Json::parse(text);
        if (const std::string found = json.at("schema").get<std::string>(); found != schema)
            throw Error(ErrorCode::Input, "the record's schema is '" + found + "', not '" + schema + "'",
                        "it was written by another version of the program; compare again", where);
        return read(json);
    } catch (const Json::exception& e) {
        // Without the parser's own "[json.exception.NAME.NUMBER] ".
        const std::string what = e.what();
        throw Error(ErrorCode::Input,
                    "not a record: " + what.substr(what.find("] ") == std::string::npos ? 0 : what.find("] ") + 2),
                    "delete the line or compare again", where);
    }
}

/// Text written for people or by a driver may hold bytes that are not UTF-8; they must not stop a record.
std::string dump(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string RunRecord::toJson() const {
    Json json;
    json["schema"] = kRecordSchema;
    json["scene"] = scene;
    json["scene_hash"] = sceneHash;
    json["camera"] = camera;
    json["light"] = light.empty() ? Json(nullptr) : Json(light);
    json["time_s"] = time_s;
    json["normals"] = normals;
    json["motion"] = motion.empty() ? Json(nullptr) : Json(motion);
    json["size"] = {width, height};
    json["family"] = family;
    json["technique"] = technique;
    json["pipeline"] = pipeline;
    json["params"] = Json::object();
    for (const auto& [key, value] : params) json["params"][key] = toJsonValue(value);
    json["metrics"] = Json::object();
    for (const auto& [key, value] : metrics) json["metrics"][key] = value ? Json(*value) : Json(nullptr);
    json["truth"] = nullptr;
    if (truth)
        json["truth"] = {{"kind", truth->kind},
                         {"spp", truth->spp},
                         {"standard_error", truth->standard_error},
                         {"masked", truth->masked}};
    json["passes"] = Json::array();
    for (const Pass& pass : passes)
        json["passes"].push_back({{"name", pass.name},
                                  {"gpu_ms", timing(pass.gpu_ms)},
                                  {"draws", pass.draws},
                                  {"triangles", pass.triangles}});
    json["gpu_ms"] = timing(gpu_ms);
    json["gpu_ms"]["clock"] = clock;
    // A tenth of a microsecond is below what any of the clocks tells.
    json["gpu_ms"]["samples"] = Json::array();
    for (const double sample_ms : frames_ms) json["gpu_ms"]["samples"].push_back(std::round(sample_ms * 1e4) / 1e4);
    json["cpu_ms"] = cpu_ms;
    json["gpu_bytes"] = gpuBytes;
    json["counters"] = Json::object();
    for (const auto& [key, value] : counters) json["counters"][key] = value;
    json["seed"] = seed;
    json["asked"] = asked;
    json["version"] = version;
    json["device"] = {{"renderer", device.renderer}, {"version", device.version}, {"software", device.software}};
    json["images"] = Json::object();
    for (const auto& [kind, path] : images) json["images"][kind] = path;
    json["warnings"] = warnings;
    return dump(json);
}

RunRecord RunRecord::fromJson(const std::string& text, const std::string& where) {
    return readDocument(text, where, kRecordSchema, [](const Json& json) {
        RunRecord r;
        r.scene = json.at("scene").get<std::string>();
        r.sceneHash = json.at("scene_hash").get<std::string>();
        r.camera = json.at("camera").get<std::string>();
        if (!json.at("light").is_null()) r.light = json.at("light").get<std::string>();
        // Earlier versions told none of these three.
        r.time_s = json.value("time_s", 0.0);
        r.normals = json.value("normals", std::string("map"));
        r.asked = json.value("asked", std::vector<std::string>());
        if (json.contains("motion") && !json.at("motion").is_null()) r.motion = json.at("motion").get<std::string>();
        r.width = json.at("size").at(0).get<int>();
        r.height = json.at("size").at(1).get<int>();
        r.technique = json.at("technique").get<std::string>();
        r.family = json.value("family", r.technique.substr(0, r.technique.find('/')));
        r.pipeline = json.value("pipeline", r.technique);
        for (const auto& [key, value] : json.at("params").items()) r.params.emplace_back(key, toParamValue(value));
        for (const auto& [key, value] : json.at("metrics").items())
            r.metrics[key] = value.is_null() ? std::nullopt : std::optional(value.get<double>());
        if (const Json& t = json.at("truth"); !t.is_null())
            r.truth = Truth{t.at("kind").get<std::string>(), t.at("spp").get<int>(),
                            t.at("standard_error").is_null() ? 0.0 : t.at("standard_error").get<double>(),
                            t.at("masked").is_null() ? 0.0 : t.at("masked").get<double>()};
        for (const Json& pass : json.at("passes"))
            r.passes.push_back({pass.at("name").get<std::string>(), toTiming(pass.at("gpu_ms")),
                                pass.at("draws").get<std::uint64_t>(), pass.at("triangles").get<std::uint64_t>()});
        r.gpu_ms = toTiming(json.at("gpu_ms"));
        r.clock = json.at("gpu_ms").at("clock").get<std::string>();
        // Folders of earlier versions have none.
        r.frames_ms = json.at("gpu_ms").value("samples", std::vector<double>());
        r.cpu_ms = json.at("cpu_ms").get<double>();
        r.gpuBytes = json.at("gpu_bytes").get<std::uint64_t>();
        for (const auto& [key, value] : json.at("counters").items()) r.counters[key] = value.get<double>();
        r.seed = json.at("seed").get<std::uint64_t>();
        r.version = json.at("version").get<std::string>();
        const Json& ranOn = json.at("device");
        r.device = {ranOn.at("renderer").get<std::string>(), ranOn.at("version").get<std::string>(),
                    ranOn.at("software").get<bool>()};
        for (const auto& [kind, path] : json.at("images").items()) r.images[kind] = path.get<std::string>();
        r.warnings = json.at("warnings").get<std::vector<std::string>>();
        return r;
    });
}

std::string RunNote::toJson() const {
    Json json;
    json["schema"] = kRunSchema;
    json["command"] = command;
    json["skipped"] = Json::array();
    for (const Skipped& s : skipped)
        json["skipped"].push_back({{"scene", s.scene}, {"technique", s.technique}, {"reason", s.reason}});
    json["failed_gates"] = failedGates;
    json["interrupted"] = interrupted;
    return dump(json);
}

RunNote RunNote::fromJson(const std::string& text, const std::string& where) {
    return readDocument(text, where, kRunSchema, [](const Json& json) {
        RunNote note;
        note.command = json.at("command").get<std::vector<std::string>>();
        for (const Json& s : json.at("skipped"))
            note.skipped.push_back({s.at("scene").get<std::string>(), s.at("technique").get<std::string>(),
                                    s.at("reason").get<std::string>()});
        note.failedGates = json.at("failed_gates").get<std::vector<std::string>>();
        note.interrupted = json.at("interrupted").get<bool>();
        return note;
    });
}

std::string identityOf(const RunRecord& r) {
    Json identity{r.scene, r.sceneHash, r.camera, r.light,    r.motion,
                  r.width, r.height,    r.seed,   r.pipeline, r.truth ? r.truth->kind : std::string()};
    // Last and only where it says something: the texts of earlier versions mean the same run.
    if (r.time_s != 0) identity.push_back(r.time_s);
    if (r.normals != "map") identity.push_back(r.normals);
    return dump(identity);
}

std::vector<std::string> readLines(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::ifstream in(file, std::ios::binary);
    // getline reports the end of file together with a last line that has no end: such a line is not whole.
    for (std::string line; std::getline(in, line) && !in.eof();)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

}  // namespace ombrage
