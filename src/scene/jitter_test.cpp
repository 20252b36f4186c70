// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/camera_view.h"

namespace ombrage {
namespace {

Camera cameraOf(bool orthographic) {
    Camera camera;
    camera.name = "test";
    camera.position = {3, 2, 5};
    camera.target = {0.5, -0.25, 1};
    camera.fovY_rad = 0.9f;
    if (orthographic) camera.orthoHeight_m = 4.0f;
    return camera;
}

TEST(Jitter, MovesEveryPixelsRayAndNothingElse) {
    for (const bool orthographic : {false, true}) {
        const Bounds bounds{glm::dvec3(-4), glm::dvec3(4)};
        const CameraView view = makeCameraView(cameraOf(orthographic), 64, 48, glm::dvec3(1, 0, 2), bounds);
        const glm::dvec2 offset(0.375, -0.25);
        const CameraView moved = jittered(view, offset);
        for (const glm::dvec2 px : {glm::dvec2(0.5, 0.5), glm::dvec2(40.5, 7.5), glm::dvec2(63.5, 47.5)}) {
            // Rows count downwards, the offset upwards.
            glm::dvec3 start, direction, startMoved, directionMoved;
            view.ray(px.x + offset.x, px.y - offset.y, start, direction);
            moved.ray(px.x, px.y, startMoved, directionMoved);
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(startMoved[i], start[i], 1e-6);
                EXPECT_NEAR(directionMoved[i], direction[i], 1e-6);
            }
            // A point of that ray falls onto the pixel's centre, at the depth that it had: floats at 1e-6.
            const glm::vec4 p_world(glm::vec3(start + 3.0 * direction), 1.0f);
            const glm::vec4 clip = moved.clipFromWorld * p_world, before = view.clipFromWorld * p_world;
            EXPECT_NEAR(clip.x / clip.w, 2 * px.x / 64 - 1, 1e-5);
            EXPECT_NEAR(clip.y / clip.w, 1 - 2 * px.y / 48, 1e-5);
            EXPECT_NEAR(clip.z / clip.w, before.z / before.w, 1e-6);
            // What a shader rebuilds from the depth is the point again.
            const glm::vec4 back = moved.worldFromView * (moved.viewFromWorld * p_world);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], p_world[i], 1e-5);
        }
    }
    const Bounds bounds{glm::dvec3(-4), glm::dvec3(4)};
    const CameraView view = makeCameraView(cameraOf(false), 64, 48, glm::dvec3(0), bounds);
    EXPECT_EQ(jittered(view, {0, 0}).clipFromWorld, view.clipFromWorld);
}

}  // namespace
}  // namespace ombrage
