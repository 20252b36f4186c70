// SPDX-License-Identifier: MIT
#include "reference/ray_scene.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include <ombrage/error.h>

#include "reference/ray_filters.h"

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

/// Rays of a packet; lanes beyond `count` keep their `valid` of 0.
void setRays(RTCRay16& packet, const Ray* rays, int count, int* valid) {
    for (int i = 0; i < count; ++i) {
        valid[i] = -1;
        packet.org_x[i] = float(rays[i].origin.x);
        packet.org_y[i] = float(rays[i].origin.y);
        packet.org_z[i] = float(rays[i].origin.z);
        packet.dir_x[i] = float(rays[i].direction.x);
        packet.dir_y[i] = float(rays[i].direction.y);
        packet.dir_z[i] = float(rays[i].direction.z);
        packet.tfar[i] = float(rays[i].length_m);
        packet.mask[i] = 0xffffffffu;
        packet.id[i] = unsigned(i);
    }
}

/// Below this cosine to its own plane a ray may leave the float origin's side of it later than the second look covers.
constexpr float kGrazing = 2e-3f;

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

    /// A context whose filter knows the rays; without any, only the holes of cut-out materials are looked for.
    RayContext context(const Ray* rays) const {
        RayContext c{};
        rtcInitIntersectContext(&c.base);
        if (rays) c.base.filter = filterHits;
        c.scene = &scene;
        c.flat = &flat;
        c.triangles = triangles.data();
        c.rays = rays;
        c.recheckBelow_m = recheckBelow_m;
        return c;
    }

    /// Adds the triangles of the ids as the next geometry. False without memory.
    bool attach(std::vector<std::uint32_t> ids, RTCFilterFunctionN filter);

    /// The hit with distance and barycentrics once more in double: Embree's come from the rounded ray.
    RayHit refined(const Ray& ray, RayHit hit) const;

    const Scene& scene;
    const FlatScene& flat;
    std::array<std::vector<std::uint32_t>, 2> ids;    ///< global ids of each geometry's triangles
    std::array<const std::uint32_t*, 2> triangles{};  ///< the same as the filters see them
    float extent_m = 0;                               ///< largest absolute coordinate
    float recheckBelow_m = 0;
    Device device;
    EmbreeScene embree;
};

inline RayHit RayScene::Impl::refined(const Ray& ray, RayHit hit) const {
    // Moeller and Trumbore 1997.
    const glm::uvec3 t = flat.triangles[hit.triangle];
    const glm::dvec3 a(flat.positions[t.x]);
    const glm::dvec3 ab = glm::dvec3(flat.positions[t.y]) - a, ac = glm::dvec3(flat.positions[t.z]) - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac), fromA = ray.origin - a, q = glm::cross(fromA, ab);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return hit;
    // A ray along the edge may leave the triangle by the rounding that Embree's robust test allows: back onto it.
    hit.u = std::clamp(glm::dot(fromA, p) / determinant, 0.0, 1.0);
    hit.v = std::clamp(glm::dot(ray.direction, q) / determinant, 0.0, 1.0 - hit.u);
    hit.distance_m = glm::dot(ac, q) / determinant;
    return hit;
}

