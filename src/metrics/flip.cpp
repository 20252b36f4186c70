// SPDX-License-Identifier: MIT
// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild 2020, "FLIP: A difference evaluator for
// alternating images", Proc. ACM Comput. Graph. Interact. Tech. 3(2). Section and equation numbers below are those of
// the paper.
#include <algorithm>
#include <array>
#include <cmath>

#include <ombrage/error.h>
#include <ombrage/metrics.h>
#include <tbb/parallel_for.h>
#include <glm/glm.hpp>

#include "metrics/convolution.h"

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Constants of sections 4.1 and 4.2.
constexpr float kColorExponent = 0.7f;       // q_c
constexpr float kColorCutoff = 0.4f;         // p_c
constexpr float kColorTarget = 0.95f;        // p_t
constexpr double kFeatureWidth_deg = 0.082;  // w
constexpr float kFeatureExponent = 0.5f;     // q_f

/// XYZ from linear sRGB (IEC 61966-2-1), columns first, with its white.
const glm::mat3& xyzFromRgb() {
    static const glm::mat3 m(0.41238656f, 0.21263682f, 0.01933062f, 0.35759149f, 0.71518298f, 0.11919716f, 0.18045049f,
                             0.07218020f, 0.95037259f);
    return m;
}
const glm::mat3& rgbFromXyz() {
    static const glm::mat3 m(glm::inverse(glm::dmat3(xyzFromRgb())));
    return m;
}
const glm::vec3& white() {
    static const glm::vec3 w = xyzFromRgb() * glm::vec3(1);
    return w;
}

/// The opponent space in which the eye's contrast sensitivity is applied.
glm::vec3 ycxczFromRgb(const glm::vec3& rgb) {
    const glm::vec3 t = xyzFromRgb() * rgb / white();
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}
glm::vec3 rgbFromYcxcz(const glm::vec3& c) {
    const float y = (c.x + 16) / 116;
    return rgbFromXyz() * (glm::vec3(y + c.y / 500, y, y - c.z / 200) * white());
}

/// CIELAB with the Hunt effect: chroma counts less in the dark (equation 6).
glm::vec3 huntLab(const glm::vec3& rgb) {
    const auto f = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29.0f;
    };
    const glm::vec3 t = xyzFromRgb() * rgb / white();
    const float fx = f(t.x), fy = f(t.y), fz = f(t.z);
    const float lightness = 116 * fy - 16;
    return {lightness, 0.01f * lightness * 500 * (fx - fy), 0.01f * lightness * 200 * (fy - fz)};
}

/// HyAB distance (equation 7).
float hyab(const glm::vec3& a, const glm::vec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// A sum of two isotropic Gaussians: a Fourier pair of the contrast sensitivity of one channel (table 1).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kLuminance{1, 0.0047, 0, 1e-5}, kRedGreen{1, 0.0053, 0, 1e-5},
    kBlueYellow{34.1, 0.04, 13.5, 0.025};

/// The channel as the eye resolves it (section 4.1.1). Each Gaussian of the sum is separable.
Plane blurred(const Plane& plane, const Sensitivity& s, double pixelsPerDegree) {
    const int radius = int(std::ceil(3 * std::sqrt(kBlueYellow.b1 / (2 * kPi * kPi)) * pixelsPerDegree));
    const auto kernel = [&](double b, double& sum) {
        std::vector<double> k;
        sum = 0;
        for (int i = -radius; i <= radius; ++i) {
            const double degrees = i / pixelsPerDegree;
            k.push_back(std::exp(-kPi * kPi * degrees * degrees / b));
            sum += k.back();
        }
        return k;
    };
    // Normalised so that the whole two-dimensional filter sums to 1.
    double sum1 = 0, sum2 = 0;
    const auto k1 = kernel(s.b1, sum1), k2 = kernel(s.b2, sum2);
    const double w1 = s.a1 * std::sqrt(kPi / s.b1), w2 = s.a2 * std::sqrt(kPi / s.b2);
    const double total = w1 * sum1 * sum1 + w2 * sum2 * sum2;
    Plane out(plane.width, plane.height);
    const auto add = [&](const std::vector<double>& k, double weight) {
        Kernel rows, columns;
        for (double v : k) {
            rows.push_back(float(v));
            columns.push_back(float(v * weight / total));
        }
        const Plane part = filterColumns(filterRows(plane, rows), columns);
        for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] += part.values[i];
    };
    add(k1, w1);
    if (w2 > 0) add(k2, w2);
    return out;
}

/// Strength of edges and points (section 4.2.1).
struct Features {
    Plane edges, points;
};

