// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

constexpr const char* kFullscreen = R"(
uniform float depth;
void main() {
    gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, depth, 1.0);
}
)";
constexpr const char* kTriangles = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in uint value;
flat out uint v_value;
void main() { v_value = value; gl_Position = vec4(position, 0.5, 1.0); }
)";
constexpr const char* kWhite = "out vec4 color; uniform vec4 tint; void main() { color = tint; }";
constexpr const char* kValue = "flat in uint v_value; out vec4 color; void main() { color = vec4(float(v_value)); }";

class DrawStateTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        beginFrameState();
    }

    const Program& program(const char* vertex, const char* fragment) {
        ProgramDesc desc;
        desc.stages = {{GL_VERTEX_SHADER, "v"}, {GL_FRAGMENT_SHADER, "f"}};
        desc.virtuals = {{"v", vertex}, {"f", fragment}};
        return m_library.program(desc);
    }

    const Program& fullscreen(float depth, const glm::vec4& tint) {
        const Program& p = program(kFullscreen, kWhite);
        p.set("depth", depth);
        p.set("tint", tint);
        p.use();
        return p;
    }

    float red(int x = 0, int y = 0) const {
        std::vector<float> values(16 * 4);
        m_color.download(0, 0, GL_RGBA, GL_FLOAT, values.size() * 4, values.data());
        return values[std::size_t(y * 4 + x) * 4];
    }

    int stencil() const {
        std::uint8_t values[16] = {};
        m_depth.download(0, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, sizeof values, values);
        return values[5];
    }

    float depth() const {
        float values[16] = {};
        m_depth.download(0, 0, GL_DEPTH_COMPONENT, GL_FLOAT, sizeof values, values);
        return values[5];
    }

    void clear() {
        m_target.clearColor(0, glm::vec4(0));
        m_target.clearDepth(0.5f);
        m_target.clearStencil(10);
        m_target.bind();
    }

    ShaderLibrary m_library;
    Texture m_color{{TextureKind::Tex2D, GL_RGBA32F, 4, 4}, "color"};
    Texture m_depth{{TextureKind::Tex2D, GL_DEPTH32F_STENCIL8, 4, 4}, "depth"};
    Framebuffer m_target{{{&m_color}}, {&m_depth}, "target"};
};

TEST_F(DrawStateTest, FullscreenReachesEveryPixel) {
    clear();
    fullscreen(0.0f, glm::vec4(3));
    apply({});
    drawFullscreen();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_EQ(red(x, y), 3.0f);
    EXPECT_EQ(depth(), 0.5f);
}

TEST_F(DrawStateTest, ReversedDepthKeepsTheNearer) {
    clear();
    DrawState state;
    state.depthTest = state.depthWrite = true;
    apply(state);
    fullscreen(0.25f, glm::vec4(1));  // farther than 0.5
    drawFullscreen();
    EXPECT_EQ(red(), 0.0f);
    fullscreen(0.75f, glm::vec4(2));
    drawFullscreen();
    EXPECT_EQ(red(), 2.0f);
    EXPECT_EQ(depth(), 0.75f);  // clip z is stored as it is: zero-to-one clip control, exact in float
}

TEST_F(DrawStateTest, DepthWritesWithoutTest) {
    clear();
    DrawState state;
    state.depthWrite = true;
    apply(state);
    fullscreen(0.125f, glm::vec4(1));
    drawFullscreen();
    EXPECT_EQ(depth(), 0.125f);
}

TEST_F(DrawStateTest, BlendingAdds) {
    clear();
    DrawState state;
    state.blend = true;
    apply(state);
    fullscreen(0.5f, glm::vec4(1.5f));
    for (int i = 0; i < 3; ++i) drawFullscreen();
    EXPECT_EQ(red(), 4.5f);
    state.colorWrite = false;
    apply(state);
    drawFullscreen();
    EXPECT_EQ(red(), 4.5f);
}

TEST_F(DrawStateTest, ScissorLimitsDrawing) {
    clear();
    fullscreen(0.0f, glm::vec4(3));
    DrawState state;
    state.scissor = DrawState::Rect{1, 2, 3, 1};
    apply(state);
    drawFullscreen();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_EQ(red(x, y), x >= 1 && y == 2 ? 3.0f : 0.0f) << x << ", " << y;
    // An empty rectangle is not the same as none.
    clear();
    state.scissor = DrawState::Rect{};
    apply(state);
    drawFullscreen();
    EXPECT_EQ(red(), 0.0f);
    apply({});
    drawFullscreen();
    EXPECT_EQ(red(), 3.0f);
}

