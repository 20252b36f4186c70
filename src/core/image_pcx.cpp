// SPDX-License-Identifier: MIT
#include "core/image_pcx.h"

#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage {

namespace {
constexpr std::size_t kHeadBytes = 128;
constexpr std::size_t kPaletteBytes = 768;
constexpr int kMostPixels = 16384;  ///< along a side

/// Runs: a byte with its two upper bits set counts (lower six bits) the byte behind it; every other byte is itself.
class RunReader {
public:
    explicit RunReader(std::span<const unsigned char> bytes) : m_bytes(bytes) {}

    /// False at the end of the data.
    bool next(unsigned char& value) {
        while (m_left == 0) {
            if (m_position >= m_bytes.size()) return false;
            m_value = m_bytes[m_position++];
            m_left = 1;
            if (m_value < 0xc0) break;
            m_left = m_value & 0x3fu;
            if (m_position >= m_bytes.size()) return false;
            m_value = m_bytes[m_position++];
        }
        --m_left;
        value = m_value;
        return true;
    }

private:
    std::span<const unsigned char> m_bytes;
    std::size_t m_position = 0;
    unsigned m_left = 0;
    unsigned char m_value = 0;
};
}  // namespace

bool isPcx(std::span<const unsigned char> bytes) {
    return bytes.size() >= 3 && bytes[0] == 0x0a && bytes[1] == 5 && bytes[2] == 1;
}

Image decodePcx(std::span<const unsigned char> bytes, const std::string& name) {
    const auto refuse = [&](const std::string& message) {
        return Error(ErrorCode::Input, "cannot decode this PCX image: " + message, "", name);
    };
    if (!isPcx(bytes)) throw refuse("it does not begin as a run-length-coded PCX file of version 5");
    if (bytes.size() < kHeadBytes) throw refuse("it ends within its head");
    const auto word = [&](std::size_t at) { return int(bytes[at]) | int(bytes[at + 1]) << 8; };
    const int bits = bytes[3], planes = bytes[65], stride = word(66);
    const int width = word(8) - word(4) + 1, height = word(10) - word(6) + 1;
    if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
        throw refuse(fmt::format("a size of {} x {} pixels is not between 1 and {}", width, height, kMostPixels));
    if (bits != 8 || (planes != 1 && planes != 3))
        throw refuse(fmt::format("{} planes of {} bits are not read; 1 or 3 planes of 8 bits are", planes, bits));
    if (stride < width) throw refuse(fmt::format("lines of {} bytes do not hold {} pixels", stride, width));

    // The palette lies behind a byte of value 12 at the very end.
    std::span<const unsigned char> data = bytes.subspan(kHeadBytes), palette;
    if (planes == 1) {
        if (data.size() < kPaletteBytes + 1 || data[data.size() - kPaletteBytes - 1] != 12)
            throw refuse("its palette of 256 colours is missing");
        palette = data.last(kPaletteBytes);
        data = data.first(data.size() - kPaletteBytes - 1);
    }
    // A run of two bytes gives at most 63: what the data cannot fill is not made room for.
    if (std::size_t(height) * std::size_t(stride) * std::size_t(planes) > (data.size() / 2 + 1) * 63)
        throw refuse(fmt::format("it ends before its {} lines", height));

    Image image = Image::rgb(width, height, ColorSpace::Srgb);
    RunReader runs(data);
    for (int y = 0; y < height; ++y)
        for (int plane = 0; plane < planes; ++plane)
            for (int x = 0; x < stride; ++x) {
                unsigned char value = 0;
                if (!runs.next(value)) throw refuse(fmt::format("it ends in line {} of {}", y + 1, height));
                if (x >= width) continue;
                if (planes == 3) {
                    image.at(plane, x, y) = float(value) / 255.0f;
                } else {
                    for (int c = 0; c < 3; ++c)
                        image.at(c, x, y) = float(palette[std::size_t(value) * 3 + std::size_t(c)]) / 255.0f;
                }
            }
    return image;
}

}  // namespace ombrage
