// SPDX-License-Identifier: MIT
// Thin and jointed things.
#include <cmath>

#include "scene/builtin.h"
#include "scene/builtin_palette.h"
#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage::builtin {

using namespace palette;

namespace {
/// A wheel of 0.34 m radius about (x, 0.34, 0): tyre, rim, hub and 36 spokes of 2 mm.
struct Wheel {
    Mesh tyre, metal;
};

Wheel wheel(float x) {
    const glm::vec3 hub(x, 0.34f, 0);
    Wheel made;
    made.tyre = shapes::torus(hub, 0.325f, 0.016f, 72, 10);
    made.metal = shapes::torus(hub, 0.305f, 0.009f, 72, 8);
    shapes::append(made.metal,
                   shapes::tube(hub - glm::vec3(0, 0, 0.05f), hub + glm::vec3(0, 0, 0.05f), 0.018f, 0.018f));
    constexpr int kSpokes = 36;
    for (int i = 0; i < kSpokes; ++i) {
        // Spokes leave the hub on either side in turn and cross their neighbours.
        const float flange = i % 2 ? 0.032f : -0.032f, lead_rad = i % 4 < 2 ? 0.9f : -0.9f;
        const float rim_rad = 6.2831853f * float(i) / float(kSpokes), hub_rad = rim_rad + lead_rad;
        const glm::vec3 outer = hub + 0.303f * glm::vec3(std::cos(rim_rad), std::sin(rim_rad), 0);
        const glm::vec3 inner = hub + glm::vec3(0.017f * std::cos(hub_rad), 0.017f * std::sin(hub_rad), flange);
        shapes::append(made.metal, shapes::tube(inner, outer, 0.001f, 0.001f, 6));
    }
    return made;
}

Mesh bicycleFrame() {
    const glm::vec3 crank(0.0f, 0.29f, 0), seat(-0.17f, 0.82f, 0), head(0.36f, 0.86f, 0), fork(0.39f, 0.7f, 0);
    const glm::vec3 rear(-0.52f, 0.34f, 0), front(0.52f, 0.34f, 0);
    Mesh frame = shapes::tube(crank, seat, 0.016f, 0.016f);
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, float radius) {
        shapes::append(frame, shapes::tube(a, b, radius, radius));
    };
    add(seat - glm::vec3(-0.01f, 0.03f, 0), head - glm::vec3(0, 0.02f, 0), 0.014f);
    add(crank, fork, 0.017f);
    add(head, fork - glm::vec3(-0.01f, 0.03f, 0), 0.019f);
    for (const float z : {-0.05f, 0.05f}) {
        add(crank + glm::vec3(0, 0, 0.5f * z), rear + glm::vec3(0, 0, z), 0.009f);
        add(seat + glm::vec3(0, -0.04f, 0.4f * z), rear + glm::vec3(0, 0, z), 0.008f);
        add(fork + glm::vec3(0, -0.02f, 0.7f * z), front + glm::vec3(0, 0, z), 0.011f);
    }
    add(fork + glm::vec3(0.003f, -0.025f, -0.045f), fork + glm::vec3(0.003f, -0.025f, 0.045f), 0.012f);
    add(crank + glm::vec3(0, 0, -0.07f), crank + glm::vec3(0, 0, 0.07f), 0.02f);
    return frame;
}

Mesh bicycleFittings() {
    Mesh parts;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, float radius) {
        shapes::append(parts, shapes::tube(a, b, radius, radius));
    };
    // Saddle on its post, bar on its stem, cranks with pedals, chain wheel and the chain's two runs.
    shapes::append(parts, shapes::box({-0.33f, 0.955f, -0.06f}, {-0.08f, 0.985f, 0.06f}));
    add({-0.165f, 0.8f, 0}, {-0.205f, 0.96f, 0}, 0.012f);
    add({0.36f, 0.85f, 0}, {0.33f, 0.98f, 0}, 0.013f);
    add({0.33f, 0.98f, -0.27f}, {0.33f, 0.98f, 0.27f}, 0.012f);
    add({0.0f, 0.29f, 0.075f}, {0.12f, 0.17f, 0.075f}, 0.009f);
    add({0.0f, 0.29f, -0.075f}, {-0.12f, 0.41f, -0.075f}, 0.009f);
    shapes::append(parts, shapes::box({0.08f, 0.16f, 0.08f}, {0.16f, 0.18f, 0.17f}));
    shapes::append(parts, shapes::box({-0.16f, 0.4f, -0.17f}, {-0.08f, 0.42f, -0.08f}));
    shapes::append(parts, shapes::torus({0.0f, 0.29f, 0.045f}, 0.085f, 0.004f, 48, 6));
    add({-0.52f, 0.375f, 0.045f}, {0.0f, 0.375f, 0.045f}, 0.003f);
    add({-0.52f, 0.305f, 0.045f}, {0.0f, 0.205f, 0.045f}, 0.003f);
    return parts;
}
}  // namespace

