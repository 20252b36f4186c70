// SPDX-License-Identifier: MIT
#include "scene/scene_file.h"

#include <algorithm>
#include <map>
#include <set>

#include <glm/gtc/matrix_transform.hpp>

#include "core/strings.h"
#include "scene/asset_path.h"
#include "scene/framing.h"
#include "scene/json_document.h"
#include "scene/scene_lights.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
constexpr double kFarthest_m = 1e9;

/// Adds "-2", "-3", ... until the name is new.
std::string uniqueName(const std::string& name, const std::set<std::string>& taken) {
    std::string unique = name;
    for (int i = 2; taken.count(unique) > 0; ++i) unique = name + "-" + std::to_string(i);
    return unique;
}

/// The element's "name", or a free variant of `otherwise`. A name that is taken is an error.
std::string nameOf(const JsonNode& node, const std::string& otherwise, std::set<std::string>& taken) {
    std::string name;
    if (const auto given = node.find("name")) {
        name = given->name();
        if (taken.count(name) > 0) throw given->error("the name '" + name + "' is taken", "give each its own name");
    } else {
        name = uniqueName(otherwise, taken);
    }
    taken.insert(name);
    return name;
}

glm::dmat4 placement(const JsonNode& node) {
    glm::dvec3 position(0.0), rotation_deg(0.0), scale(1.0);
    if (const auto p = node.find("position")) position = p->vec3(-kFarthest_m, kFarthest_m);
    if (const auto r = node.find("rotation_deg")) rotation_deg = r->vec3(-36000.0, 36000.0);
    if (const auto s = node.find("scale")) {
        scale = s->isNumber() ? glm::dvec3(s->number(-1e6, 1e6)) : s->vec3(-1e6, 1e6);
        for (int i = 0; i < 3; ++i)
            if (std::abs(scale[i]) < 1e-9) throw s->error("a scale of 0 flattens the model");
    }
    // Scaled first, then turned about X, then Y, then Z, then moved.
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), position);
    m = glm::rotate(m, glm::radians(rotation_deg.z), glm::dvec3(0, 0, 1));
    m = glm::rotate(m, glm::radians(rotation_deg.y), glm::dvec3(0, 1, 0));
    m = glm::rotate(m, glm::radians(rotation_deg.x), glm::dvec3(1, 0, 0));
    return glm::scale(m, scale);
}

class SceneReader {
public:
    SceneReader(const fs::path& file, const SceneOptions& options)
        : m_folder(file.has_parent_path() ? file.parent_path() : fs::path(".")),
          m_options(options),
          m_document(file.string(), readWholeFile(file)) {
        m_scene.name = file.stem().string();
    }

    Scene read() {
        const JsonNode root(m_document);
        root.requireKeys("a scene", {"$schema", "name", "description", "models", "lights", "cameras", "animations",
                                     "techniques", "ambient", "ao_radius_m"});
        if (const auto schema = root.find("$schema")) schema->text();
        if (const auto name = root.find("name")) m_scene.name = name->name();
        if (const auto description = root.find("description")) m_scene.description = description->text();
        if (const auto ambient = root.find("ambient")) m_scene.ambient = float(ambient->number(0.0, 1e6));
        if (const auto radius = root.find("ao_radius_m"))
            m_scene.aoRadius_m = float(radius->numberAbove(0.0, kFarthest_m));

        const JsonNode models = root.at("models");
        const std::vector<JsonNode> modelNodes = models.elements();
        if (modelNodes.empty()) throw models.error("a scene needs at least one model");
        for (const JsonNode& node : modelNodes) readModel(node);
        readLights(root);
        readCameras(root);
        if (const auto animations = root.find("animations"))
            for (const JsonNode& node : animations->elements()) readAnimation(node);
        if (const auto techniques = root.find("techniques"))
            for (const JsonNode& node : techniques->elements()) readTechnique(node);
        return std::move(m_scene);
    }

private:
    fs::path modelPath(const JsonNode& node) const {
        const std::string name = node.name();
        std::string slashes = name;
        std::replace(slashes.begin(), slashes.end(), '\\', '/');
        const fs::path path = fs::path(slashes).is_absolute() ? fs::path(slashes) : m_folder / slashes;
        // A relative path that leaves the folder, by dots or by a link, could show files that the scene's author never
        // saw.
        if (!m_options.allowOutside && !fs::path(slashes).is_absolute()) {
            const fs::path folder = fs::weakly_canonical(m_folder), file = fs::weakly_canonical(path);
            if (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end())
                throw node.error("the file '" + name + "' lies outside the scene's folder",
                                 "allow that with --allow-outside");
        }
        std::error_code failed;
        if (!fs::is_regular_file(path, failed)) throw node.error("there is no file '" + name + "'");
        return path;
    }

