// SPDX-License-Identifier: MIT
// The truth as a statistic and as a program: calibrated standard errors, the same bits on any number of threads,
// progress.
#include <algorithm>
#include <numeric>

#include <ombrage/error.h>

#include "reference/test_scenes.h"

namespace ombrage {
namespace {

/// A sphere over a floor under an area light.
Scene sphereOverFloor() {
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    test::add(scene, shapes::sphere({0, 0, 0.8f}, 0.5f));
    scene.lights.push_back(test::point({1, 1, 4}, 0.6f));
    scene.aoRadius_m = 1;
    scene.cameras.push_back(test::camera({0, -4, 3}, {0, 0, 0.4}, {0, 0, 1}));
    return scene;
}

/// Standard deviation of the differences of two truths of independent seeds over their joint standard errors.
double zDeviation(const std::vector<float>& a, const std::vector<float>& aError, const std::vector<float>& b,
                  const std::vector<float>& bError, const std::vector<Mask>& mask) {
    double squares = 0;
    int n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double error = std::hypot(double(aError[i]), double(bError[i]));
        if (mask[i] != Mask::Valid || error <= 0) continue;
        squares += std::pow((double(a[i]) - double(b[i])) / error, 2);
        ++n;
    }
    EXPECT_GT(n, 300);
    return std::sqrt(squares / n);
}

TEST(Statistics, StandardErrorsAreCalibrated) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    auto options = test::picture(96, 72, 128);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const ShadowTruth shadow1 = reference.shadow(receivers, scene.cameras[0], 0, options);
    const AoTruth ao1 = reference.ao(receivers, scene.cameras[0], options);
    options.seed = 2;
    const ShadowTruth shadow2 = reference.shadow(receivers, scene.cameras[0], 0, options);
    const AoTruth ao2 = reference.ao(receivers, scene.cameras[0], options);

    // Student's t with 14 degrees of freedom has a standard deviation of 1.08; counts of few points are discrete, which
    // widens it. A standard error taken from points of one sequence would be too large by a factor of 2 and more.
    const double shadowZ =
        zDeviation(shadow1.visibility, shadow1.standardError, shadow2.visibility, shadow2.standardError, shadow1.mask);
    const double aoZ = zDeviation(ao1.visibility, ao1.standardError, ao2.visibility, ao2.standardError, ao1.mask);
    EXPECT_GT(shadowZ, 0.8);
    EXPECT_LT(shadowZ, 1.25);
    EXPECT_GT(aoZ, 0.8);
    EXPECT_LT(aoZ, 1.25);
}

TEST(Statistics, MoreSamplesAreMoreExact) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    auto options = test::picture(48, 36, 64);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const double few = reference.ao(receivers, scene.cameras[0], options).meanStandardError;
    options.samplesPerPixel = 1024;
    const double many = reference.ao(receivers, scene.cameras[0], options).meanStandardError;
    // 16 times the points: independent ones would give a factor of 4, nets about n^(3/4) = 8.
    EXPECT_GT(few, 0.0);
    EXPECT_LT(many, few / 4);
}

TEST(Truth, SameBitsOnAnyNumberOfThreads) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    auto options = test::picture(64, 48, 32);
    options.threads = 1;
    const Receivers r1 = reference.receivers(scene.cameras[0], options);
    const ShadowTruth s1 = reference.shadow(r1, scene.cameras[0], 0, options);
    const AoTruth a1 = reference.ao(r1, scene.cameras[0], options);
    options.threads = 2;
    const Receivers r2 = reference.receivers(scene.cameras[0], options);
    const ShadowTruth s2 = reference.shadow(r2, scene.cameras[0], 0, options);
    const AoTruth a2 = reference.ao(r2, scene.cameras[0], options);
    EXPECT_EQ(r1.triangle, r2.triangle);
    EXPECT_EQ(r1.barycentric, r2.barycentric);
    EXPECT_EQ(s1.visibility, s2.visibility);
    EXPECT_EQ(s1.standardError, s2.standardError);
    EXPECT_EQ(s1.irradianceShare, s2.irradianceShare);
    EXPECT_EQ(s1.centreSeen, s2.centreSeen);
    EXPECT_EQ(a1.visibility, a2.visibility);
    EXPECT_EQ(s1.meanStandardError, s2.meanStandardError);

    options.seed = 7;
    EXPECT_NE(reference.ao(r2, scene.cameras[0], options).visibility, a2.visibility);
}

