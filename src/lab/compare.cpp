// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>

#include <ombrage/error.h>
#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/log.h"
#include "lab/gate.h"
#include "lab/plan.h"
#include "lab/run_record.h"
#include "lab/scene_runner.h"

namespace ombrage {

namespace {

/// Turns steps into a share of the whole and stops when the caller asks for it.
class Steps {
public:
    Steps(const Report& report, std::size_t count) : m_report(report), m_count(count) {}

    /// An empty text keeps the last one: a sign of life inside a step. Called from any thread.
    bool tell(const std::string& what) {
        const std::lock_guard lock(m_mutex);
        if (!what.empty()) m_what = what;
        return !m_report || m_report(m_what, m_count == 0 ? 1.0 : double(m_done) / double(m_count));
    }
    void finish() { ++m_done; }

private:
    const Report& m_report;
    std::size_t m_count, m_done = 0;
    std::string m_what;
    std::mutex m_mutex;
};

/// A gate on a technique that is not run would never speak.
void checkGate(const Gate& gate, const std::vector<ScenePlan>& plans) {
    if (gate.technique.empty()) return;
    for (const ScenePlan& plan : plans)
        for (const PlannedRun& run : plan.runs)
            if (gate.technique == toString(run.pipeline) || gate.technique == techniqueText(run.pipeline)) return;
    throw Error(ErrorCode::Usage, "the gate '" + gate.text + "' is about a technique that is not compared",
                "ask for it with --technique " + gate.technique);
}

void makeFolder(const std::filesystem::path& folder) {
    if (folder.empty()) throw Error(ErrorCode::Usage, "no folder for the results", "name one with -o DIR");
    std::error_code error;
    std::filesystem::create_directories(folder / "images", error);
    if (error)
        throw Error(ErrorCode::Environment, "cannot make the folder '" + folder.string() + "': " + error.message(),
                    "choose another with -o DIR");
}

}  // namespace

std::string CompareResult::json() const {
    nlohmann::ordered_json json;
    json["schema"] = "ombrage/records/1";
    json["records"] = nlohmann::ordered_json::array();
    for (const std::string& record : records) json["records"].push_back(nlohmann::ordered_json::parse(record));
    json["skipped"] = nlohmann::ordered_json::array();
    for (const SkippedPair& pair : skipped)
        json["skipped"].push_back({{"scene", pair.scene}, {"technique", pair.technique}, {"reason", pair.reason}});
    json["failed_gates"] = failedGates;
    json["report"] = report.string();
    return json.dump(2);
}

CompareResult compare(const CompareRequest& request, const RendererOptions& options) {
    if (request.scenes.empty())
        throw Error(ErrorCode::Usage, "no scene to compare on", "name at least one; 'ombrage list scenes' shows them");
    if (request.pipelines.empty() && request.allOf.empty())
        throw Error(ErrorCode::Usage, "no technique to compare", "use --technique ID or --all FAMILY");

    // Everything that can be wrong with the request is found before the first ray.
    if (!request.truthKind.empty()) truthKindFromName(request.truthKind);
    std::vector<Scene> scenes;
    std::vector<ScenePlan> plans;
    CompareResult result;
    std::size_t stepCount = 0;
    for (const std::string& name : request.scenes) {
        scenes.push_back(loadScene(name, request.sceneOptions));
        scenes.back().cameraIndex(request.base.camera);
        plans.push_back(planScene(scenes.back(), request));
        stepCount += plans.back().runs.size();
        result.skipped.insert(result.skipped.end(), plans.back().skipped.begin(), plans.back().skipped.end());
        for (const std::string& warning : plans.back().warnings) warn(warning);
    }
    for (const Gate& gate : request.failOn) checkGate(gate, plans);
    makeFolder(request.outputDir);

    Steps steps(request.progress, stepCount);
    try {
        const auto stopIf = [](bool stop) {
            if (stop) throw Error(ErrorCode::Interrupted, "interrupted", "what was done is kept");
        };
        stopIf(!steps.tell("starting OpenGL"));
        Renderer renderer(options);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            if (plans[i].runs.empty()) continue;
            SceneRunner runner(scenes[i], request, renderer, [&](const std::string& what) { return steps.tell(what); });
            for (const PlannedRun& planned : plans[i].runs) {
                for (RunRecord& record : runner.run(planned)) {
                    for (const std::string& warning : plans[i].warnings)
                        if (warning.find(planned.pipeline.front().id) != std::string::npos)
                            record.warnings.push_back(warning);
                    result.records.push_back(record.toJson());
                    appendLine(request.outputDir / kRecordsFile, result.records.back());
                    for (const Gate& gate : request.failOn)
                        if (const auto sentence = metGate(gate, record)) result.failedGates.push_back(*sentence);
                }
                steps.finish();
            }
        }
        stopIf(!steps.tell("writing the report"));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::Interrupted) throw;
        result.interrupted = true;
    }

    RunNote note{request.commandLine, {}, result.failedGates, result.interrupted};
    for (const SkippedPair& pair : result.skipped) note.skipped.push_back({pair.scene, pair.technique, pair.reason});
    appendLine(request.outputDir / kRunsFile, note.toJson());
    if (!result.records.empty()) result.report = writeReport(request.outputDir);
    return result;
}

}  // namespace ombrage
