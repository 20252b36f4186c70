// SPDX-License-Identifier: MIT
#include "techniques/ao/baked/bake.h"

#include <cmath>
#include <limits>

#include "core/hash.h"
#include "reference/ao_estimator.h"
#include "reference/parallel_rows.h"

namespace ombrage::baked {

namespace {

/// Counts up whenever a bake of the same key would come out differently.
constexpr int kVersion = 1;
constexpr std::uint32_t kSeed = 0x6f626b65u;
constexpr std::uint32_t kNone = 0xffffffffu;
/// Rays that ask whether a point is inside of a solid.
constexpr int kInsideRays = 8;
/// How far values are carried into solids, in texels: a visible point interpolates between its next four.
constexpr int kDilations = 2;

/// A point of a side of a triangle, its weights in the triangle's own order.
struct Place {
    std::uint32_t triangle = 0;
    bool isBack = false;
    glm::dvec3 weights{0.0};
};

/// What is computed once, and which texels show it.
struct Samples {
    std::vector<Place> places;
    std::vector<std::uint32_t> texel;  ///< per texel of the texture the sample, kNone where no block is
};

Place placeOf(const Block& block, std::uint32_t triangle, bool isBack, int i, int j) {
    const glm::dvec3 w = weightsOf(block, i, j);
    Place place{triangle, isBack, {}};
    for (int k = 0; k < 3; ++k) place.weights[(block.first + k) % 3] = w[k];
    return place;
}

/// A sample for each texel of the larger blocks, and for each vertex and side of the others.
Samples samplesOf(const FlatScene& flat, const Layout& layout) {
    Samples samples;
    samples.texel.assign(std::size_t(layout.width) * std::size_t(layout.height), kNone);
    std::vector<std::uint32_t> vertex[2];
    for (auto& ofSide : vertex) ofSide.assign(flat.positions.size(), kNone);
    for (std::uint32_t t = 0; t < layout.blocks.size(); ++t) {
        const Block& block = layout.blocks[t];
        const int sides = layout.hasBack[flat.triangleInstance[t]] ? 2 : 1;
        for (int side = 0; side < sides; ++side)
            for (int j = 0; j <= block.up; ++j)
                for (int i = 0; i <= block.across; ++i) {
                    std::uint32_t own = kNone;
                    std::uint32_t* index = &own;
                    const int corner = (block.first + (j > 0 ? 2 : i)) % 3;
                    if (block.isCoarse()) index = &vertex[side][flat.triangles[t][corner]];
                    if (*index == kNone) {
                        *index = std::uint32_t(samples.places.size());
                        samples.places.push_back(placeOf(block, t, side == 1, i, j));
                    }
                    const glm::uvec2 at = block.place[std::size_t(side)] + glm::uvec2(i, j);
                    samples.texel[std::size_t(at.y) * std::size_t(layout.width) + at.x] = *index;
                }
    }
    return samples;
}

/// The place as the truth sees a receiver there: a rounding error inside of its triangle's edges.
SurfacePoint pointOf(const FlatScene& flat, const Place& place, double inset_m) {
    const glm::uvec3 t = flat.triangles[place.triangle];
    const glm::dvec3 a(flat.positions[t.x]), ab = glm::dvec3(flat.positions[t.y]) - a,
                                             ac = glm::dvec3(flat.positions[t.z]) - a;
    const glm::dvec3 n = glm::cross(ab, ac);
    const double doubleArea = glm::length(n);
    glm::dvec3 least(1.0 / 3);
    if (doubleArea > 0)
        least = glm::min(glm::dvec3(glm::length(ac - ab), glm::length(ac), glm::length(ab)) * (inset_m / doubleArea),
                         1.0 / 3);
    glm::dvec3 w = glm::max(place.weights, least);
    w /= w.x + w.y + w.z;

    SurfacePoint point;
    point.triangle = place.triangle;
    point.instance = flat.triangleInstance[place.triangle];
    point.position = a + ab * w.y + ac * w.z;
    const double side = place.isBack ? -1 : 1;
    point.normal = doubleArea > 0 ? n * (side / doubleArea) : glm::dvec3(0, side, 0);
    glm::dvec3 ns =
        w.x * glm::dvec3(flat.normals[t.x]) + w.y * glm::dvec3(flat.normals[t.y]) + w.z * glm::dvec3(flat.normals[t.z]);
    const double length = glm::length(ns);
    ns = std::isfinite(length) && length > 1e-6 ? ns / length : point.normal;
    point.shadingNormal = glm::dot(ns, point.normal) < 0 ? -ns : ns;
    return point;
}

/// Whether most rays from the point first meet a solid from within.
bool isInside(const RayScene& rays, const FlatScene& flat, const Layout& layout, const SurfacePoint& point) {
    glm::dvec3 t, b;
    basis(point.normal, t, b);
    int inside = 0;
    for (int k = 0; k < kInsideRays; ++k) {
        // Heights of equal steps, each turned by the golden angle.
        const double z = (k + 0.5) / kInsideRays, r = std::sqrt(1 - z * z), azimuth_rad = k * 2.39996322972865332;
        Ray ray;
        ray.origin = point.position;
        ray.direction = (t * std::cos(azimuth_rad) + b * std::sin(azimuth_rad)) * r + point.normal * z;
        ray.ownTriangle = point.triangle;
        const auto hit = rays.nearest(ray);
        if (!hit || layout.hasBack[flat.triangleInstance[hit->triangle]]) continue;
        const glm::uvec3 v = flat.triangles[hit->triangle];
        const glm::vec3 a = flat.positions[v.x];
        const glm::vec3 n = glm::cross(flat.positions[v.y] - a, flat.positions[v.z] - a);
        inside += glm::dot(glm::dvec3(n), ray.direction) > 0 ? 1 : 0;
    }
    return 2 * inside > kInsideRays;
}

struct Values {
    std::vector<float> visibility;
    std::vector<std::uint8_t> isKnown;
};

Values estimate(const Scene& scene, const FlatScene& flat, const Layout& layout, const Samples& samples,
                const BakeOptions& options) {
    const RayScene rays(scene, flat);
    AoQuestion question;
    question.kind = TruthKind::T1;
    question.radius_m = options.radius_m;
    const SampleSets sets(kSeed, samplesPerScrambling(options.samples, kAoSamples));
    const AoEstimator estimator(rays, flat, question, sets);
    const double inset_m = rays.positionError_m(0);

    // Rows of samples for the cores to share.
    constexpr std::size_t kRow = 256;
    const std::size_t count = samples.places.size();
    Values values{std::vector<float>(count, 1.0f), std::vector<std::uint8_t>(count, 1)};
    parallelRows(int((count + kRow - 1) / kRow), {}, [&](int row) {
        const std::size_t first = std::size_t(row) * kRow;
        for (std::size_t i = first; i < std::min(first + kRow, count); ++i) {
            const SurfacePoint point = pointOf(flat, samples.places[i], inset_m);
            // Triangles with corners that are no numbers have no place to look from.
            const glm::dvec3 sum = point.position + point.normal + point.shadingNormal;
            if (!std::isfinite(sum.x + sum.y + sum.z)) continue;
            values.visibility[i] = float(estimator.at(point, hashCombine(kSeed, std::uint32_t(i))).mean);
            if (options.dilate) values.isKnown[i] = isInside(rays, flat, layout, point) ? 0 : 1;
        }
    });
    return values;
}

/// Carries values one texel into what is not known, within each block.
void dilate(const FlatScene& flat, const Layout& layout, const Samples& samples, Values& values) {
    // Means of the neighbours of each unknown sample; a vertex has those of all its small triangles.
    std::vector<std::pair<float, int>> around(values.visibility.size(), {0.0f, 0});
    for (std::size_t t = 0; t < layout.blocks.size(); ++t) {
        const Block& block = layout.blocks[t];
        const int sides = layout.hasBack[flat.triangleInstance[t]] ? 2 : 1;
        for (int side = 0; side < sides; ++side) {
            const auto sampleAt = [&](int i, int j) {
                const glm::uvec2 at = block.place[std::size_t(side)] + glm::uvec2(i, j);
                return samples.texel[std::size_t(at.y) * std::size_t(layout.width) + at.x];
            };
            for (int j = 0; j <= block.up; ++j)
                for (int i = 0; i <= block.across; ++i) {
                    const std::uint32_t own = sampleAt(i, j);
                    if (values.isKnown[own]) continue;
                    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, int(block.up)); ++y)
                        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, int(block.across)); ++x) {
                            const std::uint32_t other = sampleAt(x, y);
                            if (!values.isKnown[other]) continue;
                            around[own].first += values.visibility[other];
                            ++around[own].second;
                        }
                }
        }
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
        if (around[i].second == 0) continue;
        values.visibility[i] = around[i].first / float(around[i].second);
        values.isKnown[i] = 1;
    }
}

}  // namespace

