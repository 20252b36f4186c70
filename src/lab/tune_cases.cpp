// SPDX-License-Identifier: MIT
#include "lab/tune_cases.h"

#include <ombrage/error.h>
#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/flat_scene.h"

namespace ombrage::tuning {

namespace {

constexpr double kOrbit_rad = 0.4363323129985824;  // 25 degrees
constexpr int kHalvings = 5;

}  // namespace

Camera orbited(const Scene& scene, const Camera& camera, double angle_rad) {
    const FlatScene flat = flatten(scene);
    Camera turned = camera;
    for (int i = 0; i <= kHalvings; ++i, angle_rad /= 2) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle_rad, glm::normalize(glm::dvec3(camera.up)));
        turned.position = camera.target + glm::dvec3(turn * glm::dvec4(camera.position - camera.target, 0.0));
        if (nearestHit(flat, camera.position - flat.origin, turned.position - camera.position) > 1) break;
    }
    return turned;
}

Cameras divideCameras(Scene& scene, const std::string& camera, const std::vector<std::string>& holdout) {
    Cameras cameras;
    const std::string named = camera.empty() ? "" : scene.cameras[std::size_t(scene.cameraIndex(camera))].name;
    for (const Camera& own : scene.cameras)
        if (std::find(holdout.begin(), holdout.end(), own.name) != holdout.end())
            cameras.heldOut.push_back(own.name);
        else if (named.empty() || own.name == named)
            cameras.searched.push_back(own.name);
    if (cameras.searched.empty())
        throw Error(ErrorCode::Usage, "all cameras of the scene '" + scene.name + "' are held out",
                    "leave one to search on");
    if (!cameras.heldOut.empty()) return cameras;

    const std::string first = cameras.searched.front();
    cameras.searched = {first};
    for (const Camera& own : scene.cameras)
        if (own.name != first) cameras.heldOut.push_back(own.name);
    const Camera from = scene.cameras[std::size_t(scene.cameraIndex(first))];
    for (const double side : {1.0, -1.0}) {
        if (cameras.heldOut.size() >= kFewestHeldOut) break;
        Camera made = orbited(scene, from, side * kOrbit_rad);
        made.name = first + (side > 0 ? " orbit left" : " orbit right");
        cameras.heldOut.push_back(made.name);
        cameras.made.push_back(made.name);
        scene.cameras.push_back(made);
    }
    return cameras;
}

}  // namespace ombrage::tuning
