// SPDX-License-Identifier: MIT
// From space to the screen, for every stage that places vertices.

// Homogeneous: w = 0 is a direction.
vec4 clipFromPosition(mat4 clipFromWorld, vec4 p_world) {
    precise vec4 clip = clipFromWorld[0] * p_world.x + clipFromWorld[1] * p_world.y + clipFromWorld[2] * p_world.z +
                        clipFromWorld[3] * p_world.w;
    return clip;
}
