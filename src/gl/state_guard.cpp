// SPDX-License-Identifier: MIT
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "gl/context.h"

namespace ombrage::gl {

namespace {

// OpenGL guarantees eight draw buffers and clip distances, and Ombrage uses no more.
constexpr GLuint kDrawBuffers = 8;

constexpr std::array kSwitches = {GL_DEPTH_TEST,
                                  GL_DEPTH_CLAMP,
                                  GL_STENCIL_TEST,
                                  GL_CULL_FACE,
                                  GL_POLYGON_OFFSET_FILL,
                                  GL_POLYGON_OFFSET_LINE,
                                  GL_POLYGON_OFFSET_POINT,
                                  GL_MULTISAMPLE,
                                  GL_SAMPLE_ALPHA_TO_COVERAGE,
                                  GL_SAMPLE_ALPHA_TO_ONE,
                                  GL_SAMPLE_COVERAGE,
                                  GL_SAMPLE_MASK,
                                  GL_SAMPLE_SHADING,
                                  GL_CLIP_DISTANCE0,
                                  GL_CLIP_DISTANCE1,
                                  GL_CLIP_DISTANCE2,
                                  GL_CLIP_DISTANCE3,
                                  GL_CLIP_DISTANCE4,
                                  GL_CLIP_DISTANCE5,
                                  GL_CLIP_DISTANCE6,
                                  GL_CLIP_DISTANCE7,
                                  GL_FRAMEBUFFER_SRGB,
                                  GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                  GL_PRIMITIVE_RESTART,
                                  GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                  GL_DITHER,
                                  GL_PROGRAM_POINT_SIZE,
                                  GL_RASTERIZER_DISCARD,
                                  GL_COLOR_LOGIC_OP,
                                  GL_LINE_SMOOTH,
                                  GL_POLYGON_SMOOTH};

constexpr std::array kPixelStore = {
    GL_PACK_SWAP_BYTES,    GL_PACK_LSB_FIRST,      GL_PACK_ROW_LENGTH,    GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_ROWS,     GL_PACK_SKIP_PIXELS,    GL_PACK_SKIP_IMAGES,   GL_PACK_ALIGNMENT,
    GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST,    GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ALIGNMENT};

struct BindingPoint {
    GLenum target, query;
};

constexpr BindingPoint kTextures[] = {{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
                                      {GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY},
                                      {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                                      {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
                                      {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
                                      {GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY},
                                      {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                                      {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
                                      {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
                                      {GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY},
                                      {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE}};

constexpr BindingPoint kBuffers[] = {{GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
                                     {GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
                                     {GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING},
                                     {GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING},
                                     {GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING},
                                     {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
                                     {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING}};

struct IndexedBuffer {
    GLenum target, binding, start, size, maximum;
};

constexpr IndexedBuffer kIndexedBuffers[] = {
    {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
     GL_MAX_UNIFORM_BUFFER_BINDINGS},
    {GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
     GL_SHADER_STORAGE_BUFFER_SIZE, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START,
     GL_ATOMIC_COUNTER_BUFFER_SIZE, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS}};

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLint integer(GLenum name, GLuint index) {
    GLint value = 0;
    glGetIntegeri_v(name, index, &value);
    return value;
}

GLfloat number(GLenum name) {
    GLfloat value = 0;
    glGetFloatv(name, &value);
    return value;
}

void setSwitch(GLenum name, bool on) {
    if (on)
        glEnable(name);
    else
        glDisable(name);
}

void setSwitch(GLenum name, GLuint index, bool on) {
    if (on)
        glEnablei(name, index);
    else
        glDisablei(name, index);
}

}  // namespace

/// Reads a piece of state at once and remembers how to put it back.
struct StateGuard::Saved {
    std::vector<std::function<void()>> steps;

    template <typename Step>
    void onRestore(Step step) {
        steps.emplace_back(std::move(step));
    }

    void saveSwitches() {
        for (GLenum name : kSwitches) onRestore([name, on = glIsEnabled(name)] { setSwitch(name, on); });
        if (!epoxy_has_gl_extension("GL_EXT_depth_bounds_test")) return;
        std::array<GLfloat, 2> bounds{};
        glGetFloatv(GL_DEPTH_BOUNDS_EXT, bounds.data());
        onRestore([bounds, on = glIsEnabled(GL_DEPTH_BOUNDS_TEST_EXT)] {
            setSwitch(GL_DEPTH_BOUNDS_TEST_EXT, on);
            glDepthBoundsEXT(GLclampd(bounds[0]), GLclampd(bounds[1]));
        });
    }

    void saveViewports() {
        const auto count = GLuint(integer(GL_MAX_VIEWPORTS));
        for (GLuint i = 0; i < count; ++i) {
            std::array<GLfloat, 4> viewport{};
            std::array<GLdouble, 2> range{};
            std::array<GLint, 4> scissor{};
            glGetFloati_v(GL_VIEWPORT, i, viewport.data());
            glGetDoublei_v(GL_DEPTH_RANGE, i, range.data());
            glGetIntegeri_v(GL_SCISSOR_BOX, i, scissor.data());
            onRestore([i, viewport, range, scissor, on = glIsEnabledi(GL_SCISSOR_TEST, i)] {
                glViewportIndexedfv(i, viewport.data());
                glDepthRangeIndexed(i, range[0], range[1]);
                glScissorIndexedv(i, scissor.data());
                setSwitch(GL_SCISSOR_TEST, i, on);
            });
        }
    }

    void saveBlending() {
        for (GLuint i = 0; i < kDrawBuffers; ++i) {
            std::array<GLenum, 6> f{};
            const GLenum names[] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                    GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
            for (std::size_t n = 0; n < f.size(); ++n) f[n] = GLenum(integer(names[n], i));
            std::array<GLboolean, 4> mask{};
            glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask.data());
            onRestore([i, f, mask, on = glIsEnabledi(GL_BLEND, i)] {
                setSwitch(GL_BLEND, i, on);
                glBlendFuncSeparatei(i, f[0], f[1], f[2], f[3]);
                glBlendEquationSeparatei(i, f[4], f[5]);
                glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
            });
        }
        std::array<GLfloat, 4> color{};
        glGetFloatv(GL_BLEND_COLOR, color.data());
        onRestore([color] { glBlendColor(color[0], color[1], color[2], color[3]); });
    }

    void saveDepthAndStencil() {
        onRestore([function = GLenum(integer(GL_DEPTH_FUNC)), mask = GLboolean(integer(GL_DEPTH_WRITEMASK))] {
            glDepthFunc(function);
            glDepthMask(mask);
        });
        saveStencilFace(GL_FRONT, {GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL,
                                   GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_WRITEMASK});
        saveStencilFace(GL_BACK,
                        {GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BACK_FAIL,
                         GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_STENCIL_BACK_WRITEMASK});
    }

    void saveStencilFace(GLenum face, const std::array<GLenum, 7>& names) {
        std::array<GLint, 7> v{};
        for (std::size_t n = 0; n < v.size(); ++n) v[n] = integer(names[n]);
        onRestore([face, v] {
            glStencilFuncSeparate(face, GLenum(v[0]), v[1], GLuint(v[2]));
            glStencilOpSeparate(face, GLenum(v[3]), GLenum(v[4]), GLenum(v[5]));
            glStencilMaskSeparate(face, GLuint(v[6]));
        });
    }

    void saveRasterization() {
        // A compatibility context answers with the mode of both faces, so leave room for two.
        std::array<GLint, 2> polygonMode{};
        glGetIntegerv(GL_POLYGON_MODE, polygonMode.data());
        onRestore([mode = GLenum(polygonMode[0]), cull = GLenum(integer(GL_CULL_FACE_MODE)),
                   front = GLenum(integer(GL_FRONT_FACE)), factor = number(GL_POLYGON_OFFSET_FACTOR),
                   units = number(GL_POLYGON_OFFSET_UNITS), origin = GLenum(integer(GL_CLIP_ORIGIN)),
                   depthMode = GLenum(integer(GL_CLIP_DEPTH_MODE))] {
            glPolygonMode(GL_FRONT_AND_BACK, mode);
            glCullFace(cull);
            glFrontFace(front);
            glPolygonOffset(factor, units);
            glClipControl(origin, depthMode);
        });
        onRestore([coverage = number(GL_SAMPLE_COVERAGE_VALUE), invert = GLboolean(integer(GL_SAMPLE_COVERAGE_INVERT)),
                   shading = number(GL_MIN_SAMPLE_SHADING_VALUE), mask = integer(GL_SAMPLE_MASK_VALUE, 0)] {
            glSampleCoverage(coverage, invert);
            glMinSampleShading(shading);
            glSampleMaski(0, GLbitfield(mask));
        });
    }

    void saveTextures() {
        const auto active = GLenum(integer(GL_ACTIVE_TEXTURE));
        const auto count = std::min(kGuardedTextureUnits, GLuint(integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS)));
        for (GLuint unit = 0; unit < count; ++unit) {
            glActiveTexture(GL_TEXTURE0 + unit);
            std::array<GLuint, std::size(kTextures)> names{};
            for (std::size_t n = 0; n < names.size(); ++n) names[n] = GLuint(integer(kTextures[n].query));
            onRestore([unit, names, sampler = GLuint(integer(GL_SAMPLER_BINDING))] {
                glActiveTexture(GL_TEXTURE0 + unit);
                for (std::size_t n = 0; n < names.size(); ++n) glBindTexture(kTextures[n].target, names[n]);
                glBindSampler(unit, sampler);
            });
        }
        glActiveTexture(active);
        onRestore([active] { glActiveTexture(active); });
    }

    void saveImages() {
        const auto count = GLuint(integer(GL_MAX_IMAGE_UNITS));
        for (GLuint i = 0; i < count; ++i) {
            onRestore([i, name = GLuint(integer(GL_IMAGE_BINDING_NAME, i)), level = integer(GL_IMAGE_BINDING_LEVEL, i),
                       layered = GLboolean(integer(GL_IMAGE_BINDING_LAYERED, i)),
                       layer = integer(GL_IMAGE_BINDING_LAYER, i), access = GLenum(integer(GL_IMAGE_BINDING_ACCESS, i)),
                       format = GLenum(integer(GL_IMAGE_BINDING_FORMAT, i))] {
                glBindImageTexture(i, name, level, layered, layer, access, format);
            });
        }
    }

    void saveBuffers() {
        for (const IndexedBuffer& kind : kIndexedBuffers) {
            const auto count = GLuint(integer(kind.maximum));
            for (GLuint i = 0; i < count; ++i) saveIndexedBuffer(kind, i);
            // Binding a range also changes the plain binding point: put that back after all of them.
            onRestore([target = kind.target, name = GLuint(integer(kind.binding))] { glBindBuffer(target, name); });
        }
        for (const BindingPoint& point : kBuffers)
            onRestore([target = point.target, name = GLuint(integer(point.query))] { glBindBuffer(target, name); });
    }

    void saveIndexedBuffer(const IndexedBuffer& kind, GLuint i) {
        const auto name = GLuint(integer(kind.binding, i));
        GLint64 start = 0, size = 0;
        if (name != 0) {
            glGetInteger64i_v(kind.start, i, &start);
            glGetInteger64i_v(kind.size, i, &size);
        }
        onRestore([target = kind.target, i, name, start, size] {
            if (size > 0)
                glBindBufferRange(target, i, name, GLintptr(start), GLsizeiptr(size));
            else
                glBindBufferBase(target, i, name);
        });
    }

    void saveObjects() {
        onRestore([program = GLuint(integer(GL_CURRENT_PROGRAM)), draw = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING)),
                   read = GLuint(integer(GL_READ_FRAMEBUFFER_BINDING)),
                   array = GLuint(integer(GL_VERTEX_ARRAY_BINDING)),
                   element = GLuint(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING))] {
            // A program deleted while in use ends when it is no longer current.
            glUseProgram(glIsProgram(program) ? program : 0);
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw);
            glBindFramebuffer(GL_READ_FRAMEBUFFER, read);
            glBindVertexArray(array);
            // The element buffer is part of the vertex array, which a core context does not have by default.
            if (array != 0) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, element);
        });
    }

    void savePixelStore() {
        for (GLenum name : kPixelStore) onRestore([name, value = integer(name)] { glPixelStorei(name, value); });
    }
};

StateGuard::StateGuard() : m_saved(std::make_unique<Saved>()) {
    m_saved->saveSwitches();
    m_saved->saveViewports();
    m_saved->saveBlending();
    m_saved->saveDepthAndStencil();
    m_saved->saveRasterization();
    m_saved->saveTextures();
    m_saved->saveImages();
    m_saved->saveBuffers();
    m_saved->saveObjects();
    m_saved->savePixelStore();
}

StateGuard::~StateGuard() {
    for (const auto& step : m_saved->steps) step();
}

}  // namespace ombrage::gl
