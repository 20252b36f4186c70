// SPDX-License-Identifier: MIT
// The search on made-up techniques whose best parameters are known.
#include "lab/tune_search.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "lab/tune_steps.h"

namespace ombrage::tuning {
namespace {

using Kind = Dimension::Kind;

Dimension real(double minimum, double maximum, bool logarithmic = false) {
    return {Kind::Real, minimum, maximum, logarithmic, 0};
}
Dimension integer(double minimum, double maximum, bool logarithmic = false) {
    return {Kind::Integer, minimum, maximum, logarithmic, 0};
}
Dimension choice(int count) {
    return {Kind::Choice, 0, 0, false, count};
}

double squareOf(double x) {
    return x * x;
}

/// Two biases with a narrow best place, a resolution that pays less and less, and a mode of four with a trap: mode 1 is
/// right, mode 2 is nearly as good over a wide range, the others are hopeless.
struct Planted {
    static constexpr double kBias = 1.37, kSlope = 3.1, kResolution = 1500;
    static constexpr double kLeast = 0.02;

    static SearchProblem problem() {
        SearchProblem p;
        p.dimensions = {real(0, 4), choice(4), real(0.1, 20, true), integer(256, 4096, true), choice(2)};
        p.start = {3.9, 3, 0.1, 256, 0};  // the known wrong default
        p.evaluations = 400;
        p.evaluate = [](const Point& x) { return Outcome{errorOf(x), x[3]}; };
        return p;
    }
    static double errorOf(const Point& x) {
        const double bias = squareOf((x[0] - kBias) / 4), slope = squareOf(std::log(x[2] / kSlope) / std::log(200.0)),
                     resolution = squareOf(std::log(x[3] / kResolution) / std::log(16.0));
        // A coupling, so that no parameter can be found without the others.
        const double coupling = 0.5 * (x[0] - kBias) / 4 * std::log(x[2] / kSlope) / std::log(200.0);
        const double bowl = bias + slope + resolution + coupling;
        if (x[1] == 1) return kLeast + 0.6 * bowl + (x[4] == 1 ? 0 : 0.004);
        if (x[1] == 2) return kLeast + 0.012 + 0.1 * bowl + 0.1 * squareOf(x[0] / 4);
        return 0.2 + 0.1 * x[1] + bowl;
    }
};

std::vector<Candidate> found(const SearchProblem& problem) {
    std::vector<Candidate> seen;
    search(problem, seen);
    return seen;
}

const Candidate& best(const std::vector<Candidate>& seen, const Goal& goal = {}) {
    return seen[bestOf(seen, goal, 1).at(0)];
}

TEST(TuneSearch, FindsThePlantedOptimumFromEverySeed) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SearchProblem problem = Planted::problem();
        problem.seed = seed;
        const std::vector<Candidate> seen = found(problem);
        const Candidate& winner = best(seen);
        EXPECT_LE(seen.size(), 400u);
        // 5 % is what the tuner promises, of the error and of each parameter's range.
        EXPECT_LE(winner.outcome.error, 1.05 * Planted::kLeast) << "seed " << seed;
        EXPECT_EQ(winner.point[1], 1) << "seed " << seed;
        EXPECT_EQ(winner.point[4], 1) << "seed " << seed;
        EXPECT_NEAR(placeOf(problem.dimensions[0], winner.point[0]), Planted::kBias / 4, 0.05) << "seed " << seed;
        EXPECT_NEAR(placeOf(problem.dimensions[2], winner.point[2]), placeOf(problem.dimensions[2], Planted::kSlope),
                    0.05)
            << "seed " << seed;
        EXPECT_NEAR(placeOf(problem.dimensions[3], winner.point[3]),
                    placeOf(problem.dimensions[3], Planted::kResolution), 0.05)
            << "seed " << seed;
    }
}