TEST(Truth, TellsWhetherTheCentreOfASoftLightIsSeen) {
    // A plate 1 m above x > 0 of a floor; the sun is 0.1 rad wide and its centre straight above.
    Scene scene;
    test::add(scene, test::slab(-2, 2, 2, 0));
    test::add(scene, test::slab(0, 2, 2, 1));
    scene.lights = {test::sun({0, 0, -1}, 0.1f), test::sun({0, 0, -1}), test::sun({1, 0, 0.02f}, 0.1f)};
    scene.cameras = {test::camera({0, 0, 0.5}, {0, 0, 0})};
    scene.cameras[0].orthoHeight_m = 2.0f;
    const Reference reference(scene);
    const auto options = test::picture(64, 64, 64);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const ShadowTruth soft = reference.shadow(receivers, scene.cameras[0], 0, options);
    const ShadowTruth hard = reference.shadow(receivers, scene.cameras[0], 1, options);
    const ShadowTruth low = reference.shadow(receivers, scene.cameras[0], 2, options);
    EXPECT_TRUE(hard.centreSeen.empty());
    ASSERT_EQ(soft.centreSeen.size(), soft.mask.size());
    int partly = 0;
    for (std::size_t i = 0; i < soft.mask.size(); ++i) {
        EXPECT_EQ(soft.centreSeen[i], i % 64 < 32 ? 1 : 0) << i;
        EXPECT_EQ(float(soft.centreSeen[i]), hard.visibility[i]) << i;
        partly += soft.visibility[i] > 0 && soft.visibility[i] < 1 ? 1 : 0;
        // Of a setting sun whose centre is below the horizon a part is seen.
        EXPECT_EQ(low.mask[i], Mask::Valid);
        EXPECT_EQ(low.centreSeen[i], 0);
    }
    // The penumbra is 0.1 m wide: 3 pixels.
    EXPECT_GE(partly, 2 * 64);
    EXPECT_GT(*std::max_element(low.visibility.begin(), low.visibility.end()), 0.0f);
}

TEST(Truth, SampleCountsAreRoundedUpAndHaveDefaults) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    auto options = test::picture(4, 4, 9);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    EXPECT_EQ(reference.ao(receivers, scene.cameras[0], options).samplesPerPixel, 16);
    options.samplesPerPixel = 0;
    EXPECT_EQ(reference.ao(receivers, scene.cameras[0], options).samplesPerPixel, 256);
    const ShadowTruth soft = reference.shadow(receivers, scene.cameras[0], 0, options);
    EXPECT_EQ(soft.samplesPerPixel, 1024);
    EXPECT_TRUE(soft.soft);
    Scene hardScene = scene;
    hardScene.lights[0].radius_m = 0;
    const Reference hardReference(hardScene);
    const ShadowTruth hard = hardReference.shadow(receivers, scene.cameras[0], 0, options);
    EXPECT_EQ(hard.samplesPerPixel, 1);
    EXPECT_FALSE(hard.soft);
    options.samplesPerPixel = -1;
    EXPECT_THROW(reference.ao(receivers, scene.cameras[0], options), Error);
}

