// SPDX-License-Identifier: MIT
#include "lab/tune_search.h"

#include <nlopt.h>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <set>

#include "lab/tune_steps.h"

namespace ombrage::tuning {

namespace {

/// First and last step of a descent, as shares of the ranges.
constexpr double kFirstStep = 0.25, kLastStep = 1.0 / 256;
/// A choice that is at most so much worse where it was tried may be better where its reals would be.
constexpr double kWorthPolishing = 1.5;

/// Ends a search from inside: no evaluation is left.
struct Enough {};

/// The state of one search.
class Search {
public:
    Search(const SearchProblem& problem, std::vector<Candidate>& seen)
        : m_problem(problem), m_seen(seen), m_random(problem.seed) {
        for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
            (problem.dimensions[i].kind == Dimension::Kind::Real ? m_reals : m_discrete).push_back(i);
    }

    void run() {
        const Goal::Kind kind = m_problem.goal.kind;
        try {
            at(m_problem.start);
            for (const Point& point : m_problem.further) at(point);
            cover();
            if (kind != Goal::Kind::Front) {
                m_last = m_problem.evaluations;
                descendEverywhere();
            } else {
                // Each weight pulls the search to another part of the front.
                const double weights[] = {0.5, 0, 1, 0.25, 0.75};
                const int left = m_problem.evaluations - int(m_seen.size());
                int part = 0;
                for (const double weight : weights) {
                    m_errorWeight = weight;
                    m_had.clear();
                    m_last = m_problem.evaluations - left * (4 - part++) / 5;
                    descendEverywhere();
                }
            }
        } catch (const Enough&) {
        }
    }

private:
    static constexpr double kNowhere = std::numeric_limits<double>::infinity();

    /// The outcome of a point, measured or remembered.
    const Outcome& at(const Point& point) {
        const auto known = m_known.find(point);
        if (known != m_known.end()) return m_seen[known->second].outcome;
        if (int(m_seen.size()) >= m_problem.evaluations || (m_problem.enough && m_problem.enough())) throw Enough{};
        const Outcome outcome = m_problem.evaluate(point);
        m_known.emplace(point, m_seen.size());
        m_seen.push_back({point, outcome});
        return m_seen.back().outcome;
    }

    /// What a descent makes small. Errors and costs count in those of the start; what is over a limit counts tenfold,
    /// so that it is worth more than any gain beyond it, and yet leads back.
    double meritOf(const Outcome& outcome) const {
        const Outcome& first = m_seen.front().outcome;
        const auto relative = [](double value, double to) { return to == 0 ? value : 1 + (value - to) / std::abs(to); };
        const double error = relative(outcome.error, first.error), cost = relative(outcome.cost, first.cost);
        const Goal& goal = m_problem.goal;
        double merit = 0;
        switch (goal.kind) {
            case Goal::Kind::LeastError:
                merit = error;
                break;
            case Goal::Kind::LeastCost:
                // Where the cost does not care, room below the bound is what lets the next step pay less.
                merit = cost + 0.1 * error;
                break;
            case Goal::Kind::Front:
                // Augmented weighted Chebyshev (Steuer and Choo 1983): reaches the hollow parts of a front too.
                merit = std::max(m_errorWeight * error, (1 - m_errorWeight) * cost) + 0.001 * (error + cost);
                break;
        }
        if (outcome.error > goal.errorLimit)
            merit += 10 * (1 + (outcome.error - goal.errorLimit) / std::max(std::abs(goal.errorLimit), 1e-12));
        if (outcome.cost > goal.costLimit)
            merit += 10 * (1 + (outcome.cost - goal.costLimit) / std::max(std::abs(goal.costLimit), 1e-12));
        return merit;
    }
    double meritAt(const Point& point) { return meritOf(at(point)); }

    /// A Latin hypercube: each part of each range is visited once, each choice as often as any other.
    void cover() {
        const std::size_t dims = m_problem.dimensions.size();
        // How many there are does not depend on the evaluations allowed: a longer search goes the way of a shorter one.
        const std::size_t count = 8 + 2 * dims;
        std::vector<Point> points(count, Point(dims));
        for (std::size_t d = 0; d < dims; ++d) {
            const Dimension& dimension = m_problem.dimensions[d];
            std::vector<std::size_t> cells(count);
            for (std::size_t i = 0; i < count; ++i) cells[i] = i;
            m_random.shuffle(cells);
            for (std::size_t i = 0; i < count; ++i)
                points[i][d] = dimension.kind == Dimension::Kind::Choice
                                   ? double(cells[i] % std::size_t(dimension.choices))
                                   : valueAt(dimension, (double(cells[i]) + m_random.unit()) / double(count));
        }
        for (const Point& point : points) at(point);
    }

    /// Descents from one set of choices after another until the evaluations of this part are used up.
    void descendEverywhere() {
        while (int(m_seen.size()) < m_last) {
            const Candidate* from = nullptr;
            for (const Candidate& candidate : m_seen)
                if (!m_had.count(choicesOf(candidate.point)) &&
                    (!from || meritOf(candidate.outcome) < meritOf(from->outcome)))
                    from = &candidate;
            if (!from) return;
            descend(from->point);
        }
    }

    /// A value outside of its range, which the start alone may have. It can mean something of its own, 0 for "as the
    /// scene says": a descent from there leaves it as it is.
    bool isOutside(const Point& point, std::size_t i) const {
        const Dimension& d = m_problem.dimensions[i];
        return d.kind != Dimension::Kind::Choice && (point[i] < d.minimum || point[i] > d.maximum);
    }

