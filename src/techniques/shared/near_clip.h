// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/camera_view.h"

namespace ombrage {

/// All points that can shade a point of the camera's near plane: the hull of its rectangle and the light (Everitt and
/// Kilgard 2002, section 6.2). A caster outside of it leaves the near plane whole, and z-pass may count it.
class NearClipVolume {
public:
    /// @param toward  the light: (position, 1), or (direction to a sun, 0)
    NearClipVolume(const CameraView& view, const glm::vec4& toward);

    /// Whether a box may reach into it; never false for one that does.
    bool touches(const glm::vec3& lower, const glm::vec3& upper) const;

private:
    std::vector<glm::dvec4> m_planes;  ///< inside is above 0; none: everything is inside
};

}  // namespace ombrage
