// SPDX-License-Identifier: MIT
#include "render/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/packing.hpp>

#include "core/trace.h"
#include "render/faceted_mesh.h"
#include "render/frame_context.h"
#include "scene/solidity.h"

namespace ombrage {

namespace {

/// As in ombrage/instances.glsl, std430.
struct InstanceData {
    glm::mat4 worldFromLocal;
    std::uint32_t baseColor, surface, firstTriangle, material, flags, index;
    std::uint32_t padding[2] = {};
};
constexpr std::uint32_t kMirrored = 1, kUnshadowed = 2;

struct MaterialData {
    glm::vec4 baseColor, specular, emissive, surface;
    glm::uvec4 textures;
};

/// A vertex of a FacetedMesh.
struct SurfaceVertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;
    glm::vec2 uv;
    glm::vec3 facetNormal;   ///< of the triangle that it ends, unit, local
    std::uint32_t triangle;  ///< likewise, counted within the mesh
};

constexpr GLuint kTriangleStorage = 2, kExclusionStorage = 7;

/// The triangle's own normal by the order of its corners, in double so that slivers keep theirs.
glm::vec3 facetNormal(const Mesh& mesh, std::size_t triangle) {
    glm::dvec3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]);
    const glm::dvec3 n = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double length = glm::length(n);
    return length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
}

/// As in ombrage/surface.glsl.
std::uint32_t packedAlbedo(const glm::vec3& linear) {
    const glm::uvec3 c(glm::sqrt(glm::clamp(linear, 0.0f, 1.0f)) * glm::vec3(2047, 2047, 1023) + 0.5f);
    return c.r | c.g << 11 | c.b << 22;
}

/// Metallic, roughness, luminance of the specular colour, shininess / 255.
std::uint32_t packedMaterial(const Material& m) {
    const float specular = glm::dot(m.specular, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    return glm::packUnorm4x8(glm::vec4(m.metallic, m.roughness, specular, m.shininess / 255.0f));
}

/// Textures of a material, the key by which draws are grouped.
std::array<int, 5> textureSet(const Material& m) {
    return {m.baseColorTexture, m.normalTexture, m.heightTexture, m.metallicRoughnessTexture, m.emissiveTexture};
}

}  // namespace

namespace {
FlatScene traced(const Scene& scene) {
    const TraceScope trace("flatten");
    return flatten(scene);
}
}  // namespace

