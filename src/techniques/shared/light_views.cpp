// SPDX-License-Identifier: MIT
#include "techniques/shared/light_views.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace ombrage {

namespace {

struct Box {
    glm::vec3 lower{INFINITY}, upper{-INFINITY};
    void add(const glm::vec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    bool empty() const { return !(lower.x <= upper.x); }
};

/// Looks for flat instances with nothing behind them, seen from a sun. Its work is bounded, however many there are.
class LowestPlanes {
public:
    LowestPlanes(const FlatScene& flat, const glm::vec3& toLight) : m_flat(flat), m_toLight(toLight) {
        for (const glm::vec3& p : flat.positions) m_all.add(p);
    }

    /// Whether the instance is flat and everything else lies on the side from which the light comes. "No" for some
    /// after many: they then count as casters, which costs resolution and nothing else.
    bool holds(const FlatInstance& instance);

private:
    bool nothingBehind(const glm::vec3& point, const glm::vec3& normal, float tolerance);

    const FlatScene& m_flat;
    glm::vec3 m_toLight;
    Box m_all;
    std::size_t m_last = 0;   ///< the vertex that lay behind the plane before
    int m_searchesLeft = 64;  ///< of all vertices
};

bool LowestPlanes::nothingBehind(const glm::vec3& point, const glm::vec3& normal, float tolerance) {
    const auto behind = [&](const glm::vec3& p) { return glm::dot(p - point, normal) < -tolerance; };
    // Two tests that need no search: the corner of the bounds that lies farthest behind, and who was found before.
    const glm::vec3 deepest(normal.x > 0 ? m_all.lower.x : m_all.upper.x, normal.y > 0 ? m_all.lower.y : m_all.upper.y,
                            normal.z > 0 ? m_all.lower.z : m_all.upper.z);
    if (!behind(deepest)) return true;
    if (behind(m_flat.positions[m_last]) || m_searchesLeft == 0) return false;

    --m_searchesLeft;
    const auto found = std::find_if(m_flat.positions.begin(), m_flat.positions.end(), behind);
    if (found == m_flat.positions.end()) return true;
    m_last = std::size_t(found - m_flat.positions.begin());
    return false;
}

bool LowestPlanes::holds(const FlatInstance& instance) {
    const FlatScene& flat = m_flat;
    // The plane of the first triangle with an area.
    glm::vec3 normal(0.0f), point(0.0f);
    for (std::uint32_t t = 0; t < instance.triangleCount && normal == glm::vec3(0.0f); ++t) {
        const glm::uvec3 v = flat.triangles[instance.firstTriangle + t];
        point = flat.positions[v.x];
        normal = glm::cross(flat.positions[v.y] - point, flat.positions[v.z] - point);
    }
    if (normal == glm::vec3(0.0f)) return true;
    normal = glm::normalize(normal);
    if (glm::dot(normal, m_toLight) < 0) normal = -normal;

    // Flat to within rounding of the coordinates; others may touch the plane but not pass it.
    float extent = 0;
    for (std::uint32_t v = 0; v < instance.vertexCount; ++v)
        extent = std::max(extent, glm::length(flat.positions[instance.firstVertex + v] - point));
    const float tolerance = 1e-5f * extent;
    for (std::uint32_t v = 0; v < instance.vertexCount; ++v)
        if (std::abs(glm::dot(flat.positions[instance.firstVertex + v] - point, normal)) > tolerance) return false;
    return nothingBehind(point, normal, tolerance);
}

/// The corners of what the camera sees of the scene's bounds: the frustum cut off at the farthest corner of the bounds.
std::array<glm::vec3, 8> visibleCorners(const FrameContext& frame) {
    const CameraView& view = frame.fitView;
    const glm::vec3 lower(frame.gpuScene->bounds().lower - frame.gpuScene->origin());
    const glm::vec3 upper(frame.gpuScene->bounds().upper - frame.gpuScene->origin());
    float farthest = 0;
    for (int c = 0; c < 8; ++c) {
        const glm::vec3 corner(c & 1 ? upper.x : lower.x, c & 2 ? upper.y : lower.y, c & 4 ? upper.z : lower.z);
        farthest = std::max(farthest, glm::dot(corner - view.eye, view.forward));
    }
    const float aspect = float(view.width) / float(view.height);
    std::array<glm::vec3, 8> corners;
    for (int c = 0; c < 8; ++c) {
        const float distance_m = c & 4 ? farthest : 0.0f;
        const float half = view.orthographic ? view.orthoHeight_m * 0.5f : distance_m * view.tanHalfFovY;
        corners[std::size_t(c)] = view.eye + view.forward * distance_m + view.up * (c & 2 ? half : -half) +
                                  view.right * ((c & 1 ? half : -half) * aspect);
    }
    return corners;
}

LightView sunView(const FrameContext& frame, const LightFrame& light, LightFit fit) {
    LightView view;
    view.forward = light.direction;
    view.right = lightTangent(*light.light);
    view.up = glm::cross(view.right, view.forward);
    const auto toLightSpace = [&](const glm::vec3& p) {
        return glm::vec3(glm::dot(p, view.right), glm::dot(p, view.up), glm::dot(p, view.forward));
    };

    // Extent of the casters that matter, depth range of everything.
    const FlatScene& flat = frame.gpuScene->flat();
    LowestPlanes lowest(flat, -light.direction);
    Box casters, all;
    for (const FlatInstance& instance : flat.instances) {
        const bool matters = instance.casts && !lowest.holds(instance);
        for (std::uint32_t v = 0; v < instance.vertexCount; ++v) {
            const glm::vec3 p = toLightSpace(flat.positions[instance.firstVertex + v]);
            all.add(p);
            if (matters) casters.add(p);
        }
    }
    if (casters.empty()) casters = all;
    if (fit == LightFit::View) {
        Box seen;
        for (const glm::vec3& corner : visibleCorners(frame)) seen.add(toLightSpace(corner));
        const glm::vec3 lower = glm::max(casters.lower, seen.lower), upper = glm::min(casters.upper, seen.upper);
        if (lower.x < upper.x && lower.y < upper.y) {
            casters.lower = glm::vec3(lower.x, lower.y, casters.lower.z);
            casters.upper = glm::vec3(upper.x, upper.y, casters.upper.z);
        }
    }

    // A border of one part in a thousand keeps the outermost silhouettes off the map's edge.
    const glm::vec3 center = (casters.lower + casters.upper) * 0.5f;
    const glm::vec2 half = glm::vec2(casters.upper - casters.lower) * 0.5f;
    const float smallest = 1e-4f * std::max(glm::length(half), 1e-3f);
    view.halfExtent = glm::max(half * 1.002f, glm::vec2(smallest));
    const float depth = std::max(all.upper.z - all.lower.z, smallest);
    const float nearest = all.lower.z - 1e-3f * depth;
    view.origin = view.right * center.x + view.up * center.y + view.forward * nearest;
    view.near_m = 0.0f;
    view.far_m = depth * 1.002f;
    return view;
}

/// Half the distance to the nearest caster's bounds, or a small part of their size when the light is among them.
float nearPlane(const FrameContext& frame, const glm::vec3& position) {
    const glm::vec3 lower = frame.gpuScene->casterLower(), upper = frame.gpuScene->casterUpper();
    const float distance_m = glm::length(position - glm::clamp(position, lower, upper));
    return std::max(distance_m * 0.5f, 1e-4f * glm::length(upper - lower));
}

/// The halves above and below.
void addParaboloids(LightViews& made, LightView view, float margin) {
    for (const float side : {1.0f, -1.0f}) {
        view.forward = glm::vec3(0, side, 0);
        view.right = glm::vec3(1, 0, 0);
        view.up = glm::cross(view.right, view.forward);
        view.halfExtent = glm::vec2(1.0f / (1.0f - margin));
        made.views.push_back(view);
    }
}

/// Row vectors (x, y, 1) of a view's picture from a direction d: dot(d, X), dot(d, Y), over dot(d, forward), such that
/// three directions show at three given points.
void addTetrahedron(LightViews& made, LightView view, float margin) {
    // One corner, where texels are finest, points down.
    const float c = std::sqrt(8.0f) / 3.0f, half = std::sqrt(0.75f) * c;
    const glm::vec3 corners[4] = {
        {0, -1, 0}, {c, 1.0f / 3.0f, 0}, {-0.5f * c, 1.0f / 3.0f, half}, {-0.5f * c, 1.0f / 3.0f, -half}};
    // Half a square, lower left or upper right, less the margin along its three sides (2 of its units are the square).
    const float m = 2.0f * margin, far = 1.0f - m * (1.0f + std::sqrt(2.0f));
    const glm::vec3 x(-1.0f + m, far, -1.0f + m), y(-1.0f + m, -1.0f + m, far);
    for (int face = 0; face < 4; ++face) {
        // The face opposite to a corner; where d . forward is 1 its corners are three times the unit ones. The lowest
        // of them has the right angle.
        view.forward = -corners[face];
        glm::mat3 rows;
        for (int k = 0; k < 3; ++k) rows[k] = 3.0f * corners[k < face ? k : k + 1];
        const glm::mat3 solve = glm::inverse(glm::transpose(rows));
        const float side = face % 2 == 0 ? 1.0f : -1.0f;
        view.right = solve * (x * side);
        view.up = solve * (y * side);
        // A texel's greatest size at unit distance along the axis, as other views have it.
        const glm::mat3 ray = glm::inverse(glm::transpose(glm::mat3(view.right, view.up, view.forward)));
        view.halfExtent = glm::vec2(std::max(glm::length(ray[0]), glm::length(ray[1])));
        view.right *= view.halfExtent.x;
        view.up *= view.halfExtent.y;
        made.views.push_back(view);
    }
}

}  // namespace

LightViews makeLightViews(const FrameContext& frame, const LightFrame& light, LightFit fit, float margin,
                          LightShape shape) {
    constexpr float kWidestSpot_rad = 1.308997f;  // 75 degrees: beyond it one picture wastes its texels on the rim
    LightViews made;
    if (light.light->type == LightType::Sun) {
        made.views.push_back(sunView(frame, light, fit));
        return made;
    }
    made.perspective = true;
    LightView view;
    view.origin = light.position;
    view.near_m = nearPlane(frame, light.position);
    made.shape = shape;
    if (shape == LightShape::Paraboloids) addParaboloids(made, view, margin);
    if (shape == LightShape::Tetrahedron) addTetrahedron(made, view, margin);
    if (shape != LightShape::Usual) return made;
    if (light.light->type == LightType::Spot && light.light->outer_rad <= kWidestSpot_rad) {
        view.forward = light.direction;
        view.right = lightTangent(*light.light);
        view.up = glm::cross(view.right, view.forward);
        // A texel's breadth beyond the cone, so that its rim is inside whatever the resolution.
        view.halfExtent = glm::vec2(std::tan(light.light->outer_rad) * 1.01f);
        made.views.push_back(view);
        return made;
    }
    const glm::vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int face = 0; face < 6; ++face) {
        view.forward = axes[face / 2] * (face % 2 == 0 ? 1.0f : -1.0f);
        view.right = axes[(face / 2 + 1) % 3];
        view.up = glm::cross(view.right, view.forward);
        view.halfExtent = glm::vec2(1.0f / (1.0f - margin));
        made.views.push_back(view);
    }
    return made;
}

