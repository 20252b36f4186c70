// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage::shapes {

/// Generated meshes: counter-clockwise from outside, with normals and texture coordinates (about one unit per metre);
/// tangents are left to makeTangents(). Lengths in metres. Those marked closed are closed manifolds once equal
/// positions are welded.

/// A flat rectangle from `corner` along u and v, its normal along cross(u, v), cut into uCount x vCount quads.
Mesh rectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, int uCount = 1, int vCount = 1);

/// A level floor about (0, y, 0), facing up.
Mesh floor(float size, float y = 0.0f, int count = 8);

/// Closed; flat faces. With `inward` the faces look in: the walls of a room.
Mesh box(const glm::vec3& lower, const glm::vec3& upper, bool inward = false);

/// Closed; `slices` around the vertical axis, `stacks` from pole to pole, smooth normals.
Mesh sphere(const glm::vec3& center, float radius, int slices = 64, int stacks = 32);

/// Closed; vertical, standing on `foot`, smooth sides and flat ends.
Mesh cylinder(const glm::vec3& foot, float radius, float height, int slices = 32);

/// Open: a level disk facing up, a fan and `rings` - 1 rings of `slices` quads.
Mesh disk(const glm::vec3& center, float radius, int slices = 256, int rings = 4);

/// Open, without thickness: the upper half of a tube along x about `center`, normals outwards.
Mesh halfTube(const glm::vec3& center, float radius, float length, int slices = 32, int segments = 8);

/// Open, without thickness: the lower half of a sphere, normals outwards.
Mesh bowl(const glm::vec3& center, float radius, int slices = 48, int stacks = 12);

/// Closed: a Menger sponge standing on y = `bottom` about the vertical axis, only the faces that are outside.
Mesh mengerSponge(int level, float side, float bottom);

/// Closed: a straight tube with flat ends, its radius going from `startRadius` to `endRadius`.
Mesh tube(const glm::vec3& start, const glm::vec3& end, float startRadius, float endRadius, int slices = 16);

/// Closed: a ring about the z axis through `center`; `sides` around its own section.
Mesh torus(const glm::vec3& center, float radius, float thickness, int slices = 64, int sides = 10);

/// Closed: the outline (counter-clockwise seen from +z, not crossing itself, star-shaped about its first corner) drawn
/// from z = 0 to z = `depth`.
Mesh prism(const std::vector<glm::vec2>& outline, float depth);

/// Closed: a wall from `lower` to `upper` (in x and y) and from z = 0 to z = `depth` with a rectangular opening.
Mesh wallWithOpening(const glm::vec2& lower, const glm::vec2& upper, const glm::vec2& openingLower,
                     const glm::vec2& openingUpper, float depth);

/// Closed: half a ring that stands on y = 0 with its feet about x = 0 and x = `span`, from z = 0 to z = `depth`.
Mesh arch(float span, float thickness, float depth, int steps = 16);

/// Open, both sides alike: a rectangle whose texture is shown once.
Mesh card(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v);

/// Puts a mesh's triangles behind those of another.
void append(Mesh& mesh, const Mesh& other);

}  // namespace ombrage::shapes
