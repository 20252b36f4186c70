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
#include "core/image_pcx.h"
#include "core/strings.h"
#include "core/trace.h"

namespace ombrage {

namespace {

std::vector<unsigned char> readBytes(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input || std::filesystem::is_directory(file))
        throw Error(ErrorCode::Input, "cannot open this image file", "check that it exists and may be read",
                    file.string());
    return std::vector<unsigned char>(std::istreambuf_iterator<char>(input), {});
}

/// Bytes for the decoder, which takes what lies beyond the end of a JPEG, TGA or BMP file for zeros (or for whatever is
/// in memory) and calls it a picture.
struct Reading {
    std::span<const unsigned char> bytes;
    std::size_t position = 0;
    bool pastEnd = false;

    static int read(void* user, char* data, int size) {
        auto& self = *static_cast<Reading*>(user);
        const std::size_t count = std::min(std::size_t(size), self.bytes.size() - self.position);
        std::copy_n(self.bytes.data() + self.position, count, data);
        std::fill(data + count, data + size, char(0));
        self.position += count;
        // The decoder's own buffer takes 128 bytes at a time, fewer at the end; other sizes are needed whole.
        constexpr int kBufferSize = 128;
        self.pastEnd = self.pastEnd || count == 0 || (size != kBufferSize && count < std::size_t(size));
        return int(count);
    }
    static void skip(void* user, int count) {
        auto& self = *static_cast<Reading*>(user);
        const auto target = std::int64_t(self.position) + count;
        self.position = std::size_t(std::clamp<std::int64_t>(target, 0, std::int64_t(self.bytes.size())));
    }
    static int atEnd(void* user) {
        const auto& self = *static_cast<const Reading*>(user);
        return self.position >= self.bytes.size();
    }
};

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
        throw Error(ErrorCode::Environment, "cannot write this file",
                    "check the folder's permissions and the free space", file.string());
}

}  // namespace

Image decodeImage(std::span<const unsigned char> bytes, const std::string& name) {
    if (isPcx(bytes)) return decodePcx(bytes, name);
    int width = 0, height = 0, channels = 0;
    Reading reading{bytes};
    const stbi_io_callbacks callbacks{&Reading::read, &Reading::skip, &Reading::atEnd};
    unsigned char* pixels = stbi_load_from_callbacks(&callbacks, &reading, &width, &height, &channels, 0);
    const char* reason = stbi_failure_reason();
    if (reading.pastEnd && pixels) {
        stbi_image_free(pixels);
        pixels = nullptr;
        reason = "the file ends early";
    }
    if (!pixels)
        throw Error(ErrorCode::Input, fmt::format("cannot decode this image: {}", reason ? reason : "unknown kind"),
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
    const TraceScope trace("encode PNG");
    const int channels = displayChannels(image);
    const std::vector<unsigned char> pixels = to8Bit(image, channels);
    std::vector<unsigned char> bytes;
    if (!stbi_write_png_to_func(&appendBytes, &bytes, image.width(), image.height(), channels, pixels.data(),
                                image.width() * channels))
        throw Error(ErrorCode::Environment, "not enough memory to encode a PNG file");
    return bytes;
}

void writeImage(const std::filesystem::path& file, const Image& image) {
    const TraceScope trace("write image", file.string());
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
        if (channels == 4)
            throw Error(ErrorCode::Usage, "JPEG holds no alpha plane", "write it as .png or .exr", file.string());
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
