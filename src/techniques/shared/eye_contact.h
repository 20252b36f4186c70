// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace ombrage {

class FrameContext;

/// Whether a triangle of the instance may pass before the near plane, where the picture does not show it: then rays
/// from the eye enter the volume of the instance unseen. Never false for one that does.
bool touchesEye(const FrameContext& frame, std::size_t instance);

}  // namespace ombrage
