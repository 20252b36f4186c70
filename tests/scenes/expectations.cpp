// SPDX-License-Identifier: MIT
#include "scenes/expectations.h"

#include <fstream>
#include <set>

#include <ombrage/error.h>
#include <nlohmann/json.hpp>

namespace ombrage::test {

namespace {
using nlohmann::json;

void requireKeys(const json& object, const std::set<std::string>& known, const std::string& where) {
    for (const auto& [key, value] : object.items())
        if (known.count(key) == 0) throw Error(ErrorCode::Input, "unknown key '" + key + "'", "", where);
}

std::vector<Expectation> readList(const json& file, const char* key, const std::string& where) {
    std::vector<Expectation> list;
    for (const json& entry : file.at(key)) {
        requireKeys(entry, {"technique", "metric", "min", "max", "why"}, where);
        Expectation expectation{entry.at("technique"), entry.at("metric"), {}, {}, entry.at("why")};
        if (entry.contains("min")) expectation.min = entry["min"].get<double>();
        if (entry.contains("max")) expectation.max = entry["max"].get<double>();
        if (expectation.min.has_value() == expectation.max.has_value())
            throw Error(ErrorCode::Input, "an expectation has either 'min' or 'max'", "", where);
        list.push_back(std::move(expectation));
    }
    if (list.empty()) throw Error(ErrorCode::Input, std::string("nothing under '") + key + "'", "", where);
    return list;
}
}  // namespace

SceneExpectations readExpectations(const std::filesystem::path& folder, const std::string& scene) {
    const std::string name = (folder / (scene + ".json")).string();
    std::ifstream input(name);
    if (!input) throw Error(ErrorCode::Input, "every built-in scene declares what it shows", "", name);
    try {
        const json file = json::parse(input);
        requireKeys(file, {"camera", "light", "time_s", "shows", "holds"}, name);
        SceneExpectations read;
        read.scene = scene;
        read.camera = file.value("camera", "");
        read.light = file.value("light", "");
        read.time_s = file.value("time_s", 0.0);
        read.shows = readList(file, "shows", name);
        read.holds = readList(file, "holds", name);
        return read;
    } catch (const json::exception& error) {
        throw Error(ErrorCode::Input, error.what(), "", name);
    }
}

}  // namespace ombrage::test
