// SPDX-License-Identifier: MIT
#include "techniques/shared/gpu_bvh.h"

#include <bit>

#include "reference/bvh_builder.h"

namespace ombrage {

namespace {

constexpr GLuint kNodeStorage = 3;

}  // namespace

GpuBvh::GpuBvh(const GpuScene& scene, const std::vector<std::uint32_t>& triangles) {
    const FlatScene& flat = scene.flat();
    Bvh bvh = buildBvh(flat.positions, flat.triangles, triangles);
    std::vector<glm::vec4> nodes;
    nodes.reserve(bvh.nodes.size() * 2);
    for (const BvhNode& node : bvh.nodes) {
        nodes.emplace_back(node.lower, std::bit_cast<float>(node.skip));
        nodes.emplace_back(node.upper, std::bit_cast<float>(node.leaf));
    }
    checkStorageSize(nodes.size() * sizeof(glm::vec4));
    m_nodes = gl::Buffer::from(nodes, "ray-tracing nodes");
    m_nodeCount = std::uint32_t(bvh.nodes.size());
    m_triangles = GpuTriangles(scene, std::move(bvh.order));
}

void GpuBvh::bind(const gl::Program& program) const {
    m_nodes.bindStorage(kNodeStorage);
    m_triangles.bind(program);
    program.set("u_bvhNodeCount", m_nodeCount);
}

std::uint64_t GpuBvh::gpuBytes() const {
    return m_nodes.size() + m_triangles.gpuBytes();
}

}  // namespace ombrage
