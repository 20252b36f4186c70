// SPDX-License-Identifier: MIT
#include "report/crops.h"

#include <fmt/format.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "metrics/error_colors.h"
#include "report/html_text.h"

namespace ombrage {

namespace {

constexpr int kCropCount = 3;
constexpr double kLeastSpread = 0.5 / 255;

/// Sums of all values above and left of a pixel, so that a window's sum takes four of them.
std::vector<double> summedTable(const std::vector<double>& values, int width, int height) {
    std::vector<double> table(std::size_t(width + 1) * std::size_t(height + 1), 0.0);
    const std::size_t row = std::size_t(width) + 1;
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        for (std::size_t x = 0; x < std::size_t(width); ++x)
            table[(y + 1) * row + x + 1] = values[y * std::size_t(width) + x] + table[y * row + x + 1] +
                                           table[(y + 1) * row + x] - table[y * row + x];
    return table;
}

std::vector<double> deviations(const std::vector<Image>& images, const std::vector<bool>& measured) {
    std::vector<double> result(images.front().pixelCount(), 0.0);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!measured.empty() && !measured[i]) continue;
        double sum = 0, squares = 0;
        for (const Image& image : images) {
            const double v = double(image.plane(0)[i]);
            sum += v;
            squares += v * v;
        }
        const double n = double(images.size()), mean = sum / n;
        result[i] = std::sqrt(std::max(0.0, squares / n - mean * mean));
    }
    return result;
}

/// What is not measured is grey, as in the error maps: whatever stands there counts for nothing.
Image cut(const Image& source, const CropWindow& window, const std::vector<bool>& measured) {
    Image result(window.size, window.size, source.planeNames(), source.colorSpace());
    const bool known = measured.size() == source.pixelCount();
    for (int p = 0; p < source.planeCount(); ++p)
        for (int y = 0; y < window.size; ++y)
            for (int x = 0; x < window.size; ++x) {
                const int fromX = window.x + x, fromY = window.y + y;
                const bool counts =
                    !known || measured[std::size_t(fromY) * std::size_t(source.width()) + std::size_t(fromX)];
                result.at(p, x, y) = counts ? source.at(p, fromX, fromY) : kMaskedGrey;
            }
    return result;
}

/// Error maps paint what is not measured in a grey that their scale does not have. Empty where there is no error map.
std::vector<bool> measuredPixels(const Image& errorMap) {
    std::vector<bool> measured(errorMap.planeCount() < 3 ? 0 : errorMap.pixelCount());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        measured[i] = false;
        // One step of eight bits either way.
        for (int p = 0; p < 3; ++p)
            if (std::fabs(errorMap.plane(p)[i] - kMaskedGrey) > 1.5f / 255) measured[i] = true;
    }
    return measured;
}

/// Mean absolute difference over the measured pixels of a window; nothing where there are none.
std::optional<double> meanDifference(const Image& a, const Image& b, const std::vector<bool>& measured,
                                     const CropWindow& window) {
    double sum = 0;
    int count = 0;
    for (int y = window.y; y < window.y + window.size; ++y)
        for (int x = window.x; x < window.x + window.size; ++x) {
            if (!measured.empty() && !measured[std::size_t(y) * std::size_t(a.width()) + std::size_t(x)]) continue;
            sum += std::fabs(double(a.at(0, x, y) - b.at(0, x, y)));
            ++count;
        }
    return count == 0 ? std::nullopt : std::optional(sum / count);
}

/// Of the records with a picture of the group's size, the better half, at least two; or all of them.
std::vector<Image> answers(const PictureFiles& pictures, const RecordGroup& group, bool betterHalf) {
    std::vector<const RunRecord*> order;
    for (const RunRecord* r : group.records)
        if (metricOf(*r, "rmse")) order.push_back(r);
    std::stable_sort(order.begin(), order.end(), [](const RunRecord* a, const RunRecord* b) {
        return *metricOf(*a, "rmse") < *metricOf(*b, "rmse");
    });
    if (betterHalf) order.resize(std::min(order.size(), std::max<std::size_t>(2, (order.size() + 1) / 2)));
    std::vector<Image> images;
    for (const RunRecord* r : order) {
        Image image = pictures.decoded(*r, "visibility");
        if (!image.empty() &&
            (images.empty() || (image.width() == images[0].width() && image.height() == images[0].height())))
            images.push_back(std::move(image));
    }
    return images;
}

struct CropPicture {
    std::string html;
    std::size_t bytes = 0;
};

CropPicture cropFigure(const Image& image, const std::string& caption, const std::string& alt,
                       const std::string& data) {
    const std::string uri = pngUri(encodePng(image));
    return {"<figure" + data + "><img alt=\"" + escapeHtml(alt) + "\" src=\"" + uri + "\"><figcaption>" +
                escapeHtml(caption) + "</figcaption></figure>\n",
            uri.size()};
}

}  // namespace

