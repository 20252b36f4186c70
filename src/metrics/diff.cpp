// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include <ombrage/error.h>
#include <ombrage/metrics.h>

#include "core/strings.h"
#include "metrics/image_metrics.h"

namespace ombrage {
namespace {

std::string sizeText(const Image& image) {
    return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

/// Difference of two values, or not a number where only one of them is a number.
double difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    return double(b) - double(a);
}

void check(const Image& a, const Image& b) {
    if (a.width() != b.width() || a.height() != b.height())
        throw Error(ErrorCode::Usage, "the images differ in size: " + sizeText(a) + " and " + sizeText(b));
    if (a.planeNames() != b.planeNames())
        throw Error(ErrorCode::Usage,
                    "the images differ in planes: " + join(a.planeNames(), ",") + " and " + join(b.planeNames(), ","));
    if (a.empty()) throw Error(ErrorCode::Usage, "empty images cannot be compared");
}

/// Root of the mean square over the planes, or the mean absolute difference, per pixel.
void differenceMap(const Image& a, const Image& b, bool square, DiffResult& result) {
    const std::span<float> map = result.map.plane(0);
    double sum = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        double pixel = 0;
        for (int p = 0; p < a.planeCount(); ++p) {
            const double d = difference(a.plane(p)[i], b.plane(p)[i]);
            if (!std::isfinite(d))
                throw Error(ErrorCode::Input, "only one image has a finite number in plane " +
                                                  a.planeNames()[std::size_t(p)] + " at pixel (" +
                                                  std::to_string(i % std::size_t(a.width())) + ", " +
                                                  std::to_string(i / std::size_t(a.width())) + ")");
            pixel += square ? d * d : std::abs(d);
        }
        pixel /= a.planeCount();
        sum += pixel;
        map[i] = float(square ? std::sqrt(pixel) : pixel);
    }
    result.value = square ? std::sqrt(sum / double(map.size())) : sum / double(map.size());
}

void ssimDifference(const Image& a, const Image& b, DiffResult& result) {
    const std::span<float> map = result.map.plane(0);
    double sum = 0;
    for (int p = 0; p < a.planeCount(); ++p) {
        sum += ssim(a.plane(p), b.plane(p), a.width(), a.height(), {}).value();
        const auto local = ssimMap(a.plane(p), b.plane(p), a.width(), a.height(), {});
        // The border without windows shows no error.
        for (std::size_t i = 0; i < map.size(); ++i)
            if (!std::isnan(local[i])) map[i] += (1 - local[i]) / float(a.planeCount());
    }
    result.value = sum / a.planeCount();
}

}  // namespace

DiffResult diffImages(const Image& first, const Image& second, const std::string& metric) {
    static const std::vector<std::string> names{"flip", "rmse", "mae", "psnr", "ssim"};
    if (std::find(names.begin(), names.end(), metric) == names.end()) throw unknownName("metric", metric, names);
    check(first, second);
    // Two encodings of light are compared in one.
    const bool mixed = first.colorSpace() != second.colorSpace() && first.colorSpace() != ColorSpace::Data &&
                       second.colorSpace() != ColorSpace::Data;
    const Image a = mixed ? toSrgb(first) : first, b = mixed ? toSrgb(second) : second;

    DiffResult result;
    result.metric = metric;
    result.map = Image::grey(a.width(), a.height(), metric);
    result.exact = true;
    for (int p = 0; p < a.planeCount() && result.exact; ++p)
        for (std::size_t i = 0; i < a.pixelCount() && result.exact; ++i)
            result.exact = difference(a.plane(p)[i], b.plane(p)[i]) == 0;

    if (metric == "flip") {
        result.map = flip(a, b);
        double sum = 0;
        for (float v : result.map.plane(0)) sum += double(v);
        result.value = sum / double(a.pixelCount());
    } else if (metric == "ssim") {
        ssimDifference(a, b, result);
    } else {
        differenceMap(a, b, metric != "mae", result);
        // Of equal images there is none.
        if (metric == "psnr")
            result.value = result.exact ? std::nullopt : std::optional<double>(psnrFromRmse(*result.value));
    }
    const std::span<const float> map = std::as_const(result.map).plane(0);
    result.p95 = percentile({map.begin(), map.end()}, 0.95);
    result.max = double(*std::max_element(map.begin(), map.end()));
    return result;
}

}  // namespace ombrage
