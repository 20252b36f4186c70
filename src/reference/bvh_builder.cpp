// SPDX-License-Identifier: MIT
#include "reference/bvh_builder.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include <embree3/rtcore.h>

#include <ombrage/error.h>

namespace ombrage {
namespace {

constexpr unsigned kMaxLeafTriangles = 2;
constexpr unsigned kMaxDepth = 64;

struct Box {
    glm::vec3 lower, upper;

    float area() const {
        const glm::vec3 d = upper - lower;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// What Embree builds: a leaf holds triangles, an inner node two children.
struct BuildNode {
    BuildNode* children[2] = {nullptr, nullptr};
    Box boxes[2] = {};   // of the children
    unsigned count = 0;
    std::uint32_t triangles[kMaxLeafTriangles] = {};
};

Box boxOf(const RTCBounds& b) { return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}}; }

void* createNode(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}

void setChildren(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->children[i] = static_cast<BuildNode*>(children[i]);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->boxes[i] = boxOf(*bounds[i]);
}

void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
    auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
    leaf->count = unsigned(count);
    for (std::size_t i = 0; i < count; ++i) leaf->triangles[i] = primitives[i].primID;
    return leaf;
}

/// The triangles' boxes; those without a finite one are left out.
std::vector<RTCBuildPrimitive> primitivesOf(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles,
                                            const std::vector<std::uint32_t>& wanted, Box& all) {
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(wanted.size());
    all = {glm::vec3(INFINITY), glm::vec3(-INFINITY)};
    for (const std::uint32_t id : wanted) {
        const glm::uvec3 t = triangles[id];
        const glm::vec3 &a = positions[t.x], &b = positions[t.y], &c = positions[t.z];
        const glm::vec3 sum = a + b + c;
        if (!std::isfinite(sum.x) || !std::isfinite(sum.y) || !std::isfinite(sum.z)) continue;
        const glm::vec3 lower = glm::min(a, glm::min(b, c)), upper = glm::max(a, glm::max(b, c));
        primitives.push_back({lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, id});
        all = {glm::min(all.lower, lower), glm::max(all.upper, upper)};
    }
    return primitives;
}

/// Writes a subtree in depth-first order; the child of the larger surface goes first, for it stops more rays.
void flattenTree(const BuildNode* node, const Box& box, int depth, Bvh& bvh) {
    bvh.depth = std::max(bvh.depth, depth);
    const std::size_t index = bvh.nodes.size();
    bvh.nodes.push_back({box.lower, 0, box.upper, 0});
    if (node->count > 0) {
        bvh.nodes[index].leaf = std::uint32_t(bvh.order.size()) << 4 | node->count;
        bvh.order.insert(bvh.order.end(), node->triangles, node->triangles + node->count);
    } else {
        const int first = node->boxes[0].area() >= node->boxes[1].area() ? 0 : 1;
        for (const int child : {first, 1 - first})
            if (node->children[child]) flattenTree(node->children[child], node->boxes[child], depth + 1, bvh);
    }
    bvh.nodes[index].skip = std::uint32_t(bvh.nodes.size());
}

}  // namespace

Bvh buildBvh(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles, const std::vector<std::uint32_t>& wanted) {
    Bvh bvh;
    Box all;
    std::vector<RTCBuildPrimitive> primitives = primitivesOf(positions, triangles, wanted, all);
    if (primitives.empty()) return bvh;
    if (primitives.size() >= std::size_t(1) << 28)
        throw Error(ErrorCode::Input, "the scene has too many triangles for ray tracing", "Use fewer than 268 million.");

    using Device = std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)>;
    using Tree = std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)>;
    const Device device(rtcNewDevice(nullptr), &rtcReleaseDevice);
    const Tree tree(device ? rtcNewBVH(device.get()) : nullptr, &rtcReleaseBVH);
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = kMaxDepth;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = kMaxLeafTriangles;
    arguments.bvh = tree.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = createNode;
    arguments.setNodeChildren = setChildren;
    arguments.setNodeBounds = setBounds;
    arguments.createLeaf = createLeaf;
    const auto* root = tree ? static_cast<const BuildNode*>(rtcBuildBVH(&arguments)) : nullptr;
    if (!root) throw Error(ErrorCode::Environment, "Embree cannot build its tree", "Free some memory or reinstall libembree3.");

    bvh.nodes.reserve(primitives.size());
    bvh.order.reserve(primitives.size());
    flattenTree(root, all, 1, bvh);
    return bvh;
}

}  // namespace ombrage
