// SPDX-License-Identifier: MIT
#include "gl/objects.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include <ombrage/error.h>

#include "gl/gpu_timer.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

class ObjectsTest : public GlTest {};

template <typename T>
std::vector<T> downloadLayer(const Texture& texture, int level, int layer, GLenum format, GLenum type,
                             std::size_t count) {
    std::vector<T> values(count);
    texture.download(level, layer, format, type, count * sizeof(T), values.data());
    return values;
}

// Values that no two texels share, so that a swapped row or channel shows.
template <typename T>
std::vector<T> counting(std::size_t count, T first = T(1)) {
    std::vector<T> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

TEST_F(ObjectsTest, BufferKeepsBytes) {
    Buffer buffer = Buffer::from(counting<std::uint32_t>(100), "numbers");
    EXPECT_EQ(buffer.size(), 400u);
    const std::uint32_t patch[2] = {7000, 8000};
    buffer.upload(40, sizeof patch, patch);
    std::vector<std::uint32_t> back(100);
    buffer.download(0, 400, back.data());
    auto expected = counting<std::uint32_t>(100);
    expected[10] = 7000;
    expected[11] = 8000;
    EXPECT_EQ(back, expected);

    buffer.clear();
    buffer.download(0, 400, back.data());
    EXPECT_EQ(back, std::vector<std::uint32_t>(100, 0u));
}

TEST_F(ObjectsTest, EmptyBufferCanBeBound) {
    const Buffer buffer(0, nullptr, "nothing");
    EXPECT_EQ(buffer.size(), 16u);
    std::vector<std::uint8_t> bytes(16, 0xff);
    buffer.download(0, 16, bytes.data());
    EXPECT_EQ(bytes, std::vector<std::uint8_t>(16, 0));
    buffer.bindStorage(0);
    buffer.bindUniform(0);
}

TEST_F(ObjectsTest, MovesLeaveOneOwner) {
    Buffer a(16, nullptr, "a");
    const GLuint id = a.id();
    Buffer b(std::move(a));
    EXPECT_EQ(b.id(), id);
    EXPECT_FALSE(bool(a));  // NOLINT(bugprone-use-after-move): the state after a move is the subject
    a = std::move(b);
    EXPECT_EQ(a.id(), id);
    EXPECT_EQ(a.size(), 16u);
}

TEST_F(ObjectsTest, HalfFloatsComeBackExactly) {
    // Half floats hold the integers up to 2048 exactly.
    Texture texture({TextureKind::Tex2D, GL_R16F, 5, 3}, "half");
    const auto values = counting<float>(15);
    texture.upload(0, GL_RED, GL_FLOAT, values.data());
    EXPECT_EQ(downloadLayer<float>(texture, 0, 0, GL_RED, GL_FLOAT, 15), values);
}

TEST_F(ObjectsTest, RowsArePackedTightly) {
    // Five bytes a row: any pixel alignment but 1 shifts the second row.
    Texture texture({TextureKind::Tex2D, GL_R8, 5, 3}, "bytes");
    const auto values = counting<std::uint8_t>(15);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);
    texture.upload(0, GL_RED, GL_UNSIGNED_BYTE, values.data());
    EXPECT_EQ(downloadLayer<std::uint8_t>(texture, 0, 0, GL_RED, GL_UNSIGNED_BYTE, 15), values);
}

TEST_F(ObjectsTest, SixteenBitColoursComeBackExactly) {
    Texture texture({TextureKind::Tex2D, GL_RGBA16, 5, 3}, "rgba16");
    const auto values = counting<std::uint16_t>(60, 65470);
    texture.upload(0, GL_RGBA, GL_UNSIGNED_SHORT, values.data());
    EXPECT_EQ(downloadLayer<std::uint16_t>(texture, 0, 0, GL_RGBA, GL_UNSIGNED_SHORT, 60), values);
}

TEST_F(ObjectsTest, UnsignedPairsComeBackExactly) {
    Texture texture({TextureKind::Tex2D, GL_RG32UI, 5, 3}, "ids");
    const auto values = counting<std::uint32_t>(30, 0xfffffff0u);  // wraps: all 32 bits count
    texture.upload(0, GL_RG_INTEGER, GL_UNSIGNED_INT, values.data());
    EXPECT_EQ(downloadLayer<std::uint32_t>(texture, 0, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, 30), values);
}

