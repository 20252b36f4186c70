// SPDX-License-Identifier: MIT
#include <ombrage/scene.h>

#include "scene/builtin.h"

namespace ombrage {

Scene loadScene(const std::string& nameOrFile, const SceneOptions&) {
    return makeBuiltinScene(nameOrFile);
}

}  // namespace ombrage
