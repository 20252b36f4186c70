// SPDX-License-Identifier: MIT
// Rays per second of the truth against bare loops over rtcOccluded1, 4 and 8 on the same rays, in memory and in the
// same order, on as many threads. By turns in one process: medians over the rounds of the ratios within a round.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/reference.h>
#include <CLI/CLI.hpp>

#include "reference/ao_estimator.h"
#include "reference/light_sampling.h"
#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

namespace ombrage::bench {
namespace {

struct BareRay {
    glm::vec3 origin, direction;
    float length_m;
};

/// The rays of a picture, row by row of receivers.
using Rays = std::vector<std::vector<BareRay>>;

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) * 0.5;
}

/// Embree with nothing but the triangles.
class BareScene {
public:
    BareScene(const FlatScene& flat, float start_m) : m_start_m(start_m) {
        m_device = rtcNewDevice(nullptr);
        m_scene = rtcNewScene(m_device);
        rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(m_scene, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            flat.positions.size()),
                    flat.positions.data(), flat.positions.size() * sizeof(glm::vec3));
        std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                            flat.triangles.size()),
                    flat.triangles.data(), flat.triangles.size() * sizeof(glm::uvec3));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(m_scene);
    }
    ~BareScene() {
        rtcReleaseScene(m_scene);
        rtcReleaseDevice(m_device);
    }
    BareScene(const BareScene&) = delete;
    BareScene& operator=(const BareScene&) = delete;

    int single(const std::vector<BareRay>& rays) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        int blocked = 0;
        for (const BareRay& from : rays) {
            RTCRay ray{from.origin.x,
                       from.origin.y,
                       from.origin.z,
                       m_start_m,
                       from.direction.x,
                       from.direction.y,
                       from.direction.z,
                       0,
                       from.length_m,
                       0xffffffffu,
                       0,
                       0};
            rtcOccluded1(m_scene, &context, &ray);
            blocked += ray.tfar < 0;
        }
        return blocked;
    }

    template <int N, typename Packet, typename Call>
    int packets(const std::vector<BareRay>& rays, const Call& call) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        alignas(64) int valid[N];
        Packet packet;
        int blocked = 0;
        for (std::size_t first = 0; first < rays.size(); first += N) {
            for (int i = 0; i < N; ++i) {
                const bool isThere = first + std::size_t(i) < rays.size();
                const BareRay& from = rays[isThere ? first + std::size_t(i) : first];
                valid[i] = isThere ? -1 : 0;
                packet.org_x[i] = from.origin.x;
                packet.org_y[i] = from.origin.y;
                packet.org_z[i] = from.origin.z;
                packet.dir_x[i] = from.direction.x;
                packet.dir_y[i] = from.direction.y;
                packet.dir_z[i] = from.direction.z;
                packet.tnear[i] = m_start_m;
                packet.tfar[i] = from.length_m;
                packet.time[i] = 0;
                packet.mask[i] = 0xffffffffu;
                packet.flags[i] = 0;
            }
            call(valid, m_scene, &context, &packet);
            for (int i = 0; i < N; ++i) blocked += valid[i] != 0 && packet.tfar[i] < 0;
        }
        return blocked;
    }

private:
    float m_start_m;
    RTCDevice m_device;
    RTCScene m_scene;
};

/// One question to the truth and the rays that it traces for it.
struct Question {
    std::string name;
    std::function<void()> ask;
    Rays rays;
    ReferenceOptions options;
};

/// What a question needs of the scene.
struct Setting {
    const Scene& scene;
    const Reference& reference;
    const FlatScene& flat;
    const RayScene& rays;
};

/// Calls `at` with every receiver and the row of rays that it adds to.
void everyReceiver(const Setting& setting, const Receivers& receivers, Rays& rays,
                   const std::function<void(const SurfacePoint&, std::uint32_t, std::vector<BareRay>&)>& at) {
    rays.resize(std::size_t(receivers.height));
    SurfacePoints points(setting.flat, receivers, setting.rays.positionError_m(0));
    for (std::size_t i = 0; i < receivers.triangle.size(); ++i)
        if (receivers.triangle[i] != kNoHit) at(points.at(i), std::uint32_t(i), rays[i / std::size_t(receivers.width)]);
}