    /// What descents differ in: the choices, and which values stay outside.
    std::vector<double> choicesOf(const Point& point) const {
        std::vector<double> choices;
        for (const std::size_t i : m_discrete)
            if (m_problem.dimensions[i].kind == Dimension::Kind::Choice) choices.push_back(point[i]);
        for (std::size_t i = 0; i < point.size(); ++i) choices.push_back(isOutside(point, i));
        return choices;
    }

    void descend(Point best) {
        double merit = meritAt(best);
        int round = 0;
        for (double step = kFirstStep; step >= kLastStep && int(m_seen.size()) < m_last; ++round) {
            m_had.insert(choicesOf(best));
            const double before = merit;
            moveDiscrete(best, merit, step);
            moveReals(best, merit, step, round % 2 == 0, int(10 * m_reals.size() + 5));
            if (before - merit <= 1e-3 * std::abs(before)) step /= 2;
        }
        m_had.insert(choicesOf(best));
    }

    /// Choices to each other value, whole numbers a step up and down, in a new order each time.
    void moveDiscrete(Point& best, double& merit, double step) {
        std::vector<std::size_t> order = m_discrete;
        m_random.shuffle(order);
        for (const std::size_t i : order) {
            if (isOutside(best, i)) continue;
            const Dimension& d = m_problem.dimensions[i];
            const double here = best[i];
            std::vector<double> values;
            if (d.kind == Dimension::Kind::Choice) {
                for (int choice = 0; choice < d.choices; ++choice)
                    if (choice != int(here)) values.push_back(choice);
            } else {
                const double place = placeOf(d, here);
                values = {std::min(valueAt(d, place + step), d.maximum), std::max(valueAt(d, place - step), d.minimum)};
                // A step is at least a whole one.
                if (values[0] == here && here < d.maximum) values[0] = here + 1;
                if (values[1] == here && here > d.minimum) values[1] = here - 1;
            }
            for (const double value : values) {
                if (value == best[i]) continue;
                Point tried = best;
                tried[i] = value;
                double triedMerit = meritAt(tried);
                const bool isNear = triedMerit < kWorthPolishing * merit;
                // The reals that suit one choice seldom suit another.
                if (d.kind == Dimension::Kind::Choice && step >= kFirstStep / 2 && triedMerit >= merit && isNear &&
                    !m_had.count(choicesOf(tried))) {
                    m_had.insert(choicesOf(tried));
                    moveReals(tried, triedMerit, step, true, int(2 * m_reals.size() + 6));
                }
                if (triedMerit < merit) {
                    best = tried;
                    merit = triedMerit;
                }
            }
        }
    }

    /// What NLopt calls, and what came of it.
    struct Call {
        Search* search = nullptr;
        nlopt_opt optimizer = nullptr;
        std::vector<std::size_t> reals;
        Point point, best;
        double merit = 0;
        std::exception_ptr stopped;
    };

    static double measure(unsigned count, const double* places, double*, void* data) {
        Call& call = *static_cast<Call*>(data);
        Search& search = *call.search;
        if (call.stopped) return kNowhere;
        for (unsigned i = 0; i < count; ++i) {
            const std::size_t dimension = call.reals[i];
            call.point[dimension] = valueAt(search.m_problem.dimensions[dimension], places[i]);
        }
        // C code must not see an exception.
        try {
            const double merit = search.meritAt(call.point);
            if (merit < call.merit) {
                call.merit = merit;
                call.best = call.point;
            }
            return merit;
        } catch (...) {
            call.stopped = std::current_exception();
            nlopt_force_stop(call.optimizer);
            return kNowhere;
        }
    }

    /// All reals at once, from a point, with steps of this share of the ranges: by a quadratic model (BOBYQA, Powell
    /// 2009), which is quick where the error is smooth, or by simplices in subspaces (Subplex, Rowan 1990), which need
    /// nothing.
    void moveReals(Point& best, double& merit, double step, bool byModel, int calls) {
        std::vector<std::size_t> reals;
        for (const std::size_t i : m_reals)
            if (!isOutside(best, i)) reals.push_back(i);
        if (reals.empty()) return;
        const unsigned count = unsigned(reals.size());
        const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
            nlopt_create(byModel && count > 1 ? NLOPT_LN_BOBYQA : NLOPT_LN_SBPLX, count), nlopt_destroy);
        Call call{this, optimizer.get(), reals, best, best, merit, nullptr};
        std::vector<double> places;
        for (const std::size_t i : reals) places.push_back(placeOf(m_problem.dimensions[i], best[i]));
        nlopt_set_min_objective(optimizer.get(), measure, &call);
        nlopt_set_lower_bounds1(optimizer.get(), 0);
        nlopt_set_upper_bounds1(optimizer.get(), 1);
        nlopt_set_initial_step1(optimizer.get(), step);
        nlopt_set_xtol_abs1(optimizer.get(), std::min(step / 8, 1e-3));
        // Points that were seen before cost nothing and count here, so that it ends.
        nlopt_set_maxeval(optimizer.get(), calls);
        double least = 0;
        // What the best point was is known here; how it ended, at a tolerance or at a flat place, does not matter.
        nlopt_optimize(optimizer.get(), places.data(), &least);
        best = call.best;
        merit = call.merit;
        if (call.stopped) std::rethrow_exception(call.stopped);
    }

    const SearchProblem& m_problem;
    std::vector<Candidate>& m_seen;
    Random m_random;
    std::vector<std::size_t> m_reals, m_discrete;
    std::map<Point, std::size_t> m_known;
    std::set<std::vector<double>> m_had;  ///< choices that a descent has had
    int m_last = 0;                       ///< evaluations after which this part ends
    double m_errorWeight = 1;             ///< of a Front's part
};

}  // namespace

void search(const SearchProblem& problem, std::vector<Candidate>& seen) {
    Search(problem, seen).run();
}

}  // namespace ombrage::tuning
