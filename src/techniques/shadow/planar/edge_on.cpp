// SPDX-License-Identifier: MIT
#include "techniques/shadow/planar/edge_on.h"

#include <vector>

namespace ombrage::planar {

namespace {

/// Bits per global triangle whose plane holds the place, to the tolerance; empty when there is none.
std::vector<std::uint32_t> edgeOnBits(const FlatScene& flat, const glm::dvec3& place, double tolerance_m) {
    std::vector<std::uint32_t> bits;
    for (const FlatInstance& instance : flat.instances) {
        if (!instance.casts) continue;
        for (std::uint32_t t = instance.firstTriangle; t < instance.firstTriangle + instance.triangleCount; ++t) {
            const glm::uvec3& corners = flat.triangles[t];
            const glm::dvec3 a = flat.positions[corners.x], b = flat.positions[corners.y],
                             c = flat.positions[corners.z];
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double height = glm::dot(normal, place - a);
            // None that has no area.
            if (height * height >= tolerance_m * tolerance_m * glm::dot(normal, normal)) continue;
            if (bits.empty()) bits.resize((flat.triangles.size() + 31) / 32);
            bits[t / 32] |= 1u << (t % 32);
        }
    }
    return bits;
}

}  // namespace

const gl::Buffer* EdgeOnCasters::find(const FrameContext& frame, const LightFrame& light, float tolerance_m) {
    const glm::vec4 toward = light.toward();
    if (toward.w == 0.0f) return nullptr;
    const auto [place, isNew] = m_found.try_emplace(light.index);
    Found& found = place->second;
    if (isNew || found.toward != toward) {
        const std::vector<std::uint32_t> bits = edgeOnBits(frame.gpuScene->flat(), glm::vec3(toward), tolerance_m);
        found.toward = toward;
        found.bits.reset();
        if (!bits.empty()) found.bits = gl::Buffer::from(bits, "edge-on casters");
    }
    return found.bits ? &*found.bits : nullptr;
}

std::uint64_t EdgeOnCasters::gpuBytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [light, found] : m_found) bytes += found.bits ? found.bits->size() : 0;
    return bytes;
}

}  // namespace ombrage::planar