std::vector<CropWindow> cropsWhereTheyDiffer(const std::vector<Image>& images, const std::vector<bool>& measured,
                                             int count) {
    if (images.size() < 2) return {};
    const int width = images[0].width(), height = images[0].height();
    assert(measured.empty() || measured.size() == images[0].pixelCount());
    // An eighth of the width, so that the eye sees pixels and still knows where it is.
    const int size = std::min({std::max(48, width / 8), width, height});
    const int step = std::max(1, size / 4);
    const std::vector<double> table = summedTable(deviations(images, measured), width, height);
    const auto at = [&](int x, int y) { return table[std::size_t(y) * std::size_t(width + 1) + std::size_t(x)]; };
    std::vector<CropWindow> windows;
    for (int y = 0; y + size <= height; y += step)
        for (int x = 0; x + size <= width; x += step) {
            const double sum = at(x + size, y + size) - at(x, y + size) - at(x + size, y) + at(x, y);
            windows.push_back({x, y, size, sum / (double(size) * size)});
        }
    std::stable_sort(windows.begin(), windows.end(),
                     [](const CropWindow& a, const CropWindow& b) { return a.spread > b.spread; });
    std::vector<CropWindow> chosen;
    for (const CropWindow& window : windows) {
        if (int(chosen.size()) == count || window.spread < kLeastSpread) break;
        const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const CropWindow& other) {
            return std::abs(other.x - window.x) >= size || std::abs(other.y - window.y) >= size;
        });
        if (apart) chosen.push_back(window);
    }
    return chosen;
}

std::string cropFigures(const PictureFiles& pictures, const RecordGroup& group, std::size_t& budget) {
    std::vector<Image> images = answers(pictures, group, true);
    if (images.empty()) return {};
    std::vector<bool> measured = measuredPixels(pictures.decoded(group.first(), "error"));
    if (measured.size() != images.front().pixelCount()) measured.clear();
    std::vector<CropWindow> windows = cropsWhereTheyDiffer(images, measured, kCropCount);
    const bool ofBetterHalf = !windows.empty();
    if (!ofBetterHalf) windows = cropsWhereTheyDiffer(answers(pictures, group, false), measured, kCropCount);
    if (windows.empty()) return {};
    const bool own = hasOwnTruth(group.first());
    std::vector<std::string> rows(windows.size());
    std::size_t bytes = 0;
    const auto add = [&](std::size_t row, CropPicture picture) {
        rows[row] += picture.html;
        bytes += picture.bytes;
    };
    for (std::size_t i = 0; i < group.records.size(); ++i) {
        const RunRecord& r = *group.records[i];
        const Image truth = pictures.decoded(r, "truth"), image = pictures.decoded(r, "visibility");
        for (std::size_t w = 0; w < windows.size(); ++w) {
            const auto fits = [&](const Image& picture) {
                return picture.width() >= windows[w].x + windows[w].size &&
                       picture.height() >= windows[w].y + windows[w].size;
            };
            if (i == 0 && !own && fits(truth))
                add(w, cropFigure(cut(truth, windows[w], measured), "truth", "Truth within the crop", ""));
            if (!fits(image)) continue;
            const Image crop = cut(image, windows[w], measured);
            std::string caption = r.pipeline;
            const bool sameSize = truth.width() == image.width() && truth.height() == image.height() &&
                                  (measured.empty() || measured.size() == image.pixelCount());
            if (sameSize) caption += ": " + shortNumber(meanDifference(image, truth, measured, windows[w]));
            add(w, cropFigure(crop, caption, "Visibility by " + caption,
                              fmt::format(" data-record=\"{}\"", group.indices[i])));
        }
    }
    if (bytes > budget) return {};
    budget -= bytes;
    std::string html =
        std::string("<details class=\"crops\" open><summary>Where the ") +
        (ofBetterHalf ? "better techniques" : "techniques") +
        " differ most</summary>\n"
        "<p class=\"about\">Visibility, pixel by pixel. The figure is the mean absolute difference from the truth over "
        "the crop's measured pixels.</p>\n";
    for (std::size_t w = 0; w < windows.size(); ++w)
        html += fmt::format(
                    "<div class=\"croprow\" data-x=\"{}\" data-y=\"{}\" data-size=\"{}\"><p>At {}, {}: {} x {} "
                    "pixels</p><div class=\"strip\">\n",
                    windows[w].x, windows[w].y, windows[w].size, windows[w].x, windows[w].y, windows[w].size,
                    windows[w].size) +
                rows[w] + "</div></div>\n";
    return html + "</details>\n";
}

}  // namespace ombrage
