// SPDX-License-Identifier: MIT
#include "render/standard_views.h"

#include <cmath>
#include <limits>

#include <glm/gtc/packing.hpp>

namespace ombrage {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Distance along the view axis, infinite for the sky.
Image viewDepth(const GBuffer& gbuffer, const CameraView& view) {
    Image depth = readDepth(gbuffer.depth);
    for (float& d : depth.plane(0)) {
        if (d <= 0)
            d = kInfinity;
        else
            d = view.orthographic ? view.far_m - d * (view.far_m - view.near_m) : view.near_m / d;
    }
    return depth;
}

/// The inverse of ombrage/octahedral.glsl.
glm::vec3 unitFromOctahedral(std::uint32_t word) {
    const glm::vec2 o = glm::unpackSnorm2x16(word);
    glm::vec3 n(o, 1 - std::abs(o.x) - std::abs(o.y));
    const float t = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -t : t;
    n.y += n.y >= 0 ? -t : t;
    return glm::normalize(n);
}

/// The words of the surface plane, with triangle kNoHit for the sky.
std::vector<std::uint32_t> readSurface(const GBuffer& gbuffer) {
    auto words = readWords(gbuffer.surface);
    const Image depth = readDepth(gbuffer.depth);
    for (std::size_t i = 0; i < depth.pixelCount(); ++i)
        if (depth.plane(0)[i] <= 0) words[4 * i + 3] = kNoHit;
    return words;
}

ShownImage normals(const GBuffer& gbuffer, bool shading) {
    const auto words = readSurface(gbuffer);
    const int width = gbuffer.layout.width, height = gbuffer.layout.height;
    ShownImage shown{Image(width, height, {"X", "Y", "Z"}), Image::rgb(width, height, ColorSpace::Data)};
    for (std::size_t i = 0; i < shown.raw.pixelCount(); ++i) {
        if (words[4 * i + 3] == kNoHit) continue;
        const glm::vec3 n = unitFromOctahedral(words[4 * i + (shading ? 1 : 0)]);
        for (int c = 0; c < 3; ++c) {
            shown.raw.plane(c)[i] = n[c];
            shown.display.plane(c)[i] = n[c] * 0.5f + 0.5f;
        }
    }
    return shown;
}

ShownImage albedo(const GBuffer& gbuffer) {
    const auto words = readSurface(gbuffer);
    Image image = Image::rgb(gbuffer.layout.width, gbuffer.layout.height);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        // The inverse of ombrage/surface.glsl.
        if (words[4 * i + 3] == kNoHit) continue;
        const std::uint32_t word = words[4 * i + 2];
        const glm::vec3 root = glm::vec3(word & 2047u, (word >> 11) & 2047u, word >> 22) / glm::vec3(2047, 2047, 1023);
        for (int c = 0; c < 3; ++c) image.plane(c)[i] = root[c] * root[c];
    }
    return {image, image};
}

ShownImage material(const GBuffer& gbuffer) {
    const auto words = readWords(gbuffer.material);
    const Image depth = readDepth(gbuffer.depth);
    Image image(gbuffer.layout.width, gbuffer.layout.height, {"R", "G", "B"}, ColorSpace::Data);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        // The sky's was never written.
        if (depth.plane(0)[i] <= 0) continue;
        const glm::vec4 values = glm::unpackUnorm4x8(words[i]);
        for (int c = 0; c < 3; ++c) image.plane(c)[i] = values[c];
    }
    return {image, image};
}

ShownImage positions(const GBuffer& gbuffer, const CameraView& view, const glm::dvec3& origin) {
    const Image depth = viewDepth(gbuffer, view);
    Image raw(depth.width(), depth.height(), {"X", "Y", "Z"});
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x) {
            const float d = depth.at(0, x, y);
            glm::dvec3 start, direction;
            view.ray(x + 0.5, y + 0.5, start, direction);
            const double along = glm::dot(direction, glm::dvec3(view.forward));
            const double startDepth = glm::dot(start - glm::dvec3(view.eye), glm::dvec3(view.forward));
            const glm::dvec3 p = origin + start + direction * ((double(d) - startDepth) / along);
            for (int c = 0; c < 3; ++c) raw.at(c, x, y) = std::isfinite(d) ? float(p[c]) : kInfinity;
        }
    return {raw, stretched(raw, kInfinity)};
}

/// A colour per id, spread by a multiplicative hash.
ShownImage ids(const GBuffer& gbuffer, const std::vector<std::uint32_t>& values) {
    ShownImage shown{Image::grey(gbuffer.layout.width, gbuffer.layout.height, "id"),
                     Image::rgb(gbuffer.layout.width, gbuffer.layout.height, ColorSpace::Data)};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool sky = values[i] == kNoHit;
        shown.raw.plane(0)[i] = sky ? -1.0f : float(values[i]);
        const std::uint32_t hash = (values[i] + 1) * 2654435761u;
        for (int c = 0; c < 3; ++c)
            shown.display.plane(c)[i] = sky ? 0.0f : float((hash >> (8 * c + 4)) & 0xffu) / 255.0f;
    }
    return shown;
}

}  // namespace

const std::vector<PassInfo>& standardGBufferViews() {
    static const std::vector<PassInfo> views = {{"depth", "distance along the view axis in metres"},
                                                {"normal", "shading normal"},
                                                {"geometric-normal", "normal of the triangle, towards the eye"},
                                                {"position", "world position in metres"},
                                                {"albedo", "base colour"},
                                                {"material", "metallic, roughness, specular"},
                                                {"instance", "instance ids in colours"},
                                                {"triangle", "triangle ids in colours"}};
    return views;
}

void readIds(const GBuffer& gbuffer, const FlatScene& flat, std::vector<std::uint32_t>& instance,
             std::vector<std::uint32_t>& triangle) {
    const auto words = readSurface(gbuffer);
    triangle.resize(words.size() / 4);
    instance.resize(triangle.size());
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        triangle[i] = words[4 * i + 3];
        instance[i] = triangle[i] == kNoHit ? kNoHit : flat.triangleInstance[triangle[i]];
    }
}

ShownImage showGBuffer(const std::string& name, const GBuffer& gbuffer, const CameraView& view, const FlatScene& flat) {
    if (name == "depth") {
        const Image depth = viewDepth(gbuffer, view);
        return {depth, stretched(depth, kInfinity)};
    }
    if (name == "normal") return normals(gbuffer, true);
    if (name == "geometric-normal") return normals(gbuffer, false);
    if (name == "position") return positions(gbuffer, view, flat.origin);
    if (name == "albedo") return albedo(gbuffer);
    if (name == "material") return material(gbuffer);
    std::vector<std::uint32_t> instance, triangle;
    readIds(gbuffer, flat, instance, triangle);
    return ids(gbuffer, name == "triangle" ? triangle : instance);
}

}  // namespace ombrage
