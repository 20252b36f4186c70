// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/renderer.h>
#include <ombrage/version.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.h"

namespace ombrage::cli {

namespace {

int runDoctorCommand(const Options& options) {
    const std::vector<DoctorCheck> checks = runDoctor(rendererOptions(options));
    const bool healthy = std::none_of(checks.begin(), checks.end(), [](const DoctorCheck& check) {
        return check.verdict == "missing" || check.verdict == "failed";
    });
    if (options.flag("json")) {
        nlohmann::ordered_json json{{"schema", "ombrage/doctor/1"}, {"version", versionString()}, {"healthy", healthy}};
        json["checks"] = nlohmann::ordered_json::array();
        for (const DoctorCheck& check : checks)
            json["checks"].push_back({{"name", check.name}, {"verdict", check.verdict}, {"detail", check.detail}});
        printResult(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    } else {
        std::string text = fmt::format("ombrage {}\n", versionString());
        for (const DoctorCheck& check : checks)
            text += fmt::format("{:<9} {:<26} {}\n", check.verdict, check.name, check.detail);
        printResult(text);
    }
    return healthy ? 0 : int(ErrorCode::Environment);
}

}  // namespace

Command doctorCommand() {
    return {"doctor",
            "Tries what the program needs and says what is in use",
            {"", "--json", "--device software"},
            [](Options& options) {
                options.add("--device", "software, or the index of an EGL device (the best, with a fallback)");
                options.add("--shader-dir", "DIR: read the shaders from here instead of the built-in ones");
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runDoctorCommand};
}

}  // namespace ombrage::cli
