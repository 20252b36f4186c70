// SPDX-License-Identifier: MIT
// Per tile: x the greatest height of the casters whose half-shadow can reach it, less than 0 where none can; y 1 where all that
// can reach it is covered. A caster of a tile reaches as far as the light's image past its height is wide.
#include "shadow/planar/penumbra.glsl"

layout(binding = 5) uniform sampler2D t_tiles;

uniform vec2 u_tileInMask;   // a tile's share of the mask
uniform float u_highest_m;   // no caster counts as higher

layout(location = 0) out vec2 o_reach;

// The point of the plane that is seen at a place of the mask. Past the horizon w is 0 or less.
vec4 pointOfPlane(vec2 uv) {
    vec2 plane = (uv * 2.0 - 1.0) / u_zoom * frame.projection.zw;
    vec3 aside = frame.worldFromView[0].xyz * plane.x + frame.worldFromView[1].xyz * plane.y;
    vec3 start = frame.eye.xyz + (isOrthographic() ? aside : vec3(0.0));
    vec3 along = frame.forward.xyz + (isOrthographic() ? vec3(0.0) : aside);
    float falling = -dot(u_plane.xyz, along);
    return vec4(start * falling + along * (dot(u_plane.xyz, start) + u_plane.w), falling);
}

// Of a disk's image in the mask: the centre (clip x, y, w), and from the half axes u and v the sums that tell its borders.
struct Extents {
    vec3 centre;
    float ww;
    vec2 sw, ss;
};

// Whether the disk, its axes that much longer, may touch a tile. The lines x = t that touch the ellipse are the zeros of
// (c_x - t c_w)^2 - (u_x - t u_w)^2 - (v_x - t v_w)^2; y likewise. A tile more on each side, for points beside the own tile's middle.
bool isWithin(Extents e, float longer, vec2 tile) {
    float l2 = longer * longer, a = e.centre.z * e.centre.z - l2 * e.ww;
    if (a <= 0.0) return true;
    vec2 b = e.centre.xy * e.centre.z - l2 * e.sw, c = e.centre.xy * e.centre.xy - l2 * e.ss;
    vec2 root = sqrt(max(b * b - a * c, vec2(0.0)));
    vec2 lower = (tile - 1.0) * u_tileInMask * 2.0 - 1.0, upper = (tile + 2.0) * u_tileInMask * 2.0 - 1.0;
    return all(lessThanEqual((b - root) / a, upper)) && all(greaterThanEqual((b + root) / a, lower));
}

void main() {
    ivec2 size = textureSize(t_tiles, 0);
    // The middle may lie past the horizon where a corner does not: then everything can reach it.
    vec4 point = pointOfPlane(gl_FragCoord.xy * u_tileInMask);
    bool isSeen = point.w > 1e-6 * length(point.xyz);
    vec3 p_world = point.xyz / point.w, centre = clipXyw(vec4(p_world, 1.0));

    // Half axes of the disk's image on the plane, to first order. Past a blocker at the height h they are k(h) (u - P.u (L - w p) / H)
    // with k(h) = h / (H - h w): the height decides of the size alone.
    float lightHeight = dot(u_plane, u_toward);
#ifdef CONTACT
    LightDisk disk = lightDisk(p_world);
    // Half-shadows of a light that sinks under the plane have no end.
    isSeen = isSeen && length(vec2(dot(u_plane.xyz, disk.u), dot(u_plane.xyz, disk.v))) < 0.9 * lightHeight;
    vec3 toLight = (u_toward.xyz - u_toward.w * p_world) / lightHeight;
    vec3 u = clipXyw(vec4(disk.u - dot(u_plane.xyz, disk.u) * toLight, 0.0));
    vec3 v = clipXyw(vec4(disk.v - dot(u_plane.xyz, disk.v) * toLight, 0.0));
#else
    DiskImage image = constantImage(p_world);
    vec3 u = image.u, v = image.v;
#endif
    Extents extents = Extents(centre, dot(vec2(u.z, v.z), vec2(u.z, v.z)), u.xy * u.z + v.xy * v.z, u.xy * u.xy + v.xy * v.xy);

    o_reach = vec2(-1.0, 1.0);
    float reachGrowth = 0.0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            float height_m = min(texelFetch(t_tiles, ivec2(x, y), 0).x, u_highest_m);
            if (height_m < 0.0) continue;
            float growth = growthAt(height_m, lightHeight);
            if (isSeen && !isWithin(extents, growth, vec2(x, y))) continue;
            o_reach.x = max(o_reach.x, height_m);
            reachGrowth = max(reachGrowth, growth);
        }
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (texelFetch(t_tiles, ivec2(x, y), 0).y < 1.0 && (!isSeen || isWithin(extents, reachGrowth, vec2(x, y)))) o_reach.y = 0.0;
}
