// SPDX-License-Identifier: MIT
#include "lab/statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace ombrage {

namespace {

constexpr int kResamples = 6000;
/// Quantile of the normal distribution at 0.995: both tails leave 1 %.
constexpr double kNormal995 = 2.5758293035489004;

/// Quantile of Student's distribution at 0.995, from the normal one's by the expansion of Cornish and Fisher
/// (Abramowitz and Stegun 26.7.5). Off by 0.02 at 7 degrees of freedom, by less above.
double student995(double freedom) {
    const double z = kNormal995, z2 = z * z;
    const double g1 = z * (z2 + 1) / 4, g2 = z * ((5 * z2 + 16) * z2 + 3) / 96,
                 g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    return z + ((g3 / freedom + g2) / freedom + g1) / freedom;
}

/// Share of the resamples below the interval. The spread of resamples is too small by sqrt((n - 1) / n), and their
/// tails are the normal distribution's; a 99 % interval takes as much further out as Student's says.
double tailShare(std::size_t rounds) {
    const double n = double(rounds);
    return 0.5 * std::erfc(std::sqrt(n / (n - 1)) * student995(n - 1) / std::sqrt(2.0));
}

std::vector<double> resampled(const std::vector<double>& values, std::mt19937_64& random) {
    std::vector<double> result(values.size());
    // Not std::uniform_int_distribution: its results differ from library to library.
    for (double& value : result) value = values[std::size_t((random() >> 32) * values.size() >> 32)];
    return result;
}

Difference differenceOf(double change, std::size_t rounds, std::uint64_t seed,
                        const std::function<double(std::mt19937_64&)>& resample) {
    Difference result;
    result.change = std::expm1(change);
    if (rounds < kFewestRounds) return result;
    std::mt19937_64 random(seed);
    std::vector<double> changes(kResamples);
    for (double& value : changes) value = resample(random);
    std::sort(changes.begin(), changes.end());
    const auto out = std::size_t(tailShare(rounds) * kResamples);
    result.low = std::expm1(changes[out]);
    result.high = std::expm1(changes[kResamples - 1 - out]);
    const bool counts = (result.low > 0 || result.high < 0) && std::abs(result.change) > kLeastDifference;
    result.verdict = !counts             ? Difference::Verdict::None
                     : result.change > 0 ? Difference::Verdict::More
                                         : Difference::Verdict::Less;
    return result;
}

/// What takes no measurable time is taken for the least that a double can tell from nothing here.
std::vector<double> logarithms(const std::vector<double>& values) {
    std::vector<double> result;
    for (const double value : values) result.push_back(std::log(std::max(value, 1e-9)));
    return result;
}

}  // namespace

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0;
    const std::size_t n = values.size();
    const auto middle = values.begin() + std::ptrdiff_t(n / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (n % 2 == 1) return *middle;
    return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

double p95Of(std::vector<double> values) {
    if (values.empty()) return 0;
    const std::size_t rank = std::max<std::size_t>(std::size_t(std::ceil(0.95 * double(values.size()))), 1);
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank - 1), values.end());
    return values[rank - 1];
}

double madOf(const std::vector<double>& values) {
    const double median = medianOf(values);
    std::vector<double> distances;
    for (const double value : values) distances.push_back(std::abs(value - median));
    return medianOf(std::move(distances));
}

double middleOf(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t left = values.size() / 4;
    return std::accumulate(values.begin() + std::ptrdiff_t(left), values.end() - std::ptrdiff_t(left), 0.0) /
           double(values.size() - 2 * left);
}

Difference pairedDifference(const std::vector<double>& a, const std::vector<double>& b, std::uint64_t seed) {
    std::vector<double> changes = logarithms(b);
    const std::vector<double> base = logarithms(a);
    changes.resize(std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < changes.size(); ++i) changes[i] -= base[i];
    return differenceOf(middleOf(changes), changes.size(), seed,
                        [&](std::mt19937_64& random) { return middleOf(resampled(changes, random)); });
}

Difference unpairedDifference(const std::vector<double>& a, const std::vector<double>& b, std::uint64_t seed) {
    const std::vector<double> from = logarithms(a), to = logarithms(b);
    return differenceOf(middleOf(to) - middleOf(from), std::min(a.size(), b.size()), seed,
                        [&](std::mt19937_64& random) {
                            const double base = middleOf(resampled(from, random));
                            return middleOf(resampled(to, random)) - base;
                        });
}

const char* verdictName(Difference::Verdict verdict) {
    switch (verdict) {
        case Difference::Verdict::TooFew:
            return "too few rounds";
        case Difference::Verdict::More:
            return "slower";
        case Difference::Verdict::Less:
            return "faster";
        case Difference::Verdict::None:
            break;
    }
    return "no significant difference";
}

}  // namespace ombrage
