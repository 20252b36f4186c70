// SPDX-License-Identifier: MIT
#include "lab/motion.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/strings.h"

namespace ombrage {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLargestCaster = 0.6;  ///< of the scene's diagonal

Bounds boundsOf(const Scene& scene, const std::vector<int>& instances) {
    Bounds bounds;
    for (const int i : instances) {
        const Instance& instance = scene.instances[std::size_t(i)];
        for (const glm::vec3& p : scene.meshes[std::size_t(instance.mesh)].positions) {
            const glm::dvec3 world(instance.worldFromLocal * glm::dvec4(glm::dvec3(p), 1.0));
            if (!std::isfinite(world.x + world.y + world.z)) continue;
            bounds.lower = glm::min(bounds.lower, world);
            bounds.upper = glm::max(bounds.upper, world);
        }
    }
    return bounds;
}

/// Level and across `way`; +X where that is vertical or nothing.
glm::dvec3 sideways(const glm::dvec3& way) {
    const glm::dvec3 side = glm::cross(way, glm::dvec3(0, 1, 0));
    const double length = glm::length(side);
    return length > 1e-6 * std::max(glm::length(way), 1e-30) ? side / length : glm::dvec3(1, 0, 0);
}

glm::dvec3 turned(const glm::dvec3& v, double angle_rad, const glm::dvec3& axis) {
    return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle_rad, axis) * glm::dvec4(v, 0.0));
}

const std::string& meshNameOf(const Scene& scene, int instance) {
    return scene.meshes[std::size_t(scene.instances[std::size_t(instance)].mesh)].name;
}

/// The instances of every model that casts.
std::vector<Caster> castingModels(const Scene& scene) {
    std::vector<Caster> casters;
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        if (!scene.models[m].casts) continue;
        Caster caster{scene.models[m].name, {}};
        for (std::size_t i = 0; i < scene.instances.size(); ++i)
            if (scene.instances[i].model == int(m)) caster.instances.push_back(int(i));
        if (!caster.instances.empty()) casters.push_back(std::move(caster));
    }
    return casters;
}

Caster casterNamed(const Scene& scene, const std::string& name) {
    Caster found{name, {}};
    std::vector<std::string> names;
    const std::vector<Caster> models = castingModels(scene);
    for (const Caster& model : models) {
        if (model.name == name) return model;
        names.push_back(model.name);
    }
    for (const Caster& model : models)
        for (const int instance : model.instances) {
            const std::string& mesh = meshNameOf(scene, instance);
            if (mesh == name) found.instances.push_back(instance);
            names.push_back(mesh);
        }
    if (found.instances.empty()) throw unknownName("caster", name, names);
    return found;
}

/// How many of the script's steps are done in a frame.
int stepsDone(const MotionScript& script, int frame) {
    return script.jumpAt > 0 ? (frame >= script.jumpAt ? 1 : 0) : frame;
}

}  // namespace

const std::vector<MotionScript>& motionScripts() {
    // Steps are those of a walk, a look around and a fast sun at 60 frames a second, and no whole number of texels.
    // A jump has 2 frames before it and 30 to recover in.
    static const std::vector<MotionScript> scripts = {
        {"camera-walk", "The camera goes forward, level, by 0.07 % of the scene's diagonal a frame.",
         MotionKind::CameraWalk, 12, 0, 0.07, 0},
        {"camera-turn", "The camera turns to the left by 0.3 degrees a frame.", MotionKind::CameraTurn, 12, 0, 0, 0.3},
        {"sun-arc",
         "A sun climbs by 0.1 degrees a frame; another light goes sideways by 0.07 % of the scene's diagonal.",
         MotionKind::Light, 12, 0, 0.07, 0.1},
        {"caster-move", "A caster goes sideways by 0.07 % of the scene's diagonal a frame.", MotionKind::Caster, 12, 0,
         0.07, 0},
        {"caster-jump", "A caster jumps sideways by 3 % of the scene's diagonal.", MotionKind::Caster, 32, 2, 3, 0},
        {"light-jump", "A sun jumps up by 5 degrees; another light sideways by 3 % of the scene's diagonal.",
         MotionKind::Light, 32, 2, 3, 5},
    };
    return scripts;
}

