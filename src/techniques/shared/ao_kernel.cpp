// SPDX-License-Identifier: MIT
#include "techniques/shared/ao_kernel.h"

#include <cmath>

namespace ombrage {

namespace {

constexpr double kGoldenAngle = 2.39996322972865332;
constexpr double kPlastic = 0.7548776662466927;  // 1 / the plastic number: even with any other coordinate

/// Solves cdf(x) = u on [0,1] for a growing cdf.
template <typename Cdf>
double invert(Cdf cdf, double u) {
    double low = 0, high = 1;
    for (int step = 0; step < 40; ++step) {
        const double middle = 0.5 * (low + high);
        (cdf(middle) < u ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

struct Radius {
    double length, weight;
};

Radius diskRadius(AoDistribution distribution, double u) {
    switch (distribution) {
        case AoDistribution::Cosine:
            // The integral of 4 rho ln(1 / rho), what the ball's points leave on its base.
            return {invert([](double x) { return x > 0 ? x * x * (1 - 2 * std::log(x)) : 0.0; }, u), 1};
        case AoDistribution::Importance: {
            // Area density (2/pi)(1 - rho^2), the falloff on a flat neighbourhood, against 1/pi of the even one.
            const double rho2 = 1 - std::sqrt(1 - u);
            return {std::sqrt(rho2), 0.5 / (1 - rho2)};
        }
        case AoDistribution::Uniform:
            break;
    }
    return {std::sqrt(u), 1};
}

Radius ballRadius(AoDistribution distribution, double u) {
    switch (distribution) {
        case AoDistribution::Cosine:
            return {std::sqrt(u), 1};
        case AoDistribution::Importance: {
            // Density 3 t^2 (2 - t^2) 5/7 against 3 t^2: the surface found may be nearer than the point asked for, so
            // the density keeps away from 0 (defensive mixture, Owen and Zhou 2000).
            const double t = invert([](double x) { return (10 * x * x * x - 3 * x * x * x * x * x) / 7; }, u);
            return {t, 7.0 / (5 * (2 - t * t))};
        }
        case AoDistribution::Uniform:
            break;
    }
    return {std::cbrt(u), 1};
}

/// Cosine to the normal of a direction in the hemisphere, and its weight.
Radius elevation(AoDistribution distribution, double u) {
    switch (distribution) {
        case AoDistribution::Cosine:
            return {std::sqrt(u), 1};
        case AoDistribution::Importance: {
            // Density 1/2 + z against 1.
            const double z = 0.5 * (std::sqrt(1 + 8 * u) - 1);
            return {z, 1 / (0.5 + z)};
        }
        case AoDistribution::Uniform:
            break;
    }
    return {u, 1};
}

}  // namespace

std::vector<glm::vec4> aoKernel(AoOffsets offsets, AoDistribution distribution, int count) {
    std::vector<glm::vec4> kernel;
    for (int i = 0; i < count; ++i) {
        // A golden spiral: radii stratified, angles even (Vogel 1979).
        const double u = (i + 0.5) / count, angle = i * kGoldenAngle;
        if (offsets == AoOffsets::Screen) {
            const Radius radius = diskRadius(distribution, u);
            kernel.emplace_back(radius.length * std::cos(angle), radius.length * std::sin(angle), 0, radius.weight);
            continue;
        }
        const Radius radius = ballRadius(distribution, u);
        const double v = 0.5 + i * kPlastic;
        const Radius height = elevation(distribution, v - std::floor(v));
        const double across = radius.length * std::sqrt(1 - height.length * height.length);
        kernel.emplace_back(across * std::cos(angle), across * std::sin(angle), radius.length * height.length,
                            radius.weight * height.weight);
    }
    return kernel;
}

std::vector<glm::vec4> aoBallKernel(int count) {
    std::vector<glm::vec4> kernel;
    for (int i = 0; i < count; ++i) {
        // A spiral from pole to pole, heights stratified; lengths even in volume.
        const double z = 1 - 2 * (i + 0.5) / count, angle = i * kGoldenAngle, across = std::sqrt(1 - z * z);
        const double v = 0.5 + i * kPlastic, length = std::cbrt(v - std::floor(v));
        kernel.emplace_back(length * across * std::cos(angle), length * across * std::sin(angle), length * z, 1);
    }
    return kernel;
}

}  // namespace ombrage
