// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace ombrage {

struct Curve {
    std::string name;
    std::vector<double> x, y;  ///< positive
};

/// Exponent b of the power law y = a * x^b that fits best: the slope of the least-squares line through the logarithms.
double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

/// An SVG picture of curves on two logarithmic axes, with a dashed line of exponent 1 through the last point of the
/// first curve.
std::string logPlot(const std::string& title, const std::string& xLabel, const std::string& yLabel,
                    const std::vector<Curve>& curves);

}  // namespace ombrage
