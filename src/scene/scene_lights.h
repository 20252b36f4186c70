// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

#include "scene/json_document.h"

namespace ombrage {

/// One element of a scene file's "lights", without its name. The models must be in the scene already.
Light readLight(const JsonNode& node, const Scene& scene);

}  // namespace ombrage
