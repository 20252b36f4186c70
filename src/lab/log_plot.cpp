// SPDX-License-Identifier: MIT
#include "lab/log_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ombrage {

namespace {

constexpr double kWidth = 560, kHeight = 360, kLeft = 62, kRight = 130, kTop = 34, kBottom = 46;
constexpr const char* kColors[] = {"#1b6ca8", "#d1495b", "#3a8f4d", "#8a5fb0", "#c98a1b"};

/// Logarithms of the ends of an axis, and where a value stands on the paper.
struct Axis {
    double lower, upper, from, to;
    double at(double value) const { return from + (std::log10(value) - lower) / (upper - lower) * (to - from); }
};

Axis axisOf(const std::vector<Curve>& curves, std::vector<double> Curve::*values, double from, double to) {
    double lower = INFINITY, upper = -INFINITY;
    for (const Curve& curve : curves)
        for (const double v : curve.*values) {
            lower = std::min(lower, std::log10(v));
            upper = std::max(upper, std::log10(v));
        }
    const double margin = std::max(0.04 * (upper - lower), 0.05);
    return {lower - margin, upper + margin, from, to};
}

std::string shortNumber(double value) {
    if (value >= 1e6) return fmt::format("{:g}M", value / 1e6);
    if (value >= 1e4) return fmt::format("{:g}k", value / 1e3);
    return fmt::format("{:g}", value);
}

/// Powers of ten, with 2 and 5 between them where there is room.
std::vector<double> ticksOf(const Axis& axis) {
    std::vector<double> ticks;
    const bool dense = axis.upper - axis.lower < 2.2;
    for (int power = int(std::floor(axis.lower)); power <= int(std::ceil(axis.upper)); ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, power), place = std::log10(value);
            if (place >= axis.lower && place <= axis.upper && (dense || digit == 1.0)) ticks.push_back(value);
        }
    return ticks;
}

}  // namespace

double fittedExponent(const std::vector<double>& x, const std::vector<double>& y) {
    double meanX = 0, meanY = 0, covariance = 0, variance = 0;
    const double n = double(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += std::log(x[i]) / n;
        meanY += std::log(y[i]) / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        covariance += (std::log(x[i]) - meanX) * (std::log(y[i]) - meanY);
        variance += (std::log(x[i]) - meanX) * (std::log(x[i]) - meanX);
    }
    return covariance / variance;
}

std::string logPlot(const std::string& title, const std::string& xLabel, const std::string& yLabel,
                    const std::vector<Curve>& curves) {
    const Axis h = axisOf(curves, &Curve::x, kLeft, kWidth - kRight);
    const Axis v = axisOf(curves, &Curve::y, kHeight - kBottom, kTop);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
        "<text x=\"{2}\" y=\"20\" font-size=\"13\">{3}</text>\n",
        kWidth, kHeight, kLeft, title);
    for (const double tick : ticksOf(h))
        svg += fmt::format(
            "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">"
            "{4}</text>\n",
            h.at(tick), kTop, kHeight - kBottom, kHeight - kBottom + 15, shortNumber(tick));
    for (const double tick : ticksOf(v))
        svg += fmt::format(
            "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}"
            "</text>\n",
            v.at(tick), kLeft, kWidth - kRight, kLeft - 5, v.at(tick) + 4, shortNumber(tick));
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (kLeft + kWidth - kRight) / 2,
                       kHeight - 10, xLabel);
    svg += fmt::format("<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       (kTop + kHeight - kBottom) / 2, yLabel);

    // What is linear has this slope, drawn down to where it leaves the paper.
    const double lastX = curves.front().x.back(), lastY = curves.front().y.back();
    const double firstX = std::pow(10.0, std::max(h.lower, std::log10(lastX) - std::log10(lastY) + v.lower));
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#888\" stroke-dasharray=\"4 3\"/>\n",
                       h.at(firstX), v.at(lastY * firstX / lastX), h.at(lastX), v.at(lastY));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        const char* const color = kColors[i % std::size(kColors)];
        std::string path, dots;
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            const double x = h.at(curve.x[k]), y = v.at(curve.y[k]);
            path += fmt::format("{}{:.1f} {:.1f}", k == 0 ? "M" : "L", x, y);
            dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>", x, y, color);
        }
        const double row = kTop + 12 + 17 * double(i);
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>{}\n", path, color, dots);
        svg +=
            fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", kWidth - kRight + 8, row, color, curve.name);
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"#666\">- - linear</text>\n</svg>\n", kWidth - kRight + 8,
                       kTop + 12 + 17 * double(curves.size()));
    return svg;
}

}  // namespace ombrage
