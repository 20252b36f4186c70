// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/context.h"

namespace ombrage::gl {

/// Told from the name that the driver gives: llvmpipe, softpipe, swrast, SwiftShader.
bool isSoftwareRenderer(const std::string& renderer);

/// The EGL side of a headless context: no display, no surface.
class EglContext {
public:
    /// Makes a context of 4.5 core, current in this thread; what was tried goes to `trace`, what the user should know
    /// of a fallback to `warnings`. @throws Error(Environment), or Error(Usage) for a device that is no index.
    static std::unique_ptr<EglContext> create(const ContextOptions& options, std::vector<std::string>& trace,
                                              std::vector<std::string>& warnings);
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void makeCurrent();

private:
    EglContext(void* display, void* context) : m_display(display), m_context(context) {}
    void* m_display;  // EGLDisplay, EGLContext: kept out of the header
    void* m_context;
    friend class EglSearch;
};

}  // namespace ombrage::gl
