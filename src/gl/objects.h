// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <glm/glm.hpp>

namespace ombrage::gl {

/// A buffer object. Movable, owns its name; a default-constructed one is empty (id 0).
class Buffer {
public:
    Buffer() = default;
    /// Immutable storage that can be updated with upload(). `data` may be null. Size 0 makes 16 zero bytes.
    /// @throws Error(Environment) when the driver has no room for it.
    Buffer(std::size_t size, const void* data, const char* label);
    template <typename T>
    static Buffer from(const std::vector<T>& values, const char* label) {
        return Buffer(values.size() * sizeof(T), values.data(), label);
    }
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    GLuint id() const { return m_id; }
    std::size_t size() const { return m_size; }
    explicit operator bool() const { return m_id != 0; }

    /// The range must lie inside the buffer (asserted).
    void upload(std::size_t offset, std::size_t size, const void* data);
    void download(std::size_t offset, std::size_t size, void* data) const;
    void clear();  ///< all bytes 0

    void bindUniform(GLuint binding) const;
    void bindStorage(GLuint binding) const;

private:
    GLuint m_id = 0;
    std::size_t m_size = 0;
};

enum class TextureKind { Tex2D, Array2D, Cube, CubeArray, Multisample2D };

struct TextureDesc {
    TextureKind kind = TextureKind::Tex2D;
    GLenum format = GL_RGBA8;  ///< sized internal format
    int width = 1, height = 1;
    int layers = 1;  ///< Array2D: layers; CubeArray: cubes; else 1
    int levels = 1;  ///< 0: the full chain
    int samples = 1;
    bool operator==(const TextureDesc&) const = default;
};

/// Mip levels: `levels`, or those of the full chain when it is 0.
int levelCount(const TextureDesc& desc);

/// How many samples a texel of a multisampled texture of the format may have, in falling order. A texture made with a
/// number between gets the next higher one.
std::vector<int> sampleCounts(GLenum format);

/// Bytes that the texture takes, all levels, layers and samples. The format is one that Ombrage uses (asserted).
std::uint64_t byteSize(const TextureDesc& desc);

/// An immutable-storage texture with its own sampling state: nearest, clamped to edge, no comparison, until set.
class Texture {
public:
    Texture() = default;
    /// @throws Error(Environment) when the driver refuses the size.
    Texture(const TextureDesc& desc, const char* label);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    GLuint id() const { return m_id; }
    /// As given to the constructor (levels 0 stays 0).
    const TextureDesc& desc() const { return m_desc; }
    int levels() const { return levelCount(m_desc); }
    int width() const { return m_desc.width; }
    int height() const { return m_desc.height; }
    explicit operator bool() const { return m_id != 0; }

    void setFilter(GLenum minFilter, GLenum magFilter);
    void setWrap(GLenum wrap);
    /// From now on the sampler sees these levels alone: one may then be drawn while another is read.
    void setLevels(int first, int last);
    void setBorder(const glm::vec4& color);  ///< and GL_CLAMP_TO_BORDER
    void setCompare(GLenum compareFunc);     ///< GL_NONE turns comparison off
    void generateMipmap();

    /// Whole level 0 of layer `layer` (cube faces count as layers). Data tightly packed, row 0 the bottom row.
    void upload(int layer, GLenum format, GLenum type, const void* data);
    /// Level `level`, one layer, into tightly packed memory; `bytes` is the room there.
    void download(int level, int layer, GLenum format, GLenum type, std::size_t bytes, void* data) const;

    void bind(GLuint unit) const;
    /// layer -1 binds all layers.
    void bindImage(GLuint unit, GLenum access, int level = 0, int layer = -1) const;

private:
    GLuint m_id = 0;
    TextureDesc m_desc;
};

/// One attachment: a level of a texture, all of its layers (layered rendering) or one.
struct Attachment {
    const Texture* texture = nullptr;
    int level = 0;
    int layer = -1;
};

/// A framebuffer with up to 8 colour attachments and an optional depth or depth-stencil attachment (told by its
/// format).
class Framebuffer {
public:
    Framebuffer() = default;
    /// All attachments have one size. @throws Error(Environment) when the driver calls it incomplete.
    Framebuffer(const std::vector<Attachment>& colors, const Attachment& depth, const char* label);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    GLuint id() const { return m_id; }
    int width() const { return m_width; }
    int height() const { return m_height; }
    explicit operator bool() const { return m_id != 0; }

