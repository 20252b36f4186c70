// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/metrics.h>
#include <ombrage/motion.h>
#include <ombrage/scene.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "commands.h"

namespace ombrage::cli {

namespace {

using Json = nlohmann::ordered_json;

Json valueJson(const ParamValue& value) {
    return std::visit(
        [](const auto& v) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vec3Value>)
                return Json::array({v.x, v.y, v.z});
            else
                return v;
        },
        value);
}

const char* typeName(ParamType type) {
    switch (type) {
        case ParamType::Bool:
            return "bool";
        case ParamType::Int:
            return "int";
        case ParamType::Float:
            return "float";
        case ParamType::Enum:
            return "enum";
        case ParamType::Vec3:
            return "vec3";
    }
    return "";
}

bool hasRange(const ParamInfo& info) {
    return info.type == ParamType::Int || info.type == ParamType::Float || info.type == ParamType::Vec3;
}

std::string numberText(const ParamInfo& info, double value) {
    return info.type == ParamType::Int ? toString(ParamValue(std::int64_t(value))) : toString(ParamValue(value));
}

Json paramJson(const ParamInfo& info) {
    static const char* const kEffects[] = {"uniform", "define", "resize", "host"};
    Json json{{"key", info.key},
              {"type", typeName(info.type)},
              {"default", valueJson(info.defaultValue)},
              {"unit", unitName(info.unit)},
              {"effect", kEffects[std::size_t(info.effect)]},
              {"help", info.help}};
    if (hasRange(info)) json["range"] = {info.minimum, info.maximum};
    if (hasRange(info)) json["scale"] = info.scale == Scale::Log ? "log" : "linear";
    if (info.tuneMinimum != info.tuneMaximum) json["tune"] = {info.tuneMinimum, info.tuneMaximum};
    if (info.type == ParamType::Enum) json["choices"] = info.choices;
    return json;
}

std::vector<std::string> lightNames(const Domain& domain) {
    std::vector<std::string> names;
    if (domain.sun) names.emplace_back("sun");
    if (domain.spot) names.emplace_back("spot");
    if (domain.point) names.emplace_back("point");
    if (domain.rect) names.emplace_back("rect");
    return names;
}

Json techniqueJson(const TechniqueInfo& info) {
    Json json{{"id", info.id},         {"family", familyName(info.family)}, {"name", info.name},
              {"title", info.title},   {"summary", info.summary},           {"limits", info.limits},
              {"papers", info.papers}, {"screen_space", info.screenSpace},  {"uses_seed", info.usesSeed}};
    if (info.family == Family::Shadow)
        json["domain"] = {{"lights", lightNames(info.domain)},
                          {"soft", info.domain.soft},
                          {"closed_casters_only", info.domain.closedCastersOnly},
                          {"planar_receivers_only", info.domain.planarReceiversOnly},
                          {"alpha_test", info.domain.alphaTest}};
    json["passes"] = Json::array();
    for (const PassInfo& pass : info.passes)
        json["passes"].push_back({{"name", pass.name}, {"description", pass.description}});
    json["params"] = Json::array();
    for (const ParamInfo& param : info.params) json["params"].push_back(paramJson(param));
    return json;
}

void print(const Json& json) {
    printResult(json.dump(2) + "\n");
}

/// Two columns, the first as wide as its longest entry.
std::string columns(const std::vector<std::pair<std::string, std::string>>& rows) {
    std::size_t width = 0;
    for (const auto& row : rows) width = std::max(width, row.first.size());
    std::string text;
    for (const auto& row : rows) text += fmt::format("{:<{}}  {}\n", row.first, width, row.second);
    return text;
}

int listTechniques(const Options& options) {
    std::optional<Family> family;
    if (options.has("family")) family = familyFromName(options.text("family"));
    Json json{{"schema", "ombrage/techniques/1"}, {"techniques", Json::array()}};
    std::vector<std::pair<std::string, std::string>> rows;
    for (const TechniqueInfo& info : techniques()) {
        if (family && info.family != *family) continue;
        json["techniques"].push_back(techniqueJson(info));
        rows.emplace_back(info.id, info.summary);
    }
    options.flag("json") ? print(json) : printResult(columns(rows));
    return 0;
}

int listScenes(const Options& options) {
    Json json{{"schema", "ombrage/scenes/1"}, {"scenes", Json::array()}};
    std::vector<std::pair<std::string, std::string>> rows;
    for (const BuiltinScene& scene : builtinScenes()) {
        json["scenes"].push_back({{"name", scene.name}, {"description", scene.description}});
        rows.emplace_back(scene.name, scene.description);
    }
    options.flag("json") ? print(json) : printResult(columns(rows));
    return 0;
}

