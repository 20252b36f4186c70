// SPDX-License-Identifier: MIT
#include "technique_case.h"

#include <fstream>
#include <set>

#include <ombrage/error.h>

namespace ombrage::test {

namespace {

void refuseUnknownKeys(const nlohmann::json& object, const std::set<std::string>& known, const std::string& where) {
    for (const auto& [key, value] : object.items())
        if (known.count(key) == 0) throw Error(ErrorCode::Input, "unknown key '" + key + "'", "", where);
}

ReferenceOptions optionsOf(int samples) {
    ReferenceOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.samplesPerPixel = samples;
    return options;
}

}  // namespace

nlohmann::json technicalSheet(const TechniqueInfo& info) {
    const std::string file =
        std::string(OMBRAGE_SOURCE_DIR) + "/src/techniques/" + info.id + "/" + info.name + ".tests.json";
    std::ifstream input(file);
    if (!input) throw Error(ErrorCode::Input, "every technique has a tests.json", "", file);
    const nlohmann::json sheet = nlohmann::json::parse(input);
    refuseUnknownKeys(sheet, {"budgets", "metamorphic", "costOnly", "live", "pipeline", "invariance"}, file);
    for (const auto& budget : sheet.value("budgets", nlohmann::json::array()))
        refuseUnknownKeys(budget,
                          {"scene", "camera", "light", "normals", "pipeline", "params", "truth", "spp", "metric", "max",
                           "min", "reason"},
                          file);
    for (const auto& fact : sheet.value("metamorphic", nlohmann::json::array()))
        refuseUnknownKeys(fact, {"name", "scene", "camera", "pipeline", "params", "expect"}, file);
    return sheet;
}

Bench::Bench(const std::string& sceneName)
    : m_scene(loadScene(sceneName)), m_reference(m_scene), m_traits(sceneTraits(m_scene)) {}

namespace {
std::map<std::string, std::unique_ptr<Bench>>& benches() {
    static std::map<std::string, std::unique_ptr<Bench>> all;
    return all;
}
}  // namespace

bool Bench::holds(const Scene& scene) {
    return std::any_of(benches().begin(), benches().end(),
                       [&](const auto& bench) { return &bench.second->scene() == &scene; });
}

Bench& Bench::of(const std::string& sceneName) {
    auto& bench = benches()[sceneName];
    if (!bench) bench = std::make_unique<Bench>(sceneName);
    return *bench;
}

const Receivers& Bench::receivers(const std::string& camera) {
    const auto known = m_receivers.find(camera);
    if (known != m_receivers.end()) return known->second;
    const Camera& eye = m_scene.cameras[std::size_t(m_scene.cameraIndex(camera))];
    return m_receivers.emplace(camera, m_reference.receivers(eye, optionsOf(0))).first->second;
}

const ShadowTruth& Bench::shadow(const std::string& camera, const std::string& light, int samples,
                                 const std::string& truth) {
    ReferenceOptions options = optionsOf(samples);
    options.kind = truthKindFromName(truth, Quantity::Shadow);
    const std::string key = camera + "|" + light + "|" + std::to_string(samples) + "|" + truth;
    const auto known = m_shadow.find(key);
    if (known != m_shadow.end()) return known->second;
    const Camera& eye = m_scene.cameras[std::size_t(m_scene.cameraIndex(camera))];
    return m_shadow.emplace(key, m_reference.shadow(receivers(camera), eye, m_scene.lightIndex(light), options))
        .first->second;
}

const ShadowFeatures& Bench::features(const std::string& camera, const std::string& light, const std::string& truth) {
    const std::string key = camera + "|" + light + "|" + truth;
    const auto known = m_features.find(key);
    if (known != m_features.end()) return known->second;
    ReferenceOptions options = optionsOf(0);
    options.kind = truthKindFromName(truth, Quantity::Shadow);
    return m_features.emplace(key, m_reference.shadowFeatures(receivers(camera), m_scene.lightIndex(light), options))
        .first->second;
}

std::vector<bool> Bench::covered(const ShadowRange& range, const std::string& camera) {
    return inRange(range, m_reference.positions(receivers(camera)),
                   m_scene.cameras[std::size_t(m_scene.cameraIndex(camera))]);
}

const AoTruth& Bench::ao(const std::string& camera, int samples, const std::string& truth, const Pipeline& pipeline) {
    ReferenceOptions options = optionsOf(samples);
    options.kind = truthKindFromName(truth, Quantity::Ao);
    const bool isOwn = options.kind == TruthKind::Own;
    const std::string claimed = isOwn ? toString({pipeline.front()}) : "";
    const std::string key = camera + "|" + std::to_string(samples) + "|" + truth + "|" + claimed;
    const auto known = m_ao.find(key);
    if (known != m_ao.end()) return known->second;
    const Camera& eye = m_scene.cameras[std::size_t(m_scene.cameraIndex(camera))];
    const std::unique_ptr<AoIntegrand> integrand = isOwn ? ownIntegrand(pipeline) : nullptr;
    options.integrand = integrand.get();
    return m_ao.emplace(key, m_reference.ao(receivers(camera), eye, options)).first->second;
}

RenderResult renderScene(const Scene& scene, const RenderSettings& settings) {
    static Renderer renderer([] {
        RendererOptions options;
        options.debugContext = true;
        return options;
    }());
    // Scenes of benches stay as they are; another one may have changed, or have the address of one that is gone.
    static const Scene* current = nullptr;
    if (current != &scene || !Bench::holds(scene)) renderer.setScene(scene);
    current = &scene;
    return renderer.render(settings);
}

std::vector<float> measuredPlane(const RenderResult& result, Family family) {
    if (family == Family::Shadow) {
        const auto plane = result.visibility.begin()->second.plane(0);
        return {plane.begin(), plane.end()};
    }
    if (family == Family::Ao || family == Family::Filter) {
        const auto plane = result.ao->plane(0);
        return {plane.begin(), plane.end()};
    }
    std::vector<float> all;
    for (int p = 0; p < result.picture.planeCount(); ++p)
        all.insert(all.end(), result.picture.plane(p).begin(), result.picture.plane(p).end());
    return all;
}

}  // namespace ombrage::test
