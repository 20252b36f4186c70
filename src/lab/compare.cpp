// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>

#include <ombrage/error.h>
#include <ombrage/metrics.h>
#include <algorithm>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "core/log.h"
#include "core/strings.h"
#include "core/whole_file.h"
#include "lab/compare_keys.h"
#include "lab/gate.h"
#include "lab/plan.h"
#include "lab/program_identity.h"
#include "lab/run_record.h"
#include "lab/scene_runner.h"
#include "lab/store.h"

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

/// A gate on a technique that is not run, or on a metric that is not measured, would never speak.
void checkGate(const Gate& gate, const CompareRequest& request, const std::vector<ScenePlan>& plans) {
    for (const MetricInfo& info : metricInfos())
        if (info.key == gate.metric && info.ofMotion && request.motions.empty())
            throw Error(ErrorCode::Usage, "the gate '" + gate.text + "' is about motion, and nothing moves",
                        "choose a script with --motion; 'ombrage list motions' shows them");
    if (gate.technique.empty()) return;
    for (const ScenePlan& plan : plans)
        for (const PlannedRun& run : plan.runs)
            if (gate.technique == toString(run.pipeline) || gate.technique == techniqueText(run.pipeline)) return;
    throw Error(ErrorCode::Usage, "the gate '" + gate.text + "' is about a technique that is not compared",
                "ask for it with --technique " + gate.technique);
}

/// Keeps records.jsonl near the store while the work goes on, for those who watch it. One export writes all records, so
/// it may take a twentieth of the time.
class Exports {
public:
    explicit Exports(const ResultStore& store) : m_store(store) {}

    void writeWhenDue() {
        if (Clock::now() >= m_next) write();
    }
    void write() {
        const auto start = Clock::now();
        m_store.exportLines();
        const auto end = Clock::now();
        m_next = end + std::max<Clock::duration>(std::chrono::seconds(1), 20 * (end - start));
    }
    /// What stopped the work may stop this too; the first reason is the one to tell.
    void tryWrite() {
        try {
            write();
        } catch (const Error&) {
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    const ResultStore& m_store;
    Clock::time_point m_next{};
};

/// Tells calls apart that one command line makes.
std::string nameOfCall(const CompareRequest& request) {
    ResultKey name("call");
    name.add("command", join(request.commandLine, "\n")).add("scenes", join(request.scenes, "\n"));
    for (const auto& [family, pipeline] : request.pipelines) name.add(familyName(family), toString(pipeline));
    for (const Family family : request.allOf) name.add("all " + std::string(familyName(family)), "");
    return name.text();
}

/// What a command says of a scene beside camera, light and size.
std::vector<std::string> wordsOf(const std::string& scene, const CompareRequest& request,
                                 const std::string& shaderDir) {
    std::vector<std::string> words{scene};
    const SceneOptions& options = request.sceneOptions;
    const auto addPoint = [&](const char* option, const std::optional<glm::dvec3>& point) {
        if (point)
            words.insert(words.end(), {option, formatNumber(point->x) + "," + formatNumber(point->y) + "," +
                                                   formatNumber(point->z)});
    };
    if (options.ground) words.emplace_back("--ground");
    addPoint("--eye", options.eye);
    addPoint("--target", options.target);
    if (options.allowOutside) words.emplace_back("--allow-outside");
    if (request.base.time_s != 0) words.insert(words.end(), {"--time", formatNumber(request.base.time_s)});
    if (request.base.normals != RenderSettings{}.normals)
        words.insert(words.end(), {"--normals", normalSourceName(request.base.normals)});
    if (!shaderDir.empty()) words.insert(words.end(), {"--shader-dir", shaderDir});
    return words;
}

/// The records of one run in the order of its truths: from the store, and what it lacks from the runner.
class StoredRuns {
public:
    /// @param asked  the words of a command that name the scene
    StoredRuns(ResultStore& store, const CompareKeys& keys, const CompareRequest& request,
               const std::vector<std::string>& warnings, std::vector<std::string> asked)
        : m_store(store), m_keys(keys), m_request(request), m_warnings(warnings), m_asked(std::move(asked)) {}

    /// @param measure  runs what is missing
    template <typename Measure>
    std::vector<std::string> run(const PlannedRun& planned, std::size_t& reused, Measure measure) {
        std::vector<std::optional<TruthKind>> kinds(planned.truths.begin(), planned.truths.end());
        if (kinds.empty()) kinds.emplace_back();
        std::vector<std::string> records(kinds.size());
        std::vector<std::size_t> missing;
        PlannedRun rest = planned;
        rest.truths.clear();
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const auto found = m_request.again ? std::nullopt : m_store.find(m_keys.record(planned, kinds[i]));
            if (found) {
                records[i] = *found;
                ++reused;
                continue;
            }
            missing.push_back(i);
            if (kinds[i]) rest.truths.push_back(*kinds[i]);
        }
        if (missing.empty()) return records;
        std::vector<RunRecord> measured = measure(rest);
        for (std::size_t i = 0; i < missing.size(); ++i) {
            put(m_keys.record(planned, kinds[missing[i]]), planned, measured[i]);
            records[missing[i]] = measured[i].toJson();
        }
        return records;
    }

private:
    void put(const ResultKey& key, const PlannedRun& planned, RunRecord& record) {
        for (const std::string& warning : m_warnings)
            if (warning.find(planned.pipeline.front().id) != std::string::npos) record.warnings.push_back(warning);
        record.asked = m_asked;
        std::vector<std::string> pictures;
        for (const auto& [kind, path] : record.images) pictures.push_back(path);
        m_store.put(key, record.toJson(), pictures);
    }

    ResultStore& m_store;
    const CompareKeys& m_keys;
    const CompareRequest& m_request;
    const std::vector<std::string>& m_warnings;
    std::vector<std::string> m_asked;
};

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
    json["reused"] = reused;
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
    const std::vector<std::string> names = eachOnce(request.scenes);
    for (const std::string& name : names) {
        scenes.push_back(loadScene(name, request.sceneOptions));
        scenes.back().cameraIndex(request.base.camera);
        plans.push_back(planScene(scenes.back(), request));
        stepCount += plans.back().runs.size();
        result.skipped.insert(result.skipped.end(), plans.back().skipped.begin(), plans.back().skipped.end());
        for (const std::string& warning : plans.back().warnings) warn(warning);
    }
    for (const Gate& gate : request.failOn) checkGate(gate, request, plans);
    if (request.outputDir.empty()) throw Error(ErrorCode::Usage, "no folder for the results", "name one with -o DIR");
    makeResultFolder(request.outputDir / "images");
    removeUnfinished(request.outputDir / "images");
    ResultStore store(request.outputDir);
    // Whoever is killed has been interrupted: that is what the folder says until the end.
    RunNote note{request.commandLine, {}, {}, true};
    for (const SkippedPair& pair : result.skipped) note.skipped.push_back({pair.scene, pair.technique, pair.reason});
    store.note(nameOfCall(request), note.toJson());
    Exports exports(store);

