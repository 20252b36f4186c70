// SPDX-License-Identifier: MIT
// Closed forms of ambient visibility (Nusselt analogue: cosine-weighted visibility is one minus a form factor).
#include <limits>

#include "reference/test_scenes.h"
#include "scene/flat_scene.h"

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
const glm::dvec3 kUp(0, 0, 1);

/// A wall in the plane x = d, standing on z = 0.
Mesh wall(float d, float height, float halfLength) {
    return shapes::rectangle({d, halfLength, 0}, {0, -2 * halfLength, 0}, {0, 0, height});
}

Reference::Estimate openAt(const Scene& scene, double radius_m) {
    const Reference reference(scene);
    return test::pooled([&](std::uint64_t seed) { return reference.aoAt({0, 0, 0}, kUp, radius_m, 512, seed); });
}

TEST(AmbientTruth, NothingInTheWayIsOpen) {
    Scene scene;
    test::add(scene, wall(2, 1, 1));
    const auto e = openAt(scene, 1.0);
    EXPECT_EQ(e.mean, 1.0);
    EXPECT_EQ(e.standardError, 0.0);
}

TEST(AmbientTruth, LongWallWithinTheRadius) {
    for (double c : {0.05, 0.2, 0.5, 0.8, 0.95}) {
        const double radius_m = 1.3;
        Scene scene;
        // Higher and longer than any ray.
        test::add(scene, wall(float(c * radius_m), 2, 2));
        test::expectClosedForm(openAt(scene, radius_m), 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi);
    }
}

TEST(AmbientTruth, LongWallUnbounded) {
    for (double d : {0.1, 0.5, 1.0, 3.0}) {
        const double height = 1.5;
        Scene scene;
        // Half a length of 2000 m leaves out less than height^2 / length^2 = 1e-6.
        test::add(scene, wall(float(d), float(height), 2000));
        test::expectClosedForm(openAt(scene, kUnbounded), 1 - 0.5 * (1 - d / std::hypot(d, height)), 1e-6);
    }
}

TEST(AmbientTruth, SphereAboveTheHorizon) {
    for (double angle : {0.0, 0.6, 1.1}) {
        const double r = 0.4, distance = 1.0;
        ASSERT_GE(distance * std::cos(angle), r);
        Scene scene;
        const glm::vec3 centre(distance * std::sin(angle), 0, distance * std::cos(angle));
        test::add(scene, shapes::sphere(centre, float(r), 512, 256));
        // The inscribed mesh covers at most (2 pi / 256)^2 / 6 = 1e-4 less of the sphere's r^2/D^2 = 0.16.
        test::expectClosedForm(openAt(scene, kUnbounded), 1 - r * r / (distance * distance) * std::cos(angle), 1.6e-5);
    }
}

/// Form factor of the regular polygon of n corners on a circle of radius a at height h above the point (Lambert).
double polygonFormFactor(int n, double a, double h) {
    const glm::dvec3 p(a, 0, h), q(a * std::cos(2 * kPi / n), a * std::sin(2 * kPi / n), h);
    const glm::dvec3 edge = glm::cross(p, q);
    const double angle = std::acos(glm::dot(p, q) / (glm::length(p) * glm::length(q)));
    return n / (2 * kPi) * angle * edge.z / glm::length(edge);
}

TEST(AmbientTruth, CoaxialDisk) {
    // Heights where the share of 64 points is no whole number: next to one the estimate is skewed, and 3 standard
    // errors are no longer rare.
    for (double h : {0.3, 0.9, 2.2}) {
        const double a = 0.8;
        Scene scene;
        Mesh fan;
        constexpr int kCorners = 256;
        for (int i = 0; i < kCorners; ++i) {
            const double phi = 2 * kPi * i / kCorners;
            fan.positions.push_back(glm::vec3(a * std::cos(phi), a * std::sin(phi), h));
            fan.normals.push_back({0, 0, -1});
            fan.uvs.push_back({0, 0});
            if (i >= 2) fan.indices.insert(fan.indices.end(), {0, std::uint32_t(i), std::uint32_t(i - 1)});
        }
        test::add(scene, fan);
        const double exact = 1 - polygonFormFactor(kCorners, a, h);
        // The polygon itself is within 2e-4 of the disk, h^2 / (a^2 + h^2).
        EXPECT_NEAR(exact, h * h / (a * a + h * h), 2e-4);
        test::expectClosedForm(openAt(scene, kUnbounded), exact);
    }
}

TEST(AmbientTruth, BlockersBeyondTheRadiusDoNotCount) {
    Scene scene;
    test::add(scene, test::slab(-50, 50, 50, 1.0f));
    // The ceiling is met within R by directions of cosine above 1/R: their cosine-weighted share is 1 - 1/R^2.
    for (double radius_m : {1.5, 2.0, 4.0}) test::expectClosedForm(openAt(scene, radius_m), 1 / (radius_m * radius_m));
    EXPECT_EQ(openAt(scene, 0.999).mean, 1.0);
}

