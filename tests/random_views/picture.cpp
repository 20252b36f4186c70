// SPDX-License-Identifier: MIT
#include "random_views/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ombrage::test {

namespace {

using Color = std::array<float, 3>;

constexpr Color kMissing{0.9f, 0.1f, 0.05f}, kTooMuch{0.1f, 0.35f, 1.0f}, kUnmeasured{0.2f, 0.23f, 0.3f};
constexpr int kZoom = 16;     // pixels of the close-up for one of the picture
constexpr int kFrame_px = 4;  // from a wrong pixel to the frame around it
constexpr float kGreys = 24;  // of the dimmed picture: few, so that files stay small

/// Draws into one quarter of the picture.
struct Panel {
    Image& image;
    int x0, y0, width, height;

    void set(int x, int y, const Color& color) {
        if (x < 0 || y < 0 || x >= width || y >= height) return;
        for (int c = 0; c < 3; ++c) image.at(c, x0 + x, y0 + y) = color[std::size_t(c)];
    }
};

/// Which pixels are wrong, and how.
class Errors {
public:
    Errors(std::span<const float> visibility, const ShadowTruth& truth) : m_visibility(visibility), m_truth(truth) {}

    bool wrong(std::size_t pixel) const { return m_truth.mask[pixel] == Mask::Valid && std::abs(error(pixel)) > 0.5f; }
    Color color(std::size_t pixel) const { return error(pixel) > 0 ? kMissing : kTooMuch; }

    /// The visibility as a grey.
    Color grey(std::span<const float> of, std::size_t pixel) const {
        if (m_truth.mask[pixel] != Mask::Valid) return kUnmeasured;
        return {of[pixel], of[pixel], of[pixel]};
    }

private:
    float error(std::size_t pixel) const { return m_visibility[pixel] - m_truth.visibility[pixel]; }

    std::span<const float> m_visibility;
    const ShadowTruth& m_truth;
};

/// The upper left corner of the window of this size with the most wrong pixels, moved to have them in its middle.
std::pair<int, int> worstWindow(const Errors& errors, int width, int height, int windowWidth, int windowHeight) {
    // Sums over the rectangles from the origin.
    std::vector<int> sums(std::size_t(width + 1) * std::size_t(height + 1));
    const auto sum = [&](int x, int y) -> int& {
        return sums[std::size_t(y) * std::size_t(width + 1) + std::size_t(x)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) +
                                (errors.wrong(std::size_t(y) * std::size_t(width) + std::size_t(x)) ? 1 : 0);
    int most = -1, left = 0, top = 0;
    for (int y = 0; y + windowHeight <= height; ++y)
        for (int x = 0; x + windowWidth <= width; ++x) {
            const int count =
                sum(x + windowWidth, y + windowHeight) - sum(x, y + windowHeight) - sum(x + windowWidth, y) + sum(x, y);
            if (count <= most) continue;
            most = count;
            left = x;
            top = y;
        }

    // Its wrong pixels into its middle.
    int sumX = 0, sumY = 0;
    for (int y = top; y < top + windowHeight; ++y)
        for (int x = left; x < left + windowWidth; ++x)
            if (errors.wrong(std::size_t(y) * std::size_t(width) + std::size_t(x))) {
                sumX += x;
                sumY += y;
            }
    if (most <= 0) return {left, top};
    return {std::clamp(sumX / most - windowWidth / 2, 0, width - windowWidth),
            std::clamp(sumY / most - windowHeight / 2, 0, height - windowHeight)};
}

}  // namespace

Image errorPicture(const Image& picture, std::span<const float> visibility, const ShadowTruth& truth) {
    const int width = truth.width, height = truth.height;
    const Errors errors(visibility, truth);
    const Image encoded = toSrgb(picture);
    Image result = Image::rgb(2 * width, 2 * height, ColorSpace::Srgb);
    Panel ours{result, 0, 0, width, height}, right{result, width, 0, width, height};
    Panel marked{result, 0, height, width, height}, close{result, width, height, width, height};

    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(width) + std::size_t(x);
            ours.set(x, y, errors.grey(visibility, pixel));
            right.set(x, y, errors.grey(truth.visibility, pixel));
            const float light = (encoded.plane(0)[pixel] + encoded.plane(1)[pixel] + encoded.plane(2)[pixel]) / 3.0f;
            const float grey = std::round(std::clamp(light, 0.0f, 1.0f) * kGreys) / kGreys * 0.6f;
            marked.set(x, y, {grey, grey, grey});
        }

    // Frames first, so that the pixels themselves stay to be seen.
    for (const bool frames : {true, false})
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t pixel = std::size_t(y) * std::size_t(width) + std::size_t(x);
                if (!errors.wrong(pixel)) continue;
                if (!frames) marked.set(x, y, errors.color(pixel));
                for (int d = -kFrame_px; frames && d <= kFrame_px; ++d)
                    for (const int side : {-kFrame_px, kFrame_px}) {
                        marked.set(x + d, y + side, errors.color(pixel));
                        marked.set(x + side, y + d, errors.color(pixel));
                    }
            }

    const auto [left, top] = worstWindow(errors, width, height, width / kZoom, height / kZoom);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(std::min(top + y / kZoom, height - 1)) * std::size_t(width) +
                                      std::size_t(std::min(left + x / kZoom, width - 1));
            close.set(x, y, errors.wrong(pixel) ? errors.color(pixel) : errors.grey(visibility, pixel));
        }
    return result;
}

}  // namespace ombrage::test