std::vector<float> bake(const Scene& scene, const FlatScene& flat, const Layout& layout, const BakeOptions& options) {
    const Samples samples = samplesOf(flat, layout);
    Values values = estimate(scene, flat, layout, samples, options);
    for (int pass = 0; options.dilate && pass < kDilations; ++pass) dilate(flat, layout, samples, values);
    std::vector<float> texels(samples.texel.size(), 1.0f);
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (samples.texel[i] != kNone) texels[i] = values.visibility[samples.texel[i]];
    return texels;
}

std::string bakeKey(const Scene& scene, const FlatScene& flat, const Layout& layout, const BakeOptions& options) {
    Hasher hasher;
    hasher.value(kVersion);
    hasher.value(options.radius_m);
    hasher.value(options.samples);
    hasher.value(options.dilate);
    hasher.value(layout.spacing_m);
    hasher.value(layout.width);
    hasher.array(flat.positions);
    hasher.array(flat.normals);
    hasher.array(flat.triangles);
    for (std::size_t i = 0; i < flat.instances.size(); ++i) {
        const FlatInstance& instance = flat.instances[i];
        hasher.value(instance.firstTriangle);
        hasher.value(bool(layout.hasBack[i]));
        const Material& material = scene.materials[std::size_t(instance.material)];
        if (material.alphaMode != AlphaMode::Mask) continue;
        // Holes let rays through.
        hasher.value(material.alpha);
        hasher.value(material.alphaCutoff);
        for (std::uint32_t v = 0; v < instance.vertexCount; ++v) {
            hasher.value(flat.uvs[instance.firstVertex + v].x);
            hasher.value(flat.uvs[instance.firstVertex + v].y);
        }
        if (material.baseColorTexture < 0) continue;
        const Texture& texture = scene.textures[std::size_t(material.baseColorTexture)];
        hasher.value(texture.width);
        hasher.array(texture.rgba);
    }
    return hasher.hex();
}

}  // namespace ombrage::baked
