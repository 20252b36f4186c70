// SPDX-License-Identifier: MIT
#include "report/previews.h"

#include <ombrage/image.h>
#include <algorithm>
#include <iterator>

namespace ombrage {

namespace {

constexpr int kWidths[] = {640, 480, 320, 240, 160};

/// What is dropped first when pictures do not fit at the smallest width.
const std::vector<std::string> kDispensable = {"flicker", "classes",    "reference", "picture",
                                               "error",   "visibility", "truth"};

int heightFor(const Image& source, int width) {
    return std::max(1, int((long(source.height()) * width + source.width() / 2) / source.width()));
}

/// Mean over the source pixels that a smaller pixel covers, edges weighted by their share.
Image shrink(const Image& source, int width) {
    const int height = heightFor(source, width);
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

/// The nearest pixel: the mean of two classes' colours could be that of a third.
Image pick(const Image& source, int width) {
    const int height = heightFor(source, width);
    Image result(width, height, source.planeNames(), source.colorSpace());
    for (int p = 0; p < source.planeCount(); ++p)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                result.at(p, x, y) =
                    source.at(p, int((x + 0.5) * source.width() / width), int((y + 0.5) * source.height() / height));
    return result;
}

std::vector<unsigned char> previewPng(const PictureFiles::File& file, const std::string& name, int width,
                                      bool& shrunk) {
    Image image = decodeImage(file.png, name);
    if (image.width() <= width) return file.png;
    shrunk = true;
    // Light is averaged as light; visibility and errors are numbers as they stand.
    if (file.kind == "picture" || file.kind == "reference") return encodePng(shrink(toLinear(std::move(image)), width));
    image.setColorSpace(ColorSpace::Data);
    return encodePng(file.kind == "classes" ? pick(image, width) : shrink(image, width));
}

}  // namespace

Previews makePreviews(const PictureFiles& pictures, std::size_t budget) {
    Previews result;
    const auto fits = [&](int width) {
        result.width_px = width;
        result.shrunk = false;
        result.uris.clear();
        std::size_t size = 0;
        for (const auto& [path, file] : pictures.files()) {
            if (std::find(result.leftOut.begin(), result.leftOut.end(), file.kind) != result.leftOut.end()) continue;
            std::string uri = pngUri(previewPng(file, path, width, result.shrunk));
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

Previews fullPreviews(const PictureFiles& pictures) {
    Previews result;
    for (const auto& [path, file] : pictures.files()) result.uris.emplace(path, pngUri(file.png));
    return result;
}

}  // namespace ombrage