    void readModel(const JsonNode& node) {
        node.requireKeys("a model", {"name", "file", "position", "rotation_deg", "scale", "casts", "receives", "skin",
                                     "fps", "clip", "path"});
        Model model;
        const JsonNode fileNode = node.at("file");
        const fs::path path = modelPath(fileNode);
        model.file = fileNode.text();
        model.name = nameOf(node, path.stem().string(), m_modelNames);
        if (const auto casts = node.find("casts")) model.casts = casts->boolean();
        if (const auto receives = node.find("receives")) model.receives = receives->boolean();
        const glm::dmat4 worldFromFile = placement(node);
        const fs::path skin = skinPath(node, path);
        checkMotion(node, model.name);

        // A file that stands in several places is read once.
        const int modelIndex = int(m_scene.models.size());
        const std::string key = fs::weakly_canonical(path).string() + "\n" + skin.string();
        if (const auto known = m_loaded.find(key); known != m_loaded.end()) {
            for (const Instance& instance : known->second.parts)
                m_scene.instances.push_back({instance.mesh, modelIndex, worldFromFile * instance.worldFromLocal});
            m_scene.models.push_back(std::move(model));
            keepLightsAndCameras(known->second, worldFromFile);
            return;
        }
        ModelFile file = readFile(path, {skin}, fileNode);
        Loaded loaded;
        for (const ModelFile::Part& part : file.parts)
            loaded.parts.push_back({int(m_scene.meshes.size()) + part.mesh, 0, part.fileFromLocal});
        loaded.lights = file.lights;
        loaded.cameras = file.cameras;
        for (std::string& warning : file.warnings) warning = model.file + ": " + warning;
        addModel(m_scene, std::move(file), std::move(model), worldFromFile);
        keepLightsAndCameras(loaded, worldFromFile);
        m_loaded.emplace(key, std::move(loaded));
    }

    /// The picture that "skin" names, seen from the scene's folder; empty without one.
    fs::path skinPath(const JsonNode& node, const fs::path& model) const {
        const auto skin = node.find("skin");
        if (!skin) return {};
        if (toLower(model.extension().string()) != ".md2") throw skin->error("only MD2 models have skins");
        return modelPath(*skin);
    }

    static ModelFile readFile(const fs::path& path, const ModelFileOptions& options, const JsonNode& fileNode) {
        try {
            return readModelFile(path, options);
        } catch (const Error& error) {
            const std::string where = error.where().empty() ? "" : error.where() + ": ";
            throw fileNode.error(where + error.message(), error.hint());
        }
    }

    void checkMotion(const JsonNode& node, const std::string& modelName) {
        std::vector<std::string> unused;
        if (const auto fps = node.find("fps")) fps->numberAbove(0.0, 1000.0), unused.push_back("fps");
        if (const auto clip = node.find("clip")) clip->name(), unused.push_back("clip");
        if (const auto path = node.find("path")) {
            for (const JsonNode& point : path->elements()) point.vec3(-kFarthest_m, kFarthest_m);
            unused.push_back("path");
        }
        if (!unused.empty())
            m_scene.warnings.push_back("model '" + modelName + "': " + join(unused, ", ") +
                                       " not used: animated model files stand still so far");
    }

    struct Loaded {
        std::vector<Instance> parts;  ///< worldFromLocal holds fileFromLocal
        std::vector<Light> lights;
        std::vector<Camera> cameras;
    };

    /// The lights and cameras of model files serve a scene that has none of its own.
    void keepLightsAndCameras(const Loaded& loaded, const glm::dmat4& worldFromFile) {
        for (Light light : loaded.lights) {
            light.position = glm::dvec3(worldFromFile * glm::dvec4(light.position, 1.0));
            light.direction = glm::vec3(glm::normalize(glm::dmat3(worldFromFile) * glm::dvec3(light.direction)));
            m_fileLights.push_back(light);
        }
        for (Camera camera : loaded.cameras) {
            camera.position = glm::dvec3(worldFromFile * glm::dvec4(camera.position, 1.0));
            camera.target = glm::dvec3(worldFromFile * glm::dvec4(camera.target, 1.0));
            camera.up = glm::vec3(glm::normalize(glm::dmat3(worldFromFile) * glm::dvec3(camera.up)));
            m_fileCameras.push_back(camera);
        }
    }

    void readLights(const JsonNode& root) {
        std::set<std::string> names;
        if (const auto lights = root.find("lights")) {
            if (lights->elements().empty())
                throw lights->error("a scene needs at least one light; without \"lights\" it has a sun");
            for (const JsonNode& node : lights->elements()) {
                Light light = readLight(node, m_scene);
                light.name = nameOf(node, lightTypeName(light.type), names);
                m_scene.lights.push_back(std::move(light));
            }
        }
        if (!m_scene.lights.empty() || m_fileLights.empty()) return;
        m_scene.lights = m_fileLights;
        tameBrightLights(m_scene);
    }

