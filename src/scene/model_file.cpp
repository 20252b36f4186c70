// SPDX-License-Identifier: MIT
#include "scene/model_file.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>
#include <tbb/parallel_for.h>

#include "core/strings.h"
#include "scene/asset_path.h"
#include "scene/gltf_file.h"
#include "scene/md2_file.h"
#include "scene/mesh_build.h"
#include "scene/model_import.h"
#include "scene/obj_file.h"
#include "scene/ply_file.h"

namespace ombrage {

namespace {
bool tangentsUsable(const Mesh& mesh) {
    return mesh.tangents.size() == mesh.positions.size() &&
           std::all_of(mesh.tangents.begin(), mesh.tangents.end(), [](const glm::vec4& t) {
               const float length = glm::length(glm::vec3(t));
               return std::isfinite(length) && length > 1e-3f;
           });
}

/// Repairs and completes a mesh. Returns the number of triangles dropped.
std::size_t finish(Mesh& mesh) {
    const std::size_t dropped = dropBadTriangles(mesh);
    joinVertices(mesh);
    completeNormals(mesh);
    if (tangentsUsable(mesh)) {
        for (glm::vec4& t : mesh.tangents) t = glm::vec4(glm::normalize(glm::vec3(t)), t.w);
        mesh.uvs.resize(mesh.positions.size(), glm::vec2(0.0f));
    } else {
        makeTangents(mesh);
    }
    return dropped;
}

void finishMeshes(ModelFile& model) {
    std::vector<std::size_t> dropped(model.meshes.size(), 0);
    tbb::parallel_for(std::size_t(0), model.meshes.size(),
                      [&](std::size_t i) { dropped[i] = finish(model.meshes[i]); });
    std::size_t droppedCount = 0;
    for (const std::size_t count : dropped) droppedCount += count;
    if (droppedCount > 0)
        model.warnings.push_back(std::to_string(droppedCount) +
                                 " triangles with non-finite corners or without area are left out");
}

/// A part whose matrix is not finite or flattens everything cannot be drawn.
void dropUnusableParts(ModelFile& model) {
    const std::size_t before = model.parts.size();
    model.parts.erase(std::remove_if(model.parts.begin(), model.parts.end(),
                                     [&](const ModelFile::Part& part) {
                                         const double volume = glm::determinant(glm::dmat3(part.fileFromLocal));
                                         const glm::dvec4 moved = part.fileFromLocal * glm::dvec4(1.0);
                                         const bool finite = std::isfinite(glm::dot(moved, moved));
                                         return !finite || !std::isfinite(volume) || volume == 0.0;
                                     }),
                      model.parts.end());
    if (model.parts.size() != before)
        model.warnings.push_back(std::to_string(before - model.parts.size()) +
                                 " objects whose transform flattens them are left out");
    model.parts.erase(std::remove_if(model.parts.begin(), model.parts.end(),
                                     [&](const ModelFile::Part& part) {
                                         return model.meshes[std::size_t(part.mesh)].indices.empty();
                                     }),
                      model.parts.end());
}

ModelFile readContent(const std::filesystem::path& file, const ModelFileOptions& options) {
    const std::string extension = toLower(file.extension().string());
    if (!options.skin.empty() && extension != ".md2")
        throw Error(ErrorCode::Input, "a skin belongs to an MD2 model", "", file.string());
    // Told apart by name: an OBJ file has no mark of its own, and the others say in their errors what they miss.
    const std::string content = readWholeFile(file);
    if (content.empty()) throw Error(ErrorCode::Input, "the file is empty", "", file.string());
    if (extension == ".obj") return readObj(content, file);
    if (extension == ".gltf" || extension == ".glb") return readGltf(content, file);
    if (extension == ".ply") return readPly(content, file);
    if (extension == ".md2") return readMd2(content, file, options.skin);
    return importModel(file);
}
}  // namespace

ModelFile readModelFile(const std::filesystem::path& file, const ModelFileOptions& options) {
    ModelFile model = readContent(file, options);
    finishMeshes(model);
    dropUnusableParts(model);
    if (model.parts.empty()) {
        // What was left out may be all that there was.
        std::string reason = model.warnings.empty() ? "" : ": " + join(model.warnings, "; ");
        throw Error(ErrorCode::Input, "the model has no usable triangle" + reason, "", file.string());
    }
    if (model.materials.empty()) model.materials.emplace_back();
    for (Mesh& mesh : model.meshes)
        if (mesh.material < 0 || mesh.material >= int(model.materials.size())) mesh.material = 0;
    return model;
}

}  // namespace ombrage