Features features(const Plane& luminance, double pixelsPerDegree) {
    const double sigma = 0.5 * kFeatureWidth_deg * pixelsPerDegree;
    const int radius = int(std::ceil(3 * sigma));
    Kernel smooth, edge, point;
    double smoothSum = 0, edgeSum = 0, pointPositive = 0, pointNegative = 0;
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-i * i / (2 * sigma * sigma));
        const double second = (i * i / (sigma * sigma) - 1) * g;
        smooth.push_back(float(g));
        edge.push_back(float(-i * g));
        point.push_back(float(second));
        smoothSum += g;
        edgeSum += i > 0 ? i * g : 0;
        (second > 0 ? pointPositive : pointNegative) += std::abs(second);
    }
    // Positive weights sum to 1 and negative ones to -1.
    for (float& w : smooth) w = float(double(w) / smoothSum);
    for (float& w : edge) w = float(double(w) / edgeSum);
    for (float& w : point) w = float(double(w) / (w > 0 ? pointPositive : pointNegative));

    const auto length = [](Plane x, const Plane& y) {
        for (std::size_t i = 0; i < x.values.size(); ++i) x.values[i] = std::hypot(x.values[i], y.values[i]);
        return x;
    };
    const Plane smoothRows = filterRows(luminance, smooth);
    return {length(filterColumns(filterRows(luminance, edge), smooth), filterColumns(smoothRows, edge)),
            length(filterColumns(filterRows(luminance, point), smooth), filterColumns(smoothRows, point))};
}

/// What the two pipelines need of one picture.
struct Seen {
    std::vector<glm::vec3> lab;  ///< after the eye's blur
    Features features;
};

Seen see(const Image& image, double pixelsPerDegree) {
    const Image linear = toLinear(image);
    const int w = image.width(), h = image.height();
    // Red, green and blue, or one grey plane for all of them.
    std::array<std::span<const float>, 3> rgb;
    for (int c = 0; c < 3; ++c) {
        const int named = linear.findPlane(std::string(1, "RGB"[c]));
        rgb[std::size_t(c)] = linear.plane(named >= 0 ? named : 0);
    }
    std::array<Plane, 3> channels{Plane(w, h), Plane(w, h), Plane(w, h)};
    Plane luminance(w, h);
    tbb::parallel_for(std::size_t(0), image.pixelCount(), [&](std::size_t i) {
        const glm::vec3 c = ycxczFromRgb(glm::clamp(glm::vec3(rgb[0][i], rgb[1][i], rgb[2][i]), 0.0f, 1.0f));
        for (int k = 0; k < 3; ++k) channels[std::size_t(k)].values[i] = c[k];
        luminance.values[i] = (c.x + 16) / 116;
    });
    Seen seen;
    seen.features = features(luminance, pixelsPerDegree);
    const Plane y = blurred(channels[0], kLuminance, pixelsPerDegree),
                cx = blurred(channels[1], kRedGreen, pixelsPerDegree),
                cz = blurred(channels[2], kBlueYellow, pixelsPerDegree);
    seen.lab.resize(image.pixelCount());
    tbb::parallel_for(std::size_t(0), image.pixelCount(), [&](std::size_t i) {
        const glm::vec3 c = rgbFromYcxcz({y.values[i], cx.values[i], cz.values[i]});
        seen.lab[i] = huntLab(glm::clamp(c, 0.0f, 1.0f));
    });
    return seen;
}

}  // namespace

Image flip(const Image& reference, const Image& test, double pixelsPerDegree) {
    if (reference.width() != test.width() || reference.height() != test.height())
        throw Error(ErrorCode::Usage, "images of different sizes have no FLIP error", "Render both at one size.");
    if (!(pixelsPerDegree > 0) || !std::isfinite(pixelsPerDegree))
        throw Error(ErrorCode::Usage, "pixels per degree must be above 0");
    Image map = Image::grey(reference.width(), reference.height(), "flip");
    if (map.empty()) return map;
    const Seen a = see(reference, pixelsPerDegree), b = see(test, pixelsPerDegree);

    // The largest colour difference is that of green and blue (section 4.1.3).
    const float largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kColorExponent);
    const float cutoff = kColorCutoff * largest;
    const std::span<float> out = map.plane(0);
    tbb::parallel_for(std::size_t(0), map.pixelCount(), [&](std::size_t i) {
        // Colour difference, small ones spread over most of the range (equation 9).
        const float distance = std::pow(hyab(a.lab[i], b.lab[i]), kColorExponent);
        const float color = distance < cutoff
                                ? kColorTarget / cutoff * distance
                                : kColorTarget + (distance - cutoff) / (largest - cutoff) * (1 - kColorTarget);
        // Feature difference (equation 12), and both together (equation 13).
        const float edges = std::abs(a.features.edges.values[i] - b.features.edges.values[i]);
        const float points = std::abs(a.features.points.values[i] - b.features.points.values[i]);
        const float feature = std::pow(std::max(edges, points) / std::sqrt(2.0f), kFeatureExponent);
        out[i] = std::clamp(std::pow(color, 1 - std::min(feature, 1.0f)), 0.0f, 1.0f);
    });
    return map;
}

}  // namespace ombrage
