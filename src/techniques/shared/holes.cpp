// SPDX-License-Identifier: MIT
#include "techniques/shared/holes.h"

#include "render/frame_context.h"

namespace ombrage {

bool hasHoles(const FrameContext& frame, std::size_t instance) {
    const int material = frame.gpuScene->flat().instances[instance].material;
    return frame.gpuScene->scene().materials[std::size_t(material)].alphaMode == AlphaMode::Mask;
}

}  // namespace ombrage