glm::mat4 LightViews::clipFromWorld(std::size_t index) const {
    const LightView& v = views[index];
    // Rows of the affine part: light-space coordinates of a point.
    const glm::vec4 x(v.right, -glm::dot(v.right, v.origin));
    const glm::vec4 y(v.up, -glm::dot(v.up, v.origin));
    const glm::vec4 d(v.forward, -glm::dot(v.forward, v.origin));
    const glm::vec4 unit(0, 0, 0, 1);
    const glm::vec4 rows[4] = {x / v.halfExtent.x, y / v.halfExtent.y,
                               perspective ? unit * v.near_m : (unit * v.far_m - d) / (v.far_m - v.near_m),
                               perspective ? d : unit};
    glm::mat4 m;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) m[c][r] = rows[r][c];
    return m;
}

TexelFootprint LightViews::footprint(int resolution) const {
    float widest = 0;
    for (const LightView& v : views) widest = std::max({widest, v.halfExtent.x, v.halfExtent.y});
    // In the middle of a paraboloid twice as much is shown as at its rim.
    const double texel = (shape == LightShape::Paraboloids ? 4.0 : 2.0) * double(widest) / resolution;
    return perspective ? TexelFootprint{0, texel, 0.5} : TexelFootprint{texel, 0, 0.5};
}

