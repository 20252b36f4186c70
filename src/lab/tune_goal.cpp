// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/tune_search.h"

namespace ombrage::tuning {

namespace {

/// How far outside the limits, as a share of them.
double excessOf(const Goal& goal, const Outcome& outcome) {
    const auto over = [](double value, double limit) {
        return value <= limit ? 0.0 : (value - limit) / std::max(std::abs(limit), 1e-12);
    };
    return over(outcome.error, goal.errorLimit) + over(outcome.cost, goal.costLimit);
}

}  // namespace

bool Goal::isBetter(const Outcome& a, const Outcome& b) const {
    const double excessA = excessOf(*this, a), excessB = excessOf(*this, b);
    if (excessA != excessB) return excessA < excessB;
    switch (kind) {
        case Kind::LeastError:
            return a.error < b.error;
        case Kind::LeastCost:
            return a.cost < b.cost;
        case Kind::Front:
            break;
    }
    return a.error <= b.error && a.cost <= b.cost && a != b;
}

std::vector<std::size_t> bestOf(const std::vector<Candidate>& candidates, const Goal& goal, std::size_t count) {
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto outcome = [&](std::size_t i) -> const Outcome& { return candidates[i].outcome; };
    if (goal.kind != Goal::Kind::Front) {
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return goal.isBetter(outcome(a), outcome(b)); });
        order.resize(std::min(order.size(), count));
        return order;
    }
    // By cost, and then each must have less error than all that cost less; of equal ones the first stays.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return outcome(a).cost != outcome(b).cost ? outcome(a).cost < outcome(b).cost
                                                  : outcome(a).error < outcome(b).error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (goal.isMetBy(outcome(i)) && (front.empty() || outcome(i).error < outcome(front.back()).error))
            front.push_back(i);
    if (front.size() <= count || count < 2) {
        front.resize(std::min(front.size(), count));
        return front;
    }
    // Too many to hold on to: evenly along the front, both ends included.
    std::vector<std::size_t> thinned;
    for (std::size_t i = 0; i < count; ++i) thinned.push_back(front[i * (front.size() - 1) / (count - 1)]);
    return thinned;
}

std::size_t decide(const std::vector<Outcome>& outcomes, const Goal& goal) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < outcomes.size(); ++i)
        if (goal.isBetter(outcomes[i], outcomes[best])) best = i;
    return best;
}

}  // namespace ombrage::tuning
