// SPDX-License-Identifier: MIT
#include "render/standard_views.h"

#include <cmath>
#include <limits>

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

ShownImage normals(const GBuffer& gbuffer, bool shading) {
    const Image packed = readColor(gbuffer.normals, {"x", "y", "z", "w"}, ColorSpace::Data);
    ShownImage shown{Image(packed.width(), packed.height(), {"X", "Y", "Z"}), Image::rgb(packed.width(), packed.height(), ColorSpace::Data)};
    const int first = shading ? 2 : 0;
    for (std::size_t i = 0; i < packed.pixelCount(); ++i) {
        // The inverse of ombrage/octahedral.glsl.
        const float x = packed.plane(first)[i] * 2 - 1, y = packed.plane(first + 1)[i] * 2 - 1;
        glm::vec3 n(x, y, 1 - std::abs(x) - std::abs(y));
        const float t = std::max(-n.z, 0.0f);
        n.x += n.x >= 0 ? -t : t;
        n.y += n.y >= 0 ? -t : t;
        n = glm::normalize(n);
        for (int c = 0; c < 3; ++c) {
            shown.raw.plane(c)[i] = n[c];
            shown.display.plane(c)[i] = n[c] * 0.5f + 0.5f;
        }
    }
    return shown;
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
ShownImage ids(const GBuffer& gbuffer, bool triangles) {
    std::vector<std::uint32_t> instance, triangle;
    readIds(gbuffer.ids, instance, triangle);
    const auto& values = triangles ? triangle : instance;
    const int width = gbuffer.ids.width(), height = gbuffer.ids.height();
    ShownImage shown{Image::grey(width, height, "id"), Image::rgb(width, height, ColorSpace::Data)};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool sky = values[i] == kNoHit;
        shown.raw.plane(0)[i] = sky ? -1.0f : float(values[i]);
        const std::uint32_t hash = (values[i] + 1) * 2654435761u;
        for (int c = 0; c < 3; ++c) shown.display.plane(c)[i] = sky ? 0.0f : float((hash >> (8 * c + 4)) & 0xffu) / 255.0f;
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

ShownImage showGBuffer(const std::string& name, const GBuffer& gbuffer, const CameraView& view, const glm::dvec3& origin) {
    if (name == "depth") {
        const Image depth = viewDepth(gbuffer, view);
        return {depth, stretched(depth, kInfinity)};
    }
    if (name == "normal") return normals(gbuffer, true);
    if (name == "geometric-normal") return normals(gbuffer, false);
    if (name == "position") return positions(gbuffer, view, origin);
    if (name == "albedo") return showTexture(gbuffer.albedo, ShowAs::Color);
    if (name == "material") {
        const Image raw = readColor(gbuffer.material, {"R", "G", "B"}, ColorSpace::Data);
        return {raw, raw};
    }
    return ids(gbuffer, name == "triangle");
}

}  // namespace ombrage