void addBundle(const SurfacePoint& point, const RayBundle& bundle, std::uint32_t wanted, std::vector<BareRay>& row) {
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        const glm::dvec3 d(bundle.x[i], bundle.y[i], bundle.z[i]);
        if ((wanted >> i & 1u) && glm::dot(d, point.normal) > 0)
            row.push_back({glm::vec3(point.position), glm::vec3(d), bundle.length_m[i]});
    }
}

ReferenceOptions optionsOf(int width, int height, int samples, int threads) {
    ReferenceOptions options;
    options.width = width;
    options.height = height;
    options.samplesPerPixel = samples;
    options.threads = threads;
    return options;
}

/// Cosine-weighted rays within the scene's radius, 256 for each receiver.
Question ambient(const Setting& setting, const Camera& camera, int threads) {
    Question q{"ambient occlusion", {}, {}, optionsOf(160, 90, 256, threads)};
    const Receivers receivers = setting.reference.receivers(camera, q.options);
    const SampleSets sets(pointSeed(1, 0, kNoHit), 256 / kScramblings);
    everyReceiver(setting, receivers, q.rays, [&](const SurfacePoint& p, std::uint32_t i, std::vector<BareRay>& row) {
        RayBundle bundle;
        bundle.length_m.fill(setting.scene.aoRadius_m);
        PolarSamples samples;
        for (int k = 0; k < kScramblings; ++k)
            for (int b = 0; b < sets.bundles(); ++b) {
                sets.polar(k, b, SampleSets::moveOf(pointSeed(1, 0, i), k), samples);
                directions(p.shadingNormal, Spread::Cosine, samples, bundle);
                addBundle(p, bundle, sets.wanted(b), row);
            }
    });
    q.ask = [&setting, &camera, receivers, options = q.options] { setting.reference.ao(receivers, camera, options); };
    return q;
}

/// The first light of the scene, which has a size, with 1024 rays for each receiver.
Question soft(const Setting& setting, const Camera& camera, int threads) {
    Question q{"soft shadow", {}, {}, optionsOf(96, 54, 1024, threads)};
    const Receivers receivers = setting.reference.receivers(camera, q.options);
    const SampleSets sets(pointSeed(1, 1, kNoHit), 1024 / kScramblings);
    const LightShape shape(setting.scene.lights.front(), setting.flat.origin);
    everyReceiver(setting, receivers, q.rays, [&](const SurfacePoint& p, std::uint32_t i, std::vector<BareRay>& row) {
        if (shape.mask(p.position, p.normal) != Mask::Valid) return;
        RayBundle bundle;
        LightBundle parts;
        for (int k = 0; k < kScramblings; ++k)
            for (int b = 0; b < sets.bundles(); ++b) {
                shape.sample(p.position, sets, k, b, SampleSets::moveOf(pointSeed(1, 1, i), k), parts);
                for (std::size_t j = 0; j < RayBundle::kSize; ++j) {
                    bundle.x[j] = float(parts.x[j]);
                    bundle.y[j] = float(parts.y[j]);
                    bundle.z[j] = float(parts.z[j]);
                    bundle.length_m[j] = float(parts.distance_m[j] - setting.rays.positionError_m(parts.distance_m[j]));
                }
                addBundle(p, bundle, sets.wanted(b) & parts.facing, row);
            }
    });
    q.ask = [&setting, &camera, receivers, options = q.options] {
        setting.reference.shadow(receivers, camera, 0, options);
    };
    return q;
}

/// The centre of the first light, one ray for each receiver.
Question hard(const Setting& setting, const Camera& camera, int threads) {
    Question q{"hard shadow", {}, {}, optionsOf(1280, 720, 1, threads)};
    const Receivers receivers = setting.reference.receivers(camera, q.options);
    const LightShape shape(setting.scene.lights.front(), setting.flat.origin);
    everyReceiver(setting, receivers, q.rays, [&](const SurfacePoint& p, std::uint32_t, std::vector<BareRay>& row) {
        if (shape.mask(p.position, p.normal) != Mask::Valid) return;
        const LightSample centre = shape.centre(p.position);
        const double length_m = centre.distance_m - setting.rays.positionError_m(centre.distance_m);
        row.push_back({glm::vec3(p.position), glm::vec3(centre.direction), float(length_m)});
    });
    q.ask = [&setting, &camera, receivers, options = q.options] {
        setting.reference.shadow(receivers, camera, 0, options);
    };
    return q;
}

struct Cost {
    double wall_s, cpu_s;
};

