// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/compare.h>
#include <ombrage/error.h>

#include "commands.h"
#include "compare_output.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

int runCompare(const Options& options) {
    CompareRequest request;
    request.scenes = options.texts("scene");
    if (request.scenes.empty())
        throw Error(ErrorCode::Usage, "no scene to compare on", "'ombrage list scenes' shows the built-in ones");
    for (const std::string& text : options.texts("technique")) request.pipelines.push_back(parseTechnique(text));
    for (const std::string& family : options.texts("all")) request.allOf.push_back(familyFromName(family));
    if (request.pipelines.empty() && request.allOf.empty())
        throw Error(ErrorCode::Usage, "no technique to compare",
                    "use --technique " + exampleId(Family::Shadow) + " or --all shadow");
    for (const std::string& gate : options.texts("fail-on")) request.failOn.push_back(parseGate(gate));
    for (const std::string& list : options.texts("motion"))
        for (Motion& motion : parseMotions(list)) request.motions.push_back(std::move(motion));
    request.outputDir = requiredText(options, "output", "folder for the results (-o DIR)");
    request.sceneOptions = sceneOptions(options);
    request.base = frameSettings(options);
    request.base.normals = normalSource(options);
    request.base.frames = kCompareFrames;
    request.base.warmupFrames = kCompareWarmupFrames;
    request.truthSamples = int(options.integer("spp", 0, 0, 1 << 20));
    request.truthKind = options.text("truth");
    request.again = options.flag("again");
    request.commandLine = commandLine();
    Progress progress;
    request.progress = [&](const std::string& what, double share) { return progress(what, share); };
    const CompareResult result = compare(request, rendererOptions(options));
    Progress::clearLine();

    for (const SkippedPair& pair : result.skipped)
        printMessage("skipped: " + pair.scene + ", " + pair.technique + ": " + pair.reason);
    for (const std::string& gate : result.failedGates) printMessage("failed: " + gate);
    if (result.reused > 0)
        printMessage(fmt::format("{} of {} records were in the folder already (--again measures them anew)",
                                 result.reused, result.records.size()));
    if (options.flag("json"))
        printResult(result.json() + "\n");
    else
        printResult(recordLines(result) + (result.report.empty() ? "" : result.report.string() + "\n"));
    if (result.interrupted) {
        printMessage(fmt::format("interrupted after {} record(s), which are kept", result.records.size()));
        return int(ErrorCode::Interrupted);
    }
    return result.failedGates.empty() ? 0 : int(ErrorCode::GateFailed);
}

}  // namespace

Command compareCommand() {
    const std::string shadow = exampleId(Family::Shadow), ao = exampleId(Family::Ao),
                      filter = exampleId(Family::Filter);
    return {"compare",
            "Holds techniques against the ray-traced truth: records, pictures and a report",
            {"gap sphere --all shadow -o out",
             "gap --technique " + shadow + " --fail-on \"" + shadow + ".wrong>0.01\" -o out --json",
             "gap --technique " + shadow + " --motion camera-walk,light-jump -o out",
             "cornell --technique " + ao + " --technique " + ao + "+" + filter + " -o out"},
            [](Options& options) {
                options.add("scene", "built-in scenes, scene files (.json) or model files", Take::Many);
                options.add("--technique", "ID[:key=value,...] or A+B; may be repeated", Take::Many);
                options.add("--all", "FAMILY: every technique of it that supports the light; may be repeated",
                            Take::Many);
                options.add("-o,--output", "DIR: results.sqlite, records.jsonl, images and report.html go here");
                options.add("--again", "measure also what DIR holds already, and replace it", Take::Flag);
                options.add("--spp",
                            "N: samples per pixel of the truth (1 for hard lights, 1024 for soft ones, 256 for ao)");
                options.add(
                    "--truth",
                    "shadow, self or area for shadows; T1 to T5, T5-ball, own, displaced or area for ao (T1 and own "
                    "by default); area for aa");
                options.add("--motion",
                            "NAME[:CASTER][,NAME...]: measures flicker and lag under these scripts too ('ombrage list "
                            "motions'); may be repeated",
                            Take::Many);
                options.add("--fail-on", "\"[ID.]METRIC>NUMBER\" (or >=, <, <=): exit 1 when it holds; may be repeated",
                            Take::Many);
                addNormalsOption(options);
                addSceneOptions(options);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runCompare};
}

}  // namespace ombrage::cli