TEST_F(ObjectsTest, FloatDepthComesBackExactly) {
    Texture texture({TextureKind::Tex2D, GL_DEPTH_COMPONENT32F, 5, 3}, "depth");
    std::vector<float> values = counting<float>(15);
    for (float& v : values) v = 1e-7f * v * v;  // far reversed depths
    texture.upload(0, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
    EXPECT_EQ(downloadLayer<float>(texture, 0, 0, GL_DEPTH_COMPONENT, GL_FLOAT, 15), values);
}

TEST_F(ObjectsTest, DepthAndStencilComeBackExactly) {
    struct DepthStencil {
        float depth;
        std::uint32_t stencil;
        bool operator==(const DepthStencil&) const = default;
    };
    Texture texture({TextureKind::Tex2D, GL_DEPTH32F_STENCIL8, 5, 3}, "depth stencil");
    std::vector<DepthStencil> values(15);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {float(i) / 16.0f, std::uint32_t(240 + i)};
    texture.upload(0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, values.data());
    auto back = downloadLayer<DepthStencil>(texture, 0, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 15);
    for (DepthStencil& v : back) v.stencil &= 0xff;  // the other 24 bits are undefined
    EXPECT_EQ(back, values);
}

TEST_F(ObjectsTest, LayersAndFacesAreApart) {
    struct Case {
        TextureKind kind;
        int layers, images;
    };
    for (const Case& c :
         {Case{TextureKind::Array2D, 3, 3}, Case{TextureKind::Cube, 1, 6}, Case{TextureKind::CubeArray, 2, 12}}) {
        Texture texture({c.kind, GL_R32F, 4, 4, c.layers}, "layers");
        for (int i = 0; i < c.images; ++i)
            texture.upload(i, GL_RED, GL_FLOAT, counting<float>(16, float(100 * i)).data());
        for (int i = 0; i < c.images; ++i)
            EXPECT_EQ(downloadLayer<float>(texture, 0, i, GL_RED, GL_FLOAT, 16), counting<float>(16, float(100 * i)))
                << "image " << i << " of kind " << int(c.kind);
    }
}

TEST_F(ObjectsTest, MipmapIsTheMean) {
    Texture texture({TextureKind::Tex2D, GL_R32F, 4, 2, 1, 0}, "chain");
    EXPECT_EQ(texture.levels(), 3);
    EXPECT_EQ(texture.desc().levels, 0);
    const std::vector<float> values = {0, 2, 4, 6, 8, 10, 12, 14};
    texture.upload(0, GL_RED, GL_FLOAT, values.data());
    texture.generateMipmap();
    EXPECT_EQ(downloadLayer<float>(texture, 1, 0, GL_RED, GL_FLOAT, 2), (std::vector<float>{5, 9}));
    EXPECT_EQ(downloadLayer<float>(texture, 2, 0, GL_RED, GL_FLOAT, 1), (std::vector<float>{7}));
}

TEST_F(ObjectsTest, ByteSizeCountsEverything) {
    EXPECT_EQ(byteSize({TextureKind::Tex2D, GL_RGBA8, 16, 8}), 512u);
    EXPECT_EQ(byteSize({TextureKind::Tex2D, GL_R32F, 4, 4, 1, 0}), (16u + 4u + 1u) * 4u);
    EXPECT_EQ(byteSize({TextureKind::Cube, GL_DEPTH_COMPONENT32F, 8, 8}), 6u * 64u * 4u);
    EXPECT_EQ(byteSize({TextureKind::CubeArray, GL_RGBA16F, 8, 8, 2}), 12u * 64u * 8u);
    EXPECT_EQ(byteSize({TextureKind::Array2D, GL_RG32F, 8, 8, 5}), 5u * 64u * 8u);
    EXPECT_EQ(byteSize({TextureKind::Multisample2D, GL_RGBA8, 8, 8, 1, 1, 4}), 4u * 64u * 4u);
}

TEST_F(ObjectsTest, SamplingStateIsSet) {
    Texture texture({TextureKind::Tex2D, GL_DEPTH_COMPONENT32F, 4, 4}, "shadow");
    const auto parameter = [&](GLenum name) {
        GLint value = 0;
        glGetTextureParameteriv(texture.id(), name, &value);
        return GLenum(value);
    };
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GLenum(GL_NEAREST));
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GLenum(GL_CLAMP_TO_EDGE));
    EXPECT_EQ(parameter(GL_TEXTURE_COMPARE_MODE), GLenum(GL_NONE));
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    texture.setBorder(glm::vec4(1));
    texture.setCompare(GL_GEQUAL);
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GLenum(GL_LINEAR));
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GLenum(GL_CLAMP_TO_BORDER));
    EXPECT_EQ(parameter(GL_TEXTURE_COMPARE_MODE), GLenum(GL_COMPARE_REF_TO_TEXTURE));
    EXPECT_EQ(parameter(GL_TEXTURE_COMPARE_FUNC), GLenum(GL_GEQUAL));
    texture.setCompare(GL_NONE);
    EXPECT_EQ(parameter(GL_TEXTURE_COMPARE_MODE), GLenum(GL_NONE));
}

