// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/renderer.h>
#include <ombrage/technique.h>

#include "core/strings.h"
#include "gl/context.h"
#include "gl/gpu_timer.h"
#include "gl/program_cache.h"
#include "gl/shader_library.h"

namespace ombrage {

std::vector<DoctorCheck> runDoctor(const RendererOptions& options) {
    std::vector<DoctorCheck> checks;
    const auto add = [&](const char* name, const char* verdict, std::string detail) {
        checks.push_back({name, verdict, std::move(detail)});
    };
    try {
        const auto context = gl::Context::createHeadless({options.device, true});
        for (const std::string& line : context->trace()) add("context", "ok", line);
        add("renderer", context->isSoftware() ? "fallback" : "ok",
            context->renderer() + (context->isSoftware() ? " (software: slow, timings say nothing of a GPU)" : ""));
        add("vendor", "ok", context->vendor());
        add("OpenGL", "ok", context->version());
        for (const std::string& warning : context->warnings()) add("warning", "fallback", warning);

        const gl::Capabilities& can = context->capabilities();
        // Extensions beyond 4.5 core; no technique needs one, so none is missed.
        const auto optional = [&](const char* name, bool present) {
            add(name, "ok", present ? "offered by the driver" : "not offered; nothing needs it");
        };
        optional("depth bounds test", can.depthBoundsTest);
        optional("layer from vertex shader", can.viewportLayerFromVertex);
        optional("conservative raster", can.conservativeRaster);
        optional("stencil export", can.stencilExport);
        add("samples", can.maxSamples >= 4 ? "ok" : "fallback", fmt::format("{} at most", can.maxSamples));
        add("storage blocks", can.maxShaderStorageBytes >= (128ll << 20) ? "ok" : "failed",
            fmt::format("{} MiB at most", can.maxShaderStorageBytes >> 20));
        add("texture size", can.maxTextureSize >= 8192 ? "ok" : "fallback", fmt::format("{} at most", can.maxTextureSize));

        const gl::GpuTimer timer;
        add("clock", timer.clock() == gl::Clock::Timestamp ? "ok" : "fallback",
            std::string(gl::clockName(timer.clock())) + ": " + timer.verdict());

        const gl::ProgramCache programs(options.cache);
        if (programs.isOn())
            add("program cache", "ok", programs.folder().string());
        else
            add("program cache", "ok",
                gl::offersProgramBinaries() ? "off"
                                            : "not in use: the driver hands out no compiled programs; its own cache "
                                              "may still keep them");
        gl::ShaderLibrary shaders(options.shaderDir);
        shaders.program({{{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "ombrage/depth_only.frag"}}, {}, {}});
        add("shaders", "ok", fmt::format("{} files, a program compiles", gl::ShaderLibrary::embeddedPaths().size()));
        const auto messages = context->takeDebugMessages();
        add("debug messages", messages.empty() ? "ok" : "failed", messages.empty() ? "none" : join(messages, "; "));
        add("techniques", "ok", fmt::format("{}", techniques().size()));
    } catch (const Error& e) {
        add("OpenGL 4.5", "missing", e.what());
    }
    return checks;
}

}  // namespace ombrage
