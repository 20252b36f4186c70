// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <ombrage/image.h>

#include "gl/objects.h"
#include "render/frame_context.h"

namespace ombrage {

/// Level 0 of a colour texture as floats, row 0 at the top. `planes` names 1 to 4 channels.
Image readColor(const gl::Texture& texture, const std::vector<std::string>& planes, ColorSpace space, int layer = 0);

/// The depth plane, as stored.
Image readDepth(const gl::Texture& texture, int layer = 0);

/// The stencil plane as floats.
Image readStencil(const gl::Texture& texture);

/// R32UI or RGBA32UI: that many words a pixel, row 0 at the top.
std::vector<std::uint32_t> readWords(const gl::Texture& texture);

/// Uploads one plane (row 0 at the top) into a single-channel float texture of the same size.
void uploadPlane(gl::Texture& texture, std::span<const float> plane);

/// The numbers of an intermediate, and the same made fit for looking at.
struct ShownImage {
    Image raw, display;
};
ShownImage showTexture(const gl::Texture& texture, ShowAs how, int layer = 0);

/// A copy stretched so that the smallest and largest finite value other than `leaveOut` become 0 and 1; the rest is 1.
Image stretched(const Image& values, float leaveOut);

}  // namespace ombrage