    Steps steps(request.progress, stepCount);
    try {
        const auto stopIf = [](bool stop) {
            if (stop) throw Error(ErrorCode::Interrupted, "interrupted", "what was done is kept");
        };
        stopIf(!steps.tell("starting OpenGL"));
        Renderer renderer(options);
        const std::string program = programIdentity(options.shaderDir);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            if (plans[i].runs.empty()) continue;
            const CompareKeys keys(scenes[i], request, renderer.device(), program);
            StoredRuns stored(store, keys, request, plans[i].warnings, wordsOf(names[i], request, options.shaderDir));
            std::optional<SceneRunner> runner;
            for (const PlannedRun& planned : plans[i].runs) {
                const std::vector<std::string> records =
                    stored.run(planned, result.reused, [&](const PlannedRun& missing) {
                        if (!runner)
                            runner.emplace(scenes[i], request, keys, renderer,
                                           [&](const std::string& what) { return steps.tell(what); });
                        return runner->run(missing);
                    });
                for (const std::string& text : records) {
                    result.records.push_back(text);
                    const RunRecord record = RunRecord::fromJson(text, ResultStore::fileIn(request.outputDir));
                    for (const Gate& gate : request.failOn)
                        if (const auto sentence = metGate(gate, record)) result.failedGates.push_back(*sentence);
                }
                exports.writeWhenDue();
                steps.finish();
            }
        }
        stopIf(!steps.tell("writing the report"));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::Interrupted) {
            exports.tryWrite();
            throw;
        }
        result.interrupted = true;
    }

    note.failedGates = result.failedGates;
    note.interrupted = result.interrupted;
    store.note(nameOfCall(request), note.toJson());
    exports.write();
    if (!result.records.empty()) result.report = writeReport(request.outputDir);
    return result;
}

void clearResults(const std::filesystem::path& folder) {
    std::error_code failed;
    if (std::filesystem::exists(ResultStore::fileIn(folder), failed)) {
        ResultStore store(folder);
        store.clear();
        store.exportLines();
        return;
    }
    for (const char* file : {kRecordsFile, kRunsFile}) std::filesystem::remove(folder / file, failed);
}

}  // namespace ombrage
