// SPDX-License-Identifier: MIT
#include <cmath>

#include <ombrage/error.h>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"
#include "scene/camera_view.h"

namespace ombrage {

Receivers Reference::receivers(const Camera& camera, const ReferenceOptions& options) const {
    if (options.width <= 0 || options.height <= 0)
        throw Error(ErrorCode::Usage,
                    "the picture's size is " + std::to_string(options.width) + "x" + std::to_string(options.height),
                    "Use positive sizes.");
    const FlatScene& flat = m_impl->flat;
    const CameraView view = makeCameraView(camera, options.width, options.height, flat.origin, m_impl->bounds);
    const std::size_t count = std::size_t(options.width) * std::size_t(options.height);
    Receivers r;
    r.width = options.width;
    r.height = options.height;
    r.instance.assign(count, kNoHit);
    r.triangle.assign(count, kNoHit);
    r.barycentric.assign(count, glm::vec2(0));
    r.normal.assign(count, glm::vec3(0));
    r.shadingNormal.assign(count, glm::vec3(0));
    r.distance_m.assign(count, std::numeric_limits<float>::infinity());
    r.pixelSize_m.assign(count, 0.0f);

    parallelRows(options.height, options, [&](int y) {
        for (int x = 0; x < options.width; ++x) {
            Ray ray;
            view.ray(x + options.pixelPoint.x, y + options.pixelPoint.y, ray.origin, ray.direction);
            const auto hit = m_impl->rays.nearest(ray);
            if (!hit) continue;

            // The normal of the side seen; a sliver without one faces the viewer.
            const glm::uvec3 t = flat.triangles[hit->triangle];
            const glm::dvec3 a(flat.positions[t.x]), b(flat.positions[t.y]), c(flat.positions[t.z]);
            glm::dvec3 n = glm::cross(b - a, c - a);
            n = glm::dot(n, n) > 0 ? glm::normalize(n) : -ray.direction;
            if (glm::dot(n, ray.direction) > 0) n = -n;

            // The interpolated normal, on the same side.
            glm::dvec3 ns = (1 - hit->u - hit->v) * glm::dvec3(flat.normals[t.x]) +
                            hit->u * glm::dvec3(flat.normals[t.y]) + hit->v * glm::dvec3(flat.normals[t.z]);
            const double length = glm::length(ns);
            ns = std::isfinite(length) && length > 1e-6 ? ns / length : n;
            if (glm::dot(ns, n) < 0) ns = -ns;

            const std::size_t i = std::size_t(y) * std::size_t(options.width) + std::size_t(x);
            r.triangle[i] = hit->triangle;
            r.instance[i] = flat.triangleInstance[hit->triangle];
            r.barycentric[i] = {float(hit->u), float(hit->v)};
            r.normal[i] = n;
            r.shadingNormal[i] = ns;
            r.distance_m[i] = float(hit->distance_m);
            const glm::dvec3 position = ray.origin + ray.direction * hit->distance_m;
            r.pixelSize_m[i] =
                view.pixelSize(float(glm::dot(position - glm::dvec3(view.eye), glm::dvec3(view.forward))));
        }
    });
    return r;
}

}  // namespace ombrage
