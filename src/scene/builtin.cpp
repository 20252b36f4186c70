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
        {{"penumbrae",
          "Casters apart from one another under a lamp, a sun, a spot and a panel with sizes: penumbrae alone."},
         builtin::penumbrae},
        {{"thin-wall",
          "A shelter of boards 1 cm thick: bias and filters wider than a board let the sun in at its seams."},
         builtin::thinWall},
        {{"resting",
          "Boxes, a drum and a ball exactly on what bears them: any bias opens a line of light at the contact."},
         builtin::resting},
        {{"far-origin",
          "A box 1 mm above a floor 5 km from the origin: 32-bit world coordinates lose the gap and the edges."},
         builtin::farOrigin},
        {{"touching",
          "A lamp inside a lantern and one 1 mm from a plinth: near planes cut casters off, volumes start at the "
          "light."},
         builtin::touching},
        {{"head-lamp",
          "A lamp at the viewer's forehead: shadows are thin rims beside their casters, and all else that is dark is "
          "false."},
         builtin::headLamp},
        {{"long-view",
          "A road of 400 m with fence posts: one map for all of it has texels larger than what casts nearby."},
         builtin::longView},
        {{"light-ahead", "A low sun straight ahead among columns: maps that are warped along the view degenerate."},
         builtin::lightAhead},
        {{"behind",
          "A gate behind the camera and a slab beside it: casters that are culled with the view lose their shadows."},
         builtin::behind},
        {{"window",
          "A room whose sun comes through one small opening: few texels carry all of the light, and seams leak."},
         builtin::window},
        {{"penumbra-ramp",
          "Thin poles and rungs at all heights above the floor: hard edges alias, soft ones must widen from the foot "
          "on."},
         builtin::penumbraRamp},
        {{"fence", "A lattice that is one rectangle with holes in its texture: techniques without alpha test fill it."},
         builtin::fence},
        {{"three-casters", "Three slabs above one another: more depths in a texel than four moments can tell apart."},
         builtin::threeCasters},
        {{"bicycle", "Spokes of 2 mm and thin tubes: casters far below a texel come and go."}, builtin::bicycle},
        {{"tree", "Alpha-tested leaves by the thousand: holes, aliasing and noise where the crown shades itself."},
         builtin::tree},
        {{"fur", "24,000 hairs of 1 mm, open and thinner than a texel: a map takes the fur for a solid, or loses it."},
         builtin::fur},
        {{"glass",
          "Coloured translucent panes: techniques that know only opaque casters give black shadows instead of tinted "
          "ones."},
         builtin::glass},
        {{"figure",
          "A walking figure of jointed limbs: its shadow must follow every joint, and its limbs shade one another."},
         builtin::figure},
        {{"bumpy",
          "Brick walls and tiles with height and normal maps: occlusion and shadows must keep to the geometry where "
          "the shading bends."},
         builtin::bumpy},
        {{"nave",
          "Columns, arches and height-mapped walls around a lamp: an interior that stretches a map over many depths."},
         builtin::nave},
        {{"many-lights", "32 coloured lamps among 36 blocks: whatever is paid once per light is paid 32 times."},
         builtin::manyLights},
        {{"mirrored",
          "Stairs with negative and uneven scales: turned winding and bent normals make shadows inside out."},
         builtin::mirrored},
        {{"degenerate",
          "Triangles with corners that are no numbers, without area and there twice: one alone can spoil bounds, trees "
          "and pixels."},
         builtin::degenerate},
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
