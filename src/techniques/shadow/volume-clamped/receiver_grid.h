// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// How a box lies to a light: along the axis from the light through the box's middle. Distances count from the light,
/// under a sun from LightRays::start_m.
struct BoxSight {
    glm::vec3 axis{0.0f};
    float nearest_m = 0, farthest_m = 0;  ///< along the axis
    float closest_m = 0;                  ///< from the light itself
    float halfAngle_rad = 0;              ///< of the cone around the box; of a point light
    glm::vec2 lower{0.0f}, upper{0.0f};   ///< the rectangle around it across a sun's rays
};

/// The rays of a light, in the space moved by the scene's origin, and a grid over them: a square across a sun's rays,
/// the six faces of a cube around any other light.
struct LightRays {
    bool sun = false;
    glm::vec3 position{0.0f};            ///< of a light that is none
    glm::vec3 direction{0.0f};           ///< a sun's: unit
    glm::vec3 right{0.0f}, up{0.0f};     ///< across a sun's rays
    glm::vec2 corner{0.0f}, size{1.0f};  ///< the square, from the bounds given
    float start_m = 0;                   ///< smallest distance along a sun's rays of anything in the bounds

    static LightRays ofSun(const glm::vec3& direction, const glm::vec3& right, const glm::vec3& lower,
                           const glm::vec3& upper);
    static LightRays from(const glm::vec3& position);

    int faces() const { return sun ? 1 : 6; }

    /// How a box lies to the light; none for a box so near to a point light that no plane lies between its points and
    /// those behind it.
    std::optional<BoxSight> sight(const glm::vec3& lower, const glm::vec3& upper) const;

    /// The plane across an axis at a distance as in BoxSight, dot(plane, (p, 1)) < 0 on the light's side.
    glm::vec4 plane(const glm::vec3& axis, float distance_m) const;
    /// How far a point lies along the axis.
    float along(const glm::vec3& axis, const glm::vec3& p) const;
};

/// Where the visible receivers are, seen from a light: the slabs of Lloyd et al. 2004, one per cell.
class ReceiverGrid {
public:
    struct Range {
        float nearest_m, farthest_m;
    };
    static constexpr std::uint32_t kEmpty = 0xffffffffu;  ///< the nearest distance's bits in a cell without receivers

    /// @param cells  of each face cellsAcross x cellsAcross: the bits of the nearest and of the farthest distance as
    ///               floats, or kEmpty
    ReceiverGrid(const LightRays& rays, int cellsAcross, std::vector<glm::uvec2> cells);

    /// What receivers there may be in the box's shadow, or in the box: distances along its axis, no less far apart than
    /// they are.
    std::optional<Range> receiversOf(const BoxSight& box) const;
    /// The farthest of them from the light itself.
    float farthestOf(const BoxSight& box) const;

    /// As given.
    const std::vector<glm::uvec2>& cells() const { return m_cells; }

private:
    template <typename F>
    void forCellsOf(const BoxSight& box, F&& visit) const;

    LightRays m_rays;
    int m_cellsAcross;
    std::vector<glm::uvec2> m_cells;
    struct Cone {
        glm::vec3 axis;
        float halfAngle_rad;
    };
    std::vector<Cone> m_cones;  ///< of each cell around a point light
};

}  // namespace ombrage
