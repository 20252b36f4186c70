// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include <ombrage/error.h>
#include <ombrage/scene.h>

#include "core/strings.h"
#include "core/trace.h"
#include "scene/archive.h"
#include "scene/builtin.h"
#include "scene/framing.h"
#include "scene/import_guard.h"
#include "scene/load_files.h"
#include "scene/scene_cache.h"
#include "scene/scene_file.h"
#include "scene/scene_repair.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
bool isBuiltin(const std::string& name) {
    const auto& all = builtinScenes();
    return std::any_of(all.begin(), all.end(), [&](const BuiltinScene& scene) { return scene.name == name; });
}

Scene openModel(const fs::path& path) {
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

LoadedScene loadFiles(const LoadRequest& request, LoadRecord::OnFile onFile) {
    const TraceScope trace("read files");
    LoadRecord record(std::move(onFile));
    LoadedScene loaded{request, {}, {}};
    Scene& scene = loaded.scene;
    const fs::path path(request.file);
    if (toLower(path.extension().string()) == ".json") {
        SceneOptions options;
        options.allowOutside = request.allowOutside;
        scene = readSceneFile(path, options);
        repairScene(scene);
    } else {
        scene = openModel(path);
        repairScene(scene);
        scene.cameras.insert(scene.cameras.begin(), framedCamera(scene));
        tameBrightLights(scene);
    }
    completeScene(scene);
    if (request.ground) addGround(scene);
    loaded.dependencies = record.dependencies();
    return loaded;
}

namespace {
/// From the cache, from a guarded process, or read here.
Scene loadFromDisk(const std::string& file, const SceneOptions& options) {
    std::error_code failed;
    const LoadRequest request{file, fs::current_path(failed).string(), options.allowOutside, options.ground};
    const SceneCache cache(options);
    {
        const TraceScope trace("look in the scene cache");
        if (std::optional<Scene> scene = cache.find(request)) return std::move(*scene);
    }

    TraceScope importing("guarded import");
    const std::optional<ImportedBytes> imported = importGuarded(request, options);
    importing.end();
    LoadedScene loaded;
    if (imported) {
        const TraceScope trace("unpack the imported scene");
        try {
            loaded = readLoadedScene(imported->archive());
        } catch (const ArchiveError& error) {
            throw Error(ErrorCode::Input, "reading '" + file + "' gave no usable scene: " + error.what());
        }
    } else {
        loaded = loadFiles(request);
    }
    // A file that changed while it was read would be kept with the wrong content.
    const TraceScope trace("keep in the scene cache");
    if (!cache.isOn() || !unchanged(loaded.dependencies)) return std::move(loaded.scene);
    if (imported)
        cache.store(request, imported->archive());
    else
        cache.store(loaded);
    return std::move(loaded.scene);
}

Scene repaired(Scene scene) {
    repairScene(scene);
    return scene;
}

/// Devices and pipes have no end or make a reader wait for ever.
void requireFile(const fs::path& path) {
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::is_directory(status))
        throw Error(ErrorCode::Input, "'" + path.string() + "' is a folder", "name a file in it");
    if (!fs::is_regular_file(status))
        throw Error(ErrorCode::Input, "'" + path.string() + "' is no file but a pipe, a socket or a device",
                    "write its content to a file first");
}
}  // namespace

Scene loadScene(const std::string& nameOrFile, const SceneOptions& options) {
    const TraceScope trace("load scene", nameOrFile);
    Scene scene;
    const fs::path path(nameOrFile);
    std::error_code failed;
    if (isBuiltin(nameOrFile)) {
        scene = repaired(makeBuiltinScene(nameOrFile));
        if (options.ground)
            scene.warnings.push_back("built-in scenes come without a ground of their own; the option is not used");
    } else if (fs::exists(path, failed)) {
        requireFile(path);
        scene = loadFromDisk(nameOrFile, options);
    } else if (failed && failed != std::errc::no_such_file_or_directory) {
        throw Error(ErrorCode::Input, "cannot open '" + nameOrFile + "': " + failed.message());
    } else if (fs::is_symlink(path, failed)) {
        throw Error(ErrorCode::Input, "'" + nameOrFile + "' is a link to a file that is not there");
    } else if (path.has_extension() || path.has_parent_path()) {
        throw Error(ErrorCode::Input, "there is no file '" + nameOrFile + "'");
    } else {
        scene = makeBuiltinScene(nameOrFile);  // says which names there are
    }
    if (options.eye) scene.cameras[0].position = *options.eye;
    if (options.target) scene.cameras[0].target = *options.target;
    return scene;
}

}  // namespace ombrage
