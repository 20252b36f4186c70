// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>

namespace ombrage {

Image::Image(int width, int height, std::vector<std::string> planeNames, ColorSpace space)
    : m_width(width), m_height(height), m_space(space), m_names(std::move(planeNames)) {
    constexpr int kLimit = 65536;
    if (width < 0 || height < 0 || width > kLimit || height > kLimit)
        throw Error(ErrorCode::Usage, fmt::format("an image of {} x {} pixels", width, height),
                    fmt::format("width and height lie between 0 and {}", kLimit));
    for (std::size_t i = 0; i < m_names.size(); ++i)
        if (std::count(m_names.begin(), m_names.end(), m_names[i]) > 1)
            throw Error(ErrorCode::Usage, fmt::format("two planes of an image are named '{}'", m_names[i]));
    m_data.resize(pixelCount() * m_names.size());
}

Image Image::rgb(int width, int height, ColorSpace space) { return Image(width, height, {"R", "G", "B"}, space); }

Image Image::grey(int width, int height, std::string planeName, ColorSpace space) {
    return Image(width, height, {std::move(planeName)}, space);
}

int Image::findPlane(std::string_view name) const {
    const auto found = std::find(m_names.begin(), m_names.end(), name);
    return found == m_names.end() ? -1 : int(found - m_names.begin());
}

std::span<float> Image::plane(int index) {
    return std::span<float>(m_data).subspan(std::size_t(index) * pixelCount(), pixelCount());
}

std::span<const float> Image::plane(int index) const {
    return std::span<const float>(m_data).subspan(std::size_t(index) * pixelCount(), pixelCount());
}

std::span<float> Image::plane(std::string_view name) {
    const int found = findPlane(name);
    if (found < 0) throw unknownName("image plane", name, m_names);
    return plane(found);
}

std::span<const float> Image::plane(std::string_view name) const {
    const int found = findPlane(name);
    if (found < 0) throw unknownName("image plane", name, m_names);
    return plane(found);
}

float srgbFromLinear(float linear) {
    const float magnitude = std::abs(linear);
    const float encoded =
        magnitude <= 0.0031308f ? 12.92f * magnitude : 1.055f * std::pow(magnitude, 1.0f / 2.4f) - 0.055f;
    return std::copysign(encoded, linear);
}

float linearFromSrgb(float encoded) {
    const float magnitude = std::abs(encoded);
    const float linear = magnitude <= 0.04045f ? magnitude / 12.92f : std::pow((magnitude + 0.055f) / 1.055f, 2.4f);
    return std::copysign(linear, encoded);
}

namespace {

Image converted(Image image, ColorSpace from, ColorSpace to, float (*transfer)(float)) {
    if (image.colorSpace() != from) return image;
    for (int p = 0; p < image.planeCount(); ++p)
        if (image.planeNames()[std::size_t(p)] != "A")
            for (float& value : image.plane(p)) value = transfer(value);
    image.setColorSpace(to);
    return image;
}

}  // namespace

Image toLinear(Image image) {
    return converted(std::move(image), ColorSpace::Srgb, ColorSpace::Linear, &linearFromSrgb);
}

Image toSrgb(Image image) {
    return converted(std::move(image), ColorSpace::Linear, ColorSpace::Srgb, &srgbFromLinear);
}

}  // namespace ombrage
