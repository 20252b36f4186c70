// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "render/readback.h"

namespace ombrage {

/// Views of the G-buffer that every render offers.
const std::vector<PassInfo>& standardGBufferViews();

/// One of them. `name` must be in standardGBufferViews().
ShownImage showGBuffer(const std::string& name, const GBuffer& gbuffer, const CameraView& view, const glm::dvec3& origin);

}  // namespace ombrage
