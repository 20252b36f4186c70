// SPDX-License-Identifier: MIT
#include "lab/tune_export.h"

#include <ombrage/error.h>
#include <ombrage/tune.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/strings.h"
#include "lab/plan.h"

namespace ombrage {

namespace tuning {

namespace {

using Json = nlohmann::ordered_json;
using Params = std::vector<std::pair<std::string, ParamValue>>;

/// The parameters that engines have something for, of a shadow technique with a map.
struct MapValues {
    std::optional<double> resolution, constantBias_texels, slopeBias_texels, normalOffset_texels;
    std::string mode;  ///< of the parameter "bias", ""
};

std::optional<double> numberOf(const Params& params, const std::string& key) {
    for (const auto& [name, value] : params)
        if (name == key) {
            if (const auto* whole = std::get_if<std::int64_t>(&value)) return double(*whole);
            if (const auto* real = std::get_if<double>(&value)) return *real;
        }
    return {};
}

MapValues mapValues(const Params& params) {
    MapValues values{numberOf(params, "resolution"), numberOf(params, "constant-bias"), {}, {}, ""};
    for (const auto& [key, value] : params)
        if (key == "bias")
            if (const auto* mode = std::get_if<std::string>(&value)) values.mode = *mode;
    // The others say nothing outside of their mode.
    if (values.mode.empty() || values.mode == "slope") values.slopeBias_texels = numberOf(params, "slope-bias");
    if (values.mode.empty() || values.mode == "normal-offset")
        values.normalOffset_texels = numberOf(params, "normal-offset");
    return values;
}

Json exact(Json value) {
    return {{"value", std::move(value)}, {"exact", true}};
}
Json near(Json value, const std::string& note) {
    return {{"value", std::move(value)}, {"exact", false}, {"note", note}};
}

constexpr const char* kGrowingTexel =
    "this light's texels grow with the distance and the engine's bias does not: no one value stands for it";

Json powerOfTwo(double resolution, const std::string& who) {
    const double power = std::exp2(std::round(std::log2(resolution)));
    if (power == resolution) return exact(std::int64_t(resolution));
    return near(std::int64_t(power), who + " takes powers of two only; the nearest to " +
                                         std::to_string(std::int64_t(resolution)) + " stands here, untuned");
}

/// https://threejs.org/docs/pages/LightShadow.html: bias is added to the depth in [0,1], normalBias is in world units.
Json threeShadow(const MapValues& values, const LightScale& light) {
    Json json;
    if (values.resolution)
        json["shadow.mapSize"] =
            exact(Json::array({std::int64_t(*values.resolution), std::int64_t(*values.resolution)}));
    if (light.width_m)
        json["shadow.camera"] = exact({{"left", -*light.width_m / 2},
                                       {"right", *light.width_m / 2},
                                       {"top", *light.height_m / 2},
                                       {"bottom", -*light.height_m / 2},
                                       {"near", 0},
                                       {"far", *light.depth_m}});
    if (values.constantBias_texels)
        json["shadow.bias"] = light.texel_m && light.depth_m
                                  ? exact(-*values.constantBias_texels * *light.texel_m / *light.depth_m)
                                  : near(nullptr, kGrowingTexel);
    if (values.normalOffset_texels)
        json["shadow.normalBias"] =
            light.texel_m ? near(*values.normalOffset_texels * *light.texel_m,
                                 "the engine does not take it times the sine of the light's angle to the normal")
                          : near(nullptr, kGrowingTexel);
    return json;
}

/// Godot 4: shadow_bias is in hundredths of the depth range, shadow_normal_bias in texels.
Json godotShadow(const MapValues& values, const LightScale& light) {
    Json json;
    if (values.resolution)
        json[light.depth_m ? "rendering/lights_and_shadows/directional_shadow/size"
                           : "rendering/lights_and_shadows/positional_shadow/atlas_size"] =
            light.depth_m ? powerOfTwo(*values.resolution, "the engine")
                          : near(std::int64_t(*values.resolution), "all lights share the atlas, each has a part of it");
    if (values.constantBias_texels)
        json["shadow_bias"] =
            light.texel_m && light.depth_m
                ? near(100 * *values.constantBias_texels * *light.texel_m / *light.depth_m,
                       "exact where the engine's own depth range is " + std::to_string(std::lround(*light.depth_m)) +
                           " m; it fits its ranges by itself")
                : near(nullptr, kGrowingTexel);
    if (values.normalOffset_texels)
        json["shadow_normal_bias"] = near(*values.normalOffset_texels,
                                          "in texels in both, but the engine scales it by 1 - cosine, not by the sine, "
                                          "and moves across the light's direction only");
    return json;
}

/// LightManager::ShadowOptions: mapSize is a power of two, constantBias in world units.
Json filamentShadow(const MapValues& values, const LightScale& light) {
    Json json;
    if (values.resolution) json["ShadowOptions.mapSize"] = powerOfTwo(*values.resolution, "Filament");
    if (values.constantBias_texels)
        json["ShadowOptions.constantBias"] =
            light.texel_m ? exact(*values.constantBias_texels * *light.texel_m) : near(nullptr, kGrowingTexel);
    if (values.normalOffset_texels)
        json["ShadowOptions.normalBias"] =
            near(*values.normalOffset_texels, "the engine scales its own largest sampling error by it");
    return json;
}

Json plainShadow(const MapValues& values, const LightScale& light) {
    Json json;
    if (values.resolution) json["map size"] = exact(std::int64_t(*values.resolution));
    if (values.constantBias_texels && light.texel_m) {
        json["bias_m"] = exact(*values.constantBias_texels * *light.texel_m);
        if (light.depth_m)
            json["bias of a linear depth in [0,1]"] =
                exact(*values.constantBias_texels * *light.texel_m / *light.depth_m);
    }
    if (values.slopeBias_texels)
        json["glPolygonOffset factor"] =
            near(*values.slopeBias_texels,
                 "it follows the steeper of the map's two axes, up to 29 % less than the slope itself");
    if (values.constantBias_texels)
        json["glPolygonOffset units"] = near(
            nullptr, "its unit is the least step of the depth buffer: of a 32 bit float one it varies with the depth");
    if (values.normalOffset_texels && light.texel_m)
        json["normal offset_m at grazing light"] = exact(*values.normalOffset_texels * *light.texel_m);
    return json;
}

/// A radius of occlusion by the engine's name. 0 is each scene's own: no one value stands for it where these differ.
Json occlusion(const std::string& engine, double radius_m, const std::map<std::string, double>& sceneRadii_m) {
    std::set<double> radii;
    std::string told;
    for (const auto& [scene, own_m] : sceneRadii_m) {
        radii.insert(own_m);
        told += (told.empty() ? "" : ", ") + scene + " " + formatNumber(own_m) + " m";
    }
    Json value;
    if (radius_m > 0 || radii.size() == 1)
        value = near(radius_m > 0 ? radius_m : *radii.begin(),
                     "the same length, but the engine estimates occlusion in another way");
    else
        value = near(nullptr, "0 stands for each scene's own: " + told);
    if (engine == "threejs") return {{"GTAOPass.radius", std::move(value)}};
    if (engine == "godot") return {{"Environment.ssao_radius", std::move(value)}};
    return {{"AmbientOcclusionOptions.radius", std::move(value)}};
}

Json jsonOf(const ParamValue& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
    if (const auto* real = std::get_if<double>(&value)) return *real;
    return toString(value);
}

}  // namespace

std::string exportText(const std::string& engine, Family family, const Pipeline& pipeline,
                       const std::vector<LightScale>& lights, const std::map<std::string, double>& sceneRadii_m) {
    const auto& engines = tuneEngines();
    if (std::find(engines.begin(), engines.end(), engine) == engines.end())
        throw unknownName("engine", engine, engines);
    Json json{{"schema", "ombrage/tune-export/1"}, {"engine", engine}, {"technique", toString(pipeline)}};
    json["lights"] = Json::array();
    json["settings"] = Json::object();
    std::set<std::string> used;
    const Params params = resolveParams(pipeline.front());
    if (family == Family::Shadow) {
        const MapValues values = mapValues(params);
        for (const LightScale& light : lights) {
            Json of = engine == "threejs"    ? threeShadow(values, light)
                      : engine == "godot"    ? godotShadow(values, light)
                      : engine == "filament" ? filamentShadow(values, light)
                                             : plainShadow(values, light);
            json["lights"].push_back({{"scene", light.scene}, {"light", light.light}, {"settings", std::move(of)}});
        }
        if (values.resolution) used.insert("resolution");
        if (values.constantBias_texels) used.insert("constant-bias");
        if (values.normalOffset_texels) used.insert("normal-offset");
        if (values.slopeBias_texels && engine == "gl") used.insert("slope-bias");
    } else if (const auto radius = numberOf(params, "radius"); radius && engine != "gl") {
        json["settings"] = occlusion(engine, *radius, sceneRadii_m);
        used.insert("radius");
    }
    // A program of one's own takes everything as it is; angles are in degrees.
    Json rest = Json::object();
    for (std::size_t i = 0; i < pipeline.size(); ++i)
        for (const auto& [key, value] : resolveParams(pipeline[i]))
            if (engine == "gl" || i > 0 || !used.count(key)) rest[pipeline[i].id + "." + key] = jsonOf(value);
    json[engine == "gl" ? "uniforms" : "without_counterpart"] = std::move(rest);
    return json.dump(2);
}

}  // namespace tuning

const std::vector<std::string>& tuneEngines() {
    static const std::vector<std::string> engines{"threejs", "godot", "filament", "gl"};
    return engines;
}

std::string exportTuned(const std::string& engine, const TuneRequest& request, const std::string& text,
                        const RendererOptions& options) {
    const Family family = request.technique.first;
    const Pipeline pipeline = parsePipeline(family, text);
    std::vector<tuning::LightScale> scales;
    if (family == Family::Shadow)
        for (const std::string& name : eachOnce(request.scenes)) {
            const Scene scene = loadScene(name, request.sceneOptions);
            Renderer renderer(options);
            renderer.setScene(scene);
            for (const int light : chosenLights(scene, request.base.light)) {
                RenderSettings settings = request.base;
                settings.light = scene.lights[std::size_t(light)].name;
                settings.shadow = pipeline;
                const RenderResult drawn = renderer.render(settings);
                tuning::LightScale scale{scene.name, settings.light, {}, {}, {}, {}};
                const auto texels = drawn.footprint.find(light);
                if (texels != drawn.footprint.end() && texels->second.texel_m > 0)
                    scale.texel_m = texels->second.texel_m;
                // An orthographic view's rows are its axes over half of its extents, and over its depth.
                const auto range = drawn.range.find(light);
                if (scale.texel_m && range != drawn.range.end() && range->second.clipFromWorld.size() == 1) {
                    const glm::dmat4 rows = glm::transpose(range->second.clipFromWorld.front());
                    scale.width_m = 2 / glm::length(glm::dvec3(rows[0]));
                    scale.height_m = 2 / glm::length(glm::dvec3(rows[1]));
                    scale.depth_m = 1 / glm::length(glm::dvec3(rows[2]));
                }
                scales.push_back(scale);
            }
        }
    std::map<std::string, double> radii_m;
    if (family == Family::Ao)
        for (const std::string& name : eachOnce(request.scenes)) {
            const Scene scene = loadScene(name, request.sceneOptions);
            // As a person writes it: 0.4 and not the nearest float's 0.4000000059604645.
            radii_m[scene.name] = std::round(double(scene.aoRadius_m) * 1e6) / 1e6;
        }
    return tuning::exportText(engine, family, pipeline, scales, radii_m);
}

}  // namespace ombrage
