// SPDX-License-Identifier: MIT
// Light caps, a corner of its own for each triangle. PART: 1 those that face outwards, 3 those that face inwards. A vertex
// shader, because drivers may round positions that come through a geometry shader in another way than the G-buffer's.
#include "ombrage/vertex.glsl"
#include "shared/volume_edges.glsl"
#include "shared/volume_ends.glsl"

void main() {
    gl_Position = clipFromPosition(frame.clipFromWorld, nearEnd(positionWorld(a_position), a_instance));
#ifdef ONTO_NEAR_PLANE
    gl_Position = ontoNearPlane(gl_Position);
#endif
    int weight = weightOf(a_instance, uint(gl_VertexID) / 3u - b_casters[a_instance].firstTriangle);
    if (weight == 0 || facesOut(a_instance, weight) != (PART == 1)) gl_Position = vec4(0.0, 0.0, 0.0, -1.0);
}
