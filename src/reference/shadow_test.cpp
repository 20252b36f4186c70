// SPDX-License-Identifier: MIT
// Penumbrae of a blocker with a straight edge, parallel to the receiver: closed forms for every kind of light.
#include <algorithm>

#include "reference/test_scenes.h"

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLight_m = 4;                          // height of the light above the receiver plane z = 0: d_r
constexpr double kBlocker_m = 1;                        // height of the blocker
constexpr double kToBlocker_m = kLight_m - kBlocker_m;  // d_b

/// The half-plane x > 0 at the blocker's height, as far as any ray of these tests goes. Not larger: a position is a
/// float, and the penumbra of the real sun is 9 mm wide here.
Scene halfPlane(const Light& light) {
    Scene scene;
    test::add(scene, test::slab(0, 2, 1, float(kBlocker_m)));
    scene.lights.push_back(light);
    return scene;
}

Reference::Estimate shareAt(const Reference& reference, double x, int samples = 512) {
    return test::pooled([&](std::uint64_t seed) { return reference.shadowAt({x, 0, 0}, {0, 0, 1}, 0, samples, seed); });
}

/// x on the light, over the point x of the receiver, where the blocker's edge cuts.
double edgeOnLight(double x) {
    return x - x * kLight_m / kBlocker_m;
}

/// Light on x < edge is seen. Checks that v is 1 and 0 just outside [-width/2, width/2] and in between just inside.
void expectPenumbraWidth(const Reference& reference, double width) {
    // 3 % inside the ends the seen part of a disk is still 0.2 % and more: among 64 x 512 points some see it.
    EXPECT_EQ(shareAt(reference, -width / 2 * 1.001).mean, 1.0);
    EXPECT_EQ(shareAt(reference, width / 2 * 1.001).mean, 0.0);
    EXPECT_LT(shareAt(reference, -width / 2 * 0.97).mean, 1.0);
    EXPECT_GT(shareAt(reference, width / 2 * 0.97).mean, 0.0);
}

Light above(LightType type) {
    Light light = test::point({0, 0, kLight_m});
    light.type = type;
    light.direction = {0, 0, -1};
    return light;
}

TEST(Penumbra, RectIsARamp) {
    Light light = above(LightType::Rect);
    light.size_m = {0.6f, 0.6f};
    const Scene scene = halfPlane(light);
    const Reference reference(scene);
    const double width = 0.6 * (kLight_m - kToBlocker_m) / kToBlocker_m;
    expectPenumbraWidth(reference, width);
    for (double x : {-0.09, -0.05, -0.01, 0.0, 0.04, 0.08})
        // 1e-7: the size of the light as a float.
        test::expectClosedForm(shareAt(reference, x), std::clamp(0.5 + edgeOnLight(x) / 0.6, 0.0, 1.0), 1e-6);
}

TEST(Penumbra, SpotIsADisk) {
    Light light = above(LightType::Spot);
    light.radius_m = 0.5f;
    light.outer_rad = 1.0f;
    const Scene scene = halfPlane(light);
    const Reference reference(scene);
    expectPenumbraWidth(reference, 2 * 0.5 * (kLight_m - kToBlocker_m) / kToBlocker_m);
    for (double x : {-0.12, -0.05, 0.0, 0.03, 0.1}) {
        // Share of a unit disk left of the chord at c.
        const double c = std::clamp(edgeOnLight(x) / 0.5, -1.0, 1.0);
        test::expectClosedForm(shareAt(reference, x), 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi, 1e-6);
    }
}

/// Share of a cone of half angle `half` about an axis that lies on the near side of a plane through its apex, whose
/// normal makes the angle pi/2 - `tilt` with the axis: by a quadrature over the rings of the cone.
double coneShare(double half, double tilt) {
    constexpr int kRings = 200000;
    double share = 0;
    for (int i = 0; i < kRings; ++i) {
        const double cosine = 1 - (1 - std::cos(half)) * (i + 0.5) / kRings;
        const double sine = std::sqrt(1 - cosine * cosine);
        // On the ring, directions with sine * cos(phi) * cos(tilt) < cosine * sin(tilt) are seen.
        const double limit = std::clamp(cosine * std::sin(tilt) / (sine * std::cos(tilt)), -1.0, 1.0);
        share += 1 - std::acos(limit) / kPi;
    }
    return share / kRings;
}

