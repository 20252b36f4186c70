// SPDX-License-Identifier: MIT
#include "report/previews.h"

#include <ombrage/error.h>
#include <ombrage/image.h>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "report/html_text.h"

namespace ombrage {

namespace {

constexpr int kWidths[] = {640, 480, 320, 240, 160};

/// What is dropped first when pictures do not fit at the smallest width.
const std::vector<std::string> kDispensable = {"flicker", "classes",    "reference", "picture",
                                               "error",   "visibility", "truth"};

/// Mean over the source pixels that a smaller pixel covers, edges weighted by their share.
Image shrink(const Image& source, int width) {
    const int height = std::max(1, int((long(source.height()) * width + source.width() / 2) / source.width()));
    Image result(width, height, source.planeNames(), source.colorSpace());
    const double stepX = double(source.width()) / width, stepY = double(source.height()) / height;
    const auto overlap = [](int cell, double from, double to) {
        return std::min(cell + 1.0, to) - std::max(double(cell), from);
    };
    for (int p = 0; p < source.planeCount(); ++p)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double x0 = x * stepX, x1 = std::min(x0 + stepX, double(source.width()));
                const double y0 = y * stepY, y1 = std::min(y0 + stepY, double(source.height()));
                double sum = 0, weight = 0;
                for (int j = int(y0); j < y1; ++j)
                    for (int i = int(x0); i < x1; ++i) {
                        const double w = overlap(i, x0, x1) * overlap(j, y0, y1);
                        sum += w * double(source.at(p, i, j));
                        weight += w;
                    }
                result.at(p, x, y) = float(sum / weight);
            }
    return result;
}

std::vector<unsigned char> readBytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A picture of the folder, kept encoded and decoded.
struct Source {
    std::string kind;
    std::vector<unsigned char> png;
    Image image;
};

std::vector<unsigned char> previewPng(const Source& source, int width) {
    if (source.image.width() <= width) return source.png;
    // Light is averaged as light; visibility, error and class colours are numbers as they stand.
    const bool light = source.kind == "picture" || source.kind == "reference";
    Image image = source.image;
    if (!light) image.setColorSpace(ColorSpace::Data);
    return encodePng(shrink(light ? toLinear(std::move(image)) : image, width));
}

/// Record paths stay inside the folder; anything else is treated as missing.
bool isInside(const std::filesystem::path& path) {
    return path.is_relative() && std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace

Previews makePreviews(const std::filesystem::path& folder, const std::vector<RunRecord>& records, std::size_t budget) {
    Previews result;
    std::map<std::string, Source> sources;
    for (const RunRecord& record : records)
        for (const auto& [kind, path] : record.images) {
            if (sources.count(path) != 0) continue;
            Source source{kind, {}, {}};
            try {
                if (isInside(path)) source.png = readBytes(folder / path);
                if (!source.png.empty()) source.image = decodeImage(source.png, path);
            } catch (const Error&) {
                source.png.clear();
            }
            if (source.png.empty()) {
                if (std::find(result.missing.begin(), result.missing.end(), path) == result.missing.end())
                    result.missing.push_back(path);
                continue;
            }
            sources.emplace(path, std::move(source));
        }

    const auto fits = [&](int width) {
        result.width_px = width;
        result.uris.clear();
        std::size_t size = 0;
        for (const auto& [path, source] : sources) {
            if (std::find(result.leftOut.begin(), result.leftOut.end(), source.kind) != result.leftOut.end()) continue;
            std::string uri = "data:image/png;base64," + base64(previewPng(source, width));
            size += uri.size();
            result.uris.emplace(path, std::move(uri));
            if (size > budget) return false;
        }
        return true;
    };
    for (int width : kWidths)
        if (fits(width)) return result;
    // Smaller pictures would show nothing: leave out whole kinds instead.
    for (const std::string& kind : kDispensable) {
        result.leftOut.push_back(kind);
        if (fits(kWidths[std::size(kWidths) - 1])) break;
    }
    return result;
}

}  // namespace ombrage
