// SPDX-License-Identifier: MIT
#include "techniques/shared/shadow_volume.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "render/frame_context.h"

namespace ombrage {

namespace {

/// w of the far ends under an orthographic camera: 1e5 times the distance to the light, beyond any scene, and a ray
/// bends by 1e-5 of its length.
constexpr float kOrthographicInfinity = 1e-5f;

bool contains(const glm::vec3& lower, const glm::vec3& upper, const glm::vec3& p, float margin) {
    return glm::all(glm::greaterThanEqual(p, lower - margin)) && glm::all(glm::lessThanEqual(p, upper + margin));
}

}  // namespace

VolumeVertices::VolumeVertices(const GpuScene& scene) {
    std::vector<glm::vec4> ends;
    for (const Mesh& mesh : scene.scene().meshes)
        for (const glm::vec3& p : mesh.positions) {
            ends.emplace_back(p, 1.0f);
            ends.emplace_back(p, 0.0f);
        }
    buffer = gl::Buffer::from(ends, "shadow volume vertices");
}

SceneTopology::SceneTopology(const GpuScene& scene) {
    for (const Mesh& mesh : scene.scene().meshes) m_meshes.emplace_back(mesh);
    for (const FlatInstance& instance : scene.flat().instances) {
        glm::vec3 lower(INFINITY), upper(-INFINITY);
        for (std::uint32_t v = 0; v < instance.vertexCount; ++v) {
            lower = glm::min(lower, scene.flat().positions[instance.firstVertex + v]);
            upper = glm::max(upper, scene.flat().positions[instance.firstVertex + v]);
        }
        m_lower.push_back(lower);
        m_upper.push_back(upper);
    }
}

void ShadowVolumes::reset() {
    m_key.reset();
}

void ShadowVolumes::update(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options) {
    const auto& topology = frame.gpuScene->derived<SceneTopology>();
    const auto& instances = frame.gpuScene->flat().instances;
    const bool isSun = light.light->type == LightType::Sun;

    // Triangles turned away from the light are enough where every ray to the light enters the mesh as often as it
    // leaves it: a closed mesh with eye and light outside. Inside of its bounds, and for open meshes, all triangles
    // cast.
    Key key{light.light->type, light.light->position, light.light->direction, options,
            std::vector<bool>(instances.size())};
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const glm::vec3 lower = topology.lower(i), upper = topology.upper(i);
        const float eyeMargin_m =
            4.0f * frame.view.near_m;  // the corners of the near plane, for a field of view up to 150 degrees
        key.both[i] = !topology.mesh(instances[i].mesh).closed() || frame.view.orthographic ||
                      contains(lower, upper, frame.view.eye, eyeMargin_m) ||
                      (!isSun && contains(lower, upper, light.position, 0.0f));
    }
    if (m_key && *m_key == key) return;
    build(frame, key, light.light->excludedModels);
    m_key = std::move(key);
}

void ShadowVolumes::build(FrameContext& frame, const Key& key, const std::vector<int>& excludedModels) {
    const GpuScene& gpuScene = *frame.gpuScene;
    const Scene& scene = gpuScene.scene();
    const auto& instances = gpuScene.flat().instances;
    const auto& topology = frame.gpuScene->derived<SceneTopology>();

    // The volume of every caster, with the light in the space of its mesh.
    std::vector<VolumeTriangles> volumes(instances.size());
    tbb::parallel_for(std::size_t(0), instances.size(), [&](std::size_t i) {
        const FlatInstance& instance = instances[i];
        if (!instance.casts) return;
        if (std::find(excludedModels.begin(), excludedModels.end(), instance.model) != excludedModels.end()) return;
        const glm::dmat4 localFromWorld = glm::inverse(scene.instances[i].worldFromLocal);
        VolumeRequest request;
        request.light_local = localFromWorld * (key.type == LightType::Sun ? glm::dvec4(-glm::dvec3(key.direction), 0.0)
                                                                           : glm::dvec4(key.position, 1.0));
        request.mirrored = instance.mirrored;
        request.both = key.both[i];
        request.perTriangle = key.options.perTriangle;
        request.caps = key.options.caps;
        request.firstVertex = gpuScene.meshFirstVertex(instance.mesh);
        appendVolume(topology.mesh(instance.mesh), request, volumes[i]);
    });

    // One index buffer, all outward triangles first; a draw command per instance and part.
    m_outward = {};
    m_inward = {};
    m_edges = 0;
    VolumeTriangles all;
    const auto append = [](Part& part, std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from,
                           std::size_t instance) {
        if (from.empty()) return;
        part.commands.push_back({std::uint32_t(from.size()), 1, std::uint32_t(to.size()), 0, std::uint32_t(instance)});
        to.insert(to.end(), from.begin(), from.end());
    };
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        append(m_outward, all.outward, volumes[i].outward, i);
        append(m_inward, all.inward, volumes[i].inward, i);
        m_edges += volumes[i].edges;
    }
    upload(frame, all);
}

void ShadowVolumes::upload(FrameContext& frame, const VolumeTriangles& triangles) {
    m_outward.indexCount = triangles.outward.size();
    m_inward.indexCount = triangles.inward.size();
    for (auto& command : m_inward.commands) command.firstIndex += std::uint32_t(m_outward.indexCount);
    std::vector<std::uint32_t> indices = triangles.outward;
    indices.insert(indices.end(), triangles.inward.begin(), triangles.inward.end());
    m_indices = gl::Buffer::from(indices, "shadow volume indices");
    m_outward.commandBuffer = gl::Buffer::from(m_outward.commands, "shadow volume commands");
    m_inward.commandBuffer = gl::Buffer::from(m_inward.commands, "shadow volume cap commands");

    const gl::Buffer& ends = frame.gpuScene->derived<VolumeVertices>().buffer;
    m_vertices = frame.gpuScene->vertexArray({{0, ends.id(), 0, sizeof(glm::vec4), 0}}, {{0, 4, GL_FLOAT, 0, 0}}, m_indices);
}

void ShadowVolumes::draw(FrameContext& frame, const LightFrame& light, const gl::Program& program, bool outward) const {
    const Part& part = outward ? m_outward : m_inward;
    if (part.commands.empty()) return;
    program.set("u_toward", light.toward());
    program.set("u_infinity", frame.view.orthographic ? kOrthographicInfinity : 0.0f);
    gl::drawElementsIndirect(m_vertices, part.commandBuffer, 0, part.commands.size());
    frame.countDraw(part.commands.size(), part.indexCount / 3);
}

std::uint64_t ShadowVolumes::gpuBytes() const {
    return m_indices.size() + m_outward.commandBuffer.size() + m_inward.commandBuffer.size();
}

}  // namespace ombrage
