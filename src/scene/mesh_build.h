// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// Edges sharper than this stay sharp when normals are made.
inline constexpr double kCreaseAngle_deg = 80.0;

/// Removes triangles with a non-finite corner, an index out of range or no area. Vertices stay. Returns how many went.
std::size_t dropBadTriangles(Mesh& mesh);

/// Makes vertices with equal bits one, in order of first use, and drops those that no triangle uses.
void joinVertices(Mesh& mesh);

/// Gives every vertex without a usable normal (arrays missing, zero or non-finite) a smooth one: the mean of the faces
/// that meet at its position within the crease angle, weighted by their angle there (Thuermer and Wuethrich 1998).
/// Vertices at one position count as one; a vertex whose corners need different normals is split. The rest become unit
/// length.
void completeNormals(Mesh& mesh);

/// Makes tangents from the texture coordinates (Lengyel 2001, area-weighted): the tangent points to growing u, w *
/// cross(n, t) to the top row of the texture (falling v), as glTF normal maps want it. Vertices shared by mirrored and
/// unmirrored triangles are split. Where the coordinates have no area any perpendicular serves.
void makeTangents(Mesh& mesh);

}  // namespace ombrage
