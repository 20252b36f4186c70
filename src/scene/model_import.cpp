// SPDX-License-Identifier: MIT
#include "scene/model_import.h"

#include <algorithm>
#include <set>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <assimp/Importer.hpp>

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
Mesh toMesh(const aiMesh& in) {
    Mesh mesh;
    mesh.name = std::string(in.mName.data, in.mName.length);
    mesh.material = int(in.mMaterialIndex);
    for (unsigned i = 0; i < in.mNumVertices; ++i) {
        mesh.positions.push_back(toGlm(in.mVertices[i]));
        if (in.HasNormals()) mesh.normals.push_back(toGlm(in.mNormals[i]));
        if (in.HasTextureCoords(0)) mesh.uvs.emplace_back(in.mTextureCoords[0][i].x, 1.0f - in.mTextureCoords[0][i].y);
        if (in.HasVertexColors(0)) {
            const aiColor4D& c = in.mColors[0][i];
            mesh.colors.emplace_back(linearFromSrgb(c.r), linearFromSrgb(c.g), linearFromSrgb(c.b));
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
void appendAttribute(std::vector<T>& to, const std::vector<T>& from, std::size_t oldCount, std::size_t addedCount,
                     const T& otherwise = T(0.0f)) {
    if (to.empty() && from.empty()) return;
    to.resize(oldCount, otherwise);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(oldCount + addedCount, otherwise);
}

void append(Mesh& to, const Mesh& from) {
    const std::size_t oldCount = to.positions.size(), addedCount = from.positions.size();
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    appendAttribute(to.normals, from.normals, oldCount, addedCount);
    appendAttribute(to.tangents, from.tangents, oldCount, addedCount);
    appendAttribute(to.uvs, from.uvs, oldCount, addedCount);
    appendAttribute(to.colors, from.colors, oldCount, addedCount, glm::vec3(1.0f));
    for (const std::uint32_t index : from.indices) to.indices.push_back(std::uint32_t(oldCount) + index);
}

bool usesEachMeshOnceInPlace(const std::vector<Use>& uses) {
    std::set<unsigned> seen;
    for (const Use& use : uses)
        if (use.fileFromLocal != glm::dmat4(1.0) || !seen.insert(use.mesh).second) return false;
    return true;
}

void readMeshes(const aiScene& source, ModelFile& model) {
    std::vector<Use> uses;
    if (source.mRootNode != nullptr) collectUses(*source.mRootNode, glm::dmat4(1.0), 0, uses);

    // Files without placed objects (STL) become one mesh per material; others keep their instances.
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
        if (isNew || merge) append(model.meshes[std::size_t(number)], toMesh(in));
        if (isNew || !merge) model.parts.push_back({number, use.fileFromLocal});
    }
}
}  // namespace

ModelFile importModel(const std::filesystem::path& file) {
    Assimp::Importer importer;
    importer.SetIOHandler(new RecordingIo);  // the importer owns it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* source = importer.ReadFile(
        file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (source == nullptr)
        throw Error(ErrorCode::Input, "cannot read the model '" + file.string() + "': " + importer.GetErrorString());

    ModelFile model;
    if (source->HasLights() || source->HasCameras())
        model.warnings.push_back("lights and cameras are read from glTF files only; those of this file are left out");
    readMeshes(*source, model);
    readSceneMaterials(*source, file.has_parent_path() ? file.parent_path() : std::filesystem::path("."), model);
    return model;
}

}  // namespace ombrage
