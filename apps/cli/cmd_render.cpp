// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/version.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
#include "progress.h"
#include "trace_file.h"

namespace ombrage::cli {

namespace {

using Json = nlohmann::ordered_json;

Json resultJson(const std::string& file, const Scene& scene, const RenderSettings& settings, const RenderResult& result,
                const DeviceInfo& device) {
    const auto stats = [](const Stats& s) { return Json{{"median", s.median}, {"p95", s.p95}}; };
    Json json{{"schema", "ombrage/render/1"},
              {"output", file},
              {"scene", scene.name},
              {"scene_hash", contentHash(scene)},
              {"size", {settings.width, settings.height}}};
    json["camera"] = scene.cameras[std::size_t(scene.cameraIndex(settings.camera))].name;
    json["light"] = settings.light.empty() ? Json(nullptr) : Json(settings.light);
    json["pipelines"] = {{"shadow", toString(settings.shadow)},
                         {"ao", toString(settings.ao)},
                         {"indirect", toString(settings.indirect)},
                         {"aa", toString(settings.aa)}};
    json["passes"] = Json::array();
    for (const PassCost& pass : result.passes)
        json["passes"].push_back({{"name", pass.name},
                                  {"gpu_ms", stats(pass.gpu_ms)},
                                  {"draws", pass.draws},
                                  {"triangles", pass.triangles}});
    json["gpu_ms"] = stats(result.gpu_ms);
    json["gpu_ms"]["clock"] = device.clock;
    json["cpu_ms"] = result.cpu_ms;
    json["gpu_bytes"] = result.gpuBytes;
    json["counters"] = Json::object();
    for (const auto& [name, value] : result.counters) json["counters"][name] = value;
    json["seed"] = settings.seed;
    json["version"] = versionString();
    json["device"] = {{"renderer", device.renderer}, {"version", device.version}, {"software", device.software}};
    json["warnings"] = result.warnings;
    return json;
}

int showNames(Renderer& renderer, const RenderSettings& settings, bool asJson) {
    Json json{{"schema", "ombrage/show/1"}, {"names", Json::array()}};
    std::string text;
    for (const PassInfo& pass : renderer.showNames(settings)) {
        json["names"].push_back({{"name", pass.name}, {"description", pass.description}});
        text += fmt::format("{:<24} {}\n", pass.name, pass.description);
    }
    printResult(asJson ? json.dump(2) + "\n" : text);
    return 0;
}

int runRender(const Options& options) {
    const std::string sceneName = requiredText(options, "scene", "scene to render");
    RenderSettings settings = renderSettings(options);
    settings.frames = int(options.integer("frames", 1, 1, 100000));
    const std::string show = options.text("show", "final");
    const bool listing = show == "list", everything = show == "all";
    const std::string file = listing ? "" : requiredText(options, "output", "picture to write (-o out.png)");
    if (everything && std::filesystem::path(file).has_extension())
        throw Error(ErrorCode::Usage, "'--show all' writes many pictures, and '" + file + "' is one file",
                    "name a folder with -o");
    if (show != "final" && !listing) settings.show = {show};
    settings.images = false;

    std::optional<TraceFile> trace;
    if (options.has("trace")) trace.emplace(options.text("trace"));
    const Scene scene = loadScene(sceneName, sceneOptions(options));
    for (const std::string& warning : scene.warnings) printMessage("warning: " + warning);
    // A scene may say what it is meant for; another choice warns and goes on. Baselines are no choice.
    for (const TechniqueSpec& spec : settings.shadow)
        if (options.has("shadow") && !scene.techniques.empty() &&
            std::find(scene.techniques.begin(), scene.techniques.end(), spec.id) == scene.techniques.end())
            printMessage(fmt::format("warning: the scene '{}' is not meant for {}", scene.name, spec.id));
    Renderer renderer(rendererOptions(options));
    renderer.setScene(scene);
    if (listing) return showNames(renderer, settings, options.flag("json"));
    settings.progress = [](double) { return !interrupted(); };
    const RenderResult result = renderer.render(settings);
    for (const std::string& warning : result.warnings) printMessage("warning: " + warning);
    if (interrupted()) throw Error(ErrorCode::Interrupted, "interrupted", "no picture was written");
    if (everything) {
        for (const auto& [name, image] : result.shown) writeImage(std::filesystem::path(file) / (name + ".png"), image);
    } else {
        // An EXR file takes the numbers, a picture file what is fit for looking at.
        const bool wantsNumbers = std::filesystem::path(file).extension() == ".exr";
        writeImage(file, show == "final" ? result.picture : (wantsNumbers ? result.shownRaw : result.shown).at(show));
    }
    if (trace) trace->close();
    if (options.flag("json"))
        printResult(resultJson(file, scene, settings, result, renderer.device())
                        .dump(2, ' ', false, Json::error_handler_t::replace) +
                    "\n");
    else
        printMessage(fmt::format("{}: {}x{}, GPU {:.2f} ms ({}{}), CPU {:.2f} ms", file, settings.width,
                                 settings.height, result.gpu_ms.median, renderer.device().clock,
                                 renderer.device().software ? ", software" : "", result.cpu_ms));
    return 0;
}

}  // namespace

Command renderCommand() {
    const std::string shadow = exampleId(Family::Shadow), ao = exampleId(Family::Ao),
                      filter = exampleId(Family::Filter);
    return {"render",
            "Renders a scene to a picture",
            {"gap -o out.png --shadow " + shadow, "cornell -o ao.png --show ao --ao " + ao + " --filter " + filter,
             "model.obj --ground --size 1280x720 -o out.exr", "gap --shadow " + shadow + " --show list",
             "gap -o out.png --shadow " + shadow + " --frames 3 --trace trace.json"},
            [](Options& options) {
                options.add("scene", "a built-in scene, a scene file (.json) or a model file");
                options.add("-o,--output", "FILE.png, .jpg (as displayed) or .exr (the linear numbers)");
                addRenderOptions(options);
                options.add("--show",
                            "the picture to write: final, visibility, ao, indirect, depth, normal, position, albedo or "
                            "a pass; 'list' names them, 'all' writes each into the folder -o (final)");
                options.add("--frames", "N: frames to render; the last one is written (1)");
                options.add("--trace",
                            "FILE.json: what was done and when, on the CPU and the GPU, for ui.perfetto.dev or "
                            "chrome://tracing");
                addSceneOptions(options);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runRender};
}

}  // namespace ombrage::cli
