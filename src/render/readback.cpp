// SPDX-License-Identifier: MIT
#include "render/readback.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ombrage {

namespace {

// GL's first row is the bottom one.
template <typename T>
void flipRows(std::vector<T>& values, int width, int height, int channels) {
    const std::ptrdiff_t row = std::ptrdiff_t(width) * channels;
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(values.begin() + y * row, values.begin() + (y + 1) * row, values.begin() + (height - 1 - y) * row);
}

Image planar(const std::vector<float>& interleaved, int width, int height, int stride, const std::vector<std::string>& planes,
             ColorSpace space) {
    Image image(width, height, planes, space);
    for (int c = 0; c < image.planeCount(); ++c) {
        auto plane = image.plane(c);
        for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = interleaved[i * std::size_t(stride) + std::size_t(c)];
    }
    return image;
}

bool isIntegerFormat(GLenum format) {
    switch (format) {
        case GL_R8UI: case GL_R16UI: case GL_R32UI: case GL_RG8UI: case GL_RG16UI: case GL_RG32UI: case GL_RGBA32UI:
        case GL_R8I: case GL_R16I: case GL_R32I:
            return true;
        default: return false;
    }
}

}  // namespace

Image readColor(const gl::Texture& texture, const std::vector<std::string>& planes, ColorSpace space, int layer) {
    const int width = texture.width(), height = texture.height();
    std::vector<float> values(std::size_t(width) * std::size_t(height) * 4);
    texture.download(0, layer, GL_RGBA, GL_FLOAT, values.size() * sizeof(float), values.data());
    flipRows(values, width, height, 4);
    return planar(values, width, height, 4, planes, space);
}

Image readDepth(const gl::Texture& texture, int layer) {
    const int width = texture.width(), height = texture.height();
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    texture.download(0, layer, GL_DEPTH_COMPONENT, GL_FLOAT, values.size() * sizeof(float), values.data());
    flipRows(values, width, height, 1);
    return planar(values, width, height, 1, {"depth"}, ColorSpace::Data);
}

Image readStencil(const gl::Texture& texture) {
    const int width = texture.width(), height = texture.height();
    std::vector<std::uint8_t> bytes(std::size_t(width) * std::size_t(height));
    texture.download(0, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.size(), bytes.data());
    flipRows(bytes, width, height, 1);
    return planar(std::vector<float>(bytes.begin(), bytes.end()), width, height, 1, {"count"}, ColorSpace::Data);
}

std::vector<std::uint32_t> readWords(const gl::Texture& texture) {
    const int width = texture.width(), height = texture.height();
    const int channels = texture.desc().format == GL_RGBA32UI ? 4 : 1;
    std::vector<std::uint32_t> words(std::size_t(width) * std::size_t(height) * std::size_t(channels));
    texture.download(0, 0, channels == 4 ? GL_RGBA_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT, words.size() * 4, words.data());
    flipRows(words, width, height, channels);
    return words;
}

void uploadPlane(gl::Texture& texture, std::span<const float> plane) {
    std::vector<float> values(plane.begin(), plane.end());
    flipRows(values, texture.width(), texture.height(), 1);
    texture.upload(0, GL_RED, GL_FLOAT, values.data());
}

Image stretched(const Image& values, float leaveOut) {
    Image result = values;
    float lower = std::numeric_limits<float>::infinity(), upper = -lower;
    for (int p = 0; p < values.planeCount(); ++p)
        for (float v : values.plane(p))
            if (std::isfinite(v) && v != leaveOut) {
                lower = std::min(lower, v);
                upper = std::max(upper, v);
            }
    const float scale = upper > lower ? 1.0f / (upper - lower) : 0.0f;
    for (int p = 0; p < values.planeCount(); ++p)
        for (float& v : result.plane(p)) v = std::isfinite(v) && v != leaveOut ? (v - lower) * scale : 1.0f;
    return result;
}

ShownImage showTexture(const gl::Texture& texture, ShowAs how, int layer) {
    ShownImage shown;
    switch (how) {
        case ShowAs::Value:
            shown.raw = shown.display = readColor(texture, {"value"}, ColorSpace::Data, layer);
            break;
        case ShowAs::Color:
            shown.raw = shown.display = readColor(texture, {"R", "G", "B"}, ColorSpace::Linear, layer);
            break;
        case ShowAs::Depth01:
            shown.raw = readDepth(texture, layer);
            shown.display = stretched(shown.raw, 1.0f);
            break;
        case ShowAs::LightDepth:
            shown.raw = readDepth(texture, layer);
            shown.display = stretched(shown.raw, 0.0f);
            for (std::size_t i = 0; i < shown.raw.pixelCount(); ++i)
                if (shown.raw.plane(0)[i] == 0.0f) shown.display.plane(0)[i] = 0.0f;
            break;
        case ShowAs::Count: {
            if (isIntegerFormat(texture.desc().format)) {
                const int width = texture.width(), height = texture.height();
                std::vector<std::uint32_t> values(std::size_t(width) * std::size_t(height));
                texture.download(0, layer, GL_RED_INTEGER, GL_UNSIGNED_INT, values.size() * 4, values.data());
                flipRows(values, width, height, 1);
                shown.raw = planar(std::vector<float>(values.begin(), values.end()), width, height, 1, {"count"}, ColorSpace::Data);
            } else {
                shown.raw = readColor(texture, {"count"}, ColorSpace::Data, layer);
            }
            shown.display = stretched(shown.raw, -1.0f);
            break;
        }
        case ShowAs::Stencil: {
            // Wrapped counters: 255 is -1. Zero is black, each level a step brighter whatever its sign.
            shown.raw = readStencil(texture);
            for (float& v : shown.raw.plane(0))
                if (v > 127) v -= 256;
            shown.display = shown.raw;
            for (float& v : shown.display.plane(0)) v = 1.0f - std::exp2(-std::abs(v));
            break;
        }
    }
    return shown;
}

}  // namespace ombrage
