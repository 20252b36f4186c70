// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "render/readback.h"

namespace ombrage {

/// Views of the G-buffer that every render offers.
const std::vector<PassInfo>& standardGBufferViews();

/// One of them. `name` must be in standardGBufferViews(); "material" needs its plane.
ShownImage showGBuffer(const std::string& name, const GBuffer& gbuffer, const CameraView& view, const FlatScene& flat);

/// Instance and global triangle of every pixel, kNoHit for the sky, row 0 at the top.
void readIds(const GBuffer& gbuffer, const FlatScene& flat, std::vector<std::uint32_t>& instance,
             std::vector<std::uint32_t>& triangle);

}  // namespace ombrage
