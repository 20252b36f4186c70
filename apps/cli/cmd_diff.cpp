// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <ombrage/metrics.h>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.h"

namespace ombrage::cli {

namespace {

/// The error map in colours; numbers above 1 take the last one.
Image coloured(const Image& map) {
    Image image = Image::rgb(map.width(), map.height(), ColorSpace::Srgb);
    for (std::size_t i = 0; i < map.pixelCount(); ++i) {
        float rgb[3];
        magma(map.plane(0)[i], rgb);
        for (int c = 0; c < 3; ++c) image.plane(c)[i] = rgb[c];
    }
    return image;
}

int runDiff(const Options& options) {
    const std::string a = requiredText(options, "a", "pictures to compare (A B)"),
                      b = requiredText(options, "b", "second picture to compare (A B)");
    const std::vector<std::string> metrics{"flip", "rmse", "mae", "psnr", "ssim"};
    const std::string metric = metrics[options.choice("metric", metrics, 0)];
    std::optional<double> bound;
    if (options.has("fail-above")) bound = parseNumber(options.text("fail-above"), "--fail-above");

    const DiffResult result = diffImages(readImage(a), readImage(b), metric);
    if (options.has("map")) {
        const std::filesystem::path file = options.text("map");
        writeImage(file, file.extension() == ".exr" ? result.map : coloured(result.map));
    }
    if (options.flag("json")) {
        nlohmann::ordered_json json{{"metric", result.metric}};
        json["value"] = result.value ? nlohmann::ordered_json(*result.value) : nlohmann::ordered_json(nullptr);
        json["p95"] = result.p95;
        json["max"] = result.max;
        if (result.exact) json["exact"] = true;
        printResult(json.dump(2) + "\n");
    } else {
        printResult(fmt::format("{} {}, p95 {:.6f}, max {:.6f}{}\n", result.metric,
                                result.value ? fmt::format("{:.6f}", *result.value) : "infinite", result.p95,
                                result.max, result.exact ? " (exactly equal)" : ""));
    }
    if (bound && result.value && *result.value > *bound) {
        printMessage(
            fmt::format("failed: {} is {:.6f}, above {}", result.metric, *result.value, options.text("fail-above")));
        return int(ErrorCode::GateFailed);
    }
    return 0;
}

}  // namespace

Command diffCommand() {
    return {"diff",
            "Measures the difference of two pictures",
            {"a.png b.png", "a.exr b.exr --metric rmse --fail-above 0.01", "a.png b.png --map error.png --json"},
            [](Options& options) {
                options.add("a", "a picture, the reference (PNG, JPEG, EXR)");
                options.add("b", "a picture of the same size");
                options.add("--metric", "flip, rmse, mae, psnr or ssim (flip)");
                options.add("--map", "FILE.png (colours) or .exr (numbers): the error of every pixel");
                options.add("--fail-above", "X: exit 1 when the value is above X");
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runDiff};
}

}  // namespace ombrage::cli
