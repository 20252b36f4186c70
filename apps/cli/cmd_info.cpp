// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/scene_info.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "commands.h"

namespace ombrage::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 40;
constexpr double kDegrees = 57.29577951308232;

/// The shortest number that reads back as the same float.
Json numberJson(float value) {
    return Json::parse(fmt::format("{}", value), nullptr, false);
}

Json numberJson(double value) {
    return value;
}

template <typename V>
Json vectorJson(const V& v) {
    Json json = Json::array();
    for (int i = 0; i < V::length(); ++i) json.push_back(numberJson(v[i]));
    return json;
}

/// Numbers of few digits; -0 is 0.
template <typename V>
std::string vectorText(const V& v) {
    std::string text;
    for (int i = 0; i < V::length(); ++i)
        text += fmt::format("{}{:.4g}", i > 0 ? ", " : "", v[i] == 0 ? 0.0 : double(v[i]));
    return text;
}

const char* alphaName(AlphaMode mode) {
    return mode == AlphaMode::Mask ? "mask" : (mode == AlphaMode::Blend ? "blend" : "opaque");
}

/// The maps of a material by what they are for.
std::vector<std::pair<const char*, int>> mapsOf(const Material& m) {
    std::vector<std::pair<const char*, int>> maps{{"colour", m.baseColorTexture},
                                                  {"normal", m.normalTexture},
                                                  {"height", m.heightTexture},
                                                  {"metallic-roughness", m.metallicRoughnessTexture},
                                                  {"emissive", m.emissiveTexture}};
    maps.erase(std::remove_if(maps.begin(), maps.end(), [](const auto& map) { return map.second < 0; }), maps.end());
    return maps;
}

/// What makes a light's shadows soft, in the key that a scene file has for it.
Json lightJson(const Light& light) {
    Json json{{"name", light.name}, {"type", lightTypeName(light.type)}};
    if (light.type != LightType::Sun) json["position"] = vectorJson(light.position);
    if (light.type != LightType::Point) json["direction"] = vectorJson(light.direction);
    json["color"] = vectorJson(light.color);
    json["intensity"] = numberJson(light.intensity);
    if (light.type == LightType::Sun)
        json["angle_deg"] = light.angle_rad * kDegrees;
    else if (light.type == LightType::Rect)
        json["size_m"] = vectorJson(light.size_m);
    else
        json["radius_m"] = numberJson(light.radius_m);
    if (std::isfinite(light.range_m)) json["range_m"] = numberJson(light.range_m);
    if (light.type == LightType::Spot) {
        json["inner_deg"] = light.inner_rad * kDegrees;
        json["outer_deg"] = light.outer_rad * kDegrees;
    }
    return json;
}

Json cameraJson(const Camera& camera) {
    Json json{{"name", camera.name},
              {"position", vectorJson(camera.position)},
              {"target", vectorJson(camera.target)},
              {"up", vectorJson(camera.up)}};
    if (camera.orthoHeight_m)
        json["ortho_height_m"] = numberJson(*camera.orthoHeight_m);
    else
        json["fov_deg"] = camera.fovY_rad * kDegrees;
    return json;
}

