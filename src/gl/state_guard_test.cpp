// SPDX-License-Identifier: MIT
#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "gl/context.h"
#include "gl/objects.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

using State = std::map<std::string, std::vector<double>>;

#define NAMED(name) \
    { #name, name }
struct Named {
    const char* text;
    GLenum name;
};

constexpr Named kSwitches[] = {NAMED(GL_DEPTH_TEST),
                               NAMED(GL_DEPTH_CLAMP),
                               NAMED(GL_STENCIL_TEST),
                               NAMED(GL_CULL_FACE),
                               NAMED(GL_POLYGON_OFFSET_FILL),
                               NAMED(GL_POLYGON_OFFSET_LINE),
                               NAMED(GL_MULTISAMPLE),
                               NAMED(GL_SAMPLE_MASK),
                               NAMED(GL_SAMPLE_SHADING),
                               NAMED(GL_SAMPLE_COVERAGE),
                               NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
                               NAMED(GL_SAMPLE_ALPHA_TO_ONE),
                               NAMED(GL_CLIP_DISTANCE0),
                               NAMED(GL_CLIP_DISTANCE7),
                               NAMED(GL_FRAMEBUFFER_SRGB),
                               NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
                               NAMED(GL_PRIMITIVE_RESTART),
                               NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                               NAMED(GL_DITHER),
                               NAMED(GL_PROGRAM_POINT_SIZE),
                               NAMED(GL_RASTERIZER_DISCARD),
                               NAMED(GL_COLOR_LOGIC_OP),
                               NAMED(GL_LINE_SMOOTH),
                               NAMED(GL_POLYGON_SMOOTH)};

// Queries of at most four values.
constexpr Named kValues[] = {NAMED(GL_CURRENT_PROGRAM),
                             NAMED(GL_VERTEX_ARRAY_BINDING),
                             NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
                             NAMED(GL_READ_FRAMEBUFFER_BINDING),
                             NAMED(GL_BLEND_COLOR),
                             NAMED(GL_DEPTH_FUNC),
                             NAMED(GL_DEPTH_WRITEMASK),
                             NAMED(GL_STENCIL_FUNC),
                             NAMED(GL_STENCIL_REF),
                             NAMED(GL_STENCIL_VALUE_MASK),
                             NAMED(GL_STENCIL_FAIL),
                             NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
                             NAMED(GL_STENCIL_PASS_DEPTH_PASS),
                             NAMED(GL_STENCIL_WRITEMASK),
                             NAMED(GL_STENCIL_BACK_FUNC),
                             NAMED(GL_STENCIL_BACK_REF),
                             NAMED(GL_STENCIL_BACK_VALUE_MASK),
                             NAMED(GL_STENCIL_BACK_FAIL),
                             NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                             NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                             NAMED(GL_STENCIL_BACK_WRITEMASK),
                             NAMED(GL_CULL_FACE_MODE),
                             NAMED(GL_FRONT_FACE),
                             NAMED(GL_CLIP_ORIGIN),
                             NAMED(GL_CLIP_DEPTH_MODE),
                             NAMED(GL_POLYGON_MODE),
                             NAMED(GL_POLYGON_OFFSET_FACTOR),
                             NAMED(GL_POLYGON_OFFSET_UNITS),
                             NAMED(GL_SAMPLE_COVERAGE_VALUE),
                             NAMED(GL_SAMPLE_COVERAGE_INVERT),
                             NAMED(GL_MIN_SAMPLE_SHADING_VALUE),
                             NAMED(GL_ACTIVE_TEXTURE),
                             NAMED(GL_ARRAY_BUFFER_BINDING),
                             NAMED(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                             NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING),
                             NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
                             NAMED(GL_COPY_READ_BUFFER_BINDING),
                             NAMED(GL_COPY_WRITE_BUFFER_BINDING),
                             NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
                             NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
                             NAMED(GL_UNIFORM_BUFFER_BINDING),
                             NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                             NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
                             NAMED(GL_PACK_ALIGNMENT),
                             NAMED(GL_PACK_ROW_LENGTH),
                             NAMED(GL_PACK_SKIP_ROWS),
                             NAMED(GL_PACK_SKIP_PIXELS),
                             NAMED(GL_UNPACK_ALIGNMENT),
                             NAMED(GL_UNPACK_ROW_LENGTH),
                             NAMED(GL_UNPACK_SKIP_ROWS),
                             NAMED(GL_UNPACK_SKIP_PIXELS),
                             NAMED(GL_UNPACK_IMAGE_HEIGHT)};

// Indexed queries, looked at for indices 0 and 1, or only 0.
constexpr Named kIndexed[] = {NAMED(GL_VIEWPORT),
                              NAMED(GL_DEPTH_RANGE),
                              NAMED(GL_SCISSOR_BOX),
                              NAMED(GL_COLOR_WRITEMASK),
                              NAMED(GL_BLEND_SRC_RGB),
                              NAMED(GL_BLEND_DST_RGB),
                              NAMED(GL_BLEND_SRC_ALPHA),
                              NAMED(GL_BLEND_DST_ALPHA),
                              NAMED(GL_BLEND_EQUATION_RGB),
                              NAMED(GL_BLEND_EQUATION_ALPHA),
                              NAMED(GL_IMAGE_BINDING_NAME),
                              NAMED(GL_IMAGE_BINDING_LEVEL),
                              NAMED(GL_IMAGE_BINDING_LAYERED),
                              NAMED(GL_IMAGE_BINDING_LAYER),
                              NAMED(GL_IMAGE_BINDING_ACCESS),
                              NAMED(GL_IMAGE_BINDING_FORMAT),
                              NAMED(GL_UNIFORM_BUFFER_BINDING),
                              NAMED(GL_UNIFORM_BUFFER_START),
                              NAMED(GL_UNIFORM_BUFFER_SIZE),
                              NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
                              NAMED(GL_SHADER_STORAGE_BUFFER_START),
                              NAMED(GL_SHADER_STORAGE_BUFFER_SIZE),
                              NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
                              NAMED(GL_ATOMIC_COUNTER_BUFFER_START)};

constexpr Named kTextures[] = {NAMED(GL_TEXTURE_BINDING_2D),
                               NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
                               NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
                               NAMED(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
                               NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
                               NAMED(GL_SAMPLER_BINDING)};
#undef NAMED

State readState() {
    State state;
    for (const Named& s : kSwitches) state[s.text] = {double(glIsEnabled(s.name))};
    for (const Named& v : kValues) {
        GLdouble values[4] = {};
        glGetDoublev(v.name, values);
        state[v.text].assign(values, values + 4);
    }
    for (GLuint index : {0u, 1u}) {
        const std::string suffix = "[" + std::to_string(index) + "]";
        for (const Named& v : kIndexed) {
            // llvmpipe offers one of some kinds of binding; every driver has two of the rest.
            if (v.name == GL_ATOMIC_COUNTER_BUFFER_BINDING && index > 0) continue;
            if (v.name == GL_ATOMIC_COUNTER_BUFFER_START && index > 0) continue;
            GLdouble values[4] = {};
            if (v.name == GL_VIEWPORT || v.name == GL_DEPTH_RANGE) {
                glGetDoublei_v(v.name, index, values);
            } else {
                GLint integers[4] = {};
                glGetIntegeri_v(v.name, index, integers);
                std::copy(integers, integers + 4, values);
            }
            state[v.text + suffix].assign(values, values + 4);
        }
        state["GL_BLEND" + suffix] = {double(glIsEnabledi(GL_BLEND, index))};
        state["GL_SCISSOR_TEST" + suffix] = {double(glIsEnabledi(GL_SCISSOR_TEST, index))};
    }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint unit : {0u, 5u, kGuardedTextureUnits - 1}) {
        glActiveTexture(GL_TEXTURE0 + unit);
        for (const Named& t : kTextures) {
            GLint name = 0;
            glGetIntegerv(t.name, &name);
            state[t.text + ("[" + std::to_string(unit) + "]")] = {double(name)};
        }
    }
    glActiveTexture(GLenum(active));
    return state;
}

class StateGuardTest : public GlTest {
protected:
    ~StateGuardTest() override { glDeleteSamplers(1, &m_sampler); }

    void SetUp() override {
        GlTest::SetUp();
        glCreateSamplers(1, &m_sampler);
        ProgramDesc desc;
        desc.stages = {{GL_COMPUTE_SHADER, "c"}};
        for (const Program** program : {&m_hostProgram, &m_ownProgram}) {
            desc.virtuals = {{"c", "layout(local_size_x = 1) in;\nvoid main() {}\n"}};
            desc.defines.emplace_back("VARIANT", "1");
            desc.defines.back().first += std::to_string(desc.defines.size());
            *program = &m_library.program(desc);
        }
    }

    // What an ill-behaved host might leave: nothing here is a default of OpenGL or of Ombrage.
    void setHostState() {
        m_hostProgram->use();
        m_hostArray.bind();
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_hostTarget.id());
        glBindFramebuffer(GL_READ_FRAMEBUFFER, m_hostTarget.id());
        glViewportIndexedf(0, 1, 2, 30, 40);
        glViewportIndexedf(1, 3, 4, 50, 60);
        glDepthRangeIndexed(0, 0.25, 0.5);
        glDepthRangeIndexed(1, 0.75, 0.125);
        glScissorIndexed(0, 5, 6, 7, 8);
        glScissorIndexed(1, 9, 10, 11, 12);
        for (GLuint i : {0u, 1u}) glEnablei(GL_SCISSOR_TEST, i);
        for (GLuint i : {0u, 1u}) glEnablei(GL_BLEND, i);
        glBlendFuncSeparatei(0, GL_SRC_ALPHA, GL_DST_ALPHA, GL_DST_COLOR, GL_SRC_COLOR);
        glBlendFuncSeparatei(1, GL_ZERO, GL_CONSTANT_COLOR, GL_CONSTANT_ALPHA, GL_ZERO);
        glBlendEquationSeparatei(0, GL_MAX, GL_MIN);
        glBlendEquationSeparatei(1, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT);
        glBlendColor(0.25f, 0.5f, 0.75f, 0.125f);
        glColorMaski(0, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
        glColorMaski(1, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glDepthFunc(GL_NOTEQUAL);
        glDepthMask(GL_TRUE);
        glStencilFuncSeparate(GL_FRONT, GL_LESS, 11, 0x0f);
        glStencilFuncSeparate(GL_BACK, GL_GREATER, 12, 0xf0);
        glStencilOpSeparate(GL_FRONT, GL_ZERO, GL_INVERT, GL_INCR);
        glStencilOpSeparate(GL_BACK, GL_DECR, GL_REPLACE, GL_INVERT);
        glStencilMaskSeparate(GL_FRONT, 0x33);
        glStencilMaskSeparate(GL_BACK, 0x55);
        glCullFace(GL_FRONT_AND_BACK);
        glFrontFace(GL_CW);
        glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        glPolygonOffset(2.0f, 3.0f);
        glSampleCoverage(0.5f, GL_TRUE);
        glMinSampleShading(0.5f);
        setSwitches(true);
        bindHostObjects();
    }

    void bindHostObjects() {
        for (GLuint unit : {0u, 5u, kGuardedTextureUnits - 1}) {
            for (const Texture& texture : m_hostTextures) texture.bind(unit);
            glBindSampler(unit, m_sampler);
        }
        glBindImageTexture(0, m_hostTextures[1].id(), 2, GL_FALSE, 3, GL_READ_ONLY, GL_R32I);
        glBindImageTexture(1, m_hostTextures[1].id(), 1, GL_FALSE, 2, GL_READ_ONLY, GL_R32UI);
        for (GLenum target : {GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER}) {
            glBindBufferRange(target, 0, m_hostBuffer.id(), 256, 512);
            if (target != GL_ATOMIC_COUNTER_BUFFER) glBindBufferBase(target, 1, m_hostBuffer.id());
            glBindBuffer(target, m_hostOther.id());
        }
        for (GLenum target :
             {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER,
              GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
            glBindBuffer(target, m_hostBuffer.id());
        glActiveTexture(GL_TEXTURE7);
        for (GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) glPixelStorei(name, 8);
        for (GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_UNPACK_ROW_LENGTH,
                            GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT})
            glPixelStorei(name, 13);
    }

    // Each switch to the opposite of what Ombrage makes of it (`host`), or to what it makes of it.
    static void setSwitches(bool host) {
        for (const Named& s : kSwitches) {
            const bool isOnInOmbrage =
                s.name == GL_FRAMEBUFFER_SRGB || s.name == GL_TEXTURE_CUBE_MAP_SEAMLESS || s.name == GL_MULTISAMPLE;
            if (isOnInOmbrage != host)
                glEnable(s.name);
            else
                glDisable(s.name);
        }
    }

    // Everything that Ombrage does to the context.
    void useOmbrage() {
        beginFrameState();
        m_ownTarget.bind();
        DrawState state;
        state.depthTest = state.depthWrite = state.blend = state.wireframe = true;
        state.cull = GL_BACK;
        state.polygonOffsetFactor = 1;
        state.stencilBack.reference = 77;
        apply(state);
        state = DrawState();
        apply(state);
        m_ownTarget.clearColor(0, glm::vec4(0));
        m_ownProgram->use();
        m_ownArray.bind();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, m_ownTarget.id());
        for (GLuint unit : {0u, 5u, kGuardedTextureUnits - 1})
            for (const Texture& texture : m_ownTextures) texture.bind(unit);
        m_ownTextures[1].bindImage(0, GL_WRITE_ONLY);
        m_ownTextures[1].bindImage(1, GL_WRITE_ONLY);
        m_ownBuffer.bindUniform(0);
        m_ownBuffer.bindUniform(1);
        m_ownBuffer.bindStorage(0);
        m_ownBuffer.bindStorage(1);
        glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, m_ownBuffer.id());
        for (GLenum target : {GL_ARRAY_BUFFER, GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER,
                              GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER})
            glBindBuffer(target, m_ownBuffer.id());
        glActiveTexture(GL_TEXTURE0);
        glBlendColor(0, 0, 0, 0);
        glSampleCoverage(1.0f, GL_FALSE);
        glMinSampleShading(0.0f);
        glScissor(0, 0, 1, 1);
    }

    static std::vector<Texture> makeTextures() {
        std::vector<Texture> textures;
        textures.emplace_back(TextureDesc{TextureKind::Tex2D, GL_RGBA8, 8, 8}, "2d");
        textures.emplace_back(TextureDesc{TextureKind::Array2D, GL_RGBA8, 8, 8, 4, 3}, "array");
        textures.emplace_back(TextureDesc{TextureKind::Cube, GL_RGBA8, 8, 8}, "cube");
        textures.emplace_back(TextureDesc{TextureKind::CubeArray, GL_RGBA8, 8, 8, 2}, "cube array");
        textures.emplace_back(TextureDesc{TextureKind::Multisample2D, GL_RGBA8, 8, 8, 1, 1, 4}, "samples");
        return textures;
    }

    ShaderLibrary m_library;
    const Program* m_hostProgram = nullptr;
    const Program* m_ownProgram = nullptr;
    Buffer m_hostBuffer{1024, nullptr, "host"}, m_hostOther{1024, nullptr, "host other"},
        m_ownBuffer{1024, nullptr, "own"};
    std::vector<Texture> m_hostTextures = makeTextures(), m_ownTextures = makeTextures();
    // With stencil, because drivers cut the reference value to the bits that the target has.
    Texture m_depth{{TextureKind::Tex2D, GL_DEPTH32F_STENCIL8, 8, 8}, "depth"};
    Framebuffer m_hostTarget{{{&m_hostTextures[0]}}, {&m_depth}, "host"};
    Framebuffer m_ownTarget{{{&m_ownTextures[0]}}, {&m_depth}, "own"};
    VertexArray m_hostArray{{}, {}, 0}, m_ownArray{{}, {}, 0};
    GLuint m_sampler = 0;
};

TEST_F(StateGuardTest, PutsEverythingBack) {
    const StateGuard cleanUp;  // for the tests after this one
    setHostState();
    const State before = readState();
    State during;
    {
        const StateGuard guard;
        EXPECT_EQ(readState(), before) << "saving changed the state";
        useOmbrage();
        during = readState();
    }
    const State after = readState();
    for (const auto& [name, value] : before) EXPECT_EQ(after.at(name), value) << name;

    // The test means nothing for state that was the same before and during. Only these are: whole buffers, bound by
    // both.
    std::vector<std::string> same;
    for (const auto& [name, value] : before)
        if (during.at(name) == value) same.push_back(name);
    EXPECT_EQ(same, (std::vector<std::string>{"GL_SHADER_STORAGE_BUFFER_SIZE[1]", "GL_SHADER_STORAGE_BUFFER_START[1]",
                                              "GL_UNIFORM_BUFFER_SIZE[1]", "GL_UNIFORM_BUFFER_START[1]"}));
}

}  // namespace
}  // namespace ombrage::gl
