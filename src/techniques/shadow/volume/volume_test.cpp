// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <ombrage/scene.h>
#include <glm/ext/matrix_transform.hpp>

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

/// An orthographic camera cannot show infinity, so volumes end far away, and all rays of a sun meet there: farther than
/// any scene, in its own measure.
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

}  // namespace
}  // namespace ombrage::test
