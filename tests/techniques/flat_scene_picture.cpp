// SPDX-License-Identifier: MIT
#include "techniques/flat_scene_picture.h"

#include <gtest/gtest.h>

namespace ombrage::test {

RenderResult renderFlat(const Scene& scene, const RenderSettings& settings) {
    static Renderer renderer([] {
        RendererOptions options;
        options.debugContext = true;
        return options;
    }());
    renderer.setScene(scene);
    RenderResult result = renderer.render(settings);
    for (const std::string& message : result.debugMessages) ADD_FAILURE() << "OpenGL says " << message;
    return result;
}

}  // namespace ombrage::test
