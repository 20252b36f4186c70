// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace ombrage {

/// What a script moves. "Percent" is of the diagonal of the scene's bounds.
enum class MotionKind {
    CameraWalk,  ///< the camera goes forward, level: percent
    CameraTurn,  ///< it turns to the left about the vertical axis through itself: degrees
    Light,       ///< a sun climbs by degrees, any other light goes sideways by percent; see poseScene
    Caster       ///< a caster goes sideways across the light, level: percent
};

/// A motion of one thing over some frames, that fits any scene.
struct MotionScript {
    std::string name;         ///< "camera-walk"
    std::string description;  ///< one sentence
    MotionKind kind = MotionKind::CameraWalk;
    int frames = 2;
    int jumpAt = 0;  ///< the frame in which all of the motion happens; 0: a step before each frame but the first
    double percent = 0, degrees = 0;  ///< of one step, or of the jump
};

/// All scripts, in a fixed order: camera-walk, camera-turn, sun-arc, caster-move, caster-jump, light-jump.
const std::vector<MotionScript>& motionScripts();

/// A script and, for one that moves a caster, which; an empty name leaves the choice to chosenCaster's rule.
struct Motion {
    MotionScript script;
    std::string caster;

    bool movesCamera() const { return script.kind == MotionKind::CameraWalk || script.kind == MotionKind::CameraTurn; }
    bool movesLight() const { return script.kind == MotionKind::Light; }
    bool movesCaster() const { return script.kind == MotionKind::Caster; }
};

/// "NAME" or, for a script that moves a caster, "NAME:CASTER", where CASTER is a model or a mesh.
/// @throws Error(Usage) with a suggestion.
Motion parseMotion(const std::string& text);

/// Several, separated by commas.
std::vector<Motion> parseMotions(const std::string& text);

/// The text that parseMotion takes.
std::string toString(const Motion& motion);

}  // namespace ombrage
