// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <ombrage/image.h>
#include <ombrage/scene.h>

#include "gl/context.h"

namespace ombrage::bench {

/// The yardstick: the least OpenGL that draws a scene with one sun by deferred shading, written by hand. A G-buffer
/// (albedo, normal, depth), a depth map of the casters, a pass that makes visibility of it, a light pass. Vertices are
/// in world space, colours are per draw, nothing is culled, cached, textured or alpha-tested, and the map has a
/// constant bias.
class MinimalLoop {
public:
    /// @param scene with a sun as its first light; the first camera looks.
    /// @param device as RendererOptions::device
    MinimalLoop(const Scene& scene, int width, int height, int mapSize, const std::string& device = {});
    ~MinimalLoop();
    MinimalLoop(const MinimalLoop&) = delete;
    MinimalLoop& operator=(const MinimalLoop&) = delete;

    /// Draws one frame, finished. @return its wall time in ms
    double frame(bool shadows);

    /// The last frame, linear RGB.
    Image picture() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace ombrage::bench