    void readCameras(const JsonNode& root) {
        std::set<std::string> names;
        if (const auto cameras = root.find("cameras"))
            for (const JsonNode& node : cameras->elements()) {
                Camera camera = readCamera(node);
                camera.name = nameOf(node, "camera", names);
                m_scene.cameras.push_back(std::move(camera));
            }
        if (!m_scene.cameras.empty()) return;
        m_scene.cameras = {framedCamera(m_scene)};
        m_scene.cameras.insert(m_scene.cameras.end(), m_fileCameras.begin(), m_fileCameras.end());
    }

    Camera readCamera(const JsonNode& node) const {
        node.requireKeys("a camera", {"name", "position", "target", "up", "fov_deg", "ortho_height_m"});
        Camera camera;
        camera.position = node.at("position").vec3(-kFarthest_m, kFarthest_m);
        camera.target = m_scene.bounds().center();
        if (const auto target = node.find("target")) camera.target = target->vec3(-kFarthest_m, kFarthest_m);
        if (!(glm::length(camera.target - camera.position) > 1e-9))
            throw node.error("the camera looks at its own position");
        if (const auto up = node.find("up")) camera.up = glm::vec3(up->direction());
        const auto fov = node.find("fov_deg"), ortho = node.find("ortho_height_m");
        if (fov && ortho) throw ortho->error("a camera has 'fov_deg' or 'ortho_height_m', not both");
        if (fov) camera.fovY_rad = float(glm::radians(fov->number(1.0, 170.0)));
        if (ortho) camera.orthoHeight_m = float(ortho->numberAbove(0.0, kFarthest_m));
        return camera;
    }

    void readAnimation(const JsonNode& node) {
        Animation animation;
        animation.type = node.at("type").choice("animation", {"orbit-camera", "orbit-light", "swing"});
        if (animation.type == "swing") {
            readSwing(node, animation);
        } else if (animation.type == "orbit-light") {
            node.requireKeys("orbit-light", {"type", "period_s", "light"});
            std::vector<std::string> names;
            for (const Light& light : m_scene.lights) names.push_back(light.name);
            if (names.empty()) names.push_back(defaultSun().name);
            animation.light = node.at("light").choice("light", names);
        } else {
            node.requireKeys("orbit-camera", {"type", "period_s"});
        }
        if (const auto period = node.find("period_s")) animation.period_s = period->numberAbove(0.0, 1e6);
        m_scene.animations.push_back(animation);
    }

    void readSwing(const JsonNode& node, Animation& animation) const {
        node.requireKeys("swing", {"type", "period_s", "models", "pivot", "axis", "amplitude_deg", "phase"});
        std::vector<std::string> names;
        for (const Model& model : m_scene.models) names.push_back(model.name);
        const JsonNode models = node.at("models");
        if (models.elements().empty()) throw models.error("a swing needs at least one model");
        std::set<std::string> chosen;
        for (const JsonNode& model : models.elements())
            if (!chosen.insert(model.choice("model", names)).second) throw model.error("this model is named twice");
        for (std::size_t i = 0; i < m_scene.instances.size(); ++i)
            if (chosen.count(m_scene.models[std::size_t(m_scene.instances[i].model)].name) > 0)
                animation.instances.push_back(int(i));
        animation.pivot = node.at("pivot").vec3(-kFarthest_m, kFarthest_m);
        animation.axis = node.at("axis").direction();
        animation.amplitude_rad = glm::radians(node.at("amplitude_deg").number(-36000.0, 36000.0));
        if (const auto phase = node.find("phase")) animation.phase = phase->number(-1.0, 1.0);
    }

    void readTechnique(const JsonNode& node) {
        const std::string id = node.name();
        const std::size_t slash = id.find('/');
        const std::vector<std::string> families = {"shadow", "ao", "filter", "indirect", "aa"};
        if (slash == std::string::npos || slash + 1 == id.size())
            throw node.error("'" + id + "' is no technique's id", "FAMILY/NAME, as in shadow/map");
        if (std::find(families.begin(), families.end(), id.substr(0, slash)) == families.end()) {
            const Error unknown = unknownName("family", id.substr(0, slash), families);
            throw node.error(unknown.message(), unknown.hint());
        }
        m_scene.techniques.push_back(id);
    }

    fs::path m_folder;
    SceneOptions m_options;
    JsonDocument m_document;
    Scene m_scene;
    std::set<std::string> m_modelNames;
    std::map<std::string, Loaded> m_loaded;
    std::vector<Light> m_fileLights;
    std::vector<Camera> m_fileCameras;
};
}  // namespace

Scene readSceneFile(const fs::path& file, const SceneOptions& options) {
    return SceneReader(file, options).read();
}

}  // namespace ombrage
