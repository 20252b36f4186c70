// SPDX-License-Identifier: MIT
#include "compare_output.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace ombrage::cli {

std::string recordLines(const CompareResult& result) {
    std::vector<std::pair<std::string, std::string>> rows;
    std::size_t width = 0;
    for (const std::string& record : result.records) {
        const auto json = nlohmann::json::parse(record);
        std::string where = json["scene"].get<std::string>();
        if (json["light"].is_string()) where += " " + json["light"].get<std::string>();
        if (json["motion"].is_string()) where += " " + json["motion"].get<std::string>();
        std::string values;
        for (const char* key : {"rmse", "wrong", "gain_db", "flicker_mean", "flicker_p99", "flicker_patch", "lag"})
            if (json["metrics"].contains(key))
                values += json["metrics"][key].is_null()
                              ? fmt::format("{} –  ", key)
                              : fmt::format("{} {:.5f}  ", key, json["metrics"][key].get<double>());
        if (json["truth"].is_object()) where += " (" + json["truth"]["kind"].get<std::string>() + ")";
        rows.emplace_back(where + "  " + json["pipeline"].get<std::string>(),
                          values + fmt::format("{:.2f} ms", json["gpu_ms"]["median"].get<double>()));
        width = std::max(width, rows.back().first.size());
    }
    std::string text;
    for (const auto& row : rows) text += fmt::format("{:<{}}  {}\n", row.first, width, row.second);
    return text;
}

}  // namespace ombrage::cli