Json infoJson(const Scene& scene, const SceneInfo& info) {
    Json json{{"schema", "ombrage/info/1"},
              {"scene", scene.name},
              {"description", scene.description},
              {"content_hash", info.contentHash},
              {"triangles", info.triangles},
              {"vertices", info.vertices},
              {"ao_radius_m", numberJson(scene.aoRadius_m)},
              {"ambient", numberJson(scene.ambient)}};
    json["bounds"] = info.bounds.empty() ? Json(nullptr)
                                         : Json{{"lower", vectorJson(info.bounds.lower)},
                                                {"upper", vectorJson(info.bounds.upper)},
                                                {"size_m", vectorJson(info.bounds.upper - info.bounds.lower)}};
    json["models"] = Json::array();
    for (const Model& model : scene.models)
        json["models"].push_back(
            {{"name", model.name}, {"file", model.file}, {"casts", model.casts}, {"receives", model.receives}});
    json["meshes"] = Json::array();
    for (const MeshInfo& mesh : info.meshes)
        json["meshes"].push_back({{"name", mesh.name},
                                  {"model", mesh.model},
                                  {"material", mesh.material},
                                  {"instances", mesh.instances},
                                  {"triangles", mesh.triangles},
                                  {"vertices", mesh.vertices},
                                  {"shape", meshShapeName(mesh.shape)},
                                  {"bounds_volume", mesh.boundsVolume()},
                                  {"edges", mesh.edges},
                                  {"open_edges", mesh.openEdges},
                                  {"non_manifold_edges", mesh.nonManifoldEdges},
                                  {"vertex_colors", mesh.hasColors}});
    json["materials"] = Json::array();
    for (const Material& material : scene.materials) {
        Json maps = Json::object();
        for (const auto& [kind, texture] : mapsOf(material)) maps[kind] = scene.textures[std::size_t(texture)].name;
        json["materials"].push_back({{"name", material.name},
                                     {"base_color", vectorJson(material.baseColor)},
                                     {"alpha", alphaName(material.alphaMode)},
                                     {"maps", maps}});
    }
    json["textures"] = Json::array();
    for (const Texture& texture : scene.textures)
        json["textures"].push_back(
            {{"name", texture.name}, {"size", {texture.width, texture.height}}, {"color", texture.srgb}});
    json["lights"] = Json::array();
    for (const Light& light : scene.lights) json["lights"].push_back(lightJson(light));
    json["cameras"] = Json::array();
    for (const Camera& camera : scene.cameras) json["cameras"].push_back(cameraJson(camera));
    json["animations"] = Json::array();
    for (const Animation& animation : scene.animations) {
        Json entry{{"type", animation.type}, {"period_s", animation.period_s}};
        if (!animation.light.empty()) entry["light"] = animation.light;
        json["animations"].push_back(entry);
    }
    json["techniques"] = scene.techniques;
    json["warnings"] = scene.warnings;
    return json;
}

