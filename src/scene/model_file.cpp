// SPDX-License-Identifier: MIT
#include "scene/model_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <ombrage/error.h>
#include <tbb/parallel_for.h>
#include <assimp/Importer.hpp>

#include "core/strings.h"
#include "scene/asset_path.h"
#include "scene/gltf_extras.h"
#include "scene/mesh_build.h"
#include "scene/model_materials.h"
#include "scene/recording_io.h"

namespace ombrage {

namespace {
constexpr int kDeepestNode = 256;

/// One use of a mesh by a node.
struct Use {
    unsigned mesh;
    glm::dmat4 fileFromLocal;
};

glm::dmat4 toGlm(const aiMatrix4x4& m) {
    glm::dmat4 result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column) result[int(column)][int(row)] = double(m[row][column]);
    return result;
}

void collectUses(const aiNode& node, const glm::dmat4& fileFromParent, int depth, std::vector<Use>& uses) {
    const glm::dmat4 fileFromNode = fileFromParent * toGlm(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) uses.push_back({node.mMeshes[i], fileFromNode});
    if (depth >= kDeepestNode) return;
    for (unsigned i = 0; i < node.mNumChildren; ++i) collectUses(*node.mChildren[i], fileFromNode, depth + 1, uses);
}

glm::vec3 toGlm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// The triangles of a mesh as the library hands them out. Texture rows are counted from the top here.
Mesh toMesh(const aiMesh& in, const GltfUv& uv) {
    Mesh mesh;
    mesh.name = std::string(in.mName.data, in.mName.length);
    mesh.material = int(in.mMaterialIndex);
    const unsigned set = uv.set >= 0 && uv.set < AI_MAX_NUMBER_OF_TEXTURECOORDS && in.HasTextureCoords(unsigned(uv.set))
                             ? unsigned(uv.set)
                             : 0u;
    for (unsigned i = 0; i < in.mNumVertices; ++i) {
        mesh.positions.push_back(toGlm(in.mVertices[i]));
        if (in.HasNormals()) mesh.normals.push_back(toGlm(in.mNormals[i]));
        if (in.HasTextureCoords(set)) {
            glm::vec2 at(in.mTextureCoords[set][i].x, 1.0f - in.mTextureCoords[set][i].y);
            if (!uv.isIdentity()) at = uv.apply(at);
            mesh.uvs.push_back(std::isfinite(at.x) && std::isfinite(at.y) ? at : glm::vec2(0.0f));
        }
        if (in.HasNormals() && in.HasTangentsAndBitangents()) {
            const glm::vec3 t = toGlm(in.mTangents[i]), b = toGlm(in.mBitangents[i]);
            const bool left = glm::dot(glm::cross(mesh.normals.back(), t), b) < 0.0f;
            mesh.tangents.push_back(glm::vec4(t, left ? -1.0f : 1.0f));
        }
    }
    for (unsigned f = 0; f < in.mNumFaces; ++f)
        if (in.mFaces[f].mNumIndices == 3)
            mesh.indices.insert(mesh.indices.end(), in.mFaces[f].mIndices, in.mFaces[f].mIndices + 3);
    return mesh;
}

template <typename T>
void appendAttribute(std::vector<T>& to, const std::vector<T>& from, std::size_t oldCount, std::size_t addedCount) {
    if (to.empty() && from.empty()) return;
    to.resize(oldCount, T(0.0f));
    to.insert(to.end(), from.begin(), from.end());
    to.resize(oldCount + addedCount, T(0.0f));
}

void append(Mesh& to, const Mesh& from) {
    const std::size_t oldCount = to.positions.size(), addedCount = from.positions.size();
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    appendAttribute(to.normals, from.normals, oldCount, addedCount);
    appendAttribute(to.tangents, from.tangents, oldCount, addedCount);
    appendAttribute(to.uvs, from.uvs, oldCount, addedCount);
    for (const std::uint32_t index : from.indices) to.indices.push_back(std::uint32_t(oldCount) + index);
}

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

bool usesEachMeshOnceInPlace(const std::vector<Use>& uses) {
    std::set<unsigned> seen;
    for (const Use& use : uses)
        if (use.fileFromLocal != glm::dmat4(1.0) || !seen.insert(use.mesh).second) return false;
    return true;
}

void readMeshes(const aiScene& source, const GltfExtras& extras, ModelFile& model) {
    std::vector<Use> uses;
    if (source.mRootNode != nullptr) collectUses(*source.mRootNode, glm::dmat4(1.0), 0, uses);

    // Files without placed objects (OBJ, PLY) become one mesh per material; others keep their instances.
    const bool merge = usesEachMeshOnceInPlace(uses);
    std::vector<int> numberOf(merge ? std::max(1u, source.mNumMaterials) : source.mNumMeshes, -1);
    for (const Use& use : uses) {
        const aiMesh& in = *source.mMeshes[use.mesh];
        int& number = numberOf[merge ? in.mMaterialIndex : use.mesh];
        const bool isNew = number < 0;
        if (isNew) {
            number = int(model.meshes.size());
            model.meshes.emplace_back();
            model.meshes.back().material = int(in.mMaterialIndex);
            model.meshes.back().name = std::string(in.mName.data, in.mName.length);
        }
        if (isNew || merge) {
            const GltfUv uv =
                in.mMaterialIndex < extras.materialUvs.size() ? extras.materialUvs[in.mMaterialIndex] : GltfUv{};
            append(model.meshes[std::size_t(number)], toMesh(in, uv));
        }
        if (isNew || !merge) model.parts.push_back({number, use.fileFromLocal});
    }

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

/// The library's MD2 reader trusts the head of the file; refuse one whose tables do not lie inside the file.
void checkMd2Head(const std::string& content, const std::filesystem::path& file) {
    std::array<std::int32_t, 17> head{};
    const auto refuse = [&] {
        throw Error(ErrorCode::Input,
                    "the MD2 model '" + file.string() + "' is damaged: its tables lie outside the file");
    };
    if (content.size() < sizeof head) refuse();
    std::memcpy(head.data(), content.data(), sizeof head);
    // Size of an element, where its count stands in the head, where its offset stands: skins, st, triangles, frames.
    const std::int64_t tables[4][3] = {{64, 5, 11}, {4, 7, 12}, {12, 8, 13}, {head[4], 10, 14}};
    for (const auto& [size, count, offset] : tables) {
        const std::int64_t n = head[std::size_t(count)], begin = head[std::size_t(offset)];
        if (size < 0 || n < 0 || begin < 0 || begin + n * size > std::int64_t(content.size())) refuse();
    }
    if (head[6] < 0 || head[4] < 40 + 4 * std::int64_t(head[6])) refuse();
}

MtlLibrary readMtlLibraries(const std::string& objText, const std::filesystem::path& folder,
                            std::vector<std::string>& warnings) {
    MtlLibrary library;
    for (const std::string& name : mtlLibrariesOf(objText)) {
        const auto file = findAsset(folder, name);
        if (file)
            library.merge(parseMtl(readWholeFile(*file), name, warnings));
        else
            warnings.push_back("material file '" + name + "' is missing");
    }
    return library;
}
}  // namespace

ModelFile readModelFile(const std::filesystem::path& file) {
    const std::string content = readWholeFile(file);
    const std::string extension = toLower(file.extension().string());
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (content.empty()) throw Error(ErrorCode::Input, "'" + file.string() + "' is empty");
    if (extension == ".md2") checkMd2Head(content, file);

    Assimp::Importer importer;
    importer.SetIOHandler(new RecordingIo);  // the importer owns it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* source = importer.ReadFile(
        file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (source == nullptr)
        throw Error(ErrorCode::Input, "cannot read the model '" + file.string() + "': " + importer.GetErrorString());

    ModelFile model;
    GltfExtras extras;
    if (extension == ".gltf" || extension == ".glb") {
        extras = readGltfExtras(content);
        model.warnings.insert(model.warnings.end(), extras.warnings.begin(), extras.warnings.end());
    } else if (source->HasLights() || source->HasCameras()) {
        model.warnings.push_back("lights and cameras are read from glTF files only; those of this file are left out");
    }
    model.lights = extras.lights;
    model.cameras = extras.cameras;
    readMeshes(*source, extras, model);
    dropUnusableParts(model);
    if (model.parts.empty()) throw Error(ErrorCode::Input, "the model '" + file.string() + "' has no usable triangle");

    if (extension == ".obj") {
        std::vector<std::string> names;
        for (unsigned i = 0; i < source->mNumMaterials; ++i) {
            const aiString name = source->mMaterials[i]->GetName();
            names.emplace_back(name.data, name.length);
        }
        const MtlLibrary library = readMtlLibraries(content, folder, model.warnings);
        readObjMaterials(names, library, folder, model.materials, model.textures, model.warnings);
    } else {
        readSceneMaterials(*source, folder, model.materials, model.textures, model.warnings);
    }
    if (model.materials.empty()) model.materials.emplace_back();
    for (Mesh& mesh : model.meshes)
        if (mesh.material < 0 || mesh.material >= int(model.materials.size())) mesh.material = 0;
    return model;
}

}  // namespace ombrage