TEST_F(DrawStateTest, TwoSidedStencilTellsTheSides) {
    // Two triangles over the same pixels: the first is counter-clockwise (front), the second clockwise.
    const std::vector<glm::vec2> positions = {{-1, -1}, {3, -1}, {-1, 3}, {-1, -1}, {-1, 3}, {3, -1}};
    const std::vector<std::uint32_t> values = {1, 1, 1, 2, 2, 2};
    const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4, 5};
    const Buffer positionBuffer = Buffer::from(positions, "positions");
    const Buffer valueBuffer = Buffer::from(values, "values");
    const Buffer indexBuffer = Buffer::from(indices, "indices");
    const VertexArray array({{0, positionBuffer.id(), 0, 8, 0}, {1, valueBuffer.id(), 0, 4, 0}},
                            {{0, 2, GL_FLOAT, 0, 0}, {1, 1, GL_UNSIGNED_INT, 0, 1}}, indexBuffer.id());
    program(kTriangles, kValue).use();

    DrawState state;
    state.stencilTest = true;
    state.stencilFront.depthPass = GL_INCR_WRAP;
    state.stencilBack.depthPass = GL_DECR_WRAP;
    const auto draw = [&](std::size_t first, std::size_t count) {
        clear();
        apply(state);
        drawElements(array, GL_TRIANGLES, first, count);
    };
    draw(0, 3);
    EXPECT_EQ(stencil(), 11);
    EXPECT_EQ(red(), 1.0f);
    draw(3, 3);
    EXPECT_EQ(stencil(), 9);
    EXPECT_EQ(red(), 2.0f);  // the integer attribute arrives as an integer
    draw(0, 6);
    EXPECT_EQ(stencil(), 10);

    // Culling and the write mask.
    state.cull = GL_BACK;
    draw(0, 6);
    EXPECT_EQ(stencil(), 11);
    state.stencilWriteMask = 0;
    draw(0, 6);
    EXPECT_EQ(stencil(), 10);

    // The test itself: only where the stencil is 10.
    state.stencilFront.func = GL_NOTEQUAL;
    state.stencilFront.reference = 10;
    draw(0, 3);
    EXPECT_EQ(red(), 0.0f);

    // The same triangles through indirect commands, the second one first in line.
    const Buffer commands =
        Buffer::from(std::vector<DrawElementsIndirect>{{3, 1, 0, 0, 0}, {3, 1, 3, 0, 0}, {3, 1, 0, 3, 0}}, "commands");
    clear();
    apply({});
    drawElementsIndirect(array, commands, 1, 1);
    EXPECT_EQ(red(), 2.0f);
    clear();
    drawElementsIndirect(array, commands, 0, 1);
    EXPECT_EQ(red(), 1.0f);
    clear();
    drawElementsIndirect(array, commands, 0, 3);
    EXPECT_EQ(red(), 2.0f);
}

TEST_F(DrawStateTest, SrgbAttachmentsEncode) {
    const Texture color({TextureKind::Tex2D, GL_SRGB8_ALPHA8, 4, 4}, "srgb");
    const Framebuffer target({{&color}}, {}, "srgb");
    target.bind();
    apply({});
    fullscreen(0.5f, glm::vec4(0.5f));
    drawFullscreen();
    std::uint8_t values[64] = {};
    color.download(0, 0, GL_RGBA, GL_UNSIGNED_BYTE, sizeof values, values);
    // sRGB of linear 0.5 is 187.5 of 255; drivers may round the encoding by one.
    EXPECT_NEAR(values[0], 187.5, 1.5);
    EXPECT_NEAR(values[3], 127.5, 0.5);
}

TEST_F(DrawStateTest, ComputeFillsABuffer) {
    ProgramDesc desc;
    desc.stages = {{GL_COMPUTE_SHADER, "c"}};
    desc.virtuals = {{"c", R"(
layout(local_size_x = 8) in;
layout(std430, binding = 3) buffer b_Out { uint values[]; };
void main() { values[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * 3u; }
)"}};
    m_library.program(desc).use();
    const Buffer out(16 * 4, nullptr, "out");
    out.bindStorage(3);
    {
        const DebugGroup group("fill");
        dispatch(2, 1, 1);
    }
    barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<std::uint32_t> values(16);
    out.download(0, 64, values.data());
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(values[i], i * 3);
}

TEST_F(DrawStateTest, ABufferSaysHowManyGroups) {
    ProgramDesc desc;
    desc.stages = {{GL_COMPUTE_SHADER, "c"}};
    desc.virtuals = {{"c", R"(
layout(local_size_x = 1) in;
layout(std430, binding = 3) buffer b_Out { uint value; };
void main() { atomicAdd(value, 1u); }
)"}};
    m_library.program(desc).use();
    const Buffer groups = Buffer::from(std::vector<std::uint32_t>{99, 2, 3, 4}, "groups");
    const Buffer out(4, nullptr, "out");
    out.bindStorage(3);
    dispatchIndirect(groups, 4);
    barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::uint32_t value = 0;
    out.download(0, 4, &value);
    EXPECT_EQ(value, 2u * 3u * 4u);
}

TEST_F(DrawStateTest, ImagesBindWithTheirFormat) {
    ProgramDesc desc;
    desc.stages = {{GL_COMPUTE_SHADER, "c"}};
    desc.virtuals = {{"c", R"(
layout(local_size_x = 4, local_size_y = 4) in;
layout(r32f, binding = 1) uniform writeonly image2DArray img_out;
void main() {
    for (int layer = 0; layer < 2; ++layer)
        imageStore(img_out, ivec3(gl_GlobalInvocationID.xy, layer), vec4(float(layer) + 0.5));
}
)"}};
    m_library.program(desc).use();
    const Texture texture({TextureKind::Array2D, GL_R32F, 4, 4, 2}, "image");
    texture.bindImage(1, GL_WRITE_ONLY);
    dispatch(1, 1, 1);
    barrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    std::vector<float> values(16);
    texture.download(0, 1, GL_RED, GL_FLOAT, 64, values.data());
    EXPECT_EQ(values, std::vector<float>(16, 1.5f));
}

}  // namespace
}  // namespace ombrage::gl