/// Characters of a UTF-8 text.
std::size_t lengthOf(const std::string& text) {
    return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// Rows of columns under a heading; numbers stand on the right. Long tables are cut, and say so.
std::string table(const std::string& title, const std::vector<std::vector<std::string>>& rows) {
    if (rows.size() < 2) return "";
    std::vector<std::size_t> widths(rows[0].size(), 0);
    const std::size_t shown = std::min(rows.size(), kMostRows + 1);
    for (std::size_t r = 0; r < shown; ++r)
        for (std::size_t c = 0; c < rows[r].size(); ++c) widths[c] = std::max(widths[c], lengthOf(rows[r][c]));
    std::string text = fmt::format("\n{} ({})\n", title, rows.size() - 1);
    for (std::size_t r = 0; r < shown; ++r) {
        std::string line = " ";
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            const std::string& cell = rows[r][c];
            const std::string& sample = rows[1][c];
            const bool number = !sample.empty() && sample.find_first_not_of("0123456789") == std::string::npos;
            line += number ? fmt::format(" {:>{}}", cell, widths[c]) : fmt::format(" {:<{}}", cell, widths[c]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    if (shown < rows.size()) text += fmt::format("  ... and {} more (--json lists all)\n", rows.size() - shown);
    return text;
}

std::string shapeText(const MeshInfo& mesh) {
    if (mesh.shape == MeshShape::Open) return fmt::format("open, {} edges", mesh.openEdges);
    if (mesh.shape == MeshShape::NonManifold)
        return fmt::format("non-manifold, {} edges{}", mesh.nonManifoldEdges,
                           mesh.boundsVolume() ? ", bounds a volume" : fmt::format("; {} open", mesh.openEdges));
    return "closed";
}

std::string sizeText(const Light& light) {
    if (!light.hasSize()) return "hard";
    if (light.type == LightType::Sun) return fmt::format("{:.4g} deg", light.angle_rad * kDegrees);
    if (light.type == LightType::Rect) return fmt::format("{:.4g} x {:.4g} m", light.size_m.x, light.size_m.y);
    return fmt::format("radius {:.4g} m", light.radius_m);
}

std::string infoText(const Scene& scene, const SceneInfo& info) {
    std::string text = scene.name + "\n";
    if (!scene.description.empty()) text += scene.description + "\n";
    text += fmt::format("\n  triangles  {}\n  vertices   {}\n", info.triangles, info.vertices);
    if (!info.bounds.empty())
        text += fmt::format("  bounds     ({}) to ({})\n  size       {} m\n", vectorText(info.bounds.lower),
                            vectorText(info.bounds.upper), vectorText(info.bounds.upper - info.bounds.lower));
    text += fmt::format("  ao radius  {:.4g} m\n  ambient    {:.4g}\n  content    {}\n", scene.aoRadius_m,
                        scene.ambient, info.contentHash);

    std::vector<std::vector<std::string>> meshes{
        {"name", "model", "material", "uses", "triangles", "vertices", "surface"}};
    for (const MeshInfo& m : info.meshes)
        meshes.push_back({m.name, m.model, m.material, std::to_string(m.instances), std::to_string(m.triangles),
                          std::to_string(m.vertices), shapeText(m)});
    text += table("meshes", meshes);

    std::vector<std::vector<std::string>> materials{{"name", "colour", "alpha", "maps"}};
    for (const Material& m : scene.materials) {
        std::string maps;
        for (const auto& [kind, texture] : mapsOf(m))
            maps += fmt::format("{}{} {}", maps.empty() ? "" : ", ", kind, scene.textures[std::size_t(texture)].name);
        materials.push_back({m.name, vectorText(m.baseColor), alphaName(m.alphaMode), maps});
    }
    text += table("materials", materials);

    std::vector<std::vector<std::string>> textures{{"name", "size", "holds"}};
    for (const Texture& t : scene.textures)
        textures.push_back({t.name, fmt::format("{}x{}", t.width, t.height), t.srgb ? "colour" : "data"});
    text += table("textures", textures);

    std::vector<std::vector<std::string>> lights{{"name", "type", "at", "towards", "intensity", "size"}};
    for (const Light& l : scene.lights)
        lights.push_back({l.name, lightTypeName(l.type), l.type == LightType::Sun ? "" : vectorText(l.position),
                          l.type == LightType::Point ? "" : vectorText(l.direction), fmt::format("{:.4g}", l.intensity),
                          sizeText(l)});
    text += table("lights", lights);

    std::vector<std::vector<std::string>> cameras{{"name", "at", "looks at", "angle"}};
    for (const Camera& c : scene.cameras)
        cameras.push_back({c.name, vectorText(c.position), vectorText(c.target),
                           c.orthoHeight_m ? fmt::format("{:.4g} m high", *c.orthoHeight_m)
                                           : fmt::format("{:.4g} deg", c.fovY_rad * kDegrees)});
    text += table("cameras", cameras);

    std::vector<std::vector<std::string>> animations{{"type", "light", "period"}};
    for (const Animation& a : scene.animations)
        animations.push_back({a.type, a.light, fmt::format("{:.4g} s", a.period_s)});
    text += table("animations", animations);

    if (!scene.warnings.empty()) text += fmt::format("\nwarnings ({})\n", scene.warnings.size());
    for (const std::string& warning : scene.warnings) text += "  " + warning + "\n";
    return text;
}

int runInfo(const Options& options) {
    const Scene scene = loadScene(requiredText(options, "scene", "scene"), sceneOptions(options));
    const SceneInfo info = describeScene(scene);
    printResult(options.flag("json") ? infoJson(scene, info).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                                     : infoText(scene, info));
    return 0;
}

}  // namespace

Command infoCommand() {
    return {"info",
            "Shows what a scene holds: meshes, materials, lights, cameras, warnings",
            {"gap", "model.glb", "scene.json --json"},
            [](Options& options) {
                options.add("scene", "a built-in scene, a scene file (.json) or a model file");
                options.add("--ground", "add a floor under a model file", Take::Flag);
                options.add("--eye", "X,Y,Z: move the first camera");
                options.add("--target", "X,Y,Z: turn the first camera");
                options.add("--allow-outside", "scene files may name models outside their folder", Take::Flag);
                options.add("--json", "one JSON document on standard output", Take::Flag);
            },
            runInfo};
}

}  // namespace ombrage::cli