TEST(Penumbra, SphereIsACone) {
    const double radius = 0.5;
    const Scene scene = halfPlane(test::point({0, 0, kLight_m}, float(radius)));
    const Reference reference(scene);
    for (double x : {-0.12, -0.05, 0.0, 0.03, 0.1}) {
        // In the plane y = 0: the angle from the light's centre to the blocker's edge.
        const double toCentre = std::atan2(-x, kLight_m), toEdge = std::atan2(-x, kBlocker_m);
        const double half = std::asin(radius / std::hypot(x, kLight_m));
        // 2e-6: the quadrature.
        test::expectClosedForm(shareAt(reference, x), coneShare(half, toEdge - toCentre), 2e-6);
    }
    // The penumbra ends where the tangents to the sphere meet the edge: distance of the centre from the line through
    // (x, 0) and (0, blocker) equals the radius. With x = -s: |s (4 - 1)| / hypot(s, 1) = 1/2.
    const double end = radius / std::sqrt(std::pow(kToBlocker_m, 2) - radius * radius);
    expectPenumbraWidth(reference, 2 * end);
}

TEST(Penumbra, SunHasItsFullAngularDiameter) {
    for (double angle : {0.00925, 0.2}) {
        const Scene scene = halfPlane(test::sun({0, 0, -1}, float(angle)));
        const Reference reference(scene);
        expectPenumbraWidth(reference, 2 * std::tan(angle / 2) * kBlocker_m);
        for (double share : {-0.8, -0.3, 0.0, 0.5}) {
            const double x = share * std::tan(angle / 2) * kBlocker_m;
            // 3e-6: the quadrature, and the rounding of a direction over so small an angle.
            test::expectClosedForm(shareAt(reference, x), coneShare(angle / 2, std::atan2(-x, kBlocker_m)), 3e-6);
        }
    }
}

TEST(Penumbra, SizeZeroIsOneExactRay) {
    for (const Light& light :
         {above(LightType::Point), above(LightType::Spot), above(LightType::Rect), test::sun({0, 0, -1})}) {
        const Scene scene = halfPlane(light);
        const Reference reference(scene);
        for (double x : {-0.001, 0.001}) {
            const auto e = reference.shadowAt({x, 0, 0}, {0, 0, 1}, 0, 64, 1);
            EXPECT_EQ(e.mean, x < 0 ? 1.0 : 0.0) << lightTypeName(light.type);
            EXPECT_EQ(e.standardError, 0.0);
        }
    }
}

TEST(Horizon, PartsBelowItAreBlocked) {
    // A sphere light whose centre is on the horizon: half of it is seen.
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, -5));
    scene.lights.push_back(test::point({3, 0, 0}, 0.5f));
    const Reference reference(scene);
    test::expectClosedForm(shareAt(reference, 0), 0.5);
}

TEST(Horizon, RectShowsItsBack) {
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, -5));
    Light light = above(LightType::Rect);
    light.size_m = {1, 1};
    light.direction = {0, 0, 1};
    scene.lights.push_back(light);
    EXPECT_EQ(shareAt(Reference(scene), 0).mean, 0.0);
}

TEST(Degenerate, ReceiverInsideASphereLight) {
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, -5));
    scene.lights.push_back(test::point({0, 0, 0}, 1.0f));
    const Reference reference(scene);
    // At the centre, off it and on the sphere: the half of all directions above the horizon, or the cone's.
    test::expectClosedForm(shareAt(reference, 0), 0.5);
    test::expectClosedForm(shareAt(reference, 0.3), 0.5);
    test::expectClosedForm(shareAt(reference, 1.0), 0.5);
    EXPECT_TRUE(std::isfinite(shareAt(reference, 1.0).standardError));
}

TEST(Degenerate, ReceiverAtAHardLight) {
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, -5));
    scene.lights.push_back(test::point({0, 0, 0}));
    EXPECT_TRUE(std::isfinite(shareAt(Reference(scene), 0).mean));
}

TEST(Lights, ASurfaceInTheLightsOwnPlaneDoesNotBlockIt) {
    // A lamp's own quad, as in the Cornell box.
    Light light = above(LightType::Rect);
    light.size_m = {0.6f, 0.6f};
    Scene scene;
    test::add(scene, test::slab(-0.3f, 0.3f, 0.3f, float(kLight_m)));
    scene.lights.push_back(light);
    EXPECT_EQ(shareAt(Reference(scene), 0.1).mean, 1.0);
}

}  // namespace
}  // namespace ombrage
