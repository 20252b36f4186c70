// SPDX-License-Identifier: MIT
#include <cassert>

#include "gl/context.h"
#include "gl/objects.h"
#include "gl/texture_format.h"

namespace ombrage::gl {

namespace {

constexpr int kMaxClipDistances = 8;

void setEnabled(GLenum capability, bool enabled) {
    if (enabled)
        glEnable(capability);
    else
        glDisable(capability);
}

void applyStencilFace(GLenum face, const DrawState::StencilFace& state) {
    glStencilFuncSeparate(face, state.func, state.reference, state.readMask);
    glStencilOpSeparate(face, state.stencilFail, state.depthFail, state.depthPass);
}

}  // namespace

void apply(const DrawState& state) {
    // OpenGL writes depth only while the test is on: a write without a test is a test that always passes.
    setEnabled(GL_DEPTH_TEST, state.depthTest || state.depthWrite);
    glDepthFunc(state.depthTest ? state.depthFunc : GLenum(GL_ALWAYS));
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    setEnabled(GL_DEPTH_CLAMP, state.depthClamp);

    setEnabled(GL_STENCIL_TEST, state.stencilTest);
    applyStencilFace(GL_FRONT, state.stencilFront);
    applyStencilFace(GL_BACK, state.stencilBack);
    glStencilMask(state.stencilWriteMask);

    setEnabled(GL_CULL_FACE, state.cull != GL_NONE);
    if (state.cull != GL_NONE) glCullFace(state.cull);
    glFrontFace(GL_CCW);

    setEnabled(GL_BLEND, state.blend);
    glBlendFunc(state.blendSource, state.blendDestination);
    glBlendEquation(state.blendEquation);
    const GLboolean color = state.colorWrite ? GL_TRUE : GL_FALSE;
    glColorMask(color, color, color, color);

    const bool offset = state.polygonOffsetFactor != 0 || state.polygonOffsetUnits != 0;
    setEnabled(GL_POLYGON_OFFSET_FILL, offset);
    setEnabled(GL_POLYGON_OFFSET_LINE, offset);
    glPolygonOffset(state.polygonOffsetFactor, state.polygonOffsetUnits);
    glPolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);

    setEnabled(GL_SCISSOR_TEST, state.scissor.has_value());
    if (state.scissor) glScissor(state.scissor->x, state.scissor->y, state.scissor->width, state.scissor->height);

    assert(state.clipDistances >= 0 && state.clipDistances <= kMaxClipDistances);
    for (int i = 0; i < kMaxClipDistances; ++i) setEnabled(GLenum(GL_CLIP_DISTANCE0 + i), i < state.clipDistances);
}

DepthBounds::DepthBounds(const std::optional<glm::vec2>& bounds)
    : m_on(bounds && epoxy_has_gl_extension("GL_EXT_depth_bounds_test")) {
    if (!m_on) return;
    glEnable(GL_DEPTH_BOUNDS_TEST_EXT);
    glDepthBoundsEXT(bounds->x, bounds->y);
}

DepthBounds::~DepthBounds() {
    if (m_on) glDisable(GL_DEPTH_BOUNDS_TEST_EXT);
}

void beginFrameState() {
    // Depth convention of the whole library: reversed, stored without the detour over -1 to 1.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthRangef(0.0f, 1.0f);
    setTightPixelStore();

    // sRGB attachments encode, cube maps filter across faces, samples of a multisample target are all drawn.
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glEnable(GL_MULTISAMPLE);

    // A host may have left these on.
    for (GLenum capability :
         {GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_DITHER, GL_PROGRAM_POINT_SIZE,
          GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE,
          GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK, GL_SAMPLE_SHADING, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
        glDisable(capability);
    if (epoxy_has_gl_extension("GL_EXT_depth_bounds_test")) glDisable(GL_DEPTH_BOUNDS_TEST_EXT);
    // A sampler object on a unit would override the sampling state of every texture there.
    glBindSamplers(0, GLsizei(kGuardedTextureUnits), nullptr);
}

void drawFullscreen() {
    drawVertices(3);
}

void drawVertices(std::size_t count) {
    // Vertex arrays belong to one context, and a process may have several: a fresh one per draw costs about a
    // microsecond.
    GLuint empty = 0;
    glCreateVertexArrays(1, &empty);
    glBindVertexArray(empty);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(count));
    glDeleteVertexArrays(1, &empty);
}

void drawElementsIndirect(const VertexArray& vertices, const Buffer& commands, std::size_t firstCommand,
                          std::size_t commandCount, GLenum mode) {
    assert((firstCommand + commandCount) * sizeof(DrawElementsIndirect) <= commands.size());
    if (commandCount == 0) return;
    vertices.bind();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.id());
    const std::size_t offset = firstCommand * sizeof(DrawElementsIndirect);
    glMultiDrawElementsIndirect(mode, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), GLsizei(commandCount), 0);
}

void drawElements(const VertexArray& vertices, GLenum mode, std::size_t firstIndex, std::size_t count) {
    if (count == 0) return;
    vertices.bind();
    const std::size_t offset = firstIndex * sizeof(std::uint32_t);
    glDrawElements(mode, GLsizei(count), GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

void dispatch(int groupsX, int groupsY, int groupsZ) {
    assert(groupsX > 0 && groupsY > 0 && groupsZ > 0);
    glDispatchCompute(GLuint(groupsX), GLuint(groupsY), GLuint(groupsZ));
}

void dispatchIndirect(const Buffer& groups, std::size_t offset) {
    assert(offset % 4 == 0 && offset + 12 <= groups.size());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    glDispatchComputeIndirect(GLintptr(offset));
}

void barrier(GLbitfield bits) {
    glMemoryBarrier(bits);
}

DebugGroup::DebugGroup(const char* name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    glPopDebugGroup();
}

}  // namespace ombrage::gl
