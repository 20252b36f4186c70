// SPDX-License-Identifier: MIT
#pragma once

#include "scene/load_record.h"
#include "scene/loaded_scene.h"

namespace ombrage {

/// Loads a scene file or a model file in this process. `onFile` hears of every file before it is read.
/// @throws Error(Input)
LoadedScene loadFiles(const LoadRequest& request, LoadRecord::OnFile onFile = {});

}  // namespace ombrage
