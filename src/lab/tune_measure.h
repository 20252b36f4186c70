// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <ombrage/tune.h>

#include "lab/scene_runner.h"
#include "lab/store.h"

namespace ombrage::tuning {

/// Measures pipelines on the request's scenes and cameras, each once: what the folder's store holds is taken from
/// there. A scene goes to its renderer, and its truth is traced, when the first pipeline needs them.
class Measurer {
public:
    /// Loads the scenes and divides their cameras. @throws Error(Usage) for whatever does not fit the request.
    /// @param tell called with what is being done; false stops with Error(Interrupted)
    Measurer(const TuneRequest& request, const RendererOptions& options, std::function<bool(const std::string&)> tell);

    const std::vector<TuneCase>& cases() const { return m_told; }
    const DeviceInfo& device() const { return m_device; }
    std::size_t measured() const { return m_measured; }
    std::size_t reused() const { return m_reused; }
    const ResultStore& store() const { return *m_store; }

    /// @param heldOut on the held-out cameras, else on the others
    /// @param timed   whether to time it too. Frames of the pipeline and of the start are drawn by turns: the time is
    /// the
    ///                ratio of the two times what the start took when it was timed first, so that a machine that is
    ///                now slower or faster changes nothing.
    TuneFigures measure(const Pipeline& pipeline, bool heldOut, bool timed);

private:
    struct SceneUnit {
        Scene scene;
        double weight = 1;
        std::unique_ptr<Renderer> renderer;
    };
    /// A scene, a camera and a light.
    struct CaseUnit {
        SceneUnit* scene = nullptr;
        CompareRequest request;
        PlannedRun planned;
        bool isHeldOut = false;
        std::unique_ptr<CompareKeys> keys;
        std::unique_ptr<SceneRunner> runner;
    };
    /// Of one pipeline on one case.
    struct Times {
        double ratio = 1;  ///< to the start
        double time_ms = 0;
    };

    void addCases(SceneUnit& scene);
    Renderer& rendererOf(CaseUnit& unit);
    /// Of the store: with `again` only what this search has put there.
    std::optional<std::string> find(const ResultKey& key) const;
    void put(const ResultKey& key, const std::string& record);
    RunRecord recordOf(CaseUnit& unit, const Pipeline& pipeline);
    Times timesOf(CaseUnit& unit, const Pipeline& pipeline);
    RenderSettings settingsOf(const CaseUnit& unit, const Pipeline& pipeline) const;
    void say(const std::string& what) const;

    const TuneRequest& m_request;
    const RendererOptions& m_options;
    std::function<bool(const std::string&)> m_tell;
    std::list<SceneUnit> m_scenes;
    std::list<CaseUnit> m_cases;
    std::vector<TuneCase> m_told;
    DeviceInfo m_device;
    std::string m_program;
    std::optional<ResultStore> m_store;
    std::set<std::string> m_fresh;
    std::size_t m_measured = 0, m_reused = 0;
};

/// The metric's value as an error: less is better; of a signed one the size.
double errorOf(const MetricInfo& metric, double value);
/// @throws Error(Usage) with a suggestion.
const MetricInfo& metricOf(const std::string& key);

}  // namespace ombrage::tuning