/// Wall time, and the time of all threads of this process, whoever else uses the machine.
Cost costOf(const std::function<void()>& work) {
    const auto cpu_s = [] {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
    };
    const auto start = std::chrono::steady_clock::now();
    const double cpuStart_s = cpu_s();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), cpu_s() - cpuStart_s};
}

void measure(const std::string& scene, const BareScene& bare, const Question& q, int rounds) {
    const auto loop = [&](const std::function<int(const std::vector<BareRay>&)>& trace) {
        std::vector<int> blocked(q.rays.size());
        parallelRows(int(q.rays.size()), q.options,
                     [&](int y) { blocked[std::size_t(y)] = trace(q.rays[std::size_t(y)]); });
    };
    const std::vector<std::pair<std::string, std::function<void()>>> subjects = {
        {"truth", q.ask},
        {"rtcOccluded1", [&] { loop([&](const auto& row) { return bare.single(row); }); }},
        {"rtcOccluded4", [&] { loop([&](const auto& row) { return bare.packets<4, RTCRay4>(row, rtcOccluded4); }); }},
        {"rtcOccluded8", [&] { loop([&](const auto& row) { return bare.packets<8, RTCRay8>(row, rtcOccluded8); }); }}};
    std::size_t count = 0;
    for (const auto& row : q.rays) count += row.size();

    // Ratios of rays per second, truth over loop, within each round; the first round warms up.
    std::vector<std::vector<double>> rates(subjects.size()), wall(subjects.size()), cpu(subjects.size());
    for (int round = 0; round <= rounds; ++round) {
        Cost truth{};
        for (std::size_t s = 0; s < subjects.size(); ++s) {
            const Cost cost = costOf(subjects[s].second);
            if (s == 0) truth = cost;
            if (round == 0) continue;
            rates[s].push_back(double(count) / cost.wall_s * 1e-6);
            wall[s].push_back(cost.wall_s / truth.wall_s);
            cpu[s].push_back(cost.cpu_s / truth.cpu_s);
        }
    }
    for (std::size_t s = 0; s < subjects.size(); ++s)
        std::puts(fmt::format("{:<12} {:<18} {:<13} {:>8.2f} {:>6.2f} {:>6.2f}", scene, q.name, subjects[s].first,
                              medianOf(rates[s]), medianOf(wall[s]), medianOf(cpu[s]))
                      .c_str());
}

int run(int argc, char** argv) {
    CLI::App app("Rays per second of the truth against bare loops over the same rays");
    std::vector<std::string> scenes{"menger"}, questions;
    int threads = 2, rounds = 7;
    app.add_option("scene", scenes, "built-in scenes, scene files or model files (menger)");
    app.add_option("--question", questions, "only these (all)")->check(CLI::IsMember({"hard", "soft", "ao"}));
    app.add_option("--threads", threads, "of the truth and of the loops (2)")->check(CLI::Range(1, 256));
    app.add_option("--rounds", rounds, "measured rounds (7)")->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    std::puts("scene        question           loop            Mrays/s   truth / loop: wall, cpu");
    for (const std::string& name : scenes) {
        Scene scene = loadScene(name);
        // A sun of half a degree or a lamp of 20 cm; the hard one has no size.
        Scene sized = scene;
        Light& light = sized.lights.front();
        light.angle_rad = 0.0093f;
        light.radius_m = light.type == LightType::Sun ? 0.0f : 0.2f;
        const FlatScene flat = flatten(scene);
        const RayScene rays(scene, flat);
        const Reference reference(scene), sizedReference(sized);
        const BareScene bare(flat, float(200 * rays.positionError_m(0)));
        const Setting hardSetting{scene, reference, flat, rays}, softSetting{sized, sizedReference, flat, rays};
        const Camera& camera = scene.cameras.front();
        const auto isAsked = [&](const char* question) {
            return questions.empty() || std::find(questions.begin(), questions.end(), question) != questions.end();
        };
        if (isAsked("hard")) measure(scene.name, bare, hard(hardSetting, camera, threads), rounds);
        if (isAsked("soft")) measure(scene.name, bare, soft(softSetting, camera, threads), rounds);
        if (isAsked("ao")) measure(scene.name, bare, ambient(hardSetting, camera, threads), rounds);
    }
    return 0;
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) {
    try {
        return ombrage::bench::run(argc, argv);
    } catch (const ombrage::Error& error) {
        std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
        return int(error.code());
    }
}
