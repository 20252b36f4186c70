// SPDX-License-Identifier: MIT
#include "scene/builtin.h"

#include <ombrage/error.h>

namespace ombrage {

namespace {
struct Entry {
    BuiltinScene scene;
    Scene (*make)();
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        {{"plane-grazing",
          "A large floor under a sun 4 degrees above it: acne, and the gap that too much bias leaves."},
         builtin::planeGrazing},
        {{"gap", "A box 1 mm above the floor: its shadow comes loose from it where the bias is too large."},
         builtin::gap},
        {{"in-shadow", "The camera stands inside the shadow of a roof: counting volumes from the camera goes wrong."},
         builtin::inShadow},
        {{"two-casters", "Two slabs at very different heights above one another: moment-based maps leak light."},
         builtin::twoCasters},
        {{"room", "A closed room lit from its middle: seams, faces and edges of an omnidirectional map."},
         builtin::room},
        {{"sphere", "A faceted sphere: false self-shadows along the line between its lit and unlit side."},
         builtin::sphere},
        {{"comb", "Teeth thinner than a texel of a shadow map: aliasing, and casters that vanish."}, builtin::comb},
        {{"menger", "A Menger sponge of 36,096 triangles: nested cavities for volumes, maps and occlusion."},
         builtin::menger},
        {{"cornell",
          "A Cornell-like box with two blocks and a small light: contact shadows and occlusion in an interior."},
         builtin::cornell},
        {{"corner", "Two walls and a floor at right angles: ambient occlusion with a closed form."}, builtin::corner},
        {{"disk", "A disk parallel to the floor: ambient occlusion with a closed form, and an open caster."},
         builtin::disk},
        {{"open-mesh",
          "A half tube and a bowl without thickness: no closed volume, so shadow volumes and second-depth maps fail."},
         builtin::openMesh},
        {{"area-overlap",
          "Two boards under a lamp with a size: overlapping penumbrae, where blockers cannot be told apart."},
         builtin::areaOverlap},
    };
    return all;
}
}  // namespace

const std::vector<BuiltinScene>& builtinScenes() {
    static const std::vector<BuiltinScene> scenes = [] {
        std::vector<BuiltinScene> list;
        for (const Entry& entry : entries()) list.push_back(entry.scene);
        return list;
    }();
    return scenes;
}

Scene makeBuiltinScene(const std::string& name) {
    std::vector<std::string> names;
    for (const Entry& entry : entries()) {
        if (entry.scene.name == name) {
            Scene scene = entry.make();
            scene.description = entry.scene.description;
            return scene;
        }
        names.push_back(entry.scene.name);
    }
    throw unknownName("scene", name, names);
}

}  // namespace ombrage
