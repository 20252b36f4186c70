// SPDX-License-Identifier: MIT
// One triangle over the whole viewport.
out vec2 v_uv;   // (0,0) lower left, (1,1) upper right

void main() {
    vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
    v_uv = corner * 0.5;
    gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
