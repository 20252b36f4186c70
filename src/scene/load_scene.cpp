// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include <ombrage/error.h>
#include <ombrage/scene.h>

#include "core/strings.h"
#include "scene/builtin.h"
#include "scene/framing.h"
#include "scene/scene_file.h"
#include "scene/scene_repair.h"

namespace ombrage {

namespace {
bool isBuiltin(const std::string& name) {
    const auto& all = builtinScenes();
    return std::any_of(all.begin(), all.end(), [&](const BuiltinScene& scene) { return scene.name == name; });
}

Scene openModel(const std::filesystem::path& path) {
    ModelFile file = readModelFile(path);
    Scene scene;
    scene.name = path.stem().string();
    scene.lights = file.lights;
    scene.cameras = file.cameras;
    Model model;
    model.name = scene.name;
    model.file = path.string();
    addModel(scene, std::move(file), model, glm::dmat4(1.0));
    return scene;
}
}  // namespace

void addModel(Scene& scene, ModelFile&& file, Model model, const glm::dmat4& worldFromFile) {
    const int firstTexture = int(scene.textures.size()), firstMaterial = int(scene.materials.size());
    const int firstMesh = int(scene.meshes.size());
    for (Texture& texture : file.textures) scene.textures.push_back(std::move(texture));
    for (Material& material : file.materials) {
        for (int* index : {&material.baseColorTexture, &material.normalTexture, &material.heightTexture,
                           &material.metallicRoughnessTexture, &material.emissiveTexture})
            if (*index >= 0) *index += firstTexture;
        scene.materials.push_back(std::move(material));
    }
    for (Mesh& mesh : file.meshes) {
        mesh.material += firstMaterial;
        scene.meshes.push_back(std::move(mesh));
    }
    for (const ModelFile::Part& part : file.parts)
        scene.instances.push_back(
            {firstMesh + part.mesh, int(scene.models.size()), worldFromFile * part.fileFromLocal});
    scene.models.push_back(std::move(model));
    scene.warnings.insert(scene.warnings.end(), file.warnings.begin(), file.warnings.end());
}

void completeScene(Scene& scene) {
    if (scene.aoRadius_m <= 0.0f) scene.aoRadius_m = float(0.05 * scene.bounds().diagonal());
    if (scene.lights.empty()) scene.lights.push_back(defaultSun());
}

Scene loadScene(const std::string& nameOrFile, const SceneOptions& options) {
    Scene scene;
    const std::filesystem::path path(nameOrFile);
    std::error_code ignored;
    if (isBuiltin(nameOrFile)) {
        scene = makeBuiltinScene(nameOrFile);
        if (options.ground)
            scene.warnings.push_back("built-in scenes come without a ground of their own; the option is not used");
    } else if (std::filesystem::exists(path, ignored)) {
        if (toLower(path.extension().string()) == ".json") {
            scene = readSceneFile(path, options);
        } else {
            scene = openModel(path);
            scene.cameras.insert(scene.cameras.begin(), framedCamera(scene));
            tameBrightLights(scene);
        }
        completeScene(scene);
        if (options.ground) addGround(scene);
    } else if (path.has_extension() || path.has_parent_path()) {
        throw Error(ErrorCode::Input, "there is no file '" + nameOrFile + "'");
    } else {
        scene = makeBuiltinScene(nameOrFile);
    }
    repairScene(scene);
    if (options.eye) scene.cameras[0].position = *options.eye;
    if (options.target) scene.cameras[0].target = *options.target;
    return scene;
}

}  // namespace ombrage
