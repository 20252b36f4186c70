// SPDX-License-Identifier: MIT
#include "reference/ray_scene.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include <embree3/rtcore.h>

#include <ombrage/error.h>

namespace ombrage {
namespace {

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, SceneRelease>;

/// What the filter must know of one ray. Embree hands the base back, so it comes first.
struct RayContext {
    RTCIntersectContext base;
    const Scene* scene;
    const FlatScene* flat;
    const Ray* ray;
    float recheckBelow_m;
};

/// Whether the ray meets the triangle farther than `onPlane_m` away, in double precision from vertices as they are.
bool meetsBeyond(const FlatScene& flat, std::uint32_t triangle, const Ray& ray, double onPlane_m) {
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::dvec3 a(flat.positions[t.x]), b(flat.positions[t.y]), c(flat.positions[t.z]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double distance_m = glm::dot(n, a - ray.origin) / glm::dot(n, ray.direction);
    if (!(distance_m > onPlane_m)) return false;
    // Inside to a billionth of its heights: beside a convex edge the neighbour's plane is met outside the neighbour.
    const glm::dvec3 p = ray.origin + ray.direction * distance_m;
    const double least = std::min({glm::dot(n, glm::cross(c - b, p - b)), glm::dot(n, glm::cross(a - c, p - c)),
                                   glm::dot(n, glm::cross(b - a, p - a))});
    return least >= -1e-9 * glm::dot(n, n);
}

/// Takes one hit away from the ray when it does not count.
void filterHit(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& context = *reinterpret_cast<const RayContext*>(args->context);
    const FlatScene& flat = *context.flat;
    const std::uint32_t triangle = RTCHitN_primID(args->hit, args->N, 0);

    // The receiver's own triangle, and instances that this ray does not see.
    const std::uint32_t instance = flat.triangleInstance[triangle];
    if (triangle == context.ray->ownTriangle || (context.ray->instances && !(*context.ray->instances)[instance])) {
        args->valid[0] = 0;
        return;
    }

    // Holes of cut-out materials.
    const Material& material = context.scene->materials[std::size_t(flat.instances[instance].material)];
    if (material.alphaMode == AlphaMode::Mask) {
        const glm::uvec3 t = flat.triangles[triangle];
        const float u = RTCHitN_u(args->hit, args->N, 0), v = RTCHitN_v(args->hit, args->N, 0);
        const glm::vec2 uv = (1 - u - v) * flat.uvs[t.x] + u * flat.uvs[t.y] + v * flat.uvs[t.z];
        if (isHole(*context.scene, material, uv)) {
            args->valid[0] = 0;
            return;
        }
    }

    // The float origin may lie a rounding error behind its surface and then meets the neighbours in the same plane.
    // A second look in double tells them from a true blocker, however near that is.
    if (RTCRayN_tfar(args->ray, args->N, 0) < context.recheckBelow_m) {
        const double onPlane = double(context.recheckBelow_m) * 1e-9;
        if (!meetsBeyond(flat, triangle, *context.ray, onPlane)) args->valid[0] = 0;
    }
}

void setRay(RTCRay& to, const Ray& from) {
    to.org_x = float(from.origin.x);
    to.org_y = float(from.origin.y);
    to.org_z = float(from.origin.z);
    to.dir_x = float(from.direction.x);
    to.dir_y = float(from.direction.y);
    to.dir_z = float(from.direction.z);
    to.tnear = 0;
    to.tfar = float(from.length_m);
    to.time = 0;
    to.mask = 0xffffffffu;
    to.id = 0;
    to.flags = 0;
}

}  // namespace

struct RayScene::Impl {
    Impl(const Scene& s, const FlatScene& f) : scene(s), flat(f) {}

    RayContext context(const Ray& ray) const {
        RayContext c;
        rtcInitIntersectContext(&c.base);
        c.base.filter = filterHit;
        c.scene = &scene;
        c.flat = &flat;
        c.ray = &ray;
        // A rounding error of extent * 2^-24 across the surface is up to 50 times as long along a grazing ray; with a
        // margin of 16.
        c.recheckBelow_m = extent_m * FLT_EPSILON * 800;
        return c;
    }

