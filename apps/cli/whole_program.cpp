// SPDX-License-Identifier: MIT
#include "whole_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <ombrage/bench.h>
#include <ombrage/error.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "progress.h"

extern char** environ;

namespace ombrage::cli {

namespace {

using Json = nlohmann::ordered_json;

/// What one process of the table measures, when it is asked for one technique on one scene.
Json measureHere(const Options& options, const std::string& sceneName, const std::string& technique) {
    const auto [family, pipeline] = parseTechnique(technique);
    const Scene scene = loadScene(sceneName, sceneOptions(options));
    RenderSettings settings = frameSettings(options);
    Pipeline& place = family == Family::Shadow     ? settings.shadow
                      : family == Family::Indirect ? settings.indirect
                      : family == Family::Aa       ? settings.aa
                                                   : settings.ao;
    place = pipeline;
    settings.progress = [](double) { return !interrupted(); };
    const ProgramFigures figures =
        measureProgram(scene, settings, int(options.integer("seconds", 3, 1, 3600)), rendererOptions(options));
    return {{"scene", figures.scene},
            {"technique", toString(pipeline)},
            {"fps", figures.fps},
            {"fps_of_seconds", figures.fpsOfSeconds},
            {"cpu_percent", figures.cpuPercent},
            {"memory_mib", figures.memory_MiB},
            {"memory_percent", figures.memoryPercent},
            {"device",
             {{"renderer", figures.device.renderer},
              {"version", figures.device.version},
              {"software", figures.device.software}}}};
}

/// The same in a process of its own. @throws Error with its exit code's meaning; its messages have been shown.
Json measureApart(const Options& options, const std::string& scene, const std::string& technique) {
    std::vector<std::string> arguments{"ombrage", "bench", scene, "--program", "--json", "--technique", technique};
    for (const char* key :
         {"size", "camera", "light", "time", "seed", "shader-dir", "device", "eye", "target", "seconds"})
        if (options.has(key)) arguments.insert(arguments.end(), {"--" + std::string(key), options.text(key)});
    for (const char* key : {"ground", "allow-outside"})
        if (options.flag(key)) arguments.push_back("--" + std::string(key));
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error(ErrorCode::Environment, "cannot make a pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    pid_t child = 0;
    const int failed = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    std::string text;
    char buffer[4096];
    for (ssize_t count = 1; failed == 0 && count != 0;) {
        count = read(ends[0], buffer, sizeof buffer);
        if (count > 0) text.append(buffer, std::size_t(count));
        if (count < 0 && errno != EINTR) break;
    }
    close(ends[0]);
    if (failed != 0) throw Error(ErrorCode::Environment, "cannot start the program again");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : int(ErrorCode::Environment);
    if (interrupted() || code == int(ErrorCode::Interrupted)) throw Error(ErrorCode::Interrupted, "interrupted");
    const Json json = Json::parse(text, nullptr, false);
    if (code != 0 || !json.contains("programs") || json["programs"].empty())
        throw Error(code == 0 ? ErrorCode::Environment : ErrorCode(code),
                    technique + " on " + scene + " could not be measured", "its own message stands above");
    return json["programs"][0];
}

/// The techniques asked for, as texts.
std::vector<std::string> techniqueTexts(const Options& options) {
    std::vector<std::string> texts;
    for (const std::string& text : options.texts("technique")) texts.push_back(toString(parseTechnique(text).second));
    for (const std::string& name : options.texts("all"))
        for (const TechniqueInfo& info : techniques())
            if (info.family == familyFromName(name)) texts.push_back(info.id);
    if (texts.empty()) throw Error(ErrorCode::Usage, "no technique to measure", "use --technique ID or --all FAMILY");
    return texts;
}

}  // namespace

int runWholeProgram(const Options& options) {
    const std::vector<std::string> scenes = options.texts("scene"), texts = techniqueTexts(options);
    if (scenes.empty())
        throw Error(ErrorCode::Usage, "no scene to measure on", "'ombrage list scenes' shows the built-in ones");
    for (const char* key :
         {"sweep", "baseline", "fail-on", "export-csv", "export-markdown", "output", "frames", "warmup"})
        if (options.has(key))
            throw Error(ErrorCode::Usage, "--" + std::string(key) + " does not go with --program",
                        "--program takes --seconds, --json and --export-json");
    Json json{{"schema", "ombrage/program/1"}, {"programs", Json::array()}};
    Progress progress;
    const std::size_t count = scenes.size() * texts.size();
    for (const std::string& scene : scenes)
        for (const std::string& text : texts) {
            if (count == 1) {
                json["programs"].push_back(measureHere(options, scene, text));
                continue;
            }
            if (!progress(scene + ": " + text, double(json["programs"].size()) / double(count)))
                return int(ErrorCode::Interrupted);
            json["programs"].push_back(measureApart(options, scene, text));
        }
    Progress::clearLine();
    const std::string document = json.dump(1) + "\n";
    if (options.has("export-json")) {
        std::ofstream out(options.text("export-json"), std::ios::binary);
        out << document;
        out.close();
        if (!out) throw Error(ErrorCode::Environment, "cannot write '" + options.text("export-json") + "'");
    }
    if (options.flag("json")) {
        printResult(document);
        return 0;
    }
    std::string table = "| scene | technique | FPS | CPU | memory | of the machine's |\n|---|---|--:|--:|--:|--:|\n";
    for (const Json& row : json["programs"])
        table +=
            fmt::format("| {} | {} | {:.1f} | {:.0f} % | {:.0f} MiB | {:.1f} % |\n", row["scene"].get<std::string>(),
                        row["technique"].get<std::string>(), row["fps"].get<double>(), row["cpu_percent"].get<double>(),
                        row["memory_mib"].get<double>(), row["memory_percent"].get<double>());
    const Json& device = json["programs"][0]["device"];
    printResult(table + "\nFrames of " + (device["software"].get<bool>() ? "a software renderer, " : "") +
                device["renderer"].get<std::string>() + ". 100 % of CPU is one processor.\n");
    return 0;
}

}  // namespace ombrage::cli
