// SPDX-License-Identifier: MIT
#include "gl/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage::gl {

namespace {

constexpr const char* kMendHint =
    "Install libegl1, libgl1-mesa-dri and libopengl0 for software OpenGL (no GPU or display is needed), or a GPU "
    "driver "
    "that gives OpenGL 4.5 through EGL.";

constexpr const char* kDeviceHint = "Leave the device out to take the first that works, or ask for 'software'.";

bool canLoad(const char* library) {
    // Never closed: libepoxy keeps using it.
    return dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr;
}

bool hasWord(const char* list, const char* word) {
    if (list == nullptr) return false;
    for (const std::string& item : split(list, ' '))
        if (item == word) return true;
    return false;
}

std::string eglErrorText() {
    return fmt::format("EGL error 0x{:04x}", eglGetError());
}

/// Makes Mesa choose its software renderer while it lives, unless the user has said something himself.
class ForceMesaSoftware {
public:
    ForceMesaSoftware() : m_set(std::getenv(kVariable) == nullptr) {
        if (m_set) setenv(kVariable, "1", 1);
    }
    ~ForceMesaSoftware() {
        if (m_set) unsetenv(kVariable);
    }
    ForceMesaSoftware(const ForceMesaSoftware&) = delete;
    ForceMesaSoftware& operator=(const ForceMesaSoftware&) = delete;

private:
    static constexpr const char* kVariable = "LIBGL_ALWAYS_SOFTWARE";
    bool m_set;
};

struct Device {
    EGLDeviceEXT handle;
    std::string name;  ///< "EGL device 0 (/dev/dri/card0)"
    bool software;
};

}  // namespace

/// One search for a context, in the order that the options ask for.
class EglSearch {
public:
    EglSearch(const ContextOptions& options, std::vector<std::string>& trace, std::vector<std::string>& warnings)
        : m_options(options), m_trace(trace), m_warnings(warnings) {}

    std::unique_ptr<EglContext> run() {
        checkLibraries();
        m_clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        listDevices();
        if (m_options.device.empty()) return firstHardwareElseSoftware();
        if (m_options.device == "software") return software();
        return byIndex();
    }

private:
    // libepoxy aborts the process when a library is missing, so ask the loader first.
    void checkLibraries() {
        if (!canLoad("libEGL.so.1")) fail("libEGL.so.1 is not installed");
        if (!canLoad("libOpenGL.so.0") && !canLoad("libGL.so.1"))
            fail("neither libOpenGL.so.0 nor libGL.so.1 is installed");
    }

    void listDevices() {
        const bool canEnumerate = hasWord(m_clientExtensions, "EGL_EXT_device_base") ||
                                  hasWord(m_clientExtensions, "EGL_EXT_device_enumeration");
        if (!canEnumerate || !hasWord(m_clientExtensions, "EGL_EXT_platform_base")) {
            m_trace.push_back("EGL cannot list devices");
            return;
        }
        EGLint count = 0;
        if (!eglQueryDevicesEXT(0, nullptr, &count) || count == 0) {
            m_trace.push_back("EGL lists no device");
            return;
        }
        std::vector<EGLDeviceEXT> handles(std::size_t(count), nullptr);
        eglQueryDevicesEXT(count, handles.data(), &count);
        for (EGLint i = 0; i < count; ++i) m_devices.push_back(describe(handles[std::size_t(i)], i));
    }

    static Device describe(EGLDeviceEXT handle, int index) {
        const char* extensions = eglQueryDeviceStringEXT(handle, EGL_EXTENSIONS);
        const bool isSoftware = hasWord(extensions, "EGL_MESA_device_software");
        const char* file = nullptr;
        if (hasWord(extensions, "EGL_EXT_device_drm")) file = eglQueryDeviceStringEXT(handle, EGL_DRM_DEVICE_FILE_EXT);
        std::string what = isSoftware ? "software" : "hardware";
        if (file != nullptr) what = file;
        return {handle, fmt::format("EGL device {} ({})", index, what), isSoftware};
    }

    std::unique_ptr<EglContext> firstHardwareElseSoftware() {
        std::vector<std::string> refused;
        for (const Device& device : m_devices) {
            if (device.software) continue;
            if (auto context = onDevice(device, true)) return context;
            refused.push_back(m_trace.back());
        }
        auto context = software();
        if (!refused.empty()) m_warnings.push_back("no usable GPU, rendering in software: " + join(refused, "; "));
        return context;
    }

    std::unique_ptr<EglContext> software() {
        if (hasWord(m_clientExtensions, "EGL_MESA_platform_surfaceless")) {
            const ForceMesaSoftware force;
            const EGLDisplay display =
                eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
            if (auto context = onDisplay(display, "surfaceless platform"))
                if (accept(*context, "surfaceless platform", Wanted::Software)) return context;
        } else {
            m_trace.push_back("EGL has no surfaceless platform");
        }
        // A display that the process opened before on a GPU stays there; Mesa's software device does not.
        for (const Device& device : m_devices) {
            if (!device.software) continue;
            if (auto context = onDisplay(deviceDisplay(device), device.name))
                if (accept(*context, device.name, Wanted::Software)) return context;
        }
        fail("no software OpenGL 4.5 came up");
    }