    const Scene& scene;
    const FlatScene& flat;
    float extent_m = 0;  ///< largest absolute coordinate
    Device device;
    EmbreeScene embree;
};

RayScene::RayScene(const Scene& scene, const FlatScene& flat) : m_impl(std::make_unique<Impl>(scene, flat)) {
    const auto fail = [](const char* what) {
        throw Error(ErrorCode::Environment, std::string("Embree ") + what, "Free some memory or reinstall libembree3.");
    };
    m_impl->device.reset(rtcNewDevice(nullptr));
    if (!m_impl->device) fail("cannot start");
    m_impl->embree.reset(rtcNewScene(m_impl->device.get()));
    rtcSetSceneFlags(m_impl->embree.get(),
                     RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcSetSceneBuildQuality(m_impl->embree.get(), RTC_BUILD_QUALITY_HIGH);

    if (!flat.triangles.empty()) {
        // All triangles are one geometry, so that Embree's primitive is the global triangle id.
        RTCGeometry geometry = rtcNewGeometry(m_impl->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(glm::vec3), flat.positions.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(glm::uvec3), flat.triangles.size());
        if (!vertices || !indices) {
            rtcReleaseGeometry(geometry);
            fail("has no memory for the scene");
        }
        std::memcpy(vertices, flat.positions.data(), flat.positions.size() * sizeof(glm::vec3));
        std::memcpy(indices, flat.triangles.data(), flat.triangles.size() * sizeof(glm::uvec3));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_impl->embree.get(), geometry);
        rtcReleaseGeometry(geometry);
        for (const glm::vec3& p : flat.positions)
            for (int axis = 0; axis < 3; ++axis)
                if (std::isfinite(p[axis])) m_impl->extent_m = std::max(m_impl->extent_m, std::abs(p[axis]));
    }
    rtcCommitScene(m_impl->embree.get());
    if (rtcGetDeviceError(m_impl->device.get()) != RTC_ERROR_NONE) fail("cannot build its tree");
}

RayScene::~RayScene() = default;

bool RayScene::occluded(const Ray& ray) const {
    RayContext context = m_impl->context(ray);
    RTCRay r;
    setRay(r, ray);
    rtcOccluded1(m_impl->embree.get(), &context.base, &r);
    return r.tfar < 0;
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
    RayContext context = m_impl->context(ray);
    RTCRayHit r;
    setRay(r.ray, ray);
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_impl->embree.get(), &context.base, &r);
    if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    // Distance and barycentrics once more in double (Moeller and Trumbore 1997): Embree's come from the rounded ray.
    const glm::uvec3 t = m_impl->flat.triangles[r.hit.primID];
    const glm::dvec3 a(m_impl->flat.positions[t.x]);
    const glm::dvec3 ab = glm::dvec3(m_impl->flat.positions[t.y]) - a, ac = glm::dvec3(m_impl->flat.positions[t.z]) - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac), fromA = ray.origin - a, q = glm::cross(fromA, ab);
    const double determinant = glm::dot(ab, p);
    RayHit hit{r.hit.primID, r.hit.u, r.hit.v, r.ray.tfar};
    if (determinant != 0) {
        // A ray along the edge may leave the triangle by the rounding that Embree's robust test allows: back onto it.
        hit.u = std::clamp(glm::dot(fromA, p) / determinant, 0.0, 1.0);
        hit.v = std::clamp(glm::dot(ray.direction, q) / determinant, 0.0, 1.0 - hit.u);
        hit.distance_m = glm::dot(ac, q) / determinant;
    }
    return hit;
}

double RayScene::positionError_m(double distance_m) const {
    return 4.0 * FLT_EPSILON * (double(m_impl->extent_m) + (std::isfinite(distance_m) ? distance_m : 0.0));
}

bool isHole(const Scene& scene, const Material& material, glm::vec2 uv) {
    float alpha = material.alpha;
    if (material.baseColorTexture >= 0) {
        const Texture& texture = scene.textures[std::size_t(material.baseColorTexture)];
        // Nearest texel, repeated, as GL_NEAREST and GL_REPEAT at level 0 take it.
        const auto texel = [](float coordinate, int size) {
            const float wrapped = coordinate - std::floor(coordinate);
            return std::min(int(wrapped * float(size)), size - 1);
        };
        if (texture.width > 0 && texture.height > 0 && std::isfinite(uv.x) && std::isfinite(uv.y)) {
            const std::size_t index = std::size_t(texel(uv.y, texture.height)) * std::size_t(texture.width) +
                                      std::size_t(texel(uv.x, texture.width));
            alpha *= float(texture.rgba[index * 4 + 3]) / 255.0f;
        }
    }
    return alpha < material.alphaCutoff;
}

}  // namespace ombrage
