// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/reference.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

/// The planes visibility, standard_error and mask (0: measured); PNG and JPEG take the visibility alone.
template <typename Truth>
Image truthImage(const Truth& truth, bool allPlanes) {
    const std::vector<std::string> planes = allPlanes ? std::vector<std::string>{"visibility", "standard_error", "mask"}
                                                      : std::vector<std::string>{"visibility"};
    Image image(truth.width, truth.height, planes);
    std::copy(truth.visibility.begin(), truth.visibility.end(), image.plane(0).begin());
    if (!allPlanes) return image;
    std::copy(truth.standardError.begin(), truth.standardError.end(), image.plane(1).begin());
    std::transform(truth.mask.begin(), truth.mask.end(), image.plane(2).begin(), [](Mask mask) { return float(mask); });
    return image;
}

int runReference(const Options& options) {
    const std::string sceneName = requiredText(options, "scene", "scene to trace");
    const std::string file = requiredText(options, "output", "picture to write (-o ref.exr)");
    const std::vector<std::string> quantities{"shadow", "ao", "picture"};
    requiredText(options, "quantity", "quantity to trace (--quantity shadow, ao or picture)");
    const std::string quantity = quantities[options.choice("quantity", quantities, 0)];
    // The kinds of truth that exist so far.
    if (options.has("truth")) {
        const std::string kind = quantity == "shadow" ? "shadow" : quantity == "ao" ? "T1" : "";
        if (kind.empty()) throw Error(ErrorCode::Usage, "--truth does not go with --quantity picture");
        options.choice("truth", {kind}, 0);
    }
    const RenderSettings frame = frameSettings(options);
    ReferenceOptions reference;
    reference.width = frame.width;
    reference.height = frame.height;
    reference.seed = frame.seed;
    reference.samplesPerPixel = int(options.integer("spp", 0, 0, 1 << 20));

    Scene scene = loadScene(sceneName, sceneOptions(options));
    for (const std::string& warning : scene.warnings) printMessage("warning: " + warning);
    animate(scene, frame.time_s);
    const Camera& camera = scene.cameras[std::size_t(scene.cameraIndex(frame.camera))];
    const int light = scene.lightIndex(frame.light);
    Progress progress;
    reference.progress = [&](double share) { return progress(scene.name + ": tracing " + quantity, share); };
    const Reference truth(scene);
    const Receivers receivers = truth.receivers(camera, reference);

    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    nlohmann::ordered_json json{{"schema", "ombrage/reference/1"},     {"output", file},        {"scene", scene.name},
                                {"scene_hash", contentHash(scene)},    {"camera", camera.name}, {"quantity", quantity},
                                {"size", {frame.width, frame.height}}, {"seed", frame.seed}};
    const auto keep = [&](const auto& result) {
        writeImage(file, truthImage(result, extension == ".exr"));
        json["spp"] = result.samplesPerPixel;
        json["standard_error"] = result.meanStandardError;
        json["masked"] = result.maskedShare;
    };
    if (quantity == "shadow") {
        json["light"] = scene.lights[std::size_t(light)].name;
        keep(truth.shadow(receivers, camera, light, reference));
    } else if (quantity == "ao") {
        keep(truth.ao(receivers, camera, reference));
    } else {
        writeImage(file, truth.picture(receivers, camera, reference));
    }
    if (options.flag("json"))
        printResult(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    else
        printMessage(json.contains("spp") ? fmt::format("{}: {} samples per pixel, standard error {:.5f}", file,
                                                        json["spp"].get<int>(), json["standard_error"].get<double>())
                                          : file);
    return 0;
}

}  // namespace

Command referenceCommand() {
    return {"reference",
            "Traces the truth of a scene on the CPU; needs no OpenGL",
            {"gap -o ref.exr --quantity shadow", "cornell -o ao.png --quantity ao --spp 256",
             "sphere -o look.png --quantity picture"},
            [](Options& options) {
                options.add("scene", "a built-in scene, a scene file (.json) or a model file");
                options.add("-o,--output", "FILE.exr (visibility, standard_error, mask) or .png (visibility)");
                options.add("--quantity", "shadow (of --light, or the first light), ao or picture");
                options.add("--spp", "N: samples per pixel (1 for hard lights, 1024 for soft ones, 256 for ao)");
                options.add("--truth", "kind of truth: shadow for shadows, T1 for ao");
                addSceneOptions(options);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runReference};
}

}  // namespace ombrage::cli
