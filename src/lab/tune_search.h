// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace ombrage::tuning {

/// One thing that the search may change.
struct Dimension {
    enum class Kind {
        Real,     ///< any number of the range
        Integer,  ///< whole numbers of the range
        Choice    ///< 0 .. choices - 1, in no order
    };
    Kind kind = Kind::Real;
    double minimum = 0, maximum = 1;  ///< inclusive; Real and Integer
    bool logarithmic = false;         ///< steps are ratios; the minimum is over 0
    int choices = 0;                  ///< of a Choice
};

/// A value for each dimension, in its own unit; a Choice has the number of one. Reals have four significant digits.
using Point = std::vector<double>;

/// What a point gives; less is better in both.
struct Outcome {
    double error = 0, cost = 0;
    bool operator==(const Outcome&) const = default;
};

struct Candidate {
    Point point;
    Outcome outcome;
};

/// What is looked for. Limits are inclusive.
struct Goal {
    enum class Kind {
        LeastError,
        LeastCost,
        Front  ///< everything that nothing else beats in both
    };
    Kind kind = Kind::LeastError;
    double errorLimit = std::numeric_limits<double>::infinity();
    double costLimit = std::numeric_limits<double>::infinity();

    bool isMetBy(const Outcome& outcome) const { return outcome.error <= errorLimit && outcome.cost <= costLimit; }
    /// Whether `a` is the better answer: one within the limits beats one outside, outside of them the smaller excess
    /// does. Of a Front's answers: whether `a` beats `b` in one and is as good in the other. Equals are not better.
    bool isBetter(const Outcome& a, const Outcome& b) const;
};

struct SearchProblem {
    std::vector<Dimension> dimensions;
    Point start;                 ///< the first candidate; it may lie outside the ranges
    std::vector<Point> further;  ///< the next ones
    Goal goal;
    std::uint64_t seed = 1;
    int evaluations = 200;  ///< at most so many different points
    /// Measures a point. Called once for each different one; may throw to end the search.
    std::function<Outcome(const Point&)> evaluate;
    /// Asked before each evaluation; true ends the search.
    std::function<bool()> enough;
};

/// Searches: the start, points that cover the ranges evenly, then descents. In a descent choices and whole numbers move
/// one at a time, each to its other values or a step away, and between these moves NLopt (BOBYQA and Subplex by turns)
/// moves all reals; steps halve while nothing improves. A descent that ends is followed by one from the best point seen
/// whose choices no descent has had.
///
/// What is done next depends on the problem and the outcomes alone, so that a search that is given the outcomes of an
/// earlier one goes the same way.
/// @param seen every point that was measured, in order, the start first; whole also when `evaluate` throws
void search(const SearchProblem& problem, std::vector<Candidate>& seen);

/// The best of the candidates, best first, equal ones in their order; at most so many. For a Front: those that nothing
/// beats within the limits, by cost.
std::vector<std::size_t> bestOf(const std::vector<Candidate>& candidates, const Goal& goal, std::size_t count);

/// Which of the outcomes is the answer: the best of them, and the first one, the start, unless another is better.
std::size_t decide(const std::vector<Outcome>& outcomes, const Goal& goal);

}  // namespace ombrage::tuning