TEST(TuneSearch, FindsRealsAloneWholeNumbersAloneAndEnumsAlone) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SearchProblem reals;
        reals.dimensions = {real(-1, 1), real(0, 10), real(1, 100, true), real(0, 1), real(0, 1), real(0, 1)};
        reals.start = {-1, 10, 100, 1, 1, 1};
        reals.seed = seed;
        reals.evaluations = 300;
        const Point planted{0.3, 7.5, 8, 0.2, 0.6, 0.9};
        reals.evaluate = [&](const Point& x) {
            double distance = 0;
            for (std::size_t i = 0; i < x.size(); ++i)
                distance += squareOf(placeOf(reals.dimensions[i], x[i]) - placeOf(reals.dimensions[i], planted[i]));
            return Outcome{0.1 + distance, 1};
        };
        const std::vector<Candidate> seen = found(reals);
        for (std::size_t i = 0; i < planted.size(); ++i)
            EXPECT_NEAR(placeOf(reals.dimensions[i], best(seen).point[i]), placeOf(reals.dimensions[i], planted[i]),
                        0.05)
                << "seed " << seed << ", dimension " << i;

        SearchProblem whole;
        whole.dimensions = {integer(1, 12), integer(8, 64), integer(16, 8192, true)};
        whole.start = {12, 8, 16};
        whole.seed = seed;
        whole.evaluate = [](const Point& x) {
            return Outcome{std::abs(x[0] - 5) + std::abs(x[1] - 33) / 8 + std::abs(std::log2(x[2] / 700)), 1};
        };
        const Point at = best(found(whole)).point;
        EXPECT_EQ(at[0], 5) << seed;
        EXPECT_EQ(at[1], 33) << seed;
        EXPECT_NEAR(at[2], 700, 0.05 * 700) << seed;

        SearchProblem enums;
        enums.dimensions = {choice(5), choice(7), choice(2), choice(3)};
        enums.start = {0, 0, 0, 0};
        enums.seed = seed;
        enums.evaluate = [](const Point& x) {
            return Outcome{double((x[0] != 4) + (x[1] != 2) + (x[2] != 1) + (x[3] != 1)), 1};
        };
        EXPECT_EQ(best(found(enums)).point, (Point{4, 2, 1, 1})) << seed;
    }
}

TEST(TuneSearch, AStaircaseWithoutSlopesIsDescended) {
    // Errors that count pixels change in steps, and beside the steps nothing tells the direction.
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SearchProblem problem;
        problem.dimensions = {real(0, 4), real(0, 4)};
        problem.start = {4, 4};
        problem.seed = seed;
        problem.evaluate = [](const Point& x) {
            return Outcome{std::floor(20 * (squareOf(x[0] - 1.2) + squareOf(x[1] - 2.6))) / 20, 1};
        };
        // One stair is 0.05, which is under 5 % of the start's 9.8.
        EXPECT_LE(best(found(problem)).outcome.error, 0.05) << "seed " << seed;
    }
}

TEST(TuneSearch, TheStartComesFirstAndIsOnlyLeftForSomethingBetter) {
    SearchProblem problem = Planted::problem();
    problem.start = {Planted::kBias, 1, Planted::kSlope, Planted::kResolution, 1};  // nothing is better
    const std::vector<Candidate> seen = found(problem);
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen[0].point, problem.start);
    EXPECT_EQ(bestOf(seen, {}, 1).at(0), 0u);

    // A flat error: everything is as good, so the start stays.
    problem.evaluate = [](const Point&) { return Outcome{0.5, 1}; };
    EXPECT_EQ(bestOf(found(problem), {}, 1).at(0), 0u);
    // Also one that lies outside of the ranges.
    problem.start = {32, 0, 100, 16, 0};
    EXPECT_EQ(best(found(problem)).point, problem.start);
}

TEST(TuneSearch, AValueOutsideOfItsRangeThatMeansSomethingOfItsOwnIsKeptWhileTheOthersMove) {
    // 0 stands for a value that the range does not reach; the other parameter has its best place in either case.
    SearchProblem problem;
    problem.dimensions = {real(0.05, 2), real(0, 1)};
    problem.start = {0, 1};
    problem.evaluations = 200;
    problem.evaluate = [](const Point& x) { return Outcome{(x[0] == 0 ? 0.1 : 0.3) + squareOf(x[1] - 0.4), 1}; };
    const Candidate winner = best(found(problem));
    EXPECT_EQ(winner.point[0], 0);
    EXPECT_NEAR(winner.point[1], 0.4, 0.05);
}

