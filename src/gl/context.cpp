// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include <dlfcn.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"
#include "core/trace.h"
#include "gl/egl_context.h"

namespace ombrage::gl {

namespace {

constexpr std::size_t kMaxMessages = 1000;
constexpr int kRequiredVersion = 45;

const char* messageType(GLenum type) {
    switch (type) {
        case GL_DEBUG_TYPE_ERROR:
            return "error";
        case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
            return "deprecated";
        case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
            return "undefined";
        case GL_DEBUG_TYPE_PORTABILITY:
            return "portability";
        case GL_DEBUG_TYPE_PERFORMANCE:
            return "performance";
        case GL_DEBUG_TYPE_MARKER:
            return "marker";
        default:
            return "other";
    }
}

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? reinterpret_cast<const char*>(value) : "";
}

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

Capabilities readCapabilities() {
    const auto has = [](const char* extension) { return epoxy_has_gl_extension(extension); };
    Capabilities c;
    c.depthBoundsTest = has("GL_EXT_depth_bounds_test");
    c.stencilExport = has("GL_ARB_shader_stencil_export");
    c.conservativeRaster = has("GL_NV_conservative_raster") || has("GL_INTEL_conservative_rasterization");
    c.fragmentInterlock = has("GL_ARB_fragment_shader_interlock");
    c.sparseTexture = has("GL_ARB_sparse_texture");
    c.viewportLayerFromVertex = has("GL_ARB_shader_viewport_layer_array") || has("GL_AMD_vertex_shader_layer");
    c.anisotropicFilter = has("GL_ARB_texture_filter_anisotropic") || has("GL_EXT_texture_filter_anisotropic");
    c.maxSamples = std::min(
        {integer(GL_MAX_SAMPLES), integer(GL_MAX_COLOR_TEXTURE_SAMPLES), integer(GL_MAX_DEPTH_TEXTURE_SAMPLES)});
    GLint64 storage = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
    c.maxShaderStorageBytes = storage;
    c.maxTextureSize = integer(GL_MAX_TEXTURE_SIZE);
    return c;
}

// Asks one windowing library, when the process has loaded it, for this thread's context. Nothing may go through
// libepoxy before: it aborts without a context.
bool hasCurrent(const char* library, const char* function) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return false;
    using GetCurrent = void* (*)();
    const auto getCurrent = reinterpret_cast<GetCurrent>(dlsym(handle, function));
    const bool current = getCurrent != nullptr && getCurrent() != nullptr;
    dlclose(handle);
    return current;
}

}  // namespace

bool isSoftwareRenderer(const std::string& renderer) {
    const std::string name = toLower(renderer);
    const auto contains = [&name](const char* part) { return name.find(part) != std::string::npos; };
    return contains("llvmpipe") || contains("softpipe") || contains("swrast") || contains("swiftshader") ||
           contains("software rasterizer");
}

struct Context::Impl {
    std::string renderer, vendor, version;
    Capabilities capabilities;
    std::vector<std::string> warnings;
    std::vector<std::string> trace;
    std::mutex messagesMutex;
    std::vector<std::string> messages;
    // Null for an adopted context. Declared last, so that it ends before what its messages go to.
    std::unique_ptr<EglContext> egl;

    // Reads what the current context says of itself.
    void describe() {
        renderer = text(GL_RENDERER);
        vendor = text(GL_VENDOR);
        version = text(GL_VERSION);
        capabilities = readCapabilities();
    }

    void receive(GLenum type, GLuint id, const std::string& message) {
        const std::lock_guard lock(messagesMutex);
        if (messages.size() < kMaxMessages)
            messages.push_back(fmt::format("{} {}: {}", messageType(type), id, trim(message)));
        else if (messages.size() == kMaxMessages)
            messages.push_back("other 0: further messages are dropped");
    }

    static void onMessage(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* message,
                          const void* user) {
        if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
        auto* impl = static_cast<Impl*>(const_cast<void*>(user));
        impl->receive(type, id, length < 0 ? std::string(message) : std::string(message, std::size_t(length)));
    }
};

Context::Context() : m_impl(std::make_unique<Impl>()) {}

Context::~Context() = default;

std::unique_ptr<Context> Context::createHeadless(const ContextOptions& options) {
    const TraceScope trace("create context");
    std::unique_ptr<Context> context(new Context());
    Impl& impl = *context->m_impl;
    impl.egl = EglContext::create(options, impl.trace, impl.warnings);
    impl.describe();

    // Messages come in the thread and during the call that caused them, so that a debugger shows the culprit.
    if (options.debug) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(&Impl::onMessage, &impl);
    }
    return context;
}

std::unique_ptr<Context> Context::adoptCurrent() {
    if (!hasCurrent("libEGL.so.1", "eglGetCurrentContext") && !hasCurrent("libGLX.so.0", "glXGetCurrentContext") &&
        !hasCurrent("libGL.so.1", "glXGetCurrentContext"))
        throw Error(ErrorCode::Environment, "no OpenGL context is current in this thread",
                    "Make the host's context current before handing it over, or let Ombrage make its own.");
    if (!epoxy_is_desktop_gl() || epoxy_gl_version() < kRequiredVersion)
        throw Error(ErrorCode::Environment,
                    fmt::format("the current context is '{}', but Ombrage needs OpenGL 4.5", text(GL_VERSION)),
                    "Ask for a 4.5 core context when the host makes its window.");

    std::unique_ptr<Context> context(new Context());
    context->m_impl->describe();
    context->m_impl->trace.push_back("adopted the host's context: " + context->m_impl->renderer);
    return context;
}

void Context::makeCurrent() {
    if (m_impl->egl) m_impl->egl->makeCurrent();
}

bool Context::isAdopted() const {
    return !m_impl->egl;
}

const std::string& Context::renderer() const {
    return m_impl->renderer;
}

const std::string& Context::vendor() const {
    return m_impl->vendor;
}

const std::string& Context::version() const {
    return m_impl->version;
}

bool Context::isSoftware() const {
    return isSoftwareRenderer(m_impl->renderer);
}

const Capabilities& Context::capabilities() const {
    return m_impl->capabilities;
}

const std::vector<std::string>& Context::warnings() const {
    return m_impl->warnings;
}

std::vector<std::string> Context::takeDebugMessages() {
    const std::lock_guard lock(m_impl->messagesMutex);
    return std::exchange(m_impl->messages, {});
}

const std::vector<std::string>& Context::trace() const {
    return m_impl->trace;
}

}  // namespace ombrage::gl
