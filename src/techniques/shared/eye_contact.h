// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace ombrage {

class FrameContext;
struct LightFrame;

/// Whether the volume of an instance can be counted along the rays from the eye, sides alone, from the number of
/// volumes that hold the eye (perspective cameras). Not so
/// - where a triangle of the instance may pass before the near plane: rays enter its volume unseen;
/// - where it has holes (alpha test): its light caps do not hide what is behind them, so rays enter through them;
/// - where the way from the eye to the light touches an edge of it: the eye is on the volume's border, in for some
/// rays. In doubt it is false.
bool countsFromEye(const FrameContext& frame, const LightFrame& light, std::size_t instance);

/// Whether the instance is alpha-tested.
bool isAlphaTested(const FrameContext& frame, std::size_t instance);

}  // namespace ombrage
