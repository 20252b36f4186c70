// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/frame_context.h"

namespace ombrage {

/// The planes of a multisampled G-buffer. @throws Error(Environment) when the device has other numbers of samples.
GBufferSamples makeSamples(const GBufferLayout& layout);

/// Bytes of all planes.
std::uint64_t byteSize(const GBufferSamples& samples);

/// PIXEL_SAMPLES and what belongs to it in ombrage/edge_samples.glsl.
std::vector<std::pair<std::string, std::string>> sampleDefines(const GBuffer& gbuffer);

/// Binds the samples' planes to the units of ombrage/edge_samples.glsl, from kUnitSampleDepth on.
void bindSamples(const GBuffer& gbuffer);
inline constexpr unsigned kUnitSampleDepth = 8, kUnitSampleSurface = 9, kUnitSampleMaterial = 10, kUnitEdges = 11;

/// Makes the G-buffer of the pixels from its samples, one surface a pixel, and finds the pixels that show several.
void makePixels(FrameContext& frame);

}  // namespace ombrage
