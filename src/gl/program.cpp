// SPDX-License-Identifier: MIT
#include <cassert>
#include <cctype>
#include <utility>

#include "gl/shader_library.h"

namespace ombrage::gl {

namespace {

bool isIdentifierChar(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool holdsWord(const std::string& text, const std::string& word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isIdentifierChar(text[at - 1])) && (end == text.size() || !isIdentifierChar(text[end])))
            return true;
    }
    return false;
}

// Whether the first identifier of a uniform's name appears in any source of the program; its shaders stay attached for
// this question.
[[maybe_unused]] bool isDeclared(GLuint program, const std::string& name) {
    const std::string identifier = name.substr(0, name.find_first_of(".["));
    GLuint shaders[6];
    GLsizei count = 0;
    glGetAttachedShaders(program, 6, &count, shaders);
    for (GLsizei i = 0; i < count; ++i) {
        GLint length = 0;
        glGetShaderiv(shaders[i], GL_SHADER_SOURCE_LENGTH, &length);
        std::string source(std::size_t(length), '\0');
        if (length > 0) glGetShaderSource(shaders[i], length, nullptr, source.data());
        if (holdsWord(source, identifier)) return true;
    }
    return false;
}

}  // namespace

Program::~Program() {
    if (m_id != 0) glDeleteProgram(m_id);
}

Program::Program(Program&& other) noexcept
    : m_id(std::exchange(other.m_id, 0)), m_locations(std::move(other.m_locations)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(m_id, other.m_id);
    m_locations.swap(other.m_locations);
    return *this;
}

void Program::use() const {
    glUseProgram(m_id);
}

GLint Program::location(const char* name) const {
    const auto known = m_locations.find(name);
    if (known != m_locations.end()) return known->second;
    const GLint found = glGetUniformLocation(m_id, name);
    assert(found >= 0 || isDeclared(m_id, name));
    m_locations.emplace(name, found);
    return found;
}

void Program::set(const char* name, int value) const {
    glProgramUniform1i(m_id, location(name), value);
}

void Program::set(const char* name, unsigned value) const {
    glProgramUniform1ui(m_id, location(name), value);
}

void Program::set(const char* name, float value) const {
    glProgramUniform1f(m_id, location(name), value);
}

void Program::set(const char* name, const glm::vec2& value) const {
    glProgramUniform2fv(m_id, location(name), 1, &value[0]);
}

void Program::set(const char* name, const glm::vec3& value) const {
    glProgramUniform3fv(m_id, location(name), 1, &value[0]);
}

void Program::set(const char* name, const glm::vec4& value) const {
    set(name, &value, 1);
}

void Program::set(const char* name, const glm::ivec2& value) const {
    glProgramUniform2iv(m_id, location(name), 1, &value[0]);
}

void Program::set(const char* name, const glm::mat4& value) const {
    set(name, &value, 1);
}

void Program::set(const char* name, const glm::mat4* values, int count) const {
    glProgramUniformMatrix4fv(m_id, location(name), count, GL_FALSE, &(*values)[0][0]);
}

void Program::set(const char* name, const glm::vec4* values, int count) const {
    glProgramUniform4fv(m_id, location(name), count, &(*values)[0]);
}

void Program::set(const char* name, const glm::vec2* values, int count) const {
    glProgramUniform2fv(m_id, location(name), count, &(*values)[0]);
}

GLint Program::uniformOffset(const char* name) const {
    // A block with an instance name calls its members "Block.member"; one without calls them "member".
    const std::string full = name;
    const std::size_t dot = full.find('.');
    GLuint index = glGetProgramResourceIndex(m_id, GL_UNIFORM, name);
    const bool isPlain = index == GL_INVALID_INDEX && dot != std::string::npos;
    if (isPlain) index = glGetProgramResourceIndex(m_id, GL_UNIFORM, full.c_str() + dot + 1);
    if (index == GL_INVALID_INDEX) return -1;

    const GLenum wanted[] = {GL_OFFSET, GL_BLOCK_INDEX};
    GLint values[2] = {-1, -1};
    glGetProgramResourceiv(m_id, GL_UNIFORM, index, 2, wanted, 2, nullptr, values);
    if (isPlain) {
        const GLuint block = glGetProgramResourceIndex(m_id, GL_UNIFORM_BLOCK, full.substr(0, dot).c_str());
        if (block == GL_INVALID_INDEX || GLint(block) != values[1]) return -1;
    }
    return values[0];
}

}  // namespace ombrage::gl