Scene bicycle() {
    Wheel rear = wheel(-0.52f), front = wheel(0.52f);
    return SceneBuilder("bicycle")
        .object("floor", shapes::floor(7.0f), kStone)
        .object("frame", bicycleFrame(), kRed)
        .part("fittings", bicycleFittings(), kSlate)
        .part("rear tyre", std::move(rear.tyre), kSlate)
        .part("rear wheel", std::move(rear.metal), kChalk)
        .part("front tyre", std::move(front.tyre), kSlate)
        .part("front wheel", std::move(front.metal), kChalk)
        .sun("sun", {-0.35f, -0.8f, 0.75f}, 3.0f)
        .camera("main", {0.25, 1.15, 1.85}, {-0.08, 0.33, 0.22}, 48.0f)
        .camera("left", {-1.5, 0.9, 1.5}, {-0.2, 0.3, 0.25})
        .camera("top", {-0.2, 2.4, 1.2}, {-0.15, 0.1, 0.35})
        .finish(0.3f);
}

Scene figure() {
    SceneBuilder builder("figure");
    builder.object("floor", shapes::floor(7.0f), kStone)
        .object("figure", shapes::tube({0, 0.95f, 0}, {0, 1.45f, 0}, 0.15f, 0.19f, 20), kSea);
    // A limb is a tube with a ball at its start; the figure walks along +z.
    const auto limb = [&](const std::string& name, const glm::vec3& from, const glm::vec3& to, float start, float end,
                          const glm::vec3& color) {
        Mesh mesh = shapes::tube(from, to, start, end, 16);
        shapes::append(mesh, shapes::sphere(from, start * 1.08f, 20, 10));
        builder.part(name, std::move(mesh), color);
    };
    builder.part("head", shapes::sphere({0, 1.64f, 0.01f}, 0.115f, 32, 16), kStraw);
    limb("neck", {0, 1.46f, 0}, {0, 1.6f, 0}, 0.07f, 0.05f, kStraw);
    limb("hips", {0, 0.92f, 0}, {0, 1.0f, 0}, 0.15f, 0.15f, kSlate);

    // Children first: a forearm's own swing comes before that of the arm which carries it.
    constexpr double kStep_s = 1.2;
    const glm::dvec3 across(1, 0, 0);
    for (const int side : {-1, 1}) {
        const float s = float(side);
        const std::string which = side < 0 ? "right " : "left ";
        const double phase = side < 0 ? 0.125 : 0.625;
        limb(which + "upper arm", {s * 0.25f, 1.42f, 0}, {s * 0.29f, 1.13f, 0}, 0.055f, 0.045f, kSea);
        limb(which + "forearm", {s * 0.29f, 1.12f, 0}, {s * 0.29f, 0.86f, 0.1f}, 0.045f, 0.035f, kStraw);
        builder.part(which + "hand", shapes::sphere({s * 0.29f, 0.83f, 0.11f}, 0.05f, 20, 10), kStraw)
            .swing(2, {s * 0.29, 1.12, 0.0}, across, -22.0, kStep_s, phase - 0.08)
            .swing(3, {s * 0.25, 1.42, 0.0}, across, -38.0, kStep_s, phase);
        limb(which + "thigh", {s * 0.1f, 0.9f, 0}, {s * 0.1f, 0.5f, 0.02f}, 0.085f, 0.06f, kPlum);
        limb(which + "shin", {s * 0.1f, 0.49f, 0.02f}, {s * 0.1f, 0.1f, -0.03f}, 0.062f, 0.04f, kPlum);
        builder
            .part(which + "foot", shapes::box({s * 0.1f - 0.05f, 0.03f, -0.09f}, {s * 0.1f + 0.05f, 0.11f, 0.16f}),
                  kClay)
            .swing(2, {s * 0.1, 0.49, 0.02}, across, 20.0, kStep_s, phase - 0.2)
            .swing(3, {s * 0.1, 0.9, 0.0}, across, 32.0, kStep_s, phase);
    }
    return builder.sun("sun", {-0.9f, -1.0f, 0.3f}, 3.0f)
        .camera("main", {2.4, 1.45, 1.9}, {-0.4, 0.66, 0.05}, 45.0f)
        .camera("left", {-2.8, 1.3, 1.8}, {-0.3, 0.7, 0.1})
        .camera("top", {-0.5, 3.9, 1.8}, {-0.5, 0.4, 0.1})
        .finish(0.3f);
}

}  // namespace ombrage::builtin
