// SPDX-License-Identifier: MIT
// The kinds of truth beside T1 and plain shadows: closed forms within 3 standard errors.
#include <limits>

#include <ombrage/error.h>

#include "reference/test_scenes.h"

namespace ombrage {
namespace {

const glm::dvec3 kUp(0, 0, 1);

/// A plate at height h, wider than any ray of length R = 1 goes, met from below.
Scene ceiling(double height) {
    Scene scene;
    test::add(scene, shapes::rectangle({-3, 3, float(height)}, {6, 0, 0}, {0, -6, 0}));
    return scene;
}

/// A wall in the plane x = d whose front looks to the point, higher and longer than any ray of length 1 goes.
Scene wall(double d) {
    Scene scene;
    test::add(scene, shapes::rectangle({float(d), 3, -3}, {0, -6, 0}, {0, 0, 6}));
    return scene;
}

Reference::Estimate at(const Scene& scene, TruthKind kind, int samples = 512) {
    const Reference reference(scene);
    return test::pooled([&](std::uint64_t seed) { return reference.aoAt({0, 0, 0}, kUp, 1, samples, seed, kind); });
}

TEST(TruthKinds, FalloffUnderACeiling) {
    // Directions of cosine z > c = h/R meet it at t = h/z: V = 1 - integral over (c,1) of 2 z (1 - (c/z)^2) dz.
    for (double c : {0.1, 0.37, 0.8})
        test::expectClosedForm(at(ceiling(c), TruthKind::T2), c * c - 2 * c * c * std::log(c), 1e-6);
}

TEST(TruthKinds, FalloffBesideAWall) {
    // By a quadrature over directions: sine cos(phi) = s > c meets the wall at t = c/s. About the wall's normal a
    // direction of cosine s weighs 2 sqrt(1 - s^2) ds / pi (the mean of the cosine to the floor over its azimuth).
    constexpr int kSteps = 200000;
    for (double c : {0.1, 0.45, 0.9}) {
        double occlusion = 0;
        for (int i = 0; i < kSteps; ++i) {
            const double s = c + (1 - c) * (i + 0.5) / kSteps;
            occlusion += 2 * std::sqrt(1 - s * s) / 3.14159265358979323846 * (1 - c * c / (s * s)) * (1 - c) / kSteps;
        }
        // 2e-6: the quadrature and the wall's float position.
        test::expectClosedForm(at(wall(c), TruthKind::T2, 4096), 1 - occlusion, 2e-6);
    }
}

TEST(TruthKinds, UniformWeighting) {
    // The ceiling leaves the cap below cosine c open; a wall takes half of the cap of height 1 - c about its normal.
    for (double c : {0.1, 0.37, 0.8}) test::expectClosedForm(at(ceiling(c), TruthKind::T3), c, 1e-6);
    for (double c : {0.1, 0.5, 0.9}) test::expectClosedForm(at(wall(c), TruthKind::T3), (1 + c) / 2, 1e-6);
}

TEST(TruthKinds, UnboundedIsT1WithoutEnd) {
    // Design section 6: a long wall of height H, unbounded. Half a length of 2000 m leaves out less than 1e-6.
    const double d = 0.5, height = 1.5;
    Scene scene;
    test::add(scene, test::slab(-6, float(d), 50, 0));
    test::add(scene, shapes::rectangle({float(d), 2000, 0}, {0, -4000, 0}, {0, 0, float(height)}));
    scene.aoRadius_m = 0.1f;
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 0.001f;
    const Reference reference(scene);
    auto options = test::picture(16, 16, 512);
    options.kind = TruthKind::T4;
    const AoTruth truth = reference.ao(reference.receivers(camera, options), camera, options);
    EXPECT_TRUE(std::isinf(truth.radius_m));
    Reference::Estimate mean;
    for (std::size_t i = 0; i < 256; ++i) {
        mean.mean += double(truth.visibility[i]) / 256;
        mean.standardError += std::pow(double(truth.standardError[i]) / 256, 2);
    }
    mean.standardError = std::sqrt(mean.standardError);
    // 1e-3: the view is 1 mm wide, over which the answer changes by a third of that.
    test::expectClosedForm(mean, 1 - 0.5 * (1 - d / std::hypot(d, height)), 1e-3);
}

TEST(TruthKinds, OccupiedVolume) {
    // A cap of height R - h takes (1-c)^2 (2+c) / 2 of the half-ball, half of that beside a wall; of the ball half.
    for (double c : {0.1, 0.5, 0.9}) {
        const double cap = (1 - c) * (1 - c) * (2 + c);
        test::expectClosedForm(at(ceiling(c), TruthKind::T5), 1 - cap / 2, 1e-6);
        test::expectClosedForm(at(wall(c), TruthKind::T5), 1 - cap / 4, 1e-6);
        // The lower half of the ball lies in the receiver's own solid.
        test::expectClosedForm(at(ceiling(c), TruthKind::T5Ball), 0.5 - cap / 4, 1e-6);
        test::expectClosedForm(at(wall(c), TruthKind::T5Ball), 0.5 - cap / 8, 1e-6);
    }
}

TEST(TruthKinds, SolidsAreLeftAgain) {
    // A sphere of radius r wholly inside the half-ball takes 2 r^3 of it; one inside another counts once.
    const double r = 0.3;
    Scene scene;
    test::add(scene, shapes::sphere({0.1f, 0, 0.5f}, float(r), 256, 128));
    test::add(scene, shapes::sphere({0.1f, 0, 0.5f}, float(r) / 2, 64, 32));
    // The inscribed mesh lacks 2 (pi / 128)^2 / 3 = 4e-4 of its volume.
    test::expectClosedForm(at(scene, TruthKind::T5), 1 - 2 * r * r * r, 4e-4 * 2 * r * r * r);
}

TEST(TruthKinds, SelfLeavesOtherModelsOut) {
    // A plate over a table under a sun straight above: the table's own top shades its floor part, the plate does not.
    Scene scene;
    Mesh table = test::slab(-2, 2, 2, 0);
    const Mesh top = test::slab(-1, 0, 2, 0.5f);
    const auto first = std::uint32_t(table.positions.size());
    table.positions.insert(table.positions.end(), top.positions.begin(), top.positions.end());
    table.normals.insert(table.normals.end(), top.normals.begin(), top.normals.end());
    table.uvs.insert(table.uvs.end(), top.uvs.begin(), top.uvs.end());
    for (std::uint32_t i : top.indices) table.indices.push_back(first + i);
    test::add(scene, table);
    test::add(scene, test::slab(0.5f, 1.5f, 2, 1));
    scene.lights = {test::sun({0, 0, -1}), test::sun({0, 0, -1}, 0.01f)};
    const Reference reference(scene);
    // From below the plates, over the table: columns from x = -1.8 to 1.8.
    Camera camera = test::camera({0, -8, 0.25}, {0, 0, 0}, {0, 0, 1});
    camera.orthoHeight_m = 0.05f;
    auto options = test::picture(72, 1);
    const Receivers receivers = reference.receivers(camera, options);
    for (int light : {0, 1}) {
        options.samplesPerPixel = 64;
        options.kind = TruthKind::Shadow;
        const ShadowTruth all = reference.shadow(receivers, camera, light, options);
        options.kind = TruthKind::Self;
        const ShadowTruth self = reference.shadow(receivers, camera, light, options);
        int differ = 0;
        for (std::size_t i = 0; i < 72; ++i) {
            if (all.mask[i] != Mask::Valid) continue;
            const double x = (double(i) + 0.5) / 72 * 3.6 - 1.8;
            const bool underTop = x > -0.98 && x<-0.02, underPlate = x> 0.52 && x < 1.48;
            if (underTop) {
                EXPECT_EQ(self.visibility[i], 0.0f) << x;
            }
            if (underPlate) {
                EXPECT_EQ(self.visibility[i], 1.0f) << x;
                EXPECT_EQ(all.visibility[i], 0.0f) << x;
                ++differ;
            }
        }
        EXPECT_GT(differ, 10);
    }
}

TEST(TruthKinds, AreaIsTheMeanOverThePixel) {
    // A plate's shadow edge runs along y at x = 0; pixel columns are 0.1 m wide, so the column from 0.02 - 0.1 to 0.02
    // is crossed with four fifths of it lit. Sixteen points have four columns: at most 1/8 off.
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    test::add(scene, test::slab(0, 3, 3, 5));
    scene.lights.push_back(test::sun({0, 0, -1}));
    scene.aoRadius_m = 1;
    const Reference reference(scene);
    Camera camera = test::camera({0.02, 0, 1}, {0.02, 0, 0});
    camera.orthoHeight_m = 0.8f;
    auto options = test::picture(8, 8);
    int parts = 0;
    const ShadowTruth truth = reference.areaShadow(camera, 0, options, [&](int part, const ShadowTruth& seen) {
        EXPECT_EQ(part, parts++);
        EXPECT_EQ(seen.width, 8);
    });
    EXPECT_EQ(parts, kAreaGrid * kAreaGrid);
    EXPECT_EQ(truth.samplesPerPixel, 16);
    for (int x = 0; x < 8; ++x) {
        const double left = 0.02 + (x - 4) * 0.1, lit = std::clamp(-left / 0.1, 0.0, 1.0);
        EXPECT_NEAR(truth.visibility[std::size_t(3 * 8 + x)], lit, 0.125) << x;
        if (lit == 0 || lit == 1) {
            EXPECT_EQ(truth.visibility[std::size_t(3 * 8 + x)], float(lit)) << x;
        }
    }
    EXPECT_EQ(truth.visibility[3 * 8 + 3], 0.75f);

    // Occlusion of an open floor is none, on average as well; a picture keeps its size.
    options.samplesPerPixel = 128;
    EXPECT_EQ(reference.areaAo(camera, options).samplesPerPixel, 128);
    EXPECT_EQ(reference.areaPicture(camera, options).width(), 8);
}

/// 1 - 1/2 where the camera sees a surface nearer than R, as a technique could claim it.
class Nearness final : public AoIntegrand {
public:
    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const auto seen = probe.seenTowards(receiver.right * (double(u.x) * receiver.sceneRadius_m));
        const auto up = probe.distanceTo(receiver.normal, 10);
        return (seen && glm::length(*seen) < receiver.sceneRadius_m ? 0.5 : 1.0) - (up ? 0.25 : 0.0);
    }
};

TEST(TruthKinds, OwnIntegratesWhatIsClaimed) {
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    scene.aoRadius_m = 0.5f;
    const Reference reference(scene);
    for (const bool orthographic : {false, true}) {
        Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
        if (orthographic) camera.orthoHeight_m = 1.0f;
        auto options = test::picture(4, 4, 64);
        options.kind = TruthKind::Own;
        const Receivers receivers = reference.receivers(camera, options);
        EXPECT_THROW(reference.ao(receivers, camera, options), Error);
        const Nearness nearness;
        options.integrand = &nearness;
        // The floor is seen everywhere and nothing is above it.
        for (const float v : reference.ao(receivers, camera, options).visibility) EXPECT_EQ(v, 0.5f);
    }
}

/// The cosine between the normal and the way to the eye.
class TowardsTheEye final : public AoIntegrand {
public:
    double sample(const AoReceiver& receiver, const AoProbe&, const glm::vec4&) const override {
        return glm::dot(receiver.toEye, receiver.normal);
    }
};

TEST(TruthKinds, OwnKnowsTheWayToTheEye) {
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    scene.aoRadius_m = 1;
    const Reference reference(scene);
    const TowardsTheEye integrand;
    for (const bool orthographic : {false, true}) {
        Camera camera = test::camera({1, 0, 1}, {0, 0, 0});
        if (orthographic) camera.orthoHeight_m = 0.1f;
        auto options = test::picture(8, 8, 64);
        options.kind = TruthKind::Own;
        options.integrand = &integrand;
        const AoTruth truth = reference.ao(reference.receivers(camera, options), camera, options);
        // The middles of the first and the last pixel of a row lie at -7/8 and 7/8 across, and 1/8 up. A perspective
        // camera looks along f + t (x r + y u) there, whose share against the floor's normal is (1 + t x) / sqrt(2) of
        // its length.
        const double t = orthographic ? 0 : std::tan(0.5 * double(camera.fovY_rad));
        const double length = std::sqrt(1 + t * t * 50.0 / 64);
        EXPECT_NEAR(truth.visibility[24], (1 - t * 7 / 8) * std::sqrt(0.5) / length, 1e-5);
        EXPECT_NEAR(truth.visibility[31], (1 + t * 7 / 8) * std::sqrt(0.5) / length, 1e-5);
    }
}

TEST(TruthKinds, NamesFitTheirQuantity) {
    EXPECT_EQ(truthKindFromName("T5-ball", Quantity::Ao), TruthKind::T5Ball);
    for (const char* name : {"T9", "slef", "", "shadow ao"}) EXPECT_THROW(truthKindFromName(name), Error) << name;
    EXPECT_THROW(truthKindFromName("T1", Quantity::Shadow), Error);
    EXPECT_THROW(truthKindFromName("self", Quantity::Ao), Error);
    EXPECT_THROW(truthKindFromName("area", Quantity::Indirect), Error);
    EXPECT_THROW(quantityFromName("shadows!"), Error);
}

TEST(Indirect, AWallSendsItsLightToTheFloor) {
    // A floor point at distance d of a long wall of height H that a sun lights evenly: the form factor of the wall is
    // (1 - d / sqrt(d^2 + H^2)) / 2, the wall's radiance E rho / pi, so the floor sends rho * F * E * rho / pi.
    const double d = 0.5, height = 1.5, albedo = 0.8;
    Scene scene;
    test::add(scene, test::slab(-6, float(d), 50, 0));
    test::add(scene, shapes::rectangle({float(d), 2000, 0}, {0, -4000, 0}, {0, 0, float(height)}));
    scene.materials[0].baseColor = glm::vec3(float(albedo));
    scene.lights.push_back(test::sun({1, 0, 0}));
    scene.lights[0].intensity = 2;
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 0.001f;
    const Reference reference(scene);
    const auto options = test::picture(16, 16, 512);
    const Image image = reference.indirect(reference.receivers(camera, options), camera, options);
    double mean = 0;
    for (float v : image.plane(0)) mean += double(v) / 256;
    const double exact = albedo * albedo * 2 / 3.14159265358979323846 * 0.5 * (1 - d / std::hypot(d, height));
    // 256 pixels of 512 samples: a standard error below 1e-3 of the value; the light grazes the floor and adds nothing.
    EXPECT_NEAR(mean, exact, 4e-3 * exact);
}

}  // namespace
}  // namespace ombrage
