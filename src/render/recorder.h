// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/frame_context.h"
#include "render/readback.h"

namespace ombrage {

/// What a frame writes down: passes, counters, warnings, wanted intermediates; and the uniform blocks of techniques.
struct FrameContext::Recorder {
    struct PassWork {
        std::string name;
        std::uint64_t draws = 0, triangles = 0;
        std::uint64_t bytes = 0;  ///< of images, each touched once (gl::takeTraffic)
    };
    struct ParamsBlock {
        std::vector<std::byte> bytes;
        gl::Buffer buffer;
    };

    gl::GpuTimer* timer = nullptr;
    bool timesPasses = true;                      ///< else the whole frame is one span
    std::vector<PassWork> passes;                 ///< of this frame, in order
    std::map<std::string, double> counters;       ///< of this frame
    bool countsSavings = false;                   ///< RenderSettings::countSavings, where it falls into no time
    bool uncounted = false;                       ///< draws are left out just now
    std::set<std::string> wanted;
    bool wantsAll = false;
    bool capturing = false;                       ///< this frame's intermediates are kept
    std::optional<LightType> lightType;           ///< of the light whose shadow is being made
    std::string suffix;                           ///< "@lamp" while a light beyond the first is drawn
    std::map<std::string, ShownImage> shown;
    std::vector<std::string> warnings;            ///< each once
    std::map<const Technique*, ParamsBlock> blocks;
};

}  // namespace ombrage