bool RayScene::Impl::attach(std::vector<std::uint32_t> wanted, RTCFilterFunctionN filter) {
    if (wanted.empty()) return true;
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                             flat.positions.size());
    auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), wanted.size()));
    if (vertices && indices) {
        std::memcpy(vertices, flat.positions.data(), flat.positions.size() * sizeof(glm::vec3));
        for (std::size_t i = 0; i < wanted.size(); ++i) indices[i] = flat.triangles[wanted[i]];
        rtcSetGeometryIntersectFilterFunction(geometry, filter);
        rtcSetGeometryOccludedFilterFunction(geometry, filter);
        rtcCommitGeometry(geometry);
        const unsigned id = rtcAttachGeometry(embree.get(), geometry);
        ids[id] = std::move(wanted);
        triangles[id] = ids[id].data();
    }
    rtcReleaseGeometry(geometry);
    return vertices && indices;
}

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

    // Two geometries, so that rays look at textures only where a material is cut out.
    std::vector<std::uint32_t> solid, masked;
    for (std::uint32_t i = 0; i < flat.triangles.size(); ++i) {
        const int material = flat.instances[flat.triangleInstance[i]].material;
        const bool isMasked = scene.materials[std::size_t(material)].alphaMode == AlphaMode::Mask;
        (isMasked ? masked : solid).push_back(i);
    }
    if (!m_impl->attach(std::move(solid), nullptr) || !m_impl->attach(std::move(masked), filterHoles))
        fail("has no memory for the scene");
    for (const glm::vec3& p : flat.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(p[axis])) m_impl->extent_m = std::max(m_impl->extent_m, std::abs(p[axis]));
    // A rounding error of extent * 2^-24 across the surface is up to 50 times as long along a grazing ray; with a
    // margin of 16.
    m_impl->recheckBelow_m = m_impl->extent_m * FLT_EPSILON * 800;
    rtcCommitScene(m_impl->embree.get());
    if (rtcGetDeviceError(m_impl->device.get()) != RTC_ERROR_NONE) fail("cannot build its tree");
}

RayScene::~RayScene() = default;

bool RayScene::occluded(const Ray& ray) const {
    RayContext context = m_impl->context(&ray);
    RTCRay r;
    setRay(r, ray);
    rtcOccluded1(m_impl->embree.get(), &context.base, &r);
    return r.tfar < 0;
}

std::uint32_t RayScene::occluded(const Ray* rays, int count) const {
    RayContext context = m_impl->context(rays);
    context.base.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[RayBundle::kSize]{};
    RTCRay16 packet{};
    setRays(packet, rays, count, valid);
    rtcOccluded16(valid, m_impl->embree.get(), &context.base, &packet);
    std::uint32_t blocked = 0;
    for (int i = 0; i < count; ++i) blocked |= std::uint32_t(packet.tfar[i] < 0) << i;
    return blocked;
}

RayOrigin RayScene::startAt(const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t ownTriangle,
                            const std::vector<bool>* instances) const {
    RayOrigin origin{position, normal, ownTriangle, instances, false};
    if (instances && std::find(instances->begin(), instances->end(), false) != instances->end()) return origin;
    // Twice the distance of the second look: the float origin lies elsewhere than the point by far less.
    const RayContext context = m_impl->context(nullptr);
    NearQuery near{&context, position, 2.0 * double(m_impl->recheckBelow_m), ownTriangle};
    RTCPointQuery query{float(position.x), float(position.y), float(position.z), 0, 2.0f * m_impl->recheckBelow_m};
    RTCPointQueryContext stack;
    rtcInitPointQueryContext(&stack);
    rtcPointQuery(m_impl->embree.get(), &query, &stack, seeNear, &near);
    origin.alone = !near.found;
    return origin;
}

