// SPDX-License-Identifier: MIT
#include "scene/framing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <glm/gtc/constants.hpp>

#include "core/strings.h"
#include "scene/mesh_build.h"
#include "scene/shapes.h"

namespace ombrage {

namespace {
constexpr double kFov_deg = 50.0;
constexpr double kAzimuth_deg = 35.0;
constexpr double kElevation_deg = 20.0;
constexpr double kFilledShare = 0.9;
constexpr double kInteriorShare = 0.2;
constexpr int kRayCount = 64;
constexpr int kInteriorRays =
    58;  ///< of 64: windows, doors and a roof light may let some out; an open front lets 10 out
constexpr double kGroundGap = 1e-3;  // share of the diagonal
constexpr float kSunIntensity_lx = 3.0f;
constexpr double kTooBright_lx = 30.0;

/// Unit vectors as one array per axis, so that the compiler tests several rays at once.
struct Rays {
    std::array<float, kRayCount> x, y, z;
};

/// Points spread evenly over the unit sphere (a Fibonacci lattice).
Rays raysEverywhere() {
    Rays rays;
    const double golden_rad = glm::pi<double>() * (3.0 - std::sqrt(5.0));
    for (std::size_t i = 0; i < kRayCount; ++i) {
        const double y = 1.0 - (2.0 * double(i) + 1.0) / kRayCount, radius = std::sqrt(1.0 - y * y);
        rays.x[i] = float(radius * std::cos(golden_rad * double(i)));
        rays.y[i] = float(y);
        rays.z[i] = float(radius * std::sin(golden_rad * double(i)));
    }
    return rays;
}

/// Nearest hit of each ray so far: its distance, and the cosine-like slope at which it met the face (negative: in
/// front).
struct Hits {
    std::array<float, kRayCount> distance, slope;
    Hits() {
        distance.fill(std::numeric_limits<float>::infinity());
        slope.fill(0.0f);
    }
    void add(const Hits& other) {
        for (std::size_t i = 0; i < kRayCount; ++i)
            if (other.distance[i] < distance[i]) distance[i] = other.distance[i], slope[i] = other.slope[i];
    }
};

/// Tests a triangle against every ray from the origin (Moeller and Trumbore 1997 with the start at zero). A ray in the
/// plane of the triangle gives NaN or infinity, and fails the comparisons.
void hitAll(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Rays& rays, Hits& hits) {
    const glm::vec3 e1 = b - a, e2 = c - a;
    const glm::vec3 n = glm::cross(e1, e2), q = glm::cross(-a, e1), r = glm::cross(-a, e2);
    const float height = glm::dot(a, n);
    for (std::size_t i = 0; i < kRayCount; ++i) {
        const float slope = rays.x[i] * n.x + rays.y[i] * n.y + rays.z[i] * n.z;
        const float inverse = 1.0f / slope;
        const float u = (rays.x[i] * r.x + rays.y[i] * r.y + rays.z[i] * r.z) * inverse;
        const float v = -(rays.x[i] * q.x + rays.y[i] * q.y + rays.z[i] * q.z) * inverse;
        const float t = height * inverse;
        const bool hit = (t > 0.0f) & (t < hits.distance[i]) & (u >= 0.0f) & (v >= 0.0f) & (u + v <= 1.0f);
        hits.distance[i] = hit ? t : hits.distance[i];
        hits.slope[i] = hit ? slope : hits.slope[i];
    }
}
}  // namespace

bool isInterior(const Scene& scene) {
    const Bounds bounds = scene.bounds();
    if (bounds.empty()) return false;
    const glm::dvec3 center = bounds.center();
    const Rays rays = raysEverywhere();
    Hits hits;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        // Leaves and glass do not make a room.
        if (scene.materials[std::size_t(mesh.material)].alphaMode != AlphaMode::Opaque) continue;
        const bool mirrored = glm::determinant(glm::dmat3(instance.worldFromLocal)) < 0.0;
        std::vector<glm::vec3> positions;
        positions.reserve(mesh.positions.size());
        for (const glm::vec3& p : mesh.positions)
            positions.emplace_back(glm::dvec3(instance.worldFromLocal * glm::dvec4(p, 1.0)) - center);
        hits.add(tbb::parallel_reduce(
            tbb::blocked_range<std::size_t>(0, mesh.triangleCount(), 4096), Hits(),
            [&](const tbb::blocked_range<std::size_t>& range, Hits found) {
                for (std::size_t f = range.begin(); f < range.end(); ++f) {
                    const std::uint32_t* index = &mesh.indices[3 * f];
                    const glm::vec3 &b = positions[index[mirrored ? 2 : 1]], &c = positions[index[mirrored ? 1 : 2]];
                    hitAll(positions[index[0]], b, c, rays, found);
                }
                return found;
            },
            [](Hits a, const Hits& b) {
                a.add(b);
                return a;
            }));
    }
    return std::count_if(hits.slope.begin(), hits.slope.end(), [](float slope) { return slope < 0.0f; }) >=
           kInteriorRays;
}

