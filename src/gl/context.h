// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ombrage::gl {

struct ContextOptions {
    std::string device;  ///< "" the first hardware EGL device that gives 4.5 core, else surfaceless software with one
                         ///< warning; "software"; or the index of an EGL device ("0")
    bool debug = false;
};

/// What the driver offers beyond 4.5 core, and its limits.
struct Capabilities {
    bool depthBoundsTest = false;
    bool stencilExport = false;
    bool conservativeRaster = false;
    bool fragmentInterlock = false;
    bool sparseTexture = false;
    bool viewportLayerFromVertex = false;  ///< ARB_shader_viewport_layer_array or AMD_vertex_shader_layer
    bool anisotropicFilter = false;
    int maxSamples = 1;
    std::int64_t maxShaderStorageBytes = 0;
    int maxTextureSize = 0;
};

/// An OpenGL 4.5 core context: owned (headless through EGL, no display needed) or the host's own.
class Context {
public:
    /// @throws Error(Environment): one paragraph of what was tried and how to mend it.
    static std::unique_ptr<Context> createHeadless(const ContextOptions& options);

    /// The context current in this thread. @throws Error(Environment) when there is none or it is older than 4.5.
    static std::unique_ptr<Context> adoptCurrent();

    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Does nothing for an adopted context.
    void makeCurrent();

    bool isAdopted() const;
    const std::string& renderer() const;
    const std::string& vendor() const;
    const std::string& version() const;
    bool isSoftware() const;
    const Capabilities& capabilities() const;

    /// Fallbacks taken while starting, to be shown once.
    const std::vector<std::string>& warnings() const;

    /// Messages of a debug context since the last call, notifications left out ("type id: text").
    std::vector<std::string> takeDebugMessages();

    /// What createHeadless tried, a line each, for `doctor`.
    const std::vector<std::string>& trace() const;

private:
    Context();
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Ombrage uses no texture unit from this one on; a StateGuard saves those below.
inline constexpr unsigned kGuardedTextureUnits = 32;

/// Saves every piece of GL state that Ombrage touches and puts it back on destruction, for a host's context:
/// program, vertex array, framebuffers, viewports, scissor, blend, depth, stencil, cull, front face, clip control,
/// colour masks, polygon mode and offset, multisample, clip distances, texture units and samplers, image units, indexed
/// uniform, storage and atomic buffers, array, element, indirect, copy, pixel pack and unpack buffers, pixel store,
/// framebuffer sRGB, depth clamp.
class StateGuard {
public:
    StateGuard();
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    struct Saved;
    std::unique_ptr<Saved> m_saved;
};

}  // namespace ombrage::gl
