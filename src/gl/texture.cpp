// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "gl/object_label.h"
#include "gl/objects.h"
#include "gl/texture_format.h"
#include "gl/traffic.h"

namespace ombrage::gl {

namespace {

GLenum targetOf(TextureKind kind) {
    switch (kind) {
        case TextureKind::Tex2D:
            return GL_TEXTURE_2D;
        case TextureKind::Array2D:
            return GL_TEXTURE_2D_ARRAY;
        case TextureKind::Cube:
            return GL_TEXTURE_CUBE_MAP;
        case TextureKind::CubeArray:
            return GL_TEXTURE_CUBE_MAP_ARRAY;
        case TextureKind::Multisample2D:
            return GL_TEXTURE_2D_MULTISAMPLE;
    }
    return GL_TEXTURE_2D;
}

// Two-dimensional images of one level; a cube has six.
int imageCount(const TextureDesc& desc) {
    switch (desc.kind) {
        case TextureKind::Array2D:
            return desc.layers;
        case TextureKind::Cube:
            return 6;
        case TextureKind::CubeArray:
            return 6 * desc.layers;
        default:
            return 1;
    }
}

}  // namespace

int levelCount(const TextureDesc& desc) {
    if (desc.levels > 0) return desc.levels;
    return int(std::bit_width(unsigned(std::max(desc.width, desc.height))));
}

std::vector<int> sampleCounts(GLenum format) {
    GLint count = 0;
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &count);
    std::vector<int> counts(std::size_t(count), 0);
    if (count > 0) glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES, count, counts.data());
    return counts;
}

std::uint64_t byteSize(const TextureDesc& desc) {
    assert(texelSize(desc.format) > 0);
    std::uint64_t texels = 0;
    for (int level = 0; level < levelCount(desc); ++level) {
        const auto width = std::uint64_t(std::max(1, desc.width >> level));
        const auto height = std::uint64_t(std::max(1, desc.height >> level));
        texels += width * height;
    }
    return texels * std::uint64_t(imageCount(desc)) * std::uint64_t(std::max(1, desc.samples)) *
           std::uint64_t(texelSize(desc.format));
}

Texture::Texture(const TextureDesc& desc, const char* label) : m_desc(desc) {
    assert(desc.width > 0 && desc.height > 0 && desc.layers > 0 && desc.levels >= 0 && desc.samples > 0);
    glCreateTextures(targetOf(desc.kind), 1, &m_id);
    switch (desc.kind) {
        case TextureKind::Tex2D:
        case TextureKind::Cube:
            glTextureStorage2D(m_id, levels(), desc.format, desc.width, desc.height);
            break;
        case TextureKind::Array2D:
            glTextureStorage3D(m_id, levels(), desc.format, desc.width, desc.height, desc.layers);
            break;
        case TextureKind::CubeArray:
            glTextureStorage3D(m_id, levels(), desc.format, desc.width, desc.height, 6 * desc.layers);
            break;
        case TextureKind::Multisample2D:
            glTextureStorage2DMultisample(m_id, desc.samples, desc.format, desc.width, desc.height, GL_TRUE);
            break;
    }

    // A size over the limits or no memory leaves the texture without storage.
    GLint immutable = GL_FALSE;
    glGetTextureParameteriv(m_id, GL_TEXTURE_IMMUTABLE_FORMAT, &immutable);
    if (immutable == GL_FALSE) {
        glDeleteTextures(1, &m_id);
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        throw Error(
            ErrorCode::Environment,
            fmt::format("the driver refused a texture of {}x{}x{} texels, {} samples, {} bytes ('{}')", desc.width,
                        desc.height, imageCount(desc), desc.samples, byteSize(desc), label ? label : ""),
            fmt::format("Use a smaller resolution; this device has textures of at most {} texels a side.", largest));
    }
    labelObject(GL_TEXTURE, m_id, label);

    // Multisample textures have no sampling state.
    if (desc.kind == TextureKind::Multisample2D) return;
    setFilter(GL_NEAREST, GL_NEAREST);
    setWrap(GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
    if (m_id != 0) glDeleteTextures(1, &m_id);
}

Texture::Texture(Texture&& other) noexcept
    : m_id(std::exchange(other.m_id, 0)), m_desc(std::exchange(other.m_desc, TextureDesc{})) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(m_id, other.m_id);
    std::swap(m_desc, other.m_desc);
    return *this;
}

void Texture::setFilter(GLenum minFilter, GLenum magFilter) {
    glTextureParameteri(m_id, GL_TEXTURE_MIN_FILTER, GLint(minFilter));
    glTextureParameteri(m_id, GL_TEXTURE_MAG_FILTER, GLint(magFilter));
}

void Texture::setWrap(GLenum wrap) {
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(m_id, axis, GLint(wrap));
}

void Texture::setLevels(int first, int last) {
    glTextureParameteri(m_id, GL_TEXTURE_BASE_LEVEL, first);
    glTextureParameteri(m_id, GL_TEXTURE_MAX_LEVEL, last);
}

void Texture::setBorder(const glm::vec4& color) {
    glTextureParameterfv(m_id, GL_TEXTURE_BORDER_COLOR, &color[0]);
    setWrap(GL_CLAMP_TO_BORDER);
}

void Texture::setCompare(GLenum compareFunc) {
    glTextureParameteri(m_id, GL_TEXTURE_COMPARE_MODE, compareFunc == GL_NONE ? GL_NONE : GL_COMPARE_REF_TO_TEXTURE);
    if (compareFunc != GL_NONE) glTextureParameteri(m_id, GL_TEXTURE_COMPARE_FUNC, GLint(compareFunc));
}

void Texture::generateMipmap() {
    glGenerateTextureMipmap(m_id);
}

void Texture::upload(int layer, GLenum format, GLenum type, const void* data) {
    assert(layer >= 0 && layer < imageCount(m_desc) && m_desc.kind != TextureKind::Multisample2D);
    setTightPixelStore();
    if (m_desc.kind == TextureKind::Tex2D)
        glTextureSubImage2D(m_id, 0, 0, 0, m_desc.width, m_desc.height, format, type, data);
    else
        glTextureSubImage3D(m_id, 0, 0, 0, layer, m_desc.width, m_desc.height, 1, format, type, data);
}

void Texture::download(int level, int layer, GLenum format, GLenum type, std::size_t bytes, void* data) const {
    assert(level >= 0 && level < levels() && layer >= 0 && layer < imageCount(m_desc));
    assert(m_desc.kind != TextureKind::Multisample2D);
    setTightPixelStore();
    const int levelWidth = std::max(1, m_desc.width >> level);
    const int levelHeight = std::max(1, m_desc.height >> level);
    glGetTextureSubImage(m_id, level, 0, 0, layer, levelWidth, levelHeight, 1, format, type, GLsizei(bytes), data);
}

void Texture::bind(GLuint unit) const {
    if (levels() == 1) noteImage(m_id, byteSize(m_desc));
    glBindTextureUnit(unit, m_id);
}

void Texture::bindImage(GLuint unit, GLenum access, int level, int layer) const {
    if (levels() == 1) noteImage(m_id, byteSize(m_desc));
    const GLboolean layered = layer < 0 ? GL_TRUE : GL_FALSE;
    glBindImageTexture(unit, m_id, level, layered, std::max(0, layer), access, m_desc.format);
}

}  // namespace ombrage::gl
