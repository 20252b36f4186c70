// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <ombrage/scene.h>
#include <glm/ext/matrix_transform.hpp>

#include "scene/scene_builder.h"
#include "scene/shapes.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

/// Holes of alpha-tested casters are filled, and what stands behind the caster is seen through them all the same: it is
/// as lit as z-fail, which begins to count behind it, finds it to be. Those that count from the eye enter such a
/// caster's volume unseen.
TEST(ShadowVolume, SeesThroughHolesWhatIsLitBehindThem) {
    const auto visibility = [](const std::string& technique) {
        Bench& bench = Bench::of("fence");
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shadow = parseTechnique(technique).second;
        return measuredPlane(renderScene(bench.scene(), settings), Family::Shadow);
    };
    const std::vector<float> expected = visibility("shadow/volume-zfail");
    for (const char* technique : {"shadow/volume", "shadow/volume:count=near-clip", "shadow/volume-clamped",
                                  "shadow/volume-tiled", "shadow/volume-blur"}) {
        SCOPED_TRACE(technique);
        EXPECT_EQ(visibility(technique), expected);
    }
}

/// An orthographic camera cannot show infinity, so volumes end behind the scene, however large it is.
TEST(ShadowVolume, KeepsShadowsInPlaceUnderAnOrthographicCameraHoweverLargeTheSceneIs) {
    const double scale = 1000;
    Scene scene = Bench::of("open-mesh").scene();
    for (Instance& instance : scene.instances)
        instance.worldFromLocal = glm::scale(glm::dmat4(1.0), glm::dvec3(scale)) * instance.worldFromLocal;
    Camera& camera = scene.cameras[0];
    camera.position *= scale;
    camera.target *= scale;
    camera.orthoHeight_m = float(4 * scale);
    const auto visibility = [&](const std::string& technique) {
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shadow = parseTechnique(technique).second;
        return measuredPlane(renderScene(scene, settings), Family::Shadow);
    };
    const std::vector<float> expected = visibility("shadow/ray-traced");
    for (const char* technique : {"shadow/volume", "shadow/volume-zfail"}) {
        const std::vector<float> found = visibility(technique);
        std::size_t differing = 0, dark = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            // Rays are not asked where a surface is turned away from the light; there volumes are dark and rays lit.
            differing += found[i] > expected[i] ? 1 : 0;
            dark += expected[i] == 0.0f ? 1 : 0;
        }
        EXPECT_GT(dark, 1000u);
        EXPECT_LE(differing, 5u) << technique;  // the budget of 0.0003, in pixels of which a quarter is valid
    }
}

Image pictureOf(const Scene& scene, const std::string& technique) {
    RenderSettings settings;
    settings.width = 160;
    settings.height = 90;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    return renderScene(scene, settings).picture;
}

/// Pixels in which the pictures that two techniques make of a scene differ; what turns away from the light is dark in
/// either.
int differing(const Scene& scene, const std::string& technique, const std::string& other) {
    const Image a = pictureOf(scene, technique), b = pictureOf(scene, other);
    int count = 0;
    for (std::size_t i = 0; i < a.pixelCount(); ++i) count += std::abs(a.plane(0)[i] - b.plane(0)[i]) > 0.01f ? 1 : 0;
    return count;
}

/// A cube of 1 m, 20 cm over a floor, seen from the height of its top and straight along the plane of its side x = 0.5.
Scene cubeSeenAlongItsFaces(const glm::dvec3& lamp) {
    SceneBuilder builder("cube");
    builder.object("floor", shapes::floor(8), glm::vec3(0.8f));
    builder.object("cube", shapes::box(glm::vec3(-0.5f), glm::vec3(0.5f)), glm::vec3(0.8f), {0, 0.75, 0});
    builder.point("lamp", lamp, 10).camera("eye", {0.5, 1.25, 3}, {0.3, 0.4, 0});
    return builder.finish(1.0f);
}

/// No ray crosses a triangle whose plane holds the light. And where the eye lies in such a plane as well, it is on the
/// border of volumes: in them for some of its rays alone.
TEST(ShadowVolume, ALampInThePlaneOfAFaceIsNotShadedByIt) {
    const std::vector<glm::dvec3> lamps{{0.5, 1.25, 0.0},  // on an edge
                                        {0.5, 1.25, 0.5},  // on a corner
                                        {0.0, 1.25, 0.0},  // on the top
                                        {0.5, 1.75, 0.5},  // over a corner
                                        {1.5, 0.0, 1.0}};  // in the floor
    for (const glm::dvec3& lamp : lamps) {
        const Scene scene = cubeSeenAlongItsFaces(lamp);
        for (const char* technique : {"shadow/volume", "shadow/volume-zfail", "shadow/volume-zpplus",
                                      "shadow/volume:count=near-clip", "shadow/volume-clamped", "shadow/volume-tiled",
                                      "shadow/volume:silhouette=compute", "shadow/volume:silhouette=geometry"}) {
            SCOPED_TRACE(fmt::format("{} at {} {} {}", technique, lamp.x, lamp.y, lamp.z));
            // 0.0003 of the picture; the cut of the near plane, which ZP+ may miss, is one column of pixels.
            const bool isCut = std::string(technique) == "shadow/volume-zpplus";
            EXPECT_LE(differing(scene, technique, "shadow/ray-traced"), isCut ? 90 : 4);
        }
    }
}

/// What ends before the eye or the near plane does not hold them.
TEST(ShadowVolume, FiniteVolumesThatEndBeforeTheEyeLeaveItLit) {
    const Scene& scene = Bench::of("in-shadow").scene();
    for (const char* distance : {"0.6", "3"})
        for (const char* technique : {"shadow/volume:", "shadow/volume:count=near-clip,", "shadow/volume-zpplus:",
                                      "shadow/volume-zpplus:silhouette=geometry,", "shadow/volume-tiled:"}) {
            const std::string ends = std::string("extrude=distance,distance=") + distance;
            SCOPED_TRACE(technique + ends);
            EXPECT_EQ(differing(scene, technique + ends, "shadow/volume-zfail:" + ends), 0);
        }
}

/// Parallel rays stay parallel: a sun's volumes must not end in one point, however small a part of them is seen.
TEST(ShadowVolume, AnOrthographicCameraMayLookAtOneMillimetre) {
    SceneBuilder builder("cube");
    builder.object("floor", shapes::floor(8), glm::vec3(0.8f));
    builder.object("cube", shapes::box(glm::vec3(-0.5f), glm::vec3(0.5f)), glm::vec3(0.8f), {0, 0.75, 0});
    // The shadow ends at z = 0.5, in the middle of the picture.
    builder.sun("sun", {-1, -1, 0}, 10).camera("above", {-1, 5, 0.5}, {-1, 0, 0.5});
    Scene scene = builder.finish(1.0f);
    scene.cameras[0].up = {0, 0, -1};
    scene.cameras[0].orthoHeight_m = 0.001f;
    const Image truth = pictureOf(scene, "shadow/ray-traced");
    EXPECT_LT(truth.plane(0)[20 * 160 + 80], truth.plane(0)[70 * 160 + 80]);
    for (const char* technique :
         {"shadow/volume", "shadow/volume-zfail", "shadow/volume-tiled", "shadow/volume-clamped"})
        EXPECT_LE(differing(scene, technique, "shadow/ray-traced"), 160) << technique;
}

}  // namespace
}  // namespace ombrage::test
