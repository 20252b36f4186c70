// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace ombrage {

class FrameContext;

/// Whether the instance is alpha-tested. Its light caps do not hide what is behind them, so rays from the eye enter its
/// volume through its holes, and z-pass, which draws no light caps, would miss that.
bool hasHoles(const FrameContext& frame, std::size_t instance);

}  // namespace ombrage
