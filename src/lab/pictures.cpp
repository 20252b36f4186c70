// SPDX-License-Identifier: MIT
#include "lab/pictures.h"

#include <algorithm>
#include <cmath>

#include "metrics/error_colors.h"

namespace ombrage {

namespace {

void setPixel(Image& image, std::size_t pixel, const float rgb[3]) {
    for (int c = 0; c < 3; ++c) image.plane(c)[pixel] = rgb[c];
}

constexpr float kMasked[3] = {kMaskedGrey, kMaskedGrey, kMaskedGrey};

}  // namespace

Image errorPicture(std::span<const float> measured, std::span<const float> truth, const std::vector<Mask>& mask,
                   int width, int height) {
    Image image = Image::rgb(width, height, ColorSpace::Srgb);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        float rgb[3];
        const float error = measured[i] - truth[i];
        // Not a number is as wrong as can be.
        errorColor(errorScalePosition(std::isfinite(error) ? error : 1.0f), rgb);
        setPixel(image, i, mask[i] == Mask::Valid ? rgb : kMasked);
    }
    return image;
}

Image classPicture(const std::vector<ErrorClass>& classes, std::span<const float> truth, const std::vector<Mask>& mask,
                   int width, int height) {
    Image image = Image::rgb(width, height, ColorSpace::Srgb);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        const bool isRight = classes[i] == ErrorClass::None;
        const float* rgb = isRight && truth[i] > 0.5f ? kRightAndLit : kErrorClassColors[std::size_t(classes[i])];
        setPixel(image, i, mask[i] == Mask::Valid ? rgb : kMasked);
    }
    return image;
}

Image greyPicture(std::span<const float> values, int width, int height) {
    Image image = Image::grey(width, height);
    std::copy(values.begin(), values.end(), image.plane(0).begin());
    return image;
}

Image displayed(const Image& linear) {
    Image image = toSrgb(linear);
    for (int p = 0; p < image.planeCount(); ++p)
        for (float& v : image.plane(p)) v = std::isfinite(v) ? std::clamp(v, 0.0f, 1.0f) : 0.0f;
    return image;
}

Image averagedOverPixels(const Image& fine, int grid) {
    Image image = Image::rgb(fine.width() / grid, fine.height() / grid);
    const float share = 1.0f / float(grid * grid);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < fine.height(); ++y)
            for (int x = 0; x < fine.width(); ++x)
                image.plane(c)[std::size_t(y / grid) * std::size_t(image.width()) + std::size_t(x / grid)] +=
                    share * fine.plane(c)[std::size_t(y) * std::size_t(fine.width()) + std::size_t(x)];
    return image;
}

void spreadOverPixels(std::span<const float> values, int width, int part, int grid, Image& fine) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int x = int(i % std::size_t(width)) * grid + part % grid,
                  y = int(i / std::size_t(width)) * grid + part / grid;
        fine.plane(0)[std::size_t(y) * std::size_t(fine.width()) + std::size_t(x)] = values[i];
    }
}

double meanOf(const Image& image) {
    double sum = 0;
    for (float v : image.plane(0)) sum += double(v);
    return image.empty() ? 0.0 : sum / double(image.pixelCount());
}

std::string fileSlug(const std::string& text) {
    std::string slug;
    for (char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        const bool capital = c >= 'A' && c <= 'Z';
        if (plain || capital)
            slug += capital ? char(c - 'A' + 'a') : c;
        else if (!slug.empty() && slug.back() != '-')
            slug += '-';
    }
    while (!slug.empty() && slug.back() == '-') slug.pop_back();
    return slug.empty() ? "unnamed" : slug;
}

}  // namespace ombrage
