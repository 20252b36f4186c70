// SPDX-License-Identifier: MIT
#include "techniques/ao/baked/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage::baked {

namespace {

/// A block is no wider than the narrowest texture.
constexpr int kMostIntervals = 1023;

/// Shortest and longest edge of a triangle.
struct Extent {
    std::uint8_t first = 0;  ///< corner where the shortest begins
    float shortest_m = 0, longest_m = 0;
};

Extent extentOf(const FlatScene& flat, std::uint32_t triangle) {
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::vec3 corners[3] = {flat.positions[t.x], flat.positions[t.y], flat.positions[t.z]};
    Extent extent{0, std::numeric_limits<float>::infinity(), 0};
    for (int k = 0; k < 3; ++k) {
        const float length_m = glm::distance(corners[k], corners[(k + 1) % 3]);
        // Triangles of lengths that are no numbers have one interval.
        if (!std::isfinite(length_m)) return {};
        extent.longest_m = std::max(extent.longest_m, length_m);
        if (length_m >= extent.shortest_m) continue;
        extent.shortest_m = length_m;
        extent.first = std::uint8_t(k);
    }
    return extent;
}

std::uint16_t intervals(float length_m, float spacing_m) {
    return std::uint16_t(std::clamp(std::ceil(length_m / spacing_m), 1.0f, float(kMostIntervals)));
}

/// How fine blocks are for a number of samples.
class Spacing {
public:
    Spacing(const FlatScene& flat, const std::vector<bool>& hasBack, const std::vector<Extent>& extents)
        : m_flat(flat), m_hasBack(hasBack), m_extents(extents) {}

    std::uint64_t samplesAt(float spacing_m) const {
        std::uint64_t samples = 0;
        for (std::size_t t = 0; t < m_extents.size(); ++t) {
            const std::uint64_t sides = m_hasBack[m_flat.triangleInstance[t]] ? 2 : 1;
            const std::uint64_t across = intervals(m_extents[t].shortest_m, spacing_m);
            const std::uint64_t up = intervals(m_extents[t].longest_m, spacing_m);
            if (across > 1 || up > 1) samples += sides * (across + 1) * (up + 1);
        }
        return samples;
    }

    float forSamples(std::uint64_t samples) const {
        float longest_m = 0;
        for (const Extent& extent : m_extents) longest_m = std::max(longest_m, extent.longest_m);
        if (!(longest_m > 0)) return 1.0f;
        float fine = longest_m / float(kMostIntervals), coarse = longest_m;
        if (samplesAt(fine) <= samples) return fine;
        // Twenty halvings of a factor of a thousand leave a hundred-thousandth.
        for (int step = 0; step < 20; ++step) {
            const float middle = std::sqrt(fine * coarse);
            (samplesAt(middle) > samples ? fine : coarse) = middle;
        }
        return coarse;
    }

private:
    const FlatScene& m_flat;
    const std::vector<bool>& m_hasBack;
    const std::vector<Extent>& m_extents;
};

/// Fills rows of blocks from left to right.
class Shelves {
public:
    explicit Shelves(int width) : m_width(width) {}

    glm::uvec2 place(int width, int height) {
        if (m_x + width > m_width) {
            m_y += m_rowHeight;
            m_x = m_rowHeight = 0;
        }
        m_rowHeight = std::max(m_rowHeight, height);
        const glm::uvec2 at(m_x, m_y);
        m_x += width;
        return at;
    }
    int height() const { return m_y + m_rowHeight; }

private:
    const int m_width;
    int m_x = 0, m_y = 0, m_rowHeight = 0;
};

/// A power of two by which the texture is about as wide as it is high.
int widthFor(std::uint64_t texels, int largest) {
    int width = kMostIntervals + 1;
    while (width * 2 <= largest && std::uint64_t(width) * std::uint64_t(width) < texels) width *= 2;
    return width;
}

void placeBlocks(Layout& layout, const FlatScene& flat, int largest) {
    // Rows of falling height waste little.
    std::vector<std::uint32_t> order(layout.blocks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return layout.blocks[a].up > layout.blocks[b].up; });
    Shelves shelves(layout.width);
    for (const std::uint32_t t : order) {
        Block& block = layout.blocks[t];
        const auto place = [&] { return shelves.place(block.across + 1, block.up + 1); };
        block.place[0] = place();
        block.place[1] = layout.hasBack[flat.triangleInstance[t]] ? place() : block.place[0];
    }
    layout.height = std::max(shelves.height(), 1);
    if (layout.height > largest)
        throw Error(ErrorCode::Environment,
                    fmt::format("the baked occlusion of {} triangles does not fit a texture of {} x {} texels",
                                flat.triangles.size(), largest, largest),
                    "Use fewer texels, a smaller scene or another technique.");
}

}  // namespace

glm::dvec3 weightsOf(const Block& block, int i, int j) {
    const double w2 = double(j) / block.up, w1 = (1 - w2) * double(i) / block.across;
    return {1 - w1 - w2, w1, w2};
}

Layout makeLayout(const FlatScene& flat, std::vector<bool> hasBack, Store store, std::uint64_t samples, int largest) {
    std::vector<Extent> extents(flat.triangles.size());
    for (std::uint32_t t = 0; t < extents.size(); ++t) extents[t] = extentOf(flat, t);
    Layout layout;
    layout.hasBack = std::move(hasBack);
    layout.spacing_m = store == Store::Texel ? Spacing(flat, layout.hasBack, extents).forSamples(samples)
                                             : std::numeric_limits<float>::infinity();

    std::uint64_t texels = 0;
    layout.blocks.resize(flat.triangles.size());
    for (std::size_t t = 0; t < layout.blocks.size(); ++t) {
        Block& block = layout.blocks[t];
        block.first = extents[t].first;
        block.across = intervals(extents[t].shortest_m, layout.spacing_m);
        block.up = intervals(extents[t].longest_m, layout.spacing_m);
        texels += std::uint64_t(block.texels()) * (layout.hasBack[flat.triangleInstance[t]] ? 2 : 1);
    }
    layout.width = widthFor(texels, largest);
    placeBlocks(layout, flat, largest);
    return layout;
}

}  // namespace ombrage::baked
