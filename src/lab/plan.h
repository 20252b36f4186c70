// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ombrage/compare.h>
#include <ombrage/truth_kind.h>

namespace ombrage {

/// One render to measure: a pipeline in its family's place and, for shadows, one light.
struct PlannedRun {
    Family family = Family::Shadow;
    Pipeline pipeline;
    int light = -1;                      ///< index into Scene::lights; -1 for families that take all lights at once
    std::vector<TruthKind> truths = {};  ///< one record for each; none: one record without truth
    std::optional<Motion> motion = {};   ///< plays a script in the place of one picture; has one truth
};

/// The runs of one scene and what was left out of them.
struct ScenePlan {
    std::vector<PlannedRun> runs;  ///< shadows ordered by light
    std::vector<SkippedPair> skipped;
    std::vector<std::string> warnings;  ///< techniques that the scene is not meant for
};

/// Every technique of the family as a pipeline with its defaults, in the order of the registry. A filter follows the
/// family of occlusion's first technique that is not its baseline.
std::vector<std::pair<Family, Pipeline>> pipelinesOf(Family family);

/// The truths that the request holds a pipeline against: the kind asked for, or the family's first and, where the
/// pipeline claims an integral, `own`. `reason` says why there is none where the kind does not fit.
std::vector<TruthKind> truthsOf(const CompareRequest& request, Family family, const Pipeline& pipeline,
                                std::string& reason);

/// Why a pipeline cannot be measured under a script, or "": only shadows and ambient occlusion have an error at surface
/// points, occlusion does not see lights, and means over pixels and claims are no truth of points.
std::string motionMisfit(const Motion& motion, Family family, TruthKind kind);

/// @throws Error(Usage) when a pipeline asked for by name does not support a chosen light or the truth asked for.
ScenePlan planScene(const Scene& scene, const CompareRequest& request);

/// Where a pipeline of the family goes; filters go where occlusion does.
Pipeline& placeOf(Family family, RenderSettings& settings);

/// Indices of the light of that name, or of all lights for "".
std::vector<int> chosenLights(const Scene& scene, const std::string& name);

/// Ids of the pipeline joined by '+', without parameters.
std::string techniqueText(const Pipeline& pipeline);

/// The texts in their order: what is named twice is one thing.
std::vector<std::string> eachOnce(const std::vector<std::string>& texts);

}  // namespace ombrage