Motion parseMotion(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string name = text.substr(0, colon);
    std::vector<std::string> names;
    for (const MotionScript& script : motionScripts()) {
        names.push_back(script.name);
        if (script.name != name) continue;
        Motion motion{script, colon == std::string::npos ? "" : text.substr(colon + 1)};
        if (colon != std::string::npos && !motion.movesCaster())
            throw Error(ErrorCode::Usage, "the motion '" + name + "' moves no caster that could be named",
                        "leave out what follows the colon");
        if (colon != std::string::npos && motion.caster.empty())
            throw Error(ErrorCode::Usage, "the motion '" + text + "' names no caster after the colon",
                        "name a model or a mesh, or leave out the colon");
        return motion;
    }
    throw unknownName("motion", name, names);
}

std::vector<Motion> parseMotions(const std::string& text) {
    std::vector<Motion> motions;
    for (const std::string& part : split(text, ',')) motions.push_back(parseMotion(trim(part)));
    return motions;
}

std::string toString(const Motion& motion) {
    return motion.script.name + (motion.caster.empty() ? "" : ":" + motion.caster);
}

Caster chosenCaster(const Scene& scene, const std::string& name) {
    if (!name.empty()) return casterNamed(scene, name);
    const double most = kLargestCaster * scene.bounds().diagonal();
    Caster chosen;
    double largest = 0;
    const auto offer = [&](const Caster& caster) {
        const double size = boundsOf(scene, caster.instances).diagonal();
        if (size > most) return false;
        if (size > largest) {
            largest = size;
            chosen = caster;
        }
        return true;
    };
    for (const Caster& model : castingModels(scene)) {
        if (offer(model)) continue;
        for (const int instance : model.instances) offer({meshNameOf(scene, instance), {instance}});
    }
    if (chosen.instances.empty())
        throw Error(ErrorCode::Usage,
                    "the scene '" + scene.name + "' has no caster that could move before something else",
                    "name a model or mesh after a colon, as in caster-move:NAME");
    return chosen;
}

void poseScene(Scene& scene, const Scene& start, const Motion& motion, int camera, int light, const Caster& caster,
               int frame) {
    // As it was, to the last bit, before the first step.
    scene.cameras = start.cameras;
    scene.lights = start.lights;
    scene.instances = start.instances;
    const int steps = stepsDone(motion.script, frame);
    if (steps == 0) return;
    const Bounds bounds = start.bounds();
    const double distance_m = steps * motion.script.percent / 100 * bounds.diagonal();
    const double angle_rad = steps * motion.script.degrees * kPi / 180;
    const Camera& cameraAtStart = start.cameras[std::size_t(camera)];
    const glm::dvec3 look = cameraAtStart.target - cameraAtStart.position;

    if (motion.script.kind == MotionKind::CameraWalk) {
        // Along the ground; straight up or down only where the camera looks so.
        const glm::dvec3 level(look.x, 0, look.z);
        const glm::dvec3 way = glm::length(level) > 1e-6 * glm::length(look) ? level : look;
        const glm::dvec3 step = glm::normalize(way) * distance_m;
        scene.cameras[std::size_t(camera)].position = cameraAtStart.position + step;
        scene.cameras[std::size_t(camera)].target = cameraAtStart.target + step;
    } else if (motion.script.kind == MotionKind::CameraTurn) {
        Camera& moved = scene.cameras[std::size_t(camera)];
        moved.target = cameraAtStart.position + turned(look, angle_rad, {0, 1, 0});
        moved.up = glm::vec3(turned(glm::dvec3(cameraAtStart.up), angle_rad, {0, 1, 0}));
    } else if (motion.script.kind == MotionKind::Light && light >= 0) {
        const Light& from = start.lights[std::size_t(light)];
        Light& to = scene.lights[std::size_t(light)];
        const glm::dvec3 direction(from.direction);
        if (from.type == LightType::Sun)
            to.direction = glm::vec3(glm::normalize(turned(direction, -angle_rad, sideways(direction))));
        else
            to.position = from.position + sideways(bounds.center() - from.position) * distance_m;
    } else if (motion.script.kind == MotionKind::Caster) {
        glm::dvec3 way(0, 0, -1);
        if (light >= 0) {
            const Light& from = start.lights[std::size_t(light)];
            way = from.type == LightType::Sun ? glm::dvec3(from.direction)
                                              : boundsOf(start, caster.instances).center() - from.position;
        }
        const glm::dmat4 move = glm::translate(glm::dmat4(1.0), sideways(way) * distance_m);
        for (const int i : caster.instances)
            scene.instances[std::size_t(i)].worldFromLocal = move * start.instances[std::size_t(i)].worldFromLocal;
    }
}

}  // namespace ombrage