TEST(TuneSearch, EverySearchedPointLiesInTheRangesAndIsMeasuredOnce) {
    SearchProblem problem = Planted::problem();
    std::set<Point> measured;
    problem.evaluate = [&](const Point& x) {
        EXPECT_TRUE(measured.insert(x).second);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Dimension& d = problem.dimensions[i];
            EXPECT_GE(x[i], d.kind == Kind::Choice ? 0 : d.minimum);
            EXPECT_LE(x[i], d.kind == Kind::Choice ? d.choices - 1 : d.maximum);
            EXPECT_TRUE(d.kind == Kind::Real || x[i] == std::round(x[i])) << x[i];
        }
        return Outcome{Planted::errorOf(x), 1};
    };
    const std::size_t count = found(problem).size();
    EXPECT_EQ(measured.size(), count);
}

TEST(TuneSearch, OneSeedGivesOnePathAndAnotherOneAnother) {
    SearchProblem problem = Planted::problem();
    const auto pathOf = [&](std::uint64_t seed) {
        problem.seed = seed;
        std::vector<Point> path;
        for (const Candidate& candidate : found(problem)) path.push_back(candidate.point);
        return path;
    };
    EXPECT_EQ(pathOf(7), pathOf(7));
    EXPECT_NE(pathOf(7), pathOf(8));
}

TEST(TuneSearch, WhatWasInterruptedGoesOnAsIfItHadNot) {
    SearchProblem problem = Planted::problem();
    const std::vector<Candidate> whole = found(problem);
    struct Interrupt : std::runtime_error {
        Interrupt() : std::runtime_error("interrupted") {}
    };
    for (const std::size_t after :
         {std::size_t{0}, std::size_t{1}, std::size_t{17}, std::size_t{120}, std::size_t{333}}) {
        // The store's part: what was measured is not measured again.
        std::map<Point, Outcome> store;
        int measured = 0;
        const auto evaluate = problem.evaluate;
        SearchProblem broken = problem;
        broken.evaluate = [&](const Point& x) {
            if (store.size() == after) throw Interrupt();
            ++measured;
            return store[x] = evaluate(x);
        };
        std::vector<Candidate> seen;
        EXPECT_THROW(search(broken, seen), Interrupt) << after;
        EXPECT_EQ(seen.size(), after);

        SearchProblem resumed = problem;
        resumed.evaluate = [&](const Point& x) {
            const auto known = store.find(x);
            if (known != store.end()) return known->second;
            ++measured;
            return store[x] = evaluate(x);
        };
        const std::vector<Candidate> again = found(resumed);
        ASSERT_EQ(again.size(), whole.size()) << after;
        for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(again[i].point, whole[i].point) << after;
        EXPECT_EQ(std::size_t(measured), whole.size()) << after;
    }
}

TEST(TuneSearch, EndsWhenAskedAndHasNoMoreEvaluationsThanAllowed) {
    SearchProblem problem = Planted::problem();
    for (const int evaluations : {1, 2, 7, 50}) {
        problem.evaluations = evaluations;
        EXPECT_EQ(found(problem).size(), std::size_t(evaluations));
    }
    int asked = 0;
    problem.evaluations = 400;
    problem.enough = [&] { return ++asked > 30; };
    EXPECT_EQ(found(problem).size(), 30u);
    // Nothing to vary: the start alone.
    SearchProblem empty;
    empty.evaluate = [](const Point&) { return Outcome{1, 1}; };
    EXPECT_EQ(found(empty).size(), 1u);
}