TEST(AmbientTruth, PictureOfAFloorBesideAWall) {
    Scene scene;
    test::add(scene, test::slab(-6, 2, 50, 0));
    test::add(scene, wall(2, 3, 50));
    scene.aoRadius_m = 1;
    // Straight down on the floor: row 0 is the far side in +y, columns go along x.
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 3.0f;
    const Reference reference(scene);
    const auto options = test::picture(64, 48, 512);
    const Receivers receivers = reference.receivers(camera, options);
    const AoTruth truth = reference.ao(receivers, camera, options);
    EXPECT_EQ(truth.samplesPerPixel, 512);
    EXPECT_EQ(truth.radius_m, 1.0f);

    // The columns' means against the closed form; the standard error of 48 pixels together.
    for (int x = 0; x < 64; ++x) {
        const double position = (x + 0.5) / 64 * 4 - 2;
        Reference::Estimate column;
        for (int y = 0; y < 48; ++y) {
            const std::size_t i = std::size_t(y * 64 + x);
            ASSERT_EQ(truth.mask[i], Mask::Valid);
            column.mean += double(truth.visibility[i]) / 48;
            column.standardError += std::pow(double(truth.standardError[i]) / 48, 2);
        }
        column.standardError = std::sqrt(column.standardError);
        const double c = std::min(1.0, 2 - position);
        // 1e-6: the float that holds the visibility.
        test::expectClosedForm(column, 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi, 1e-6);
    }
}

// On the crease itself the question has two answers; the receiver's own side gives 1/2, never the open sky that a ray
// finds which starts behind the wall. Four points of the crease, 1024 rays each, and a wall as wide as the radius.
TEST(AmbientTruth, APointOnTheCreaseSeesHalf) {
    Scene scene;
    test::add(scene, test::slab(0, 3, 8, 0.1f));
    test::add(scene, shapes::rectangle({0, 8, 0.1f}, {0, -16, 0}, {0, 0, 4}));
    scene.cameras.push_back(test::camera({2, 0, 2}, {0, 0, 0}));
    scene.aoRadius_m = 1;
    const Reference reference(scene);
    Receivers r = reference.receivers(scene.cameras[0], test::picture(4, 1));
    const FlatScene flat = flatten(scene);
    for (std::size_t i = 0; i < 4; ++i) {
        // The floor's triangle that has the crease as an edge, and a point of that edge.
        r.instance[i] = 0;
        r.normal[i] = r.shadingNormal[i] = glm::vec3(0, 0, 1);
        for (std::uint32_t t = 0; t < 2; ++t) {
            std::vector<int> onCrease;
            for (int k = 0; k < 3; ++k)
                if (std::abs(flat.positions[flat.triangles[t][k]].x + float(flat.origin.x)) < 1e-6f)
                    onCrease.push_back(k);
            if (onCrease.size() != 2) continue;
            glm::vec3 w(0.0f);
            w[onCrease[0]] = 0.3f + 0.1f * float(i);
            w[onCrease[1]] = 1 - w[onCrease[0]];
            r.triangle[i] = t;
            r.barycentric[i] = {w.y, w.z};
        }
    }
    const AoTruth truth = reference.ao(r, scene.cameras[0], test::picture(4, 1, 1024));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(truth.visibility[i], 0.5f, 3 * truth.standardError[i] + 1e-3f) << i;
}

TEST(AmbientTruth, DirectionsBelowTheGeometricHorizonAreBlocked) {
    // A floor whose shading normal leans by 60 degrees: the part of the cosine-weighted half-space about n_s that lies
    // above the floor is (1 + cos 60) / 2.
    Scene scene;
    Mesh floor = test::slab(-5, 5, 5, 0);
    for (glm::vec3& n : floor.normals) n = {std::sin(kPi / 3), 0, std::cos(kPi / 3)};
    test::add(scene, floor);
    scene.aoRadius_m = 1;
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 1.0f;
    const Reference reference(scene);
    const auto options = test::picture(16, 16, 512);
    const AoTruth truth = reference.ao(reference.receivers(camera, options), camera, options);
    Reference::Estimate all;
    for (std::size_t i = 0; i < 256; ++i) {
        all.mean += double(truth.visibility[i]) / 256;
        all.standardError += std::pow(double(truth.standardError[i]) / 256, 2);
    }
    all.standardError = std::sqrt(all.standardError);
    test::expectClosedForm(all, 0.75, 1e-6);
}

}  // namespace
}  // namespace ombrage