int listMetrics(const Options& options) {
    Json json{{"schema", "ombrage/metrics/1"}, {"metrics", Json::array()}};
    std::vector<std::pair<std::string, std::string>> rows;
    for (const MetricInfo& info : metricInfos()) {
        json["metrics"].push_back(
            {{"key", info.key}, {"unit", info.unit}, {"help", info.help}, {"lower_is_better", info.lowerIsBetter}});
        rows.emplace_back(info.key, info.help);
    }
    options.flag("json") ? print(json) : printResult(columns(rows));
    return 0;
}

int listMotions(const Options& options) {
    Json json{{"schema", "ombrage/motions/1"}, {"motions", Json::array()}};
    std::vector<std::pair<std::string, std::string>> rows;
    for (const MotionScript& script : motionScripts()) {
        json["motions"].push_back({{"name", script.name},
                                   {"description", script.description},
                                   {"frames", script.frames},
                                   {"jump_at", script.jumpAt > 0 ? Json(script.jumpAt) : Json(nullptr)},
                                   {"percent", script.percent},
                                   {"degrees", script.degrees}});
        rows.emplace_back(script.name, script.description);
    }
    options.flag("json") ? print(json) : printResult(columns(rows));
    return 0;
}

/// The technique of a full id or of a name that only one family has.
const TechniqueInfo& techniqueByName(const std::string& name) {
    std::vector<std::string> ids, matches;
    for (const TechniqueInfo& info : techniques()) {
        ids.push_back(info.id);
        if (info.name == name) matches.push_back(info.id);
    }
    if (name.find('/') != std::string::npos || matches.empty()) {
        if (std::find(ids.begin(), ids.end(), name) == ids.end()) throw unknownName("technique", name, ids);
        return technique(name);
    }
    if (matches.size() > 1)
        throw Error(ErrorCode::Usage, "the technique '" + name + "' exists in several families",
                    "name it in full, as in " + matches.front());
    return technique(matches.front());
}

int listParams(const Options& options, const std::string& id) {
    const TechniqueInfo& info = techniqueByName(id);
    if (options.flag("json")) {
        Json json{{"schema", "ombrage/params/1"}, {"technique", info.id}, {"params", Json::array()}};
        for (const ParamInfo& param : info.params) json["params"].push_back(paramJson(param));
        print(json);
        return 0;
    }
    std::vector<std::pair<std::string, std::string>> rows;
    for (const ParamInfo& param : info.params) {
        std::string range;
        if (hasRange(param)) range = numberText(param, param.minimum) + " to " + numberText(param, param.maximum);
        for (const std::string& choice : param.choices) range += (range.empty() ? "" : "|") + choice;
        if (param.type == ParamType::Bool) range = "true|false";
        const std::string unit = unitName(param.unit);
        rows.emplace_back(param.key + "=" + toString(param.defaultValue),
                          range + (unit.empty() ? "" : " " + unit) + ": " + param.help);
    }
    if (rows.empty())
        printMessage(info.id + " has no parameters");
    else
        printResult(columns(rows));
    return 0;
}

int runList(const Options& options) {
    const std::string topic = options.text("topic", "techniques");
    const std::vector<std::string> topics{"techniques", "scenes", "metrics", "motions", "params"};
    if (std::find(topics.begin(), topics.end(), topic) == topics.end()) throw unknownName("list", topic, topics);
    if (topic != "params" && options.has("id"))
        throw Error(ErrorCode::Usage, "'" + options.text("id") + "' is one argument too many");
    if (topic != "techniques" && options.has("family"))
        throw Error(ErrorCode::Usage, "--family goes with the list of techniques only");
    if (topic == "scenes") return listScenes(options);
    if (topic == "metrics") return listMetrics(options);
    if (topic == "motions") return listMotions(options);
    if (topic == "params")
        return listParams(options, requiredText(options, "id", "technique whose parameters to list"));
    return listTechniques(options);
}

}  // namespace

Command listCommand() {
    return {"list",
            "Shows techniques, built-in scenes, metrics, motion scripts, or the parameters of a technique",
            {"", "techniques --family shadow", "scenes", "metrics --json", "params " + exampleId(Family::Shadow)},
            [](Options& options) {
                options.add("topic", "techniques (default), scenes, metrics, motions or params");
                options.add("id", "the technique, for params");
                options.add("--family", "shadow, ao, filter, indirect or aa");
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runList};
}

}  // namespace ombrage::cli
