// SPDX-License-Identifier: MIT
#include "techniques/shared/shadow_volume.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>

#include <tbb/parallel_for.h>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "render/frame_context.h"
#include "techniques/shared/volume_gpu.h"

namespace ombrage {

namespace {

/// Distance of far ends under an orthographic camera, but for a sun's volumes, in diagonals of the scene: the caps
/// between them lie before them, the nearer to the lamp the wider it sees a triangle. More of it costs the precision
/// that sides and caps are clipped with (1e4: up to 0.0015 of a picture wrong; 1e5: 0.03).
constexpr float kOrthographicInfinity = 1e3f;

/// Of shared/volume_edges.glsl: bound on the error of a side, as a share of its summands.
constexpr double kPlaneRounding = 3.6e-7;

constexpr int kGroupSize = 64;  // of shared/volume_silhouette.comp

using Defines = std::vector<std::pair<std::string, std::string>>;

int groups(std::uint32_t threads) {
    return int((threads + kGroupSize - 1) / kGroupSize);
}

const std::vector<std::uint32_t>& trianglesOf(const VolumeTriangles& volume, VolumePart part) {
    switch (part) {
        case VolumePart::Sides:
            return volume.sides;
        case VolumePart::LightCaps:
            return volume.lightCaps;
        case VolumePart::DarkCaps:
            return volume.darkCaps;
        case VolumePart::InwardLightCaps:
            break;
    }
    return volume.inwardLightCaps;
}

/// Commands that draw nothing yet.
std::vector<gl::DrawElementsIndirect> emptyCommands(std::size_t instances) {
    std::vector<gl::DrawElementsIndirect> commands(kVolumeParts * instances);
    for (std::size_t c = 0; c < commands.size(); ++c) commands[c] = {0, 1, 0, 0, std::uint32_t(c % instances)};
    return commands;
}

/// How near to a triangle's plane a light counts as in it: a few units in the last place of the coordinates' size, as
/// the truth's rays end before the light.
double inPlane(const GpuScene& gpuScene, std::size_t instance, const glm::dvec3& light_local) {
    const auto& topology = gpuScene.derived<SceneTopology>();
    const Bounds& bounds = topology.bounds(gpuScene.flat().instances[instance].mesh);
    return 4.0 * double(FLT_EPSILON) * (glm::length(light_local - bounds.center()) + bounds.diagonal());
}

void checkRoom(std::uint64_t bytes) {
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    const auto most = std::uint64_t(limit);
    if (bytes > most)
        throw Error(ErrorCode::Environment,
                    fmt::format("the volumes' indices take {} MB, and the driver's storage blocks hold {} MB",
                                bytes / 1000000, most / 1000000),
                    "find silhouettes with silhouette=cpu or silhouette=geometry");
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
    for (const Mesh& mesh : scene.scene().meshes) {
        m_meshes.emplace_back(mesh);
        Bounds bounds;
        for (const glm::uvec3& t : m_meshes.back().triangles())
            for (int k = 0; k < 3; ++k) {
                bounds.lower = glm::min(bounds.lower, glm::dvec3(mesh.positions[t[k]]));
                bounds.upper = glm::max(bounds.upper, glm::dvec3(mesh.positions[t[k]]));
            }
        m_bounds.push_back(bounds);
    }
}

ShadowVolumeOptions::ShadowVolumeOptions(const VolumeParams& params)
    : faces(params.faces),
      // Pairs of uses know silhouettes only.
      source(params.faces == VolumeFaces::Silhouette ? params.silhouette : SilhouetteSource::Cpu) {
    if (params.extrude == VolumeExtrusion::Distance) distance_m = params.distance_m;
}

void ShadowVolumes::setSlabs(const std::vector<VolumeSlab>& slabs) {
    const std::size_t bytes = slabs.size() * sizeof(VolumeSlab);
    if (m_slabs.size() < bytes)
        m_slabs = gl::Buffer::from(slabs, "shadow volume slabs");
    else
        m_slabs.upload(0, bytes, slabs.data());
}

void ShadowVolumes::reset() {
    m_key.reset();
}

void ShadowVolumes::update(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options,
                           const VolumeChoice& withCaps) {
    const auto& topology = frame.gpuScene->derived<SceneTopology>();
    const auto& instances = frame.gpuScene->flat().instances;
    const bool isSun = light.light->type == LightType::Sun;
    // Parallel rays need not meet at infinity, which an orthographic camera cannot show: behind the scene is far
    // enough.
    ShadowVolumeOptions drawn = options;
    if (isSun && frame.view.orthographic && !options.end())
        drawn.distance_m = 1.01f * float(frame.gpuScene->bounds().diagonal());

    // Triangles turned away from the light are enough where every ray to the light enters the mesh as often as it
    // leaves it: a closed mesh with eye and light outside. Inside of its bounds, and for open meshes, all triangles
    // cast.
    Key key{light.towardInWorld(), drawn, VolumeChoice(instances.size()),
            withCaps.empty() || drawn.end() ? VolumeChoice(instances.size(), true) : withCaps};
    for (std::size_t i = 0; i < instances.size(); ++i) {
        key.both[i] = !topology.mesh(instances[i].mesh).closed() || frame.view.orthographic ||
                      frame.gpuScene->isWithin(i, frame.view.eye, frame.view.nearReach_m()) ||
                      (!isSun && frame.gpuScene->isWithin(i, light.position, 0.0f));
    }
    if (m_key && *m_key == key) return;
    m_key = std::move(key);

    m_casters.assign(instances.size(), false);
    const std::vector<int>& excluded = light.light->excludedModels;
    for (std::size_t i = 0; i < instances.size(); ++i)
        m_casters[i] =
            instances[i].casts && std::find(excluded.begin(), excluded.end(), instances[i].model) == excluded.end();
    switch (options.source) {
        case SilhouetteSource::Cpu:
            buildOnCpu(frame);
            break;
        case SilhouetteSource::Compute:
            buildOnGpu(frame);
            break;
        case SilhouetteSource::Geometry:
            prepareGeometryShader(frame);
            break;
    }
}

VolumeRequest ShadowVolumes::request(const GpuScene& gpuScene, std::size_t i) const {
    const FlatInstance& instance = gpuScene.flat().instances[i];
    const glm::dmat4 localFromWorld = glm::inverse(gpuScene.scene().instances[i].worldFromLocal);
    VolumeRequest request;
    request.light_local = localFromWorld * m_key->toward_world;
    request.inPlane_local = m_key->isSun() ? 0.0 : inPlane(gpuScene, i, glm::dvec3(request.light_local));
    // Shaders have rounded planes, and who counts at the eye must count what they draw.
    request.rounding = m_key->options.source == SilhouetteSource::Cpu || m_key->isSun() ? 0.0 : kPlaneRounding;
    request.mirrored = instance.mirrored;
    request.both = m_key->both[i] && m_key->options.casting == CastingSide::Automatic;
    request.litOnly = m_key->options.casting == CastingSide::Lit;
    request.faces = m_key->options.faces;
    request.finite = m_key->options.end();
    request.caps = m_key->caps[i];
    request.firstVertex = gpuScene.meshFirstVertex(instance.mesh);
    return request;
}

void ShadowVolumes::buildOnCpu(FrameContext& frame) {
    const TraceScope trace("find silhouettes");
    const GpuScene& gpuScene = *frame.gpuScene;
    const auto& instances = gpuScene.flat().instances;
    const auto& topology = frame.gpuScene->derived<SceneTopology>();
    std::vector<VolumeTriangles> volumes(instances.size());
    tbb::parallel_for(std::size_t(0), instances.size(), [&](std::size_t i) {
        if (m_casters[i]) appendVolume(topology.mesh(instances[i].mesh), request(gpuScene, i), volumes[i]);
    });

    // One index buffer, part by part; a draw command per part and instance.
    std::vector<gl::DrawElementsIndirect> commands = emptyCommands(instances.size());
    std::vector<std::uint32_t> indices;
    std::size_t total = 0;
    for (const VolumeTriangles& v : volumes)
        total += v.sides.size() + v.lightCaps.size() + v.darkCaps.size() + v.inwardLightCaps.size();
    indices.reserve(total);
    m_counts.assign(commands.size(), 0);
    m_edges = 0;
    for (std::size_t c = 0; c < commands.size(); ++c) {
        const auto& from = trianglesOf(volumes[c % instances.size()], VolumePart(c / instances.size()));
        commands[c].count = m_counts[c] = std::uint32_t(from.size());
        commands[c].firstIndex = std::uint32_t(indices.size());
        indices.insert(indices.end(), from.begin(), from.end());
    }
    for (const VolumeTriangles& v : volumes) m_edges += v.edges;
    m_indices = gl::Buffer::from(indices, "shadow volume indices");
    m_commands = gl::Buffer::from(commands, "shadow volume commands");
    const gl::Buffer& ends = frame.gpuScene->derived<VolumeVertices>().buffer;
    m_vertices = gpuScene.vertexArray({{0, ends.id(), 0, sizeof(glm::vec4), 0}}, {{0, 4, GL_FLOAT, 0, 0}}, m_indices);
}

std::vector<GpuCaster> ShadowVolumes::gpuCasters(const GpuScene& gpuScene, const GpuTopology& topology) const {
    const auto& instances = gpuScene.flat().instances;
    std::vector<GpuCaster> casters(instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (!m_casters[i]) continue;
        const VolumeRequest volume = request(gpuScene, i);
        const GpuTopology::Range& mesh = topology.meshes[std::size_t(instances[i].mesh)];
        casters[i] = {.light_local = glm::vec4(volume.light_local),
                      .firstPair = mesh.firstPair,
                      .pairs = mesh.pairs,
                      .firstTriangle = mesh.firstTriangle,
                      .triangles = mesh.triangles,
                      .firstVertex = volume.firstVertex,
                      .inPlane_local = float(volume.inPlane_local),
                      .flags = (volume.both ? kCasterBoth : 0u) | (volume.mirrored ? kCasterMirrored : 0u) |
                               (volume.hasFarEnds() ? kCasterFarEnds : 0u)};
    }
    return casters;
}

void ShadowVolumes::buildOnGpu(FrameContext& frame) {
    const auto pass = frame.pass("find silhouettes");
    const GpuScene& gpuScene = *frame.gpuScene;
    const auto& topology = frame.gpuScene->derived<GpuTopology>();
    const std::vector<GpuCaster> casters = gpuCasters(gpuScene, topology);

    // Room for all that may come: a pair bounds one volume, or two where both sides of triangles cast.
    std::vector<gl::DrawElementsIndirect> commands = emptyCommands(casters.size());
    std::uint64_t indices = 0;
    const auto reserve = [&](VolumePart part, std::size_t instance, std::uint64_t count) {
        commands[std::size_t(part) * casters.size() + instance].firstIndex = std::uint32_t(indices);
        indices += count;
    };
    for (std::size_t i = 0; i < casters.size(); ++i) {
        const bool farEnds = (casters[i].flags & kCasterFarEnds) != 0;
        const std::uint64_t caps = m_key->caps[i] ? std::uint64_t(casters[i].triangles) * 3 : 0;
        reserve(VolumePart::Sides, i,
                std::uint64_t(casters[i].pairs) * ((casters[i].flags & kCasterBoth) != 0 ? 2 : 1) * (farEnds ? 6 : 3));
        reserve(VolumePart::LightCaps, i, caps);
        reserve(VolumePart::InwardLightCaps, i, caps);
        if (farEnds) reserve(VolumePart::DarkCaps, i, caps);
        checkRoom(indices * sizeof(std::uint32_t));
    }
    m_casterData = gl::Buffer::from(casters, "shadow volume casters");
    m_commands = gl::Buffer::from(commands, "shadow volume commands");
    m_indices = gl::Buffer(indices * sizeof(std::uint32_t), nullptr, "shadow volume indices");
    const gl::Buffer& ends = frame.gpuScene->derived<VolumeVertices>().buffer;
    m_vertices = gpuScene.vertexArray({{0, ends.id(), 0, sizeof(glm::vec4), 0}}, {{0, 4, GL_FLOAT, 0, 0}}, m_indices);

    m_casterData.bindStorage(kCasterStorage);
    topology.pairs.bindStorage(kPairStorage);
    topology.planes.bindStorage(kPlaneStorage);
    topology.triangles.bindStorage(kTriangleVertexStorage);
    m_commands.bindStorage(kVolumeCommandStorage);
    m_indices.bindStorage(kVolumeIndexStorage);
    for (const bool caps : {false, true}) {
        const gl::Program& program =
            frame.program({{GL_COMPUTE_SHADER, "shared/volume_silhouette.comp"}}, {{"PART", caps ? "1" : "0"}});
        program.set("u_casters", unsigned(casters.size()));
        for (std::size_t i = 0; i < casters.size(); ++i) {
            const std::uint32_t threads = caps ? casters[i].triangles : casters[i].pairs;
            if (threads == 0 || (caps && !m_key->caps[i])) continue;
            program.set("u_caster", unsigned(i));
            gl::dispatch(groups(threads), 1, 1);
        }
    }
    gl::barrier(GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    m_counts.clear();
    m_edges = 0;
}

void ShadowVolumes::prepareGeometryShader(FrameContext& frame) {
    const GpuScene& gpuScene = *frame.gpuScene;
    const auto& topology = frame.gpuScene->derived<GpuTopology>();
    const std::vector<GpuCaster> casters = gpuCasters(gpuScene, topology);
    std::vector<gl::DrawElementsIndirect> commands = emptyCommands(casters.size());
    for (std::size_t c = 0; c < commands.size(); ++c) {
        const GpuCaster& caster = casters[c % casters.size()];
        const bool sides = VolumePart(c / casters.size()) == VolumePart::Sides;
        commands[c].count = sides ? caster.pairs * 2 : caster.triangles * 3;
        commands[c].firstIndex = sides ? caster.firstPair * 2 : caster.firstTriangle * 3;
    }
    m_casterData = gl::Buffer::from(casters, "shadow volume casters");
    m_commands = gl::Buffer::from(commands, "shadow volume commands");
    m_indices = {};
    m_vertices = gpuScene.vertexArray({{0, gpuScene.vertices().id(), 0, sizeof(glm::vec3), 0}},
                                      {{0, 3, GL_FLOAT, 0, 0}}, topology.pairIndices);
    m_capVertices = gpuScene.vertexArray({{0, topology.corners.id(), 0, sizeof(glm::vec3), 0}},
                                         {{0, 3, GL_FLOAT, 0, 0}}, topology.cornerIndices);
    m_counts.clear();
    m_edges = 0;
}

const gl::Program& ShadowVolumes::program(FrameContext& frame, VolumePart part, const VolumeLook& look) const {
    Defines defines = look.defines;
    if (look.distance_m || m_key->options.distance_m)
        defines.emplace_back("FINITE", "");
    else if (m_key->options.slabs)
        defines.emplace_back("SLABS", "");
    if (look.ontoNearPlane) defines.emplace_back("ONTO_NEAR_PLANE", "");
    if (look.tileBounds) defines.emplace_back("TILE_BOUNDS", "");
    const gl::ShaderStage fragment{GL_FRAGMENT_SHADER, look.fragmentPath};
    if (m_key->options.source != SilhouetteSource::Geometry) {
        std::vector<gl::ShaderStage> stages{{GL_VERTEX_SHADER, "shared/shadow_volume.vert"}};
        if (look.tileBounds) stages.push_back({GL_GEOMETRY_SHADER, "shared/volume_tile_bounds.geom"});
        stages.push_back(fragment);
        return frame.program(std::move(stages), std::move(defines));
    }
    if (part == VolumePart::LightCaps || part == VolumePart::InwardLightCaps) {
        defines.emplace_back("PART", std::to_string(int(part)));
        return frame.program({{GL_VERTEX_SHADER, "shared/volume_caps.vert"}, fragment}, std::move(defines));
    }
    const char* const path = part == VolumePart::Sides ? "shared/volume_sides.geom" : "shared/volume_dark_caps.geom";
    return frame.program({{GL_VERTEX_SHADER, "shared/volume_primitive.vert"}, {GL_GEOMETRY_SHADER, path}, fragment},
                         std::move(defines));
}

void ShadowVolumes::draw(FrameContext& frame, const LightFrame& light, VolumePart first, VolumePart last,
                         const VolumeChoice& chosen, const VolumeLook& look) const {
    const std::size_t instances = m_casters.size();
    const bool byGeometryShader = m_key->options.source == SilhouetteSource::Geometry;
    if (byGeometryShader) {
        const auto& topology = frame.gpuScene->derived<GpuTopology>();
        m_casterData.bindStorage(kCasterStorage);
        topology.pairs.bindStorage(kPairStorage);
        topology.planes.bindStorage(kPlaneStorage);
    }
    if (m_key->options.slabs) m_slabs.bindStorage(kSlabStorage);
    const gl::Program* program = nullptr;
    for (auto part = std::size_t(first); part <= std::size_t(last); ++part) {
        if (program == nullptr || byGeometryShader) {
            program = &this->program(frame, VolumePart(part), look);
            program->set("u_toward", light.toward());
            program->set("u_infinity", infinity(frame));
            program->set("u_distance", look.distance_m.value_or(m_key->options.distance_m.value_or(0.0f)));
        }
        // Runs of chosen instances, a draw each.
        for (std::size_t i = 0; i < instances;) {
            std::size_t end = i;
            std::uint64_t triangles = 0;
            for (; end < instances && chosen[end] && m_casters[end]; ++end)
                triangles += m_counts.empty() ? 0 : m_counts[part * instances + end] / 3;
            if (end > i) {
                const std::size_t command = part * instances + i;
                if (!byGeometryShader)
                    gl::drawElementsIndirect(m_vertices, m_commands, command, end - i);
                else if (VolumePart(part) == VolumePart::Sides)
                    gl::drawElementsIndirect(m_vertices, m_commands, command, end - i, GL_LINES);
                else
                    gl::drawElementsIndirect(m_capVertices, m_commands, command, end - i);
                frame.countDraw(end - i, triangles);
            }
            i = std::max(end, i + 1);
        }
    }
}

float ShadowVolumes::infinity(const FrameContext& frame) {
    if (!frame.view.orthographic) return 0.0f;
    const Bounds& bounds = frame.gpuScene->bounds();
    return 1.0f / (kOrthographicInfinity * float(bounds.diagonal()));
}

std::pair<std::uint32_t, std::uint32_t> ShadowVolumes::sides(std::size_t instance) const {
    // Sides come first, in the instances' order.
    const auto here = m_counts.begin() + std::ptrdiff_t(instance);
    return {std::accumulate(m_counts.begin(), here, 0u), *here};
}

std::uint32_t ShadowVolumes::indicesPerSide() const {
    return !m_key->isSun() || m_key->options.end() ? 6 : 3;
}

std::vector<glm::uvec2> ShadowVolumes::silhouette(const GpuScene& gpuScene, std::size_t i) const {
    VolumeRequest request = this->request(gpuScene, i);
    request.faces = VolumeFaces::Silhouette;
    request.finite = true;
    request.caps = false;
    request.firstVertex = 0;
    VolumeTriangles volume;
    appendVolume(gpuScene.derived<SceneTopology>().mesh(gpuScene.flat().instances[i].mesh), request, volume);
    // Two triangles a side; the first begins with the edge.
    std::vector<glm::uvec2> edges;
    for (std::size_t s = 0; s + 5 < volume.sides.size(); s += 6)
        edges.emplace_back(volume.sides[s] >> 1, volume.sides[s + 1] >> 1);
    return edges;
}

int ShadowVolumes::around(const FrameContext& frame, const LightFrame& light, const glm::vec3& p,
                          const VolumeChoice& chosen) const {
    const GpuScene& gpuScene = *frame.gpuScene;
    const auto& instances = gpuScene.flat().instances;
    const auto& topology = frame.gpuScene->derived<SceneTopology>();
    const glm::dvec4 p_world(glm::dvec3(p) + gpuScene.origin(), 1.0);
    std::optional<VolumeEnd> end;
    if (m_key->options.distance_m) end = {double(*m_key->options.distance_m), m_key->toward_world, {}};
    int count = 0;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (!chosen[i] || !m_casters[i] || !gpuScene.isOnTheWay(i, p, light.toward())) continue;
        const glm::dmat4& worldFromLocal = gpuScene.scene().instances[i].worldFromLocal;
        const glm::dvec3 p_local = glm::inverse(worldFromLocal) * p_world;
        if (end) end->worldFromLocal = worldFromLocal;
        count +=
            volumesAround(topology.mesh(instances[i].mesh), gpuScene.scene().meshes[std::size_t(instances[i].mesh)],
                          request(gpuScene, i), p_local, end);
    }
    return count;
}

void ShadowVolumes::readBackSizes() const {
    std::vector<gl::DrawElementsIndirect> commands(kVolumeParts * m_casters.size());
    m_commands.download(0, commands.size() * sizeof commands[0], commands.data());
    for (const gl::DrawElementsIndirect& command : commands) m_counts.push_back(command.count);
    std::size_t corners = 0;
    for (std::size_t i = 0; i < m_casters.size(); ++i) corners += m_counts[i];
    m_edges = corners / indicesPerSide();
}

void ShadowVolumes::report(FrameContext& frame) const {
    // What compute shaders made is counted when somebody looks at the frame: reading it back waits for them.
    if (m_counts.empty() && m_key->options.source == SilhouetteSource::Compute && frame.isReturned()) readBackSizes();
    if (m_counts.empty()) return;
    const std::size_t corners = std::accumulate(m_counts.begin(), m_counts.end(), std::size_t(0));
    frame.counter("silhouette edges", double(m_edges));
    frame.counter("volume triangles", double(corners / 3));
}

std::uint64_t ShadowVolumes::gpuBytes() const {
    return m_indices.size() + m_commands.size() + m_casterData.size() + m_slabs.size();
}

}  // namespace ombrage