    std::unique_ptr<EglContext> byIndex() {
        long long index = -1;
        if (!parseInt(m_options.device, index) || index < 0)
            throw Error(ErrorCode::Usage, fmt::format("'{}' is no device", m_options.device),
                        "Give 'software' or the index of an EGL device as 'ombrage doctor' lists them.");
        if (std::size_t(index) >= m_devices.size())
            fail(fmt::format("there is no EGL device {}, EGL lists {}", index, m_devices.size()), kDeviceHint);
        if (auto context = onDevice(m_devices[std::size_t(index)], false)) return context;
        fail(fmt::format("EGL device {} gives no OpenGL 4.5", index), kDeviceHint);
    }

    static EGLDisplay deviceDisplay(const Device& device) {
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr);
    }

    std::unique_ptr<EglContext> onDevice(const Device& device, bool hardwareOnly) {
        auto context = onDisplay(deviceDisplay(device), device.name);
        if (context && !accept(*context, device.name, hardwareOnly ? Wanted::Hardware : Wanted::Any)) context.reset();
        return context;
    }

    /// The last line of the trace says why when this gives nothing.
    std::unique_ptr<EglContext> onDisplay(EGLDisplay display, const std::string& name) {
        const auto refuse = [this, &name](const std::string& why) {
            m_trace.push_back(name + ": " + why);
            return nullptr;
        };
        // Displays are never terminated: EGL hands the same one to everybody in the process, the host included.
        EGLint major = 0, minor = 0;
        if (display == EGL_NO_DISPLAY) return refuse("no display, " + eglErrorText());
        if (!eglInitialize(display, &major, &minor)) return refuse("eglInitialize failed, " + eglErrorText());
        if (!hasWord(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
            return refuse("no EGL_KHR_surfaceless_context");
        if (!eglBindAPI(EGL_OPENGL_API)) return refuse("no desktop OpenGL, " + eglErrorText());

        // Any configuration will do, because nothing is ever drawn to a surface.
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
            return refuse("no configuration for OpenGL, " + eglErrorText());

        std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION,       4,
                                          EGL_CONTEXT_MINOR_VERSION,       5,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
        if (m_options.debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
        attributes.push_back(EGL_NONE);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
        if (context == EGL_NO_CONTEXT) return refuse("no 4.5 core context, " + eglErrorText());

        std::unique_ptr<EglContext> owned(new EglContext(display, context));
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            return refuse("the context cannot be made current, " + eglErrorText());
        return owned;
    }

    enum class Wanted { Hardware, Software, Any };

    /// Checks the renderer of a context that has just been made current.
    bool accept(const EglContext&, const std::string& name, Wanted wanted) {
        const GLubyte* renderer = glGetString(GL_RENDERER);
        const std::string rendererName = renderer != nullptr ? reinterpret_cast<const char*>(renderer) : "nothing";
        const bool isSoftware = isSoftwareRenderer(rendererName);
        const bool fits = wanted == Wanted::Any || isSoftware == (wanted == Wanted::Software);
        m_trace.push_back(fmt::format("{}: {}, {}", name, rendererName,
                                      fits         ? "taken"
                                      : isSoftware ? "refused because it is no GPU"
                                                   : "refused because it is no software renderer"));
        return fits;
    }

    [[noreturn]] void fail(const std::string& what, const char* hint = kMendHint) const {
        std::string message = "no OpenGL 4.5 context: " + what;
        if (!m_trace.empty()) message += " (tried: " + join(m_trace, "; ") + ")";
        throw Error(ErrorCode::Environment, message, hint);
    }

    const ContextOptions& m_options;
    std::vector<std::string>& m_trace;
    std::vector<std::string>& m_warnings;
    const char* m_clientExtensions = nullptr;
    std::vector<Device> m_devices;
};

std::unique_ptr<EglContext> EglContext::create(const ContextOptions& options, std::vector<std::string>& trace,
                                               std::vector<std::string>& warnings) {
    return EglSearch(options, trace, warnings).run();
}

EglContext::~EglContext() {
    eglBindAPI(EGL_OPENGL_API);
    if (eglGetCurrentContext() == m_context) eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
}

void EglContext::makeCurrent() {
    eglBindAPI(EGL_OPENGL_API);
    if (eglGetCurrentContext() == m_context) return;
    if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
        throw Error(ErrorCode::Environment, "the OpenGL context cannot be made current: " + eglErrorText(),
                    "A context can be current in one thread at a time.");
}

}  // namespace ombrage::gl
