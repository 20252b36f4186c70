// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ombrage/reference.h>
#include <ombrage/renderer.h>
#include <nlohmann/json.hpp>

#include "lab/domain.h"

namespace ombrage::test {

/// A technique's NAME.tests.json, checked for unknown keys.
nlohmann::json technicalSheet(const TechniqueInfo& info);

/// One scene with its truth, kept for the whole test program.
class Bench {
public:
    explicit Bench(const std::string& sceneName);

    const Scene& scene() const { return m_scene; }
    /// @param truth "shadow" or "self"
    const ShadowTruth& shadow(const std::string& camera, const std::string& light, int samples,
                              const std::string& truth = "shadow");
    const ShadowFeatures& features(const std::string& camera, const std::string& light,
                                   const std::string& truth = "shadow");
    const SceneTraits& traits() const { return m_traits; }
    /// @param truth "T1" to "T5" or "own"; @param pipeline whose integral "own" is
    const AoTruth& ao(const std::string& camera, int samples, const std::string& truth = "T1",
                      const Pipeline& pipeline = {});
    const Receivers& receivers(const std::string& camera);
    /// Per pixel, whether the range covers what the camera sees.
    std::vector<bool> covered(const ShadowRange& range, const std::string& camera);

    static Bench& of(const std::string& sceneName);
    /// Whether it is that of a bench.
    static bool holds(const Scene& scene);

private:
    Scene m_scene;
    Reference m_reference;
    SceneTraits m_traits;
    std::map<std::string, Receivers> m_receivers;
    std::map<std::string, ShadowTruth> m_shadow;
    std::map<std::string, ShadowFeatures> m_features;
    std::map<std::string, AoTruth> m_ao;
};

/// The one renderer of the program, with a debug context, set to the scene.
RenderResult renderScene(const Scene& scene, const RenderSettings& settings);

/// The measured image of a family: visibility of the light asked for, or ambient visibility.
std::vector<float> measuredPlane(const RenderResult& result, Family family);

inline constexpr int kWidth = 640, kHeight = 360;

}  // namespace ombrage::test
