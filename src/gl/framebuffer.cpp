// SPDX-License-Identifier: MIT
#include <algorithm>
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

constexpr std::size_t kMaxColors = 8;

const char* statusName(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "an attachment cannot be drawn to";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has no attachment";
        case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
            return "a draw buffer has no attachment";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "attachments differ in samples";
        case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
            return "layered and single attachments are mixed";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        default:
            return "unknown status";
    }
}

GLenum depthPoint(GLenum format) {
    if (hasDepth(format) && hasStencil(format)) return GL_DEPTH_STENCIL_ATTACHMENT;
    return hasStencil(format) ? GL_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

void attach(GLuint framebuffer, GLenum point, const Attachment& attachment) {
    const bool hasLayers = attachment.texture->desc().kind != TextureKind::Tex2D &&
                           attachment.texture->desc().kind != TextureKind::Multisample2D;
    if (hasLayers && attachment.layer >= 0)
        glNamedFramebufferTextureLayer(framebuffer, point, attachment.texture->id(), attachment.level,
                                       attachment.layer);
    else
        glNamedFramebufferTexture(framebuffer, point, attachment.texture->id(), attachment.level);
}

}  // namespace

Framebuffer::Framebuffer(const std::vector<Attachment>& colors, const Attachment& depth, const char* label) {
    assert(colors.size() <= kMaxColors);
    glCreateFramebuffers(1, &m_id);

    // The first attachment gives the size that all must have.
    const auto checkSize = [this](const Attachment& a) {
        const int width = std::max(1, a.texture->width() >> a.level);
        const int height = std::max(1, a.texture->height() >> a.level);
        assert(m_width == 0 || (m_width == width && m_height == height));
        m_width = width;
        m_height = height;
        TextureDesc drawn = a.texture->desc();
        drawn.width = width;
        drawn.height = height;
        drawn.levels = 1;
        if (a.layer >= 0) drawn.layers = 1;
        m_images.emplace_back(a.texture->id(), byteSize(drawn));
    };

    GLenum drawBuffers[kMaxColors];
    for (std::size_t i = 0; i < colors.size(); ++i) {
        drawBuffers[i] = colors[i].texture != nullptr ? GLenum(GL_COLOR_ATTACHMENT0 + i) : GLenum(GL_NONE);
        if (colors[i].texture == nullptr) continue;
        checkSize(colors[i]);
        attach(m_id, drawBuffers[i], colors[i]);
    }
    if (depth.texture != nullptr) {
        checkSize(depth);
        attach(m_id, depthPoint(depth.texture->desc().format), depth);
        m_hasStencil = hasStencil(depth.texture->desc().format);
    }
    if (colors.empty()) {
        glNamedFramebufferDrawBuffer(m_id, GL_NONE);
        glNamedFramebufferReadBuffer(m_id, GL_NONE);
    } else {
        glNamedFramebufferDrawBuffers(m_id, GLsizei(colors.size()), drawBuffers);
        glNamedFramebufferReadBuffer(m_id, drawBuffers[0]);
    }
    labelObject(GL_FRAMEBUFFER, m_id, label);

    const GLenum status = glCheckNamedFramebufferStatus(m_id, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        glDeleteFramebuffers(1, &m_id);
        throw Error(ErrorCode::Environment,
                    fmt::format("the driver refused the framebuffer '{}' of {}x{}: {}", label ? label : "", m_width,
                                m_height, statusName(status)),
                    "Report this together with the output of 'ombrage doctor'.");
    }
}

Framebuffer::~Framebuffer() {
    if (m_id != 0) glDeleteFramebuffers(1, &m_id);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : m_id(std::exchange(other.m_id, 0)),
      m_width(std::exchange(other.m_width, 0)),
      m_height(std::exchange(other.m_height, 0)),
      m_images(std::move(other.m_images)),
      m_hasStencil(std::exchange(other.m_hasStencil, false)) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
    std::swap(m_id, other.m_id);
    std::swap(m_width, other.m_width);
    std::swap(m_height, other.m_height);
    std::swap(m_images, other.m_images);
    std::swap(m_hasStencil, other.m_hasStencil);
    return *this;
}

void Framebuffer::bind() const {
    for (const auto& [texture, bytes] : m_images) noteImage(texture, bytes);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_id);
    glViewport(0, 0, m_width, m_height);
    glDisable(GL_SCISSOR_TEST);
}

void Framebuffer::clearColor(int attachment, const glm::vec4& value) const {
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearNamedFramebufferfv(m_id, GL_COLOR, attachment, &value[0]);
}

void Framebuffer::clearColorUint(int attachment, const glm::uvec4& value) const {
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearNamedFramebufferuiv(m_id, GL_COLOR, attachment, &value[0]);
}

void Framebuffer::clearDepth(float depth) const {
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(m_id, GL_DEPTH, 0, &depth);
}

void Framebuffer::clearStencil(int stencil) const {
    assert(m_hasStencil);
    glDisable(GL_SCISSOR_TEST);
    glStencilMask(0xff);
    glClearNamedFramebufferiv(m_id, GL_STENCIL, 0, &stencil);
}

std::vector<glm::vec2> Framebuffer::samplePositions() const {
    bind();
    GLint samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    if (samples == 0) return {glm::vec2(0.0f)};
    std::vector<glm::vec2> positions(std::size_t(samples), glm::vec2(0.0f));
    for (int i = 0; i < samples; ++i) {
        glGetMultisamplefv(GL_SAMPLE_POSITION, GLuint(i), &positions[std::size_t(i)][0]);
        positions[std::size_t(i)] -= 0.5f;
    }
    return positions;
}

}  // namespace ombrage::gl
