// SPDX-License-Identifier: MIT
// A flattened caster. COLORED: the light that passes goes to a second target, in colour. MASK: what the blur reads. FLAT: one
// grey, for pictures of the stages.
#ifdef ALPHA_MASK
#include "ombrage/alpha.glsl"
#else
#include "ombrage/bindings.glsl"
layout(binding = UNIT_BASE_COLOR) uniform sampler2D t_baseColor;
#endif
#include "ombrage/surface.glsl"
#include "shadow/planar/style.glsl"

#ifdef UV
in vec2 v_uv;
#endif
#ifdef VERTEX_COLORS
in vec3 v_color;
#endif
#ifdef SURFACE
flat in uvec2 v_surface;
#endif
#ifdef HEIGHT
in float v_height_m;
#endif
#ifdef ON_PLANE
in vec4 v_shadow;
uniform vec4 u_plane;
#endif

#ifdef EDGE_ON
flat in uint v_isEdgeOn;
#endif

#ifdef MASK
layout(location = 0) out vec2 o_mask;   // 1, and more the lower the caster: blending keeps the largest
#else
layout(location = 0) out float o_visibility;
#endif
#ifdef COLORED
layout(location = 1) out vec4 o_colored;
#endif
uniform float u_grey;   // per metre with HEIGHT

void main() {
#ifdef EDGE_ON
    if (v_isEdgeOn != 0u) discard;
#endif
#ifdef ALPHA_MASK
    if (isHole(v_surface.y, v_uv)) discard;
#endif
    vec3 caster = vec3(0.0), p_world = vec3(0.0), n = vec3(0.0);
#if defined(SURFACE) && STYLE == STYLE_TEXTURED
    caster = unpackedAlbedo(v_surface.x);
#ifdef BASE_COLOR_MAP
    caster *= texture(t_baseColor, v_uv).rgb;
#endif
#ifdef VERTEX_COLORS
    caster *= v_color;
#endif
#endif
#ifdef ON_PLANE
    p_world = v_shadow.xyz / v_shadow.w;
    n = u_plane.xyz;
#endif
#if defined(MASK)
    o_mask = vec2(1.0, 1.0 - v_height_m * u_grey);
#ifdef COLORED
    o_colored = vec4(caster, 1.0);
#endif
#elif defined(FLAT)
    o_visibility = u_grey;
#ifdef HEIGHT
    o_visibility *= abs(v_height_m);
#endif
#else
    vec3 passed = passedByShadow(caster, p_world, n);
    o_visibility = visibilityOf(passed);
#ifdef COLORED
    o_colored = vec4(passed, 1.0);
#endif
#endif
}
