// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ombrage {

/// What the numbers of an Image mean.
enum class ColorSpace {
    Data,    ///< plain numbers (visibility, depth, ids); never converted
    Linear,  ///< linear Rec. 709 light
    Srgb     ///< sRGB-encoded values in [0,1]
};

/// A rectangle of named float planes. Row 0 is the top row, column 0 the left one; planes are stored one after the
/// other, each row by row. Copyable value type; an empty image is 0 x 0 without planes.
class Image {
public:
    Image() = default;

    /// Zero-filled planes. Names must be unique. @throws Error(Usage) for sizes below 0 or over 65536.
    Image(int width, int height, std::vector<std::string> planeNames, ColorSpace space = ColorSpace::Data);

    /// The usual three planes "R", "G", "B".
    static Image rgb(int width, int height, ColorSpace space = ColorSpace::Linear);

    /// One plane.
    static Image grey(int width, int height, std::string planeName = "Y", ColorSpace space = ColorSpace::Data);

    int width() const { return m_width; }
    int height() const { return m_height; }
    bool empty() const { return m_width == 0 || m_height == 0; }
    std::size_t pixelCount() const { return std::size_t(m_width) * std::size_t(m_height); }
    int planeCount() const { return int(m_names.size()); }
    const std::vector<std::string>& planeNames() const { return m_names; }
    ColorSpace colorSpace() const { return m_space; }
    void setColorSpace(ColorSpace space) { m_space = space; }

    /// Index of the plane, or -1.
    int findPlane(std::string_view name) const;

    /// All pixels of one plane, width*height floats. The index must be in range.
    std::span<float> plane(int index);
    std::span<const float> plane(int index) const;

    /// @throws Error(Usage) when there is no such plane.
    std::span<float> plane(std::string_view name);
    std::span<const float> plane(std::string_view name) const;

    float& at(int planeIndex, int x, int y) { return m_data[index(planeIndex, x, y)]; }
    float at(int planeIndex, int x, int y) const { return m_data[index(planeIndex, x, y)]; }

    bool operator==(const Image&) const = default;

private:
    std::size_t index(int planeIndex, int x, int y) const {
        return (std::size_t(planeIndex) * m_height + y) * m_width + x;
    }

    int m_width = 0;
    int m_height = 0;
    ColorSpace m_space = ColorSpace::Data;
    std::vector<std::string> m_names;
    std::vector<float> m_data;
};

/// sRGB transfer functions (IEC 61966-2-1), extended oddly to negative values and beyond 1.
float srgbFromLinear(float linear);
float linearFromSrgb(float encoded);

/// The same picture with every plane but "A" converted; Data images come back unchanged.
Image toLinear(Image image);
Image toSrgb(Image image);

/// Reads PNG, JPEG, TGA, BMP, PCX (planes R,G,B or Y, and A; values in [0,1]; space Srgb) or EXR (its own planes; Linear,
/// or Data where it has no R, G and B). The kind is told from the content. @throws Error(Input) naming the file.
Image readImage(const std::filesystem::path& file);

/// Decodes a PNG, JPEG, TGA, BMP or PCX held in memory; `name` is used in errors only.
Image decodeImage(std::span<const unsigned char> bytes, const std::string& name);

/// Writes by extension: .png, .jpg (8 bits, Linear images are sRGB-encoded, Data written as it is, values outside
/// [0,1] saturate as a display would) or .exr (32-bit float, all planes by name, never encoded).
/// PNG and JPEG take 1 plane (grey), 3 (RGB) or 4 (RGBA). Directories are created.
/// @throws Error(Usage) for an unknown extension, Error(Environment) when the file cannot be written.
void writeImage(const std::filesystem::path& file, const Image& image);

/// The bytes of a PNG file, with the same rules as writeImage.
std::vector<unsigned char> encodePng(const Image& image);

}  // namespace ombrage