GpuScene::GpuScene(const Scene& scene) : m_scene(&scene), m_flat(traced(scene)), m_bounds(scene.bounds()) {
    {
        const TraceScope trace("upload geometry");
        uploadMeshes();
        uploadSurfaces();
        uploadInstances();
    }
    {
        const TraceScope trace("upload materials and textures");
        uploadMaterials();
    }

    // Bounds of the casters, for fitting light views.
    glm::vec3 lower(INFINITY), upper(-INFINITY);
    for (const FlatInstance& instance : m_flat.instances) {
        std::pair<glm::vec3, glm::vec3> own{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
        for (std::uint32_t v = 0; v < instance.vertexCount; ++v) {
            own.first = glm::min(own.first, m_flat.positions[instance.firstVertex + v]);
            own.second = glm::max(own.second, m_flat.positions[instance.firstVertex + v]);
        }
        m_instanceBounds.push_back(own);
        if (!instance.casts) continue;
        lower = glm::min(lower, own.first);
        upper = glm::max(upper, own.second);
    }
    if (lower.x <= upper.x) {
        m_casterLower = lower;
        m_casterUpper = upper;
    }
}

GpuScene::~GpuScene() = default;

void GpuScene::uploadMeshes() {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (const Mesh& mesh : m_scene->meshes) {
        const auto firstVertex = std::uint32_t(positions.size());
        m_meshFirstVertex.push_back(firstVertex);
        m_meshFirstIndex.push_back(std::uint32_t(indices.size()));
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (std::uint32_t index : mesh.indices) indices.push_back(firstVertex + index);
    }
    std::vector<char> solid(m_scene->meshes.size());
    tbb::parallel_for(std::size_t(0), solid.size(), [&](std::size_t i) { solid[i] = isSolid(m_scene->meshes[i]); });
    m_meshIsSolid.assign(solid.begin(), solid.end());
    m_positions = gl::Buffer::from(positions, "scene positions");
    m_indices = gl::Buffer::from(indices, "scene indices");
}

void GpuScene::uploadSurfaces() {
    std::vector<SurfaceVertex> vertices;
    std::vector<std::uint32_t> indices;
    const bool colored = std::any_of(m_scene->meshes.begin(), m_scene->meshes.end(),
                                     [](const Mesh& mesh) { return !mesh.colors.empty(); });
    std::vector<std::uint64_t> colors;
    for (const Mesh& mesh : m_scene->meshes) {
        const auto firstVertex = std::uint32_t(vertices.size());
        const FacetedMesh faceted = facet(mesh);
        for (std::size_t v = 0; v < faceted.source.size(); ++v) {
            const std::uint32_t source = faceted.source[v], triangle = faceted.triangle[v];
            const bool ends = triangle != FacetedMesh::kNoTriangle;
            vertices.push_back({mesh.positions[source], mesh.normals[source], mesh.tangents[source], mesh.uvs[source],
                                ends ? facetNormal(mesh, triangle) : glm::vec3(0.0f), ends ? triangle : 0u});
            if (colored)
                colors.push_back(
                    glm::packHalf4x16(glm::vec4(mesh.colors.empty() ? glm::vec3(1.0f) : mesh.colors[source], 1.0f)));
        }
        for (std::uint32_t index : faceted.indices) indices.push_back(firstVertex + index);
    }
    m_surfaceVertices = gl::Buffer::from(vertices, "scene surfaces");
    m_surfaceIndices = gl::Buffer::from(indices, "scene surface indices");
    if (colored) m_colors = gl::Buffer::from(colors, "scene colours");
    m_triangles = gl::Buffer::from(m_flat.triangleInstance, "scene triangles");
}

void GpuScene::uploadInstances() {
    std::vector<InstanceData> data;
    for (std::size_t i = 0; i < m_flat.instances.size(); ++i) {
        const FlatInstance& instance = m_flat.instances[i];
        const Material& material = m_scene->materials[std::size_t(instance.material)];
        data.push_back({instance.originFromLocal, packedAlbedo(material.baseColor), packedMaterial(material),
                        instance.firstTriangle, std::uint32_t(instance.material),
                        (instance.mirrored ? kMirrored : 0u) | (instance.receives ? 0u : kUnshadowed),
                        std::uint32_t(i)});
        m_hasLightExceptions = m_hasLightExceptions || !instance.receives;
    }
    m_instances = gl::Buffer::from(data, "scene instances");

    // One bit per light and instance: the light leaves the instance out.
    const std::size_t words = (m_flat.instances.size() + 31) / 32;
    std::vector<std::uint32_t> exclusions(words * m_scene->lights.size(), 0u);
    for (std::size_t l = 0; l < m_scene->lights.size(); ++l)
        for (int model : m_scene->lights[l].excludedModels)
            for (std::size_t i = 0; i < m_flat.instances.size(); ++i)
                if (m_flat.instances[i].model == model) {
                    exclusions[l * words + i / 32] |= 1u << (i % 32);
                    m_hasLightExceptions = true;
                }
    m_exclusions = gl::Buffer::from(exclusions, "light exclusions");

    m_positionArray =
        vertexArray({{0, m_positions.id(), 0, sizeof(glm::vec3), 0}}, {{0, 3, GL_FLOAT, 0, 0}}, m_indices);
    std::vector<gl::VertexBinding> bindings{{0, m_surfaceVertices.id(), 0, sizeof(SurfaceVertex), 0}};
    std::vector<gl::VertexAttribute> full{{0, 3, GL_FLOAT, GLuint(offsetof(SurfaceVertex, position)), 0},
                                          {1, 3, GL_FLOAT, GLuint(offsetof(SurfaceVertex, normal)), 0},
                                          {2, 4, GL_FLOAT, GLuint(offsetof(SurfaceVertex, tangent)), 0},
                                          {3, 2, GL_FLOAT, GLuint(offsetof(SurfaceVertex, uv)), 0},
                                          {12, 3, GL_FLOAT, GLuint(offsetof(SurfaceVertex, facetNormal)), 0},
                                          {13, 1, GL_UNSIGNED_INT, GLuint(offsetof(SurfaceVertex, triangle)), 0}};
    if (hasVertexColors()) {
        bindings.push_back({3, m_colors.id(), 0, sizeof(std::uint64_t), 0});
        full.push_back({11, 4, GL_HALF_FLOAT, 0, 3});
    }
    m_fullArray = vertexArray(std::move(bindings), std::move(full), m_surfaceIndices);
}

gl::VertexArray GpuScene::vertexArray(std::vector<gl::VertexBinding> bindings,
                                      std::vector<gl::VertexAttribute> attributes, const gl::Buffer& indices) const {
    constexpr GLuint kBinding = 2, kFirstColumn = 5;
    bindings.push_back({kBinding, m_instances.id(), 0, sizeof(InstanceData), 1});
    attributes.push_back({4, 1, GL_UNSIGNED_INT, GLuint(offsetof(InstanceData, index)), kBinding});
    for (GLuint column = 0; column < 4; ++column)
        attributes.push_back({kFirstColumn + column, 3, GL_FLOAT, column * GLuint(sizeof(glm::vec4)), kBinding});
    attributes.push_back({9, 4, GL_UNSIGNED_INT, GLuint(offsetof(InstanceData, baseColor)), kBinding});
    attributes.push_back({10, 1, GL_UNSIGNED_INT, GLuint(offsetof(InstanceData, flags)), kBinding});
    return gl::VertexArray(bindings, attributes, indices.id());
}

void GpuScene::uploadMaterials() {
    std::vector<MaterialData> data;
    for (const Material& m : m_scene->materials) {
        const auto textures = textureSet(m);
        glm::uvec4 bits{0u};
        for (std::size_t t = 0; t < textures.size(); ++t) bits.x |= textures[t] >= 0 ? 1u << t : 0u;
        bits.y = m.alphaMode == AlphaMode::Mask ? 1u : 0u;
        m_hasAlphaMask = m_hasAlphaMask || bits.y != 0;
        m_hasSpecular = m_hasSpecular || m.specular != glm::vec3(0.0f);
        m_hasEmission = m_hasEmission || m.emissive != glm::vec3(0.0f);
        data.push_back({glm::vec4(m.baseColor, m.alpha), glm::vec4(m.specular, m.shininess),
                        glm::vec4(m.emissive, m.alphaCutoff),
                        glm::vec4(m.metallic, m.roughness, m.normalScale, m.heightScale_uv), bits});
    }
    m_materials = gl::Buffer::from(data, "scene materials");

    for (const Texture& texture : m_scene->textures) {
        gl::Texture image({.format = GLenum(texture.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8),
                           .width = texture.width,
                           .height = texture.height,
                           .levels = 0},
                          texture.name.c_str());
        image.upload(0, GL_RGBA, GL_UNSIGNED_BYTE, texture.rgba.data());
        image.generateMipmap();
        image.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
        image.setWrap(GL_REPEAT);
        m_textures.push_back(std::move(image));
    }
}

const std::vector<DrawBatch>& GpuScene::batches(const DrawFilter& filter) {
    const auto known = m_batches.find(filter);
    if (known != m_batches.end()) return known->second;
    return m_batches.emplace(filter, makeBatches(filter, nullptr)).first->second;
}

std::vector<DrawBatch> GpuScene::batchesOf(const DrawFilter& filter, const std::vector<bool>& takes) const {
    return makeBatches(filter, &takes);
}

std::vector<DrawBatch> GpuScene::makeBatches(const DrawFilter& filter, const std::vector<bool>* takes) const {
    // Group the wanted instances by textures; opaque ones need none of them when only depth is drawn.
    const std::vector<int> noModels;
    const auto& excluded =
        filter.excludedByLight >= 0 ? m_scene->lights[std::size_t(filter.excludedByLight)].excludedModels : noModels;
    // Solids come first: what is open is mostly ground and walls, behind them for most eyes.
    std::map<std::tuple<bool, bool, std::array<int, 5>>, std::vector<gl::DrawElementsIndirect>> groups;
    for (std::size_t i = 0; i < m_flat.instances.size(); ++i) {
        const FlatInstance& instance = m_flat.instances[i];
        const Material& material = m_scene->materials[std::size_t(instance.material)];
        const bool masked = material.alphaMode == AlphaMode::Mask;
        if (takes && !(*takes)[i]) continue;
        if (filter.castersOnly && !instance.casts) continue;
        if (std::find(excluded.begin(), excluded.end(), instance.model) != excluded.end()) continue;
        if (filter.alpha == DrawFilter::Alpha::OpaqueOnly && masked) continue;
        if (filter.alpha == DrawFilter::Alpha::MaskedOnly && !masked) continue;
        std::array<int, 5> key{-1, -1, -1, -1, -1};
        if (filter.alpha == DrawFilter::Alpha::MaskedOnly) key[0] = material.baseColorTexture;
        if (!filter.castersOnly) key = textureSet(material);
        const bool solid = !masked && !instance.mirrored && m_meshIsSolid[std::size_t(instance.mesh)];
        const bool bothSides = !solid && material.doubleSided;
        groups[{!solid, bothSides, key}].push_back(
            {instance.triangleCount * 3, 1, m_meshFirstIndex[std::size_t(instance.mesh)], 0, std::uint32_t(i)});
    }

    std::vector<DrawBatch> made;
    for (const auto& [key, commands] : groups) {
        DrawBatch batch;
        batch.textures = std::get<2>(key);
        batch.solid = !std::get<0>(key);
        batch.bothSides = std::get<1>(key);
        batch.commands = gl::Buffer::from(commands, "draw commands");
        batch.commandCount = commands.size();
        for (const auto& command : commands) {
            batch.triangles += command.count / 3;
            batch.instances.push_back(command.baseInstance);
        }
        made.push_back(std::move(batch));
    }
    return made;
}

bool GpuScene::isWithin(std::size_t instance, const glm::vec3& point, float margin_m) const {
    const auto& [lower, upper] = m_instanceBounds[instance];
    return glm::all(glm::greaterThanEqual(point, lower - margin_m)) &&
           glm::all(glm::lessThanEqual(point, upper + margin_m));
}

bool GpuScene::isOnTheWay(std::size_t instance, const glm::vec3& from, const glm::vec4& toward) const {
    const auto& [lower, upper] = m_instanceBounds[instance];
    const glm::dvec3 start(from), along = glm::dvec3(toward) - start * double(toward.w);
    // Slabs, a little thicker than the bounds, which were rounded.
    const glm::dvec3 margin = glm::dvec3(1e-5) * (glm::abs(glm::dvec3(lower)) + glm::abs(glm::dvec3(upper)) + 1e-3);
    double first = 0, last = toward.w != 0.0f ? 1.0 : std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double below = double(lower[k]) - margin[k] - start[k], above = double(upper[k]) + margin[k] - start[k];
        if (along[k] == 0.0) {
            if (below > 0 || above < 0) return false;
            continue;
        }
        first = std::max(first, std::min(below / along[k], above / along[k]));
        last = std::min(last, std::max(below / along[k], above / along[k]));
    }
    return first <= last;
}

