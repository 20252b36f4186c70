// SPDX-License-Identifier: MIT
#include "core/image_exr.h"

#include <algorithm>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage {

namespace {

Imf::Slice sliceOf(std::span<float> plane, const Imath::Box2i& window) {
    const int width = window.max.x - window.min.x + 1;
    return Imf::Slice::Make(Imf::FLOAT, plane.data(), window, sizeof(float), sizeof(float) * std::size_t(width));
}

}  // namespace

Image readExr(const std::filesystem::path& file) {
    try {
        Imf::InputFile input(file.c_str());
        const Imath::Box2i window = input.header().dataWindow();
        const long long width = (long long)window.max.x - window.min.x + 1;
        const long long height = (long long)window.max.y - window.min.y + 1;
        if (width < 1 || height < 1 || width * height > (1ll << 28))
            throw Error(ErrorCode::Input, fmt::format("an EXR data window of {} x {} pixels", width, height),
                        "at most 2^28 pixels are read", file.string());

        // Channels come in alphabetical order; the usual three and alpha are put first.
        std::vector<std::string> names;
        const Imf::ChannelList& channels = input.header().channels();
        for (const char* usual : {"R", "G", "B", "A"})
            if (channels.findChannel(usual)) names.emplace_back(usual);
        for (auto channel = channels.begin(); channel != channels.end(); ++channel)
            if (std::find(names.begin(), names.end(), channel.name()) == names.end()) names.emplace_back(channel.name());
        const bool isColor = channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B");

        Image image(int(width), int(height), names, isColor ? ColorSpace::Linear : ColorSpace::Data);
        Imf::FrameBuffer frame;
        for (int p = 0; p < image.planeCount(); ++p)
            frame.insert(names[std::size_t(p)], sliceOf(image.plane(p), window));
        input.setFrameBuffer(frame);
        input.readPixels(window.min.y, window.max.y);
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        throw Error(ErrorCode::Input, fmt::format("cannot read this EXR file: {}", e.what()), "", file.string());
    }
}

void writeExr(const std::filesystem::path& file, const Image& image) {
    try {
        Imf::Header header(image.width(), image.height());
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer frame;
        Image copy = image;  // the library wants writable slices
        for (int p = 0; p < copy.planeCount(); ++p) {
            const std::string& name = copy.planeNames()[std::size_t(p)];
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            frame.insert(name, sliceOf(copy.plane(p), header.dataWindow()));
        }
        Imf::OutputFile output(file.c_str(), header);
        output.setFrameBuffer(frame);
        output.writePixels(image.height());
    } catch (const std::exception& e) {
        throw Error(ErrorCode::Environment, fmt::format("cannot write this EXR file: {}", e.what()), "", file.string());
    }
}

}  // namespace ombrage
