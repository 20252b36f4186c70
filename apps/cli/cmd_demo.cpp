// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <filesystem>

#include "commands.h"
#include "compare_output.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

/// One comparison of the gallery: a family on the scenes that show what it is about.
struct Part {
    std::vector<std::string> scenes;
    Family family;
    const char* truth;  ///< "": the family's own choice
    int truthSamples;
    double share;  ///< of the progress, at its end
};

int runDemo(const Options& options) {
    const std::filesystem::path folder = options.text("output", "ombrage-demo");
    // A gallery shows its own runs only.
    clearResults(folder);

    // What each occlusion technique claims takes minutes to trace: all are held against T1 alone.
    const std::vector<Part> parts{{{"in-shadow", "gap", "sphere", "menger"}, Family::Shadow, "", 0, 0.5},
                                  {{"cornell", "corner"}, Family::Ao, "T1", 64, 0.75},
                                  {{"cornell"}, Family::Filter, "T1", 64, 0.85},
                                  {{"comb", "menger"}, Family::Aa, "", 0, 0.95},
                                  {{"cornell", "sphere", "menger"}, Family::Indirect, "", 0, 1.0}};
    Progress progress;
    double start = 0;
    std::filesystem::path report;
    std::string lines;
    bool interrupted = false;
    for (const Part& part : parts) {
        CompareRequest request;
        request.scenes = part.scenes;
        request.allOf = {part.family};
        request.truthKind = part.truth;
        request.truthSamples = part.truthSamples;
        request.base = frameSettings(options);
        request.base.frames = kCompareFrames;
        request.base.warmupFrames = kCompareWarmupFrames;
        request.outputDir = folder;
        request.commandLine = commandLine();
        request.progress = [&](const std::string& what, double share) {
            return progress(what, start + share * (part.share - start));
        };
        const CompareResult result = compare(request, rendererOptions(options));
        start = part.share;
        lines += recordLines(result);
        if (!result.report.empty()) report = result.report;
        interrupted = result.interrupted;
        if (interrupted) break;
    }
    Progress::clearLine();
    printResult(lines);
    if (!report.empty()) printResult(report.string() + "\n");
    return interrupted ? int(ErrorCode::Interrupted) : 0;
}

}  // namespace

Command demoCommand() {
    return {"demo",
            "A gallery of techniques against the truth on built-in scenes, and its report",
            {"", "-o gallery --size 320x180"},
            [](Options& options) {
                options.add("-o,--output",
                            "DIR: results.sqlite, records.jsonl, images and report.html go here (ombrage-demo)");
                options.add("--size", "WxH: size of the pictures in pixels (640x360)");
                options.add("--seed", "N: seed of everything random (1)");
                options.add("--device", "software, or the index of an EGL device (the best, with a fallback)");
                options.add("--shader-dir", "DIR: read the shaders from here instead of the built-in ones");
            },
            runDemo};
}

}  // namespace ombrage::cli
