// SPDX-License-Identifier: MIT
#include <ombrage/reference.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ombrage/error.h>

#include "reference/reference_impl.h"

namespace ombrage {
double maskedShareOf(const std::vector<Mask>& mask) {
    // Blocks whose counts fit a byte: many at a time.
    std::size_t sky = 0, valid = 0;
    for (std::size_t first = 0; first < mask.size(); first += 255) {
        const std::size_t end = std::min(first + 255, mask.size());
        std::uint8_t skyHere = 0, validHere = 0;
        for (std::size_t i = first; i < end; ++i) {
            skyHere = std::uint8_t(skyHere + (mask[i] == Mask::Sky));
            validHere = std::uint8_t(validHere + (mask[i] == Mask::Valid));
        }
        sky += skyHere;
        valid += validHere;
    }
    const std::size_t seen = mask.size() - sky;
    return seen > 0 ? double(seen - valid) / double(seen) : 0.0;
}

Reference::Reference(const Scene& scene) : m_impl(std::make_unique<Impl>(scene)) {}
Reference::~Reference() = default;

void SurfacePoints::fill(Plane& plane, std::uint32_t triangle) const {
    const glm::uvec3 t = m_flat.triangles[triangle];
    plane.triangle = triangle;
    plane.knowsLeast = false;
    plane.a = glm::dvec3(m_flat.positions[t.x]);
    plane.ab = glm::dvec3(m_flat.positions[t.y]) - plane.a;
    plane.ac = glm::dvec3(m_flat.positions[t.z]) - plane.a;
    const glm::dvec3 n = glm::cross(plane.ab, plane.ac);
    plane.doubleArea = glm::length(n);
    plane.normal = plane.doubleArea > 0 ? n / plane.doubleArea : glm::dvec3(0.0);
}

void SurfacePoints::findLeast(Plane& plane) const {
    // A weight is the distance to the opposite edge over the height on it; at most the middle is reached.
    const glm::dvec3 edges(glm::length(plane.ac - plane.ab), glm::length(plane.ac), glm::length(plane.ab));
    plane.least =
        plane.doubleArea > 0 ? glm::min(edges * (m_inset_m / plane.doubleArea), 1.0 / 3) : glm::dvec3(1.0 / 3);
    plane.knowsLeast = true;
}

SurfacePoint SurfacePoints::at(std::size_t index) {
    turnTo(index);
    SurfacePoint p;
    p.triangle = m_plane->triangle;
    p.instance = m_receivers.instance[index];
    p.position = position();
    p.normal = normal();
    p.shadingNormal = shadingNormal();
    return p;
}

int samplesPerScrambling(int total, int fallback) {
    if (total < 0)
        throw Error(ErrorCode::Usage, "samples per pixel is " + std::to_string(total), "Use 0 for the default.");
    return ((total > 0 ? total : fallback) + kScramblings - 1) / kScramblings;
}

Reference::Estimate combine(const std::array<double, kScramblings>& means) {
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / kScramblings;
    double squares = 0;
    for (double m : means) squares += (m - mean) * (m - mean);
    // Standard error of the mean of independent scramblings.
    return {mean, std::sqrt(squares / (kScramblings - 1) / kScramblings)};
}

std::uint32_t pointSeed(std::uint64_t seed, std::uint32_t stream, std::uint32_t index) {
    const std::uint32_t run = hashCombine(std::uint32_t(seed), std::uint32_t(seed >> 32));
    return hashCombine(hashCombine(run, stream), index);
}

std::vector<bool> shadingInstances(const FlatScene& flat, const Light& light) {
    std::vector<bool> shades(flat.instances.size());
    for (std::size_t i = 0; i < shades.size(); ++i) {
        const int model = flat.instances[i].model;
        shades[i] =
            flat.instances[i].casts && std::count(light.excludedModels.begin(), light.excludedModels.end(), model) == 0;
    }
    return shades;
}

void summarise(const std::vector<Mask>& mask, const std::vector<float>& standardError, double& meanStandardError,
               double& maskedShare) {
    double sum = 0;
    std::size_t valid = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i] == Mask::Valid) {
            sum += double(standardError[i]);
            ++valid;
        }
    meanStandardError = valid > 0 ? sum / double(valid) : 0.0;
    maskedShare = maskedShareOf(mask);
}

void checkReceivers(const Receivers& r) {
    const std::size_t n = std::size_t(std::max(r.width, 0)) * std::size_t(std::max(r.height, 0));
    if (r.instance.size() != n || r.triangle.size() != n || r.barycentric.size() != n || r.normal.size() != n ||
        r.shadingNormal.size() != n)
        throw Error(ErrorCode::Usage, "the receivers' arrays do not match their size",
                    "Make them with Reference::receivers.");
}

void maskDisagreement(std::vector<Mask>& mask, double& maskedShare, const Receivers& receivers,
                      const std::vector<std::uint32_t>& instance, const std::vector<std::uint32_t>& triangle) {
    const std::size_t n = receivers.triangle.size();
    if (mask.size() != n || instance.size() != n || (!triangle.empty() && triangle.size() != n))
        throw Error(ErrorCode::Usage, "the picture's ids and the receivers differ in size");
    for (std::size_t i = 0; i < n; ++i) {
        const bool agree =
            instance[i] == receivers.instance[i] && (triangle.empty() || triangle[i] == receivers.triangle[i]);
        if (mask[i] == Mask::Valid && !agree) mask[i] = Mask::Disagree;
    }
    maskedShare = maskedShareOf(mask);
}

}  // namespace ombrage