TEST_F(ObjectsTest, ClearsReachEveryAttachmentWhateverTheMasks) {
    const Texture color({TextureKind::Tex2D, GL_RGBA16F, 4, 4}, "color");
    const Texture ids({TextureKind::Tex2D, GL_RG32UI, 4, 4}, "ids");
    const Texture depth({TextureKind::Tex2D, GL_DEPTH32F_STENCIL8, 4, 4}, "depth");
    const Framebuffer target({{&color}, {&ids}}, {&depth}, "target");
    EXPECT_EQ(target.width(), 4);

    // A host or an earlier draw left every mask closed and a scissor on.
    DrawState closed;
    closed.colorWrite = false;
    closed.stencilWriteMask = 0;
    apply(closed);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);

    target.clearColor(0, {0.25f, 0.5f, 0.75f, 1.0f});
    target.clearColorUint(1, {7u, 0xffffffffu, 0u, 0u});
    target.clearDepth(0.125f);
    target.clearStencil(200);

    const auto colors = downloadLayer<float>(color, 0, 0, GL_RGBA, GL_FLOAT, 64);
    EXPECT_EQ(colors[60], 0.25f);
    EXPECT_EQ(colors[62], 0.75f);
    const auto idValues = downloadLayer<std::uint32_t>(ids, 0, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, 32);
    EXPECT_EQ(idValues[30], 7u);
    EXPECT_EQ(idValues[31], 0xffffffffu);
    EXPECT_EQ(downloadLayer<float>(depth, 0, 0, GL_DEPTH_COMPONENT, GL_FLOAT, 16), std::vector<float>(16, 0.125f));
    EXPECT_EQ(downloadLayer<std::uint8_t>(depth, 0, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 16),
              std::vector<std::uint8_t>(16, 200));
}

TEST_F(ObjectsTest, FramebufferDrawsToOneFace) {
    const Texture cube({TextureKind::Cube, GL_DEPTH_COMPONENT32F, 4, 4}, "cube");
    for (int face = 0; face < 6; ++face) Framebuffer({}, {&cube, 0, face}, "face").clearDepth(float(face) / 8.0f);
    for (int face = 0; face < 6; ++face)
        EXPECT_EQ(downloadLayer<float>(cube, 0, face, GL_DEPTH_COMPONENT, GL_FLOAT, 16),
                  std::vector<float>(16, float(face) / 8.0f));
    // Layered: one clear reaches all of them.
    Framebuffer({}, {&cube}, "all faces").clearDepth(1.0f);
    EXPECT_EQ(downloadLayer<float>(cube, 0, 5, GL_DEPTH_COMPONENT, GL_FLOAT, 16), std::vector<float>(16, 1.0f));
}

TEST_F(ObjectsTest, FramebufferTakesSizeOfLevel) {
    const Texture chain({TextureKind::Tex2D, GL_R32F, 16, 8, 1, 0}, "chain");
    const Framebuffer target({{&chain, 2}}, {}, "level 2");
    EXPECT_EQ(target.width(), 4);
    EXPECT_EQ(target.height(), 2);
    target.clearColor(0, glm::vec4(3));
    EXPECT_EQ(downloadLayer<float>(chain, 2, 0, GL_RED, GL_FLOAT, 8), std::vector<float>(8, 3.0f));
}