bool GpuScene::hidesBackFaces(const DrawBatch& batch, const glm::vec4& viewpoint, float margin_m) const {
    return batch.solid && (viewpoint.w == 0.0f ||
                           std::none_of(batch.instances.begin(), batch.instances.end(),
                                        [&](std::uint32_t i) { return isWithin(i, glm::vec3(viewpoint), margin_m); }));
}

void GpuScene::bindStorage() const {
    m_instances.bindStorage(kInstanceStorage);
    m_materials.bindStorage(kMaterialStorage);
    m_triangles.bindStorage(kTriangleStorage);
    m_exclusions.bindStorage(kExclusionStorage);
}

DrawCounts GpuScene::draw(const DrawBatch& batch, bool positionsOnly, GLenum mode) {
    if (!positionsOnly)
        for (std::size_t t = 0; t < batch.textures.size(); ++t)
            if (batch.textures[t] >= 0) texture(batch.textures[t]).bind(kUnitMaterialTextures + unsigned(t));
    gl::drawElementsIndirect(positionsOnly ? m_positionArray : m_fullArray, batch.commands, 0, batch.commandCount,
                             mode);
    return {batch.commandCount, batch.triangles};
}

std::uint64_t GpuScene::gpuBytes() const {
    std::uint64_t bytes = 0;
    for (const gl::Buffer* buffer : {&m_positions, &m_indices, &m_surfaceVertices, &m_surfaceIndices, &m_colors,
                                     &m_instances, &m_materials, &m_triangles, &m_exclusions})
        bytes += buffer->size();
    for (const gl::Texture& texture : m_textures) bytes += gl::byteSize(texture.desc());
    return bytes;
}

}  // namespace ombrage
