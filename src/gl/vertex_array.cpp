// SPDX-License-Identifier: MIT
#include <utility>

#include "gl/objects.h"

namespace ombrage::gl {

namespace {

// The types that a shader reads as int or uint; packed types and floats become float.
bool isIntegerType(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_INT:
        case GL_UNSIGNED_INT:
            return true;
        default:
            return false;
    }
}

}  // namespace

VertexArray::VertexArray(const std::vector<VertexBinding>& bindings, const std::vector<VertexAttribute>& attributes,
                         GLuint indexBuffer) {
    glCreateVertexArrays(1, &m_id);
    for (const VertexBinding& b : bindings) {
        glVertexArrayVertexBuffer(m_id, b.binding, b.buffer, b.offset, b.stride);
        glVertexArrayBindingDivisor(m_id, b.binding, b.divisor);
    }
    for (const VertexAttribute& a : attributes) {
        if (isIntegerType(a.type))
            glVertexArrayAttribIFormat(m_id, a.location, a.components, a.type, a.offset);
        else
            glVertexArrayAttribFormat(m_id, a.location, a.components, a.type, GL_FALSE, a.offset);
        glVertexArrayAttribBinding(m_id, a.location, a.binding);
        glEnableVertexArrayAttrib(m_id, a.location);
    }
    if (indexBuffer != 0) glVertexArrayElementBuffer(m_id, indexBuffer);
}

VertexArray::~VertexArray() {
    if (m_id != 0) glDeleteVertexArrays(1, &m_id);
}

VertexArray::VertexArray(VertexArray&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept {
    std::swap(m_id, other.m_id);
    return *this;
}

void VertexArray::bind() const {
    glBindVertexArray(m_id);
}

}  // namespace ombrage::gl
