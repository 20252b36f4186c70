// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace ombrage {

/// Of an even number of values the mean of the two in the middle; 0 of none.
double medianOf(std::vector<double> values);
/// 95th percentile by nearest rank; 0 of no values.
double p95Of(std::vector<double> values);
/// Median of the distances from the median, not scaled.
double madOf(const std::vector<double>& values);

/// Mean of the middle half: of n values the floor(n / 4) least and greatest are left out. Less noisy than the median,
/// and a quarter of the values may be anything. 0 of no values.
double middleOf(std::vector<double> values);

/// How much more B costs than A, as a share of A: 0.1 is 10 % more.
struct Difference {
    enum class Verdict {
        TooFew,  ///< fewer than kFewestRounds rounds: nothing can be said
        None,    ///< no significant difference
        More,
        Less
    };
    double change = 0;
    double low = 0, high = 0;  ///< 99 % interval
    Verdict verdict = Verdict::TooFew;
    bool operator==(const Difference&) const = default;
};

/// A difference counts when its interval excludes 0 and it is over this share.
inline constexpr double kLeastDifference = 0.02;
inline constexpr std::size_t kFewestRounds = 8;

/// Costs of A and B by turns, one pair a round: what slows a whole round down cancels. The change is the middle of the
/// logarithms of the rounds' ratios; its interval is a bootstrap over the rounds, with percentiles widened as a small
/// number of rounds asks for (Hesterberg 2015, section 5.3, "expanded percentile interval").
/// @param seed of the resampling; equal input and seed give equal output
Difference pairedDifference(const std::vector<double>& a, const std::vector<double>& b, std::uint64_t seed);

/// The same of two runs that had nothing to do with each other: each is resampled by itself. What changed between the
/// runs beside the program is in the change, and not in the interval.
Difference unpairedDifference(const std::vector<double>& a, const std::vector<double>& b, std::uint64_t seed);

/// "no significant difference", "slower", "faster", "too few rounds".
const char* verdictName(Difference::Verdict verdict);

}  // namespace ombrage
