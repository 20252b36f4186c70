// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/image_exr.h"
#include "core/strings.h"

namespace ombrage {

namespace {

std::vector<unsigned char> readBytes(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input)
        throw Error(ErrorCode::Input, "cannot open this image file", "check that it exists and may be read",
                    file.string());
    return std::vector<unsigned char>(std::istreambuf_iterator<char>(input), {});
}

void appendBytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<unsigned char>*>(context);
    const auto* begin = static_cast<const unsigned char*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

/// Interleaved 8-bit pixels for a display. Values beyond [0,1] saturate, NaN becomes 0.
std::vector<unsigned char> to8Bit(const Image& image, int channels) {
    const Image encoded = toSrgb(image);
    std::vector<unsigned char> pixels(image.pixelCount() * std::size_t(channels));
    for (int c = 0; c < channels; ++c) {
        const auto plane = encoded.plane(c);
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const float value = plane[i] > 0.0f ? std::min(plane[i], 1.0f) : 0.0f;
            pixels[i * std::size_t(channels) + std::size_t(c)] = (unsigned char)std::lround(value * 255.0f);
        }
    }
    return pixels;
}

int displayChannels(const Image& image) {
    const int planes = image.planeCount();
    if (image.empty() || (planes != 1 && planes != 3 && planes != 4))
        throw Error(ErrorCode::Usage,
                    fmt::format("PNG and JPEG hold 1, 3 or 4 planes, this image has {} of {} x {} pixels", planes,
                                image.width(), image.height()),
                    "write it as .exr");
    return planes;
}

void writeBytes(const std::filesystem::path& file, const std::vector<unsigned char>& bytes) {
    std::ofstream output(file, std::ios::binary);
    output.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    output.close();
    if (!output)
        throw Error(ErrorCode::Environment, "cannot write this file", "check the folder's permissions and the free space",
                    file.string());
}

}  // namespace

Image decodeImage(std::span<const unsigned char> bytes, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    unsigned char* pixels =
        bytes.size() > std::size_t(1) << 30
            ? nullptr
            : stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 0);
    if (!pixels)
        throw Error(ErrorCode::Input,
                    fmt::format("cannot decode this image: {}", stbi_failure_reason() ? stbi_failure_reason() : "too big"),
                    "PNG, JPEG, TGA, BMP and EXR are read", name);
    const std::vector<std::vector<std::string>> kNames = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    Image image(width, height, kNames[std::size_t(channels - 1)], ColorSpace::Srgb);
    for (int c = 0; c < channels; ++c) {
        auto plane = image.plane(c);
        for (std::size_t i = 0; i < plane.size(); ++i)
            plane[i] = float(pixels[i * std::size_t(channels) + std::size_t(c)]) / 255.0f;
    }
    stbi_image_free(pixels);
    return image;
}

Image readImage(const std::filesystem::path& file) {
    const std::vector<unsigned char> bytes = readBytes(file);
    constexpr unsigned char kExrMagic[4] = {0x76, 0x2f, 0x31, 0x01};
    if (bytes.size() >= 4 && std::memcmp(bytes.data(), kExrMagic, 4) == 0) return readExr(file);
    return decodeImage(bytes, file.string());
}

std::vector<unsigned char> encodePng(const Image& image) {
    const int channels = displayChannels(image);
    const std::vector<unsigned char> pixels = to8Bit(image, channels);
    std::vector<unsigned char> bytes;
    if (!stbi_write_png_to_func(&appendBytes, &bytes, image.width(), image.height(), channels, pixels.data(),
                                image.width() * channels))
        throw Error(ErrorCode::Environment, "not enough memory to encode a PNG file");
    return bytes;
}

void writeImage(const std::filesystem::path& file, const Image& image) {
    const std::string extension = toLower(file.extension().string());
    if (file.has_parent_path()) {
        std::error_code failure;
        std::filesystem::create_directories(file.parent_path(), failure);
        if (failure)
            throw Error(ErrorCode::Environment, fmt::format("cannot create this folder: {}", failure.message()), "",
                        file.parent_path().string());
    }
    if (extension == ".exr") {
        writeExr(file, image);
    } else if (extension == ".png") {
        writeBytes(file, encodePng(image));
    } else if (extension == ".jpg" || extension == ".jpeg") {
        // JPEG has no alpha: planes beyond the third are refused rather than lost.
        const int channels = displayChannels(image);
        if (channels == 4) throw Error(ErrorCode::Usage, "JPEG holds no alpha plane", "write it as .png or .exr", file.string());
        const std::vector<unsigned char> pixels = to8Bit(image, channels);
        std::vector<unsigned char> bytes;
        constexpr int kQuality = 92;
        stbi_write_jpg_to_func(&appendBytes, &bytes, image.width(), image.height(), channels, pixels.data(), kQuality);
        writeBytes(file, bytes);
    } else {
        throw Error(ErrorCode::Usage, fmt::format("unknown image extension '{}'", extension), "use .png, .jpg or .exr",
                    file.string());
    }
}

}  // namespace ombrage