Camera framedCamera(const Scene& scene) {
    Camera camera;
    camera.name = "main";
    camera.fovY_rad = float(glm::radians(kFov_deg));
    const Bounds bounds = scene.bounds();
    const glm::dvec3 center = bounds.center(), extent = bounds.upper - bounds.lower;
    camera.target = center;
    if (isInterior(scene)) {
        const int axis = extent.x >= extent.z ? 0 : 2;
        camera.position = center;
        camera.position[axis] = bounds.lower[axis] + kInteriorShare * extent[axis];
        return camera;
    }
    // The sphere about the centre of the bounds that holds every vertex.
    double radius2 = 0.0;
    for (const Instance& instance : scene.instances)
        for (const glm::vec3& p : scene.meshes[std::size_t(instance.mesh)].positions) {
            const glm::dvec3 arm = glm::dvec3(instance.worldFromLocal * glm::dvec4(p, 1.0)) - center;
            radius2 = std::max(radius2, glm::dot(arm, arm));
        }
    // Seen from distance d the sphere's outline stands at an angle whose sine is radius / d.
    const double outline_rad = std::atan(kFilledShare * std::tan(glm::radians(0.5 * kFov_deg)));
    const double distance = std::sqrt(radius2) / std::sin(outline_rad);
    const double azimuth = glm::radians(kAzimuth_deg), elevation = glm::radians(kElevation_deg);
    camera.position = center + distance * glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                                     std::cos(azimuth) * std::cos(elevation));
    return camera;
}

Light defaultSun() {
    Light light;
    light.name = "sun";
    light.type = LightType::Sun;
    light.direction = glm::vec3(glm::normalize(glm::dvec3(-1.0, -2.0, -0.7)));
    light.intensity = kSunIntensity_lx;
    return light;
}

/// Whether a surface that can be seen from above, or one that is flat as a whole, lies in the plane y = lowest_m.
bool liesOn(const Scene& scene, double lowest_m, double tolerance_m) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        std::vector<glm::dvec3> positions;
        positions.reserve(mesh.positions.size());
        for (const glm::vec3& p : mesh.positions) positions.emplace_back(instance.worldFromLocal * glm::dvec4(p, 1.0));
        const auto isLow = [&](const glm::dvec3& p) { return p.y - lowest_m <= tolerance_m; };
        if (!positions.empty() && std::all_of(positions.begin(), positions.end(), isLow)) return true;

        const double side = glm::determinant(glm::dmat3(instance.worldFromLocal)) < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 &a = positions[mesh.indices[i]], &b = positions[mesh.indices[i + 1]],
                             &c = positions[mesh.indices[i + 2]];
            if (isLow(a) && isLow(b) && isLow(c) && side * glm::cross(b - a, c - a).y > 0.0) return true;
        }
    }
    return false;
}

void addGround(Scene& scene) {
    const Bounds bounds = scene.bounds();
    // Two surfaces in one plane would flicker through each other.
    const double gap_m = liesOn(scene, bounds.lower.y, 1e-6 * bounds.diagonal()) ? kGroundGap * bounds.diagonal() : 0.0;
    const float size = float(4.0 * bounds.diagonal());
    Material material;
    material.name = "ground";
    material.baseColor = glm::vec3(0.5f);
    scene.materials.push_back(material);
    Mesh mesh = shapes::floor(size);
    mesh.name = "ground";
    mesh.material = int(scene.materials.size()) - 1;
    makeTangents(mesh);
    scene.meshes.push_back(std::move(mesh));
    scene.models.push_back({.name = "ground"});
    Instance instance;
    instance.mesh = int(scene.meshes.size()) - 1;
    instance.model = int(scene.models.size()) - 1;
    instance.worldFromLocal[3] = glm::dvec4(bounds.center().x, bounds.lower.y - gap_m, bounds.center().z, 1.0);
    scene.instances.push_back(instance);
}

void tameBrightLights(Scene& scene) {
    // Illuminance that each light would give a surface facing it at the centre of the scene.
    const Bounds bounds = scene.bounds();
    double total_lx = 0.0;
    for (const Light& light : scene.lights) {
        const glm::dvec3 arm = light.position - bounds.center();
        const double distance2 = std::max(glm::dot(arm, arm), 1e-4);
        const double color = std::max({light.color.x, light.color.y, light.color.z});
        const double area = light.type == LightType::Rect ? double(light.size_m.x) * double(light.size_m.y) : 1.0;
        total_lx += double(light.intensity) * color * area / (light.type == LightType::Sun ? 1.0 : distance2);
    }
    if (!(total_lx > kTooBright_lx)) return;
    const float factor = float(double(kSunIntensity_lx) / total_lx);
    for (Light& light : scene.lights) light.intensity *= factor;
    scene.warnings.push_back("the file's lights are scaled by " + formatNumber(double(factor)) +
                             ", so that together they give 3 lx at the centre: pictures have no exposure control");
}

}  // namespace ombrage
