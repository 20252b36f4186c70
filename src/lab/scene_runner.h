// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <ombrage/compare.h>
#include <ombrage/reference.h>

#include "lab/compare_keys.h"
#include "lab/domain.h"
#include "lab/motion_stage.h"
#include "lab/plan.h"
#include "lab/run_record.h"

namespace ombrage {

/// Runs the plan of one scene: traces the truth, renders, measures, and writes pictures under DIR/images. The truth of
/// one light is kept until another light is asked for, so runs should come ordered by light.
class SceneRunner {
public:
    /// @param keys   of this scene and request; they name the pictures
    /// @param tell   called with what is being done (an empty text is a sign of life); false stops with
    /// Error(Interrupted)
    SceneRunner(const Scene& scene, const CompareRequest& request, const CompareKeys& keys, Renderer& renderer,
                std::function<bool(const std::string&)> tell);

    /// For searches: no pictures are written, and of the metrics that need further renders or pictures (noise, flip) none is
    /// measured but this one.
    void measureOnly(const std::string& metric) { m_only = metric; }

    /// One render, and a record for each truth that it is held against.
    /// @throws whatever scene, renderer and files throw; nothing is written for a run that threw, pictures apart.
    std::vector<RunRecord> run(const PlannedRun& planned);

private:
    /// The truth of one light and the picture that the renderer composes with it.
    struct ShadowCase {
        int light = -1;
        TruthKind kind = TruthKind::Shadow;
        ShadowTruth truth;
        Image picture;  ///< as displayed
        std::string truthPath, picturePath;
        std::optional<ShadowFeatures> features;  ///< none against means over pixels
    };
    struct AoCase {
        TruthKind kind = TruthKind::T1;
        std::string pipeline;  ///< of TruthKind::Own: what claims it
        AoTruth truth;
        std::optional<Receivers> receivers;  ///< where they are not the scene's
        std::string truthPath;
    };
    /// What one record is made of.
    struct Measured {
        const PlannedRun& planned;
        const RenderSettings& settings;
        const RenderResult& result;
        TruthKind kind;
        std::string name;  ///< of its files
    };

    ShadowCase& shadowCase(int light, TruthKind kind);
    AoCase& aoCase(TruthKind kind, const Pipeline& pipeline);
    void measureShadowRun(const Measured& run, RunRecord& record);
    void measureAoRun(const Measured& run, RunRecord& record);
    /// Variance among seeds of the visibility that `planeOf` takes from a result; 0 where no technique uses the seed.
    std::optional<double> measureNoise(const Measured& run, const std::vector<Mask>& mask,
                                       const std::function<std::span<const float>(const RenderResult&)>& planeOf);
    void measureAaRun(const Measured& run, RunRecord& record);
    /// Plays the planned script.
    RunRecord runMotion(const PlannedRun& planned);
    /// What the settings give in a picture kAreaGrid times as wide and high, averaged over each pixel, as displayed.
    Image supersampled(RenderSettings settings);
    RunRecord describe(const PlannedRun& planned, const RenderSettings& settings, const RenderResult& result) const;
    ReferenceOptions referenceOptions() const;
    const Receivers& receivers();
    void announce(const std::string& what) const;
    bool wants(const char* metric) const { return !m_only || *m_only == metric; }
    RenderSettings settingsFor(int light) const;
    /// What a person looks for in a picture's name: scene, camera, light and size.
    std::string stem(int light) const;
    /// The key's hash at the end keeps apart what differs in anything else.
    std::string fileName(const PlannedRun& planned, std::optional<TruthKind> kind) const;
    std::string truthName(int light, TruthKind kind, const std::string& claimed) const;
    /// Writes DIR/images/NAME-KIND.png, in one step, and returns the path relative to DIR.
    std::string save(const std::string& name, const std::string& kind, const Image& image) const;

    const Scene& m_scene;  ///< as loaded: the renderer animates it by itself
    Scene m_moved;         ///< at the chosen time, for the truth
    const CompareRequest& m_request;
    const CompareKeys& m_keys;
    Renderer& m_renderer;
    std::function<bool(const std::string&)> m_tell;
    std::optional<std::string> m_only;
    int m_camera = 0;
    std::unique_ptr<Reference> m_reference;
    SceneTraits m_traits;
    std::optional<Receivers> m_receivers;
    std::optional<ShadowCase> m_shadow;
    std::vector<AoCase> m_ao;
    std::unique_ptr<MotionStage> m_stage;
};

}  // namespace ombrage
