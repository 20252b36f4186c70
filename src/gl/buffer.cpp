// SPDX-License-Identifier: MIT
#include <cassert>
#include <utility>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "gl/object_label.h"
#include "gl/objects.h"

namespace ombrage::gl {

namespace {
// A storage block without elements still needs a buffer that can be bound.
constexpr std::size_t kEmptyBufferSize = 16;
}  // namespace

Buffer::Buffer(std::size_t size, const void* data, const char* label) : m_size(size == 0 ? kEmptyBufferSize : size) {
    glCreateBuffers(1, &m_id);
    glNamedBufferStorage(m_id, GLsizeiptr(m_size), size == 0 ? nullptr : data, GL_DYNAMIC_STORAGE_BIT);

    // A driver out of memory leaves the buffer without storage.
    GLint64 stored = 0;
    glGetNamedBufferParameteri64v(m_id, GL_BUFFER_SIZE, &stored);
    if (stored != GLint64(m_size)) {
        glDeleteBuffers(1, &m_id);
        throw Error(ErrorCode::Environment,
                    fmt::format("the driver refused a buffer of {} bytes ('{}')", m_size, label ? label : ""),
                    "Use a smaller scene or resolution, or a device with more memory.");
    }
    labelObject(GL_BUFFER, m_id, label);
    if (size == 0) clear();
}

Buffer::~Buffer() {
    if (m_id != 0) glDeleteBuffers(1, &m_id);
}

Buffer::Buffer(Buffer&& other) noexcept : m_id(std::exchange(other.m_id, 0)), m_size(std::exchange(other.m_size, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(m_id, other.m_id);
    std::swap(m_size, other.m_size);
    return *this;
}

void Buffer::upload(std::size_t offset, std::size_t size, const void* data) {
    assert(offset <= m_size && size <= m_size - offset);
    if (size != 0) glNamedBufferSubData(m_id, GLintptr(offset), GLsizeiptr(size), data);
}

void Buffer::download(std::size_t offset, std::size_t size, void* data) const {
    assert(offset <= m_size && size <= m_size - offset);
    if (size != 0) glGetNamedBufferSubData(m_id, GLintptr(offset), GLsizeiptr(size), data);
}

void Buffer::clear() {
    if (m_id != 0) glClearNamedBufferData(m_id, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

void Buffer::bindUniform(GLuint binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, m_id);
}

void Buffer::bindStorage(GLuint binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, m_id);
}

}  // namespace ombrage::gl