    /// Binds for drawing and sets the viewport (and turns the scissor off).
    void bind() const;
    /// The clear functions clear the whole attachment whatever the masks and the scissor were; they leave the scissor
    /// off and the mask concerned open, so call apply() after them.
    void clearColor(int attachment, const glm::vec4& value) const;
    void clearColorUint(int attachment, const glm::uvec4& value) const;
    void clearDepth(float depth) const;
    void clearStencil(int stencil) const;

    /// Where the samples of a pixel lie, in pixels from its centre, right and up; one at the centre without multisampling.
    /// Binds it for drawing.
    std::vector<glm::vec2> samplePositions() const;

private:
    GLuint m_id = 0;
    int m_width = 0, m_height = 0;
    std::vector<std::pair<GLuint, std::uint64_t>> m_images;  ///< attached, and the bytes of each
    bool m_hasStencil = false;
};

struct VertexAttribute {
    GLuint location;
    GLint components;
    GLenum type;  ///< GL_FLOAT; integer types go through glVertexArrayAttribIFormat
    GLuint offset;
    GLuint binding;
};

struct VertexBinding {
    GLuint binding;
    GLuint buffer;
    GLintptr offset;
    GLsizei stride;
    GLuint divisor;
};

class VertexArray {
public:
    VertexArray() = default;
    VertexArray(const std::vector<VertexBinding>& bindings, const std::vector<VertexAttribute>& attributes,
                GLuint indexBuffer);
    ~VertexArray();
    VertexArray(VertexArray&& other) noexcept;
    VertexArray& operator=(VertexArray&& other) noexcept;
    GLuint id() const { return m_id; }
    void bind() const;

private:
    GLuint m_id = 0;
};

/// Fixed-function state of one draw. The default is a full-screen pass: no depth, no stencil, no blend, no culling.
struct DrawState {
    bool depthTest = false;
    GLenum depthFunc = GL_GEQUAL;  ///< reversed-Z
    bool depthWrite = false;
    bool depthClamp = false;
    bool stencilTest = false;
    struct StencilFace {
        GLenum func = GL_ALWAYS;
        GLint reference = 0;
        GLuint readMask = 0xff;
        GLenum stencilFail = GL_KEEP, depthFail = GL_KEEP, depthPass = GL_KEEP;
    } stencilFront, stencilBack;
    GLuint stencilWriteMask = 0xff;
    GLenum cull = GL_NONE;  ///< GL_NONE, GL_FRONT, GL_BACK; counter-clockwise is the front
    bool blend = false;
    GLenum blendSource = GL_ONE, blendDestination = GL_ONE, blendEquation = GL_FUNC_ADD;
    bool colorWrite = true;
    float polygonOffsetFactor = 0, polygonOffsetUnits = 0;
    int clipDistances = 0;
    bool wireframe = false;
    struct Rect {
        int x = 0, y = 0, width = 0, height = 0;  ///< pixels, from the lower left corner
        bool operator==(const Rect&) const = default;
    };
    std::optional<Rect> scissor;  ///< nothing outside of it is drawn
};

/// Sets all of DrawState. Clip control (lower left, zero to one) is set once by beginFrameState.
void apply(const DrawState& state);

/// While it lives nothing is drawn where the stored depth lies outside of the bounds (lower, upper). Without bounds,
/// and with drivers without Capabilities::depthBoundsTest, it does nothing.
class DepthBounds {
public:
    explicit DepthBounds(const std::optional<glm::vec2>& bounds);
    ~DepthBounds();
    DepthBounds(const DepthBounds&) = delete;
    DepthBounds& operator=(const DepthBounds&) = delete;

private:
    bool m_on;
};

/// Clip control, pixel store and other once-per-frame state.
void beginFrameState();

/// One triangle that covers the viewport; binds its own empty vertex array. The program is already in use.
void drawFullscreen();

/// Triangles that a vertex shader makes of gl_VertexID alone; otherwise as drawFullscreen().
void drawVertices(std::size_t count);

struct DrawElementsIndirect {
    std::uint32_t count, instanceCount, firstIndex;
    std::int32_t baseVertex;
    std::uint32_t baseInstance;
};

void drawElementsIndirect(const VertexArray& vertices, const Buffer& commands, std::size_t firstCommand,
                          std::size_t commandCount, GLenum mode = GL_TRIANGLES);
void drawElements(const VertexArray& vertices, GLenum mode, std::size_t firstIndex, std::size_t count);
void dispatch(int groupsX, int groupsY, int groupsZ);
/// As many groups as three words of the buffer say, from a byte on that is a multiple of 4.
void dispatchIndirect(const Buffer& groups, std::size_t offset);
void barrier(GLbitfield bits);

/// KHR_debug group for tools such as RenderDoc.
class DebugGroup {
public:
    explicit DebugGroup(const char* name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace ombrage::gl