TEST_F(ObjectsTest, MultisampleTargetIsComplete) {
    const int samples = context().capabilities().maxSamples;
    const Texture color({TextureKind::Multisample2D, GL_RGBA8, 4, 4, 1, 1, samples}, "samples");
    const Texture depth({TextureKind::Multisample2D, GL_DEPTH_COMPONENT32F, 4, 4, 1, 1, samples}, "depth samples");
    const Framebuffer target({{&color}}, {&depth}, "multisample");
    target.clearColor(0, glm::vec4(1));
    target.bind();
}

TEST_F(ObjectsTest, SamplesLieInTheirPixels) {
    const std::vector<int> counts = sampleCounts(GL_RGBA32UI);
    ASSERT_FALSE(counts.empty());
    EXPECT_TRUE(std::is_sorted(counts.rbegin(), counts.rend()));
    const Texture color({TextureKind::Multisample2D, GL_RGBA32UI, 4, 4, 1, 1, counts.front()}, "samples");
    const std::vector<glm::vec2> positions = Framebuffer({{&color}}, {}, "multisample").samplePositions();
    EXPECT_EQ(positions.size(), std::size_t(counts.front()));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        EXPECT_LE(std::max(std::abs(positions[i].x), std::abs(positions[i].y)), 0.5f);
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(positions[i], positions[j]);
    }
    const Texture plain({TextureKind::Tex2D, GL_RGBA8, 4, 4}, "plain");
    EXPECT_EQ(Framebuffer({{&plain}}, {}, "plain").samplePositions(), std::vector<glm::vec2>{glm::vec2(0)});
}

TEST_F(ObjectsTest, RefusedSizeIsAnError) {
    const int side = context().capabilities().maxTextureSize * 2;
    try {
        const Texture texture({TextureKind::Tex2D, GL_RGBA8, side, 1}, "too wide");
        FAIL() << "a texture over the limit was made";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Environment);
        EXPECT_NE(error.message().find(std::to_string(side)), std::string::npos);
        EXPECT_NE(error.hint().find(std::to_string(side / 2)), std::string::npos);
    }
    // The driver's own complaint is the point of this test.
    EXPECT_FALSE(context().takeDebugMessages().empty());
}

TEST_F(ObjectsTest, IncompleteFramebufferIsAnError) {
    const Texture notDrawable({TextureKind::Tex2D, GL_RGB9_E5, 4, 4}, "shared exponent");
    EXPECT_THROW(Framebuffer({{&notDrawable}}, {}, "wrong"), Error);
    context().takeDebugMessages();
}

TEST_F(ObjectsTest, NamesAreGivenBack) {
    // Objects that live, counted over more names than the cycles can use up.
    const auto countLiving = [] {
        int count = 0;
        for (GLuint name = 1; name < 20000; ++name)
            count += glIsBuffer(name) + glIsTexture(name) + glIsFramebuffer(name) + glIsVertexArray(name) +
                     glIsProgram(name) + glIsShader(name) + glIsQuery(name);
        return count;
    };
    const auto cycle = [] {
        const Buffer buffer(64, nullptr, "cycle");
        const Texture texture({TextureKind::Tex2D, GL_RGBA8, 4, 4}, "cycle");
        const Framebuffer framebuffer({{&texture}}, {}, "cycle");
        const VertexArray array({{0, buffer.id(), 0, 12, 0}}, {{0, 3, GL_FLOAT, 0, 0}}, buffer.id());
        Buffer moved(64, nullptr, "moved");
        moved = Buffer(128, nullptr, "replacement");
        ShaderLibrary library;
        ProgramDesc desc;
        desc.stages = {{GL_VERTEX_SHADER, "v"}, {GL_FRAGMENT_SHADER, "f"}};
        desc.virtuals = {{"v", "void main() { gl_Position = vec4(0.0); }"},
                         {"f", "out vec4 color; void main() { color = vec4(0.0); }"}};
        library.program(desc).use();
        framebuffer.bind();
        apply({});
        drawFullscreen();
        glUseProgram(0);  // a program in use outlives its deletion
        GpuTimer timer(Clock::Timestamp);
        timer.begin("span");
        timer.end();
        timer.take();
    };
    cycle();
    const int before = countLiving();
    for (int i = 0; i < 100; ++i) cycle();
    EXPECT_EQ(countLiving(), before);
}

}  // namespace
}  // namespace ombrage::gl