TEST(Truth, IrradianceFallsWithTheSquareOfTheDistance) {
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    Light lamp = test::point({0, 0, 2});
    lamp.intensity = 40;
    Light ball = lamp;
    ball.radius_m = 0.4f;
    Light rect = lamp;
    rect.type = LightType::Rect;
    rect.direction = {0, 0, -1};
    rect.size_m = {0.02f, 0.02f};
    rect.intensity = 40 / 0.0004f;
    scene.lights = {lamp, ball, rect};
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 4.0f;
    const Reference reference(scene);
    const auto options = test::picture(4, 4, 256);
    const Receivers receivers = reference.receivers(camera, options);
    // Pixel (0, 0) is at (-1.5, 1.5): I cos / d^2 with d^2 = 8.5 and cos = 2 / d.
    const double expected = 40 * 2 / std::pow(8.5, 1.5);
    EXPECT_NEAR(reference.shadow(receivers, camera, 0, options).irradiance[0], expected, 1e-5);
    // A Lambert sphere above the horizon lights as its centre does: 2 %, some 5 times the error of the samples.
    EXPECT_NEAR(reference.shadow(receivers, camera, 1, options).irradiance[0], expected, 0.02 * expected);
    // A small rect is a point with a cosine of its own.
    EXPECT_NEAR(reference.shadow(receivers, camera, 2, options).irradiance[0], expected * 2 / std::sqrt(8.5),
                0.01 * expected);
}

TEST(Truth, ProgressRisesAndCanStop) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    auto options = test::picture(32, 24, 8);
    std::vector<double> shares;
    options.progress = [&](double share) {
        shares.push_back(share);
        return true;
    };
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    EXPECT_EQ(shares.size(), 24u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    shares.clear();
    options.progress = [&](double share) {
        shares.push_back(share);
        return shares.size() < 3;
    };
    try {
        reference.ao(receivers, scene.cameras[0], options);
        FAIL() << "not interrupted";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Interrupted);
    }
    EXPECT_EQ(shares.size(), 3u);
}

TEST(Truth, BadRequestsAreErrors) {
    const Scene scene = sphereOverFloor();
    const Reference reference(scene);
    const auto options = test::picture(8, 8, 8);
    Receivers receivers = reference.receivers(scene.cameras[0], options);
    EXPECT_THROW(reference.shadow(receivers, scene.cameras[0], 1, options), Error);
    EXPECT_THROW(reference.shadow(receivers, scene.cameras[0], -1, options), Error);
    EXPECT_THROW(reference.shadowAt({0, 0, 0}, {0, 0, 1}, 1, 8, 1), Error);
    EXPECT_THROW(reference.receivers(scene.cameras[0], test::picture(0, 8)), Error);
    receivers.triangle.pop_back();
    EXPECT_THROW(reference.ao(receivers, scene.cameras[0], options), Error);
}

TEST(Picture, IsLambertLightPlusAmbient) {
    Scene scene;
    test::add(scene, test::slab(-3, 3, 3, 0));
    scene.materials[0].baseColor = {0.5f, 0.25f, 1.0f};
    scene.materials[0].emissive = {0, 0, 0.125f};
    scene.lights.push_back(test::sun({0, 0, -1}));
    scene.lights[0].intensity = 2;
    scene.lights[0].color = {1, 0.5f, 0};
    scene.ambient = 0.3f;
    scene.aoRadius_m = 1;
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 12.0f;  // half of the height is sky
    const Reference reference(scene);
    const auto options = test::picture(8, 8, 8);
    const Image image = reference.picture(reference.receivers(camera, options), camera, options);
    const double sun = 2 / 3.14159265358979;
    // 1e-6: float arithmetic on values below 1.
    EXPECT_NEAR(image.at(0, 4, 4), 0.5 * (0.3 + sun), 1e-6);
    EXPECT_NEAR(image.at(1, 4, 4), 0.25 * (0.3 + 0.5 * sun), 1e-6);
    EXPECT_NEAR(image.at(2, 4, 4), 0.3 + 0.125, 1e-6);
    EXPECT_FLOAT_EQ(image.at(0, 0, 0), 0.3f);
}

}  // namespace
}  // namespace ombrage
