// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/displace.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/reference.h>
#include <ombrage/technique.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

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

/// The kind asked for, when it fits the quantity, and the technique that it is about.
std::optional<TruthKind> truthKind(const Options& options, Quantity quantity) {
    std::optional<TruthKind> kind;
    if (options.has("truth")) kind = truthKindFromName(options.text("truth"), quantity);
    const bool isOwn = kind == TruthKind::Own;
    if (isOwn && !options.has("technique"))
        throw Error(ErrorCode::Usage, "the truth 'own' needs a technique that claims it",
                    "name it with --technique " + exampleId(Family::Ao));
    if (!isOwn && options.has("technique"))
        throw Error(ErrorCode::Usage, "--technique goes with --truth own only: no other truth knows techniques");
    return kind;
}

std::unique_ptr<AoIntegrand> claimOf(const std::string& technique) {
    std::unique_ptr<AoIntegrand> claim = ownIntegrand(parsePipeline(Family::Ao, technique));
    if (!claim)
        throw Error(ErrorCode::Usage, technique + " claims no integral that the truth 'own' could trace",
                    "only techniques of ambient occlusion claim one; " + exampleId(Family::Ao) + " does");
    return claim;
}

int runReference(const Options& options) {
    const std::string sceneName = requiredText(options, "scene", "scene to trace");
    const std::string file = requiredText(options, "output", "picture to write (-o ref.exr)");
    const Quantity quantity = quantityFromName(
        requiredText(options, "quantity", "quantity to trace (--quantity shadow, ao, indirect or picture)"));
    const RenderSettings frame = frameSettings(options);
    ReferenceOptions reference;
    reference.kind = truthKind(options, quantity);
    const std::unique_ptr<AoIntegrand> claim =
        reference.kind == TruthKind::Own ? claimOf(options.text("technique")) : nullptr;
    reference.integrand = claim.get();
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
    reference.progress = [&](double share) {
        return progress(scene.name + ": tracing " + quantityName(quantity), share);
    };
    const std::optional<TruthKind> asked = reference.kind;
    const bool isDisplaced = asked == TruthKind::Displaced;
    if (isDisplaced) reference.kind = TruthKind::T1;
    const Scene traced = isDisplaced ? displaced(scene) : scene;
    const Reference truth(traced);

    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    nlohmann::ordered_json json{
        {"schema", "ombrage/reference/1"},     {"output", file},        {"scene", scene.name},
        {"scene_hash", contentHash(scene)},    {"camera", camera.name}, {"quantity", quantityName(quantity)},
        {"size", {frame.width, frame.height}}, {"seed", frame.seed}};
    if (asked || !truthKindsOf(quantity).empty())
        json["truth"] = quantity == Quantity::Picture && !asked
                            ? nlohmann::ordered_json(nullptr)
                            : nlohmann::ordered_json(truthKindName(asked.value_or(truthKindsOf(quantity)[0])));
    if (claim) json["technique"] = toString(parsePipeline(Family::Ao, options.text("technique")));
    const auto keep = [&](const auto& result) {
        writeImage(file, truthImage(result, extension == ".exr"));
        json["spp"] = result.samplesPerPixel;
        json["standard_error"] = result.meanStandardError;
        json["masked"] = result.maskedShare;
    };
    const bool isArea = reference.kind == TruthKind::Area;
    // The receivers of a mean over the pixel are made point by point.
    const Receivers receivers = isArea ? Receivers{} : truth.receivers(camera, reference);
    switch (quantity) {
        case Quantity::Shadow:
            json["light"] = scene.lights[std::size_t(light)].name;
            keep(isArea ? truth.areaShadow(camera, light, reference)
                        : truth.shadow(receivers, camera, light, reference));
            break;
        case Quantity::Ao:
            keep(isArea ? truth.areaAo(camera, reference) : truth.ao(receivers, camera, reference));
            break;
        case Quantity::Indirect:
            writeImage(file, truth.indirect(receivers, camera, reference));
            break;
        case Quantity::Picture:
            writeImage(file,
                       isArea ? truth.areaPicture(camera, reference) : truth.picture(receivers, camera, reference));
            break;
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
             "cornell -o own.exr --quantity ao --truth own --technique " + exampleId(Family::Ao),
             "sphere -o look.png --quantity picture --truth area"},
            [](Options& options) {
                options.add("scene", "a built-in scene, a scene file (.json) or a model file");
                options.add("-o,--output", "FILE.exr (visibility, standard_error, mask) or .png (visibility)");
                options.add("--quantity", "shadow (of --light, or the first light), ao, indirect or picture");
                options.add("--spp", "N: samples per pixel (1 for hard lights, 1024 for soft ones, 256 for ao)");
                options.add(
                    "--truth",
                    "shadow, self or area for shadows; T1 to T5, T5-ball, own, displaced or area for ao; area for "
                    "picture");
                options.add("--technique", "ID[:key=value,...]: whose integral --truth own traces");
                addSceneOptions(options);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runReference};
}

}  // namespace ombrage::cli