TEST(TuneSearch, TheBudgetIsRespected) {
    // The best resolution, 1500, costs more than is allowed: the best within the budget is at its limit.
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SearchProblem problem = Planted::problem();
        problem.seed = seed;
        problem.goal.costLimit = 900;
        const std::vector<Candidate> seen = found(problem);
        const Candidate& winner = best(seen, problem.goal);
        EXPECT_LE(winner.outcome.cost, 900);
        const double expected = Planted::errorOf({Planted::kBias, 1, Planted::kSlope, 900, 1});
        EXPECT_LE(winner.outcome.error, 1.05 * expected) << "seed " << seed;

        // The least cost under an error bound, from a start that is far outside: where the bowl crosses the bound.
        problem.goal = {Goal::Kind::LeastCost, 1.5 * Planted::kLeast, std::numeric_limits<double>::infinity()};
        const std::vector<Candidate> cheap = found(problem);
        const Outcome least = best(cheap, problem.goal).outcome;
        EXPECT_LE(least.error, 1.5 * Planted::kLeast);
        // 0.6 (log(1500 / r) / log 16)^2 = 0.01 with all else at its best.
        const double edge = Planted::kResolution * std::pow(16.0, -std::sqrt(0.01 / 0.6));
        EXPECT_LE(placeOf(problem.dimensions[3], least.cost), placeOf(problem.dimensions[3], edge) + 0.05)
            << "seed " << seed;
    }
}

TEST(TuneSearch, OutsideTheLimitsLessIsBetterAndInsideTheGoalCounts) {
    const Goal goal{Goal::Kind::LeastError, std::numeric_limits<double>::infinity(), 10};
    EXPECT_TRUE(goal.isBetter({0.9, 10}, {0.1, 10.1}));
    EXPECT_TRUE(goal.isBetter({0.9, 11}, {0.1, 12}));
    EXPECT_TRUE(goal.isBetter({0.1, 10}, {0.2, 1}));
    EXPECT_FALSE(goal.isBetter({0.1, 9}, {0.1, 10}));
    // The start, the first, stays when others are only as good, and goes when it breaks the limit.
    EXPECT_EQ(decide({{0.2, 5}, {0.2, 4}, {0.3, 1}}, goal), 0u);
    EXPECT_EQ(decide({{0.2, 5}, {0.1, 11}, {0.15, 9}}, goal), 2u);
    EXPECT_EQ(decide({{0.1, 20}, {0.4, 9}}, goal), 1u);
    EXPECT_EQ(decide({{0.1, 20}, {0.05, 30}}, goal), 0u);
}

TEST(TuneSearch, TheFrontHoldsWhatNothingBeatsAndReachesBothEnds) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SearchProblem problem = Planted::problem();
        problem.goal.kind = Goal::Kind::Front;
        problem.evaluations = 1000;
        problem.seed = seed;
        const std::vector<Candidate> seen = found(problem);
        const std::vector<std::size_t> front = bestOf(seen, problem.goal, seen.size());
        ASSERT_GE(front.size(), 5u);
        for (const std::size_t i : front)
            for (const Candidate& other : seen)
                EXPECT_FALSE(problem.goal.isBetter(other.outcome, seen[i].outcome)) << "seed " << seed;
        // Everything that nothing beats is there: whatever is not there is beaten by, or equal to, what is.
        for (const Candidate& other : seen) {
            bool covered = false;
            for (const std::size_t i : front)
                covered |= seen[i].outcome == other.outcome || problem.goal.isBetter(seen[i].outcome, other.outcome);
            EXPECT_TRUE(covered) << "seed " << seed;
        }
        EXPECT_EQ(seen[front.front()].outcome.cost, 256) << "the cheapest there is";
        EXPECT_LE(seen[front.back()].outcome.error, 1.05 * Planted::kLeast) << "seed " << seed;
        const std::vector<std::size_t> few = bestOf(seen, problem.goal, 4);
        ASSERT_EQ(few.size(), 4u);
        EXPECT_EQ(few.front(), front.front());
        EXPECT_EQ(few.back(), front.back());
    }
}

TEST(TuneSearch, ValuesAreShortAndStayWhereTheyAre) {
    const Dimension d = real(0.1, 20, true);
    EXPECT_EQ(valueAt(d, placeOf(d, 3.1)), 3.1);
    EXPECT_EQ(valueAt(real(0, 4), 1.0 / 3), 1.333);
    EXPECT_EQ(valueAt(real(0, 4), 1e-6), 0);
    EXPECT_EQ(valueAt(real(1e5, 2e6), 0.123456), 334600);
    EXPECT_EQ(valueAt(integer(256, 4096, true), 0.5), 1024);
    EXPECT_EQ(placeOf(d, 1000), 1);
    EXPECT_EQ(placeOf(d, 0), 0);
}

}  // namespace
}  // namespace ombrage::tuning
