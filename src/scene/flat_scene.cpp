// SPDX-License-Identifier: MIT
#include "scene/flat_scene.h"

#include <limits>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace ombrage {

namespace {
glm::dvec3 anyPerpendicular(const glm::dvec3& n) {
    const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, n));
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& fallback) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

void appendVertices(FlatScene& flat, const Mesh& mesh, const glm::dmat4& originFromLocal, bool mirrored) {
    const glm::dmat3 linear(originFromLocal);
    const glm::dmat3 normalMatrix = glm::inverseTranspose(linear);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        flat.positions.push_back(glm::vec3(originFromLocal * glm::dvec4(mesh.positions[i], 1.0)));
        const glm::dvec3 n = unitOr(normalMatrix * glm::dvec3(mesh.normals[i]), glm::dvec3(0, 1, 0));
        flat.normals.push_back(glm::vec3(n));
        // The tangent follows the surface and is made perpendicular again; a mirrored map turns the handedness.
        glm::dvec3 t = linear * glm::dvec3(mesh.tangents[i]);
        t = unitOr(t - n * glm::dot(n, t), anyPerpendicular(n));
        flat.tangents.push_back(glm::vec4(glm::vec3(t), mirrored ? -mesh.tangents[i].w : mesh.tangents[i].w));
    }
    flat.uvs.insert(flat.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    flat.colors.insert(flat.colors.end(), mesh.colors.begin(), mesh.colors.end());
    if (!flat.colors.empty()) flat.colors.resize(flat.positions.size(), glm::vec3(1.0f));
}
}  // namespace

FlatScene flatten(const Scene& scene) {
    FlatScene flat;
    const Bounds bounds = scene.bounds();
    if (!bounds.empty()) flat.origin = bounds.center();

    std::size_t vertexCount = 0;
    for (const Instance& instance : scene.instances)
        vertexCount += scene.meshes[std::size_t(instance.mesh)].positions.size();
    flat.positions.reserve(vertexCount);
    flat.normals.reserve(vertexCount);
    flat.tangents.reserve(vertexCount);
    flat.uvs.reserve(vertexCount);
    flat.triangles.reserve(scene.triangleCount());
    flat.triangleInstance.reserve(scene.triangleCount());

    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        const Model& model = scene.models[std::size_t(instance.model)];
        const glm::dmat4 originFromLocal = glm::translate(glm::dmat4(1.0), -flat.origin) * instance.worldFromLocal;

        FlatInstance out;
        out.firstVertex = std::uint32_t(flat.positions.size());
        out.vertexCount = std::uint32_t(mesh.positions.size());
        out.firstTriangle = std::uint32_t(flat.triangles.size());
        out.triangleCount = std::uint32_t(mesh.triangleCount());
        out.mesh = instance.mesh;
        out.material = mesh.material;
        out.model = instance.model;
        out.casts = model.casts;
        out.receives = model.receives;
        out.mirrored = glm::determinant(glm::dmat3(instance.worldFromLocal)) < 0.0;
        out.originFromLocal = glm::mat4(originFromLocal);
        // The first mesh with colours makes those before it white.
        if (!mesh.colors.empty()) flat.colors.resize(flat.positions.size(), glm::vec3(1.0f));
        appendVertices(flat, mesh, originFromLocal, out.mirrored);

        // A mirrored instance is seen from the other side: swap two corners so that outside stays counter-clockwise.
        for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
            glm::uvec3 t(mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]);
            if (out.mirrored) std::swap(t.y, t.z);
            flat.triangles.push_back(t + glm::uvec3(out.firstVertex));
            flat.triangleInstance.push_back(std::uint32_t(flat.instances.size()));
        }
        flat.instances.push_back(out);
    }
    return flat;
}

double nearestHit(const FlatScene& flat, const glm::dvec3& start, const glm::dvec3& direction) {
    // Moeller and Trumbore 1997.
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::uvec3& triangle : flat.triangles) {
        const glm::dvec3 a(flat.positions[triangle.x]);
        const glm::dvec3 e1 = glm::dvec3(flat.positions[triangle.y]) - a,
                         e2 = glm::dvec3(flat.positions[triangle.z]) - a;
        const glm::dvec3 p = glm::cross(direction, e2);
        const double determinant = glm::dot(e1, p);
        if (determinant == 0.0) continue;
        const glm::dvec3 s = start - a;
        const double u = glm::dot(s, p) / determinant;
        if (u < 0.0 || u > 1.0) continue;
        const glm::dvec3 q = glm::cross(s, e1);
        const double v = glm::dot(direction, q) / determinant;
        if (v < 0.0 || u + v > 1.0) continue;
        const double t = glm::dot(e2, q) / determinant;
        if (t > 0.0 && t < nearest) nearest = t;
    }
    return nearest;
}

}  // namespace ombrage