ShadowRange LightViews::range(const glm::dvec3& origin) const {
    ShadowRange range;
    if (shape != LightShape::Usual) return range;  // everything
    for (std::size_t i = 0; i < views.size(); ++i)
        range.clipFromWorld.push_back(glm::translate(glm::dmat4(clipFromWorld(i)), -origin));
    return range;
}

void LightViews::setUniforms(const gl::Program& program) const {
    glm::vec4 origin[6], right[6], up[6], forward[6];
    const int count = int(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        const LightView& v = views[i];
        origin[i] = glm::vec4(v.origin, v.far_m);
        right[i] = glm::vec4(v.right, v.halfExtent.x);
        up[i] = glm::vec4(v.up, v.halfExtent.y);
        forward[i] = glm::vec4(v.forward, v.near_m);
    }
    program.set("u_viewOrigin", origin, count);
    program.set("u_viewRight", right, count);
    program.set("u_viewUp", up, count);
    program.set("u_viewForward", forward, count);
    if (shape != LightShape::Tetrahedron) return;

    // Rays from points of the picture, [-1,1].
    glm::vec4 rays[12];
    for (std::size_t i = 0; i < views.size(); ++i) {
        const LightView& v = views[i];
        const glm::mat3 ray =
            glm::inverse(glm::transpose(glm::mat3(v.right / v.halfExtent.x, v.up / v.halfExtent.y, v.forward)));
        for (int k = 0; k < 3; ++k) rays[3 * i + std::size_t(k)] = glm::vec4(ray[k], 0.0f);
    }
    program.set("u_viewRays", rays, 12);
}

std::vector<std::pair<std::string, std::string>> LightViews::defines() const {
    std::vector<std::pair<std::string, std::string>> defines{{"LIGHT_VIEWS", std::to_string(views.size())},
                                                             {"LIGHT_PERSPECTIVE", perspective ? "1" : "0"}};
    if (shape == LightShape::Paraboloids) defines.emplace_back("LIGHT_PARABOLOIDS", "1");
    if (shape == LightShape::Tetrahedron) defines.emplace_back("LIGHT_TETRAHEDRON", "1");
    return defines;
}

std::string LightViews::perPass() {
    return "#include \"shared/light_views.glsl\"\nvoid passLookup() { passLightViews(); }\n";
}

}  // namespace ombrage