std::uint32_t RayScene::occluded(const RayOrigin& origin, const RayBundle& bundle, std::uint32_t wanted) const {
    // Far from all other triangles no hit below the distance of the second look counts: the rays start behind it and
    // need no filter. Grazing ones may meet their own triangle later.
    const glm::vec3 start(origin.position), normal(origin.normal);
    std::uint32_t careful = origin.alone ? 0 : wanted, blocked = 0;
    if (origin.alone) {
        alignas(64) int valid[RayBundle::kSize];
        RTCRay16 packet;
        for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
            const float cosine = bundle.x[i] * normal.x + bundle.y[i] * normal.y + bundle.z[i] * normal.z;
            valid[i] = (wanted >> i & 1u) != 0 && std::abs(cosine) > kGrazing ? -1 : 0;
            packet.org_x[i] = start.x;
            packet.org_y[i] = start.y;
            packet.org_z[i] = start.z;
            packet.tnear[i] = m_impl->recheckBelow_m;
            packet.time[i] = 0;
            packet.mask[i] = 0xffffffffu;
            packet.flags[i] = 0;
        }
        std::memcpy(packet.dir_x, bundle.x.data(), sizeof packet.dir_x);
        std::memcpy(packet.dir_y, bundle.y.data(), sizeof packet.dir_y);
        std::memcpy(packet.dir_z, bundle.z.data(), sizeof packet.dir_z);
        std::memcpy(packet.tfar, bundle.length_m.data(), sizeof packet.tfar);
        RayContext context = m_impl->context(nullptr);
        rtcOccluded16(valid, m_impl->embree.get(), &context.base, &packet);
        for (int i = 0; i < RayBundle::kSize; ++i) {
            blocked |= std::uint32_t(valid[i] != 0 && packet.tfar[i] < 0) << i;
            careful |= std::uint32_t(valid[i] == 0) << i;
        }
        careful &= wanted;
    }
    if (!careful) return blocked;

    // The others with the filter, packed.
    std::array<Ray, RayBundle::kSize> rays;
    std::array<int, RayBundle::kSize> lanes{};
    int count = 0;
    for (int i = 0; i < RayBundle::kSize; ++i) {
        if (!(careful >> i & 1u)) continue;
        const auto k = std::size_t(i);
        lanes[std::size_t(count)] = i;
        rays[std::size_t(count++)] = {origin.position, glm::dvec3(bundle.x[k], bundle.y[k], bundle.z[k]),
                                      double(bundle.length_m[k]), origin.ownTriangle, origin.instances};
    }
    RayContext context = m_impl->context(rays.data());
    alignas(64) int valid[RayBundle::kSize]{};
    RTCRay16 packet{};
    setRays(packet, rays.data(), count, valid);
    rtcOccluded16(valid, m_impl->embree.get(), &context.base, &packet);
    for (int i = 0; i < count; ++i) blocked |= std::uint32_t(packet.tfar[i] < 0) << lanes[std::size_t(i)];
    return blocked;
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
    RayContext context = m_impl->context(&ray);
    RTCRayHit r;
    setRay(r.ray, ray);
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_impl->embree.get(), &context.base, &r);
    if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return m_impl->refined(ray, {context.triangleOf(r.hit.geomID, r.hit.primID), r.hit.u, r.hit.v, r.ray.tfar});
}

void RayScene::crossings(const Ray& ray, std::vector<RayCrossing>& found) const {
    // The filter notes every hit and refuses it, so that the ray goes on to its end.
    std::vector<std::pair<std::uint32_t, float>> crossed;
    RayContext context = m_impl->context(&ray);
    context.crossed = &crossed;
    RTCRay r;
    setRay(r, ray);
    rtcOccluded1(m_impl->embree.get(), &context.base, &r);

    // A triangle that the tree has split is met once for each part.
    std::sort(crossed.begin(), crossed.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    crossed.erase(std::unique(crossed.begin(), crossed.end(), same), crossed.end());
    found.clear();
    for (const auto& [triangle, distance_m] : crossed) {
        const glm::uvec3 t = m_impl->flat.triangles[triangle];
        const glm::dvec3 a(m_impl->flat.positions[t.x]);
        const glm::dvec3 n =
            glm::cross(glm::dvec3(m_impl->flat.positions[t.y]) - a, glm::dvec3(m_impl->flat.positions[t.z]) - a);
        found.push_back({double(distance_m), glm::dot(n, ray.direction) < 0});
    }
    std::sort(found.begin(), found.end(),
              [](const RayCrossing& a, const RayCrossing& b) { return a.distance_m < b.distance_m; });
}

double RayScene::lengthTo_m(double distance_m) const {
    return std::isfinite(distance_m) ? std::max(0.0, distance_m - positionError_m(distance_m)) : distance_m;
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
