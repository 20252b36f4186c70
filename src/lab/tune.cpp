// SPDX-License-Identifier: MIT
#include <ombrage/tune.h>

#include <ombrage/error.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/strings.h"
#include "core/whole_file.h"
#include "lab/statistics.h"
#include "lab/tune_measure.h"
#include "lab/tune_space.h"
#include "lab/tune_steps.h"

namespace ombrage {

namespace {

using tuning::Candidate;
using tuning::Goal;
using tuning::Outcome;

/// Times the share of a budget that is taken, the error of what breaks it: more than any metric has.
constexpr double kOverBudget = 1e4;

/// At most so many of a front are held against the held-out cameras.
constexpr std::size_t kMostOfFront = 12;

void checkRequest(const TuneRequest& request) {
    if (request.scenes.empty())
        throw Error(ErrorCode::Usage, "no scene to tune on", "'ombrage list scenes' shows the built-in ones");
    if (request.technique.second.empty()) throw Error(ErrorCode::Usage, "no technique to tune", "use --technique ID");
    if (request.outputDir.empty()) throw Error(ErrorCode::Usage, "no folder for the results", "name one with -o DIR");
    if (request.pareto && request.errorBelow)
        throw Error(ErrorCode::Usage, "a Pareto search has no error bound: it shows every trade",
                    "leave one of the two out");
    if (tuning::metricOf(request.metric).ofMotion)
        throw Error(ErrorCode::Usage, "'" + request.metric + "' is measured under motion scripts, and tune plays none",
                    "tune for another --metric; 'ombrage compare --motion' then holds the answer against the start");
    if (request.evaluations < 1 || request.finalists < 1 || request.seconds < 0)
        throw Error(ErrorCode::Usage, "a search needs at least one evaluation and one finalist");
}

Goal goalOf(const TuneRequest& request) {
    Goal goal;
    if (request.pareto) goal.kind = Goal::Kind::Front;
    if (request.errorBelow) {
        goal.kind = Goal::Kind::LeastCost;
        goal.errorLimit = tuning::errorOf(tuning::metricOf(request.metric), *request.errorBelow);
    }
    if (request.budget_ms || request.budget_MiB) {
        // Two kinds of cost are one number to the search: 1 is the budget where one is given.
        if (goal.kind == Goal::Kind::LeastError) goal.costLimit = 1;
        // A front has its cost for itself; what breaks a budget beside it has an error over this bound.
        if (goal.kind == Goal::Kind::Front) goal.errorLimit = kOverBudget / 2;
    }
    return goal;
}

class Tuner {
public:
    Tuner(const TuneRequest& request, const RendererOptions& options)
        : m_request(request),
          m_metric(tuning::metricOf(request.metric)),
          m_goal(goalOf(request)),
          m_space(request.technique.second, request.keep),
          m_begin(std::chrono::steady_clock::now()),
          m_measurer(request, options, [this](const std::string& what) { return tell(what); }) {}

    TuneResult run() {
        m_result.metric = m_request.metric;
        m_result.lowerIsBetter = m_metric.lowerIsBetter;
        m_result.parameters = m_space.names();
        m_result.cases = m_measurer.cases();
        m_result.device = m_measurer.device();
        m_result.clock = m_result.device.clock;
        m_result.pareto = m_request.pareto;
        m_result.commandLine = m_request.commandLine;
        try {
            searchParameters();
            m_isSearched = true;
            holdOut();
        } catch (const Error& error) {
            if (error.code() != ErrorCode::Interrupted || m_seen.empty()) throw;
            m_result.interrupted = true;
            preferBestSoFar();
        }
        for (const Candidate& candidate : m_seen) m_result.searched.push_back(told(candidate));
        m_result.measured = m_measurer.measured();
        m_result.reused = m_measurer.reused();
        m_measurer.store().exportLines();
        writeWhole(m_request.outputDir / "tune.json", m_result.json() + "\n");
        return m_result;
    }

private:
    bool timed() const {
        return m_request.budget_ms || ((m_request.errorBelow || m_request.pareto) && m_request.cost == TuneCost::Time);
    }

    bool tell(const std::string& what) {
        if (!what.empty()) m_what = what;
        const double searched = double(m_seen.size()) / std::max(m_request.evaluations, 1);
        const double share = m_isSearched ? 0.95 : 0.95 * std::max(searched, elapsedShare());
        return !m_request.progress || m_request.progress(m_what, share);
    }

    double elapsedShare() const {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_begin;
        return m_request.seconds > 0 ? std::min(elapsed.count() / m_request.seconds, 1.0) : 0;
    }

    /// The larger of the shares of the budgets, or what is to be made least.
    Outcome outcomeOf(const TuneFigures& figures) const {
        Outcome outcome{tuning::errorOf(m_metric, figures.error), 0};
        const double ofTime = m_request.budget_ms ? figures.time_ms.value_or(0) / *m_request.budget_ms : 0;
        const double ofMemory = m_request.budget_MiB ? figures.memory_MiB / *m_request.budget_MiB : 0;
        outcome.cost = std::max(ofTime, ofMemory);
        if (m_goal.kind == Goal::Kind::LeastError) return outcome;
        // What breaks a budget beside is no answer: it counts as an error over every bound.
        if (outcome.cost > 1) outcome.error = std::max(outcome.error, 0.0) + kOverBudget * outcome.cost;
        outcome.cost = m_request.cost == TuneCost::Time ? figures.time_ms.value_or(0) : figures.memory_MiB;
        return outcome;
    }

    TuneFigures figuresOf(const tuning::Point& point, bool heldOut) {
        return m_measurer.measure(m_space.at(point), heldOut, timed());
    }

    void searchParameters() {
        tuning::SearchProblem problem;
        problem.dimensions = m_space.dimensions();
        problem.start = m_space.start();
        problem.further = {m_space.defaults()};
        problem.goal = m_goal;
        problem.seed = m_request.base.seed;
        problem.evaluations = m_request.evaluations;
        problem.evaluate = [&](const tuning::Point& point) {
            m_figures.push_back(figuresOf(point, false));
            return outcomeOf(m_figures.back());
        };
        problem.enough = [&] { return m_request.seconds > 0 && !m_seen.empty() && elapsedShare() >= 1; };
        tuning::search(problem, m_seen);
    }

    TuneCandidate told(const Candidate& candidate) const {
        TuneCandidate result;
        result.pipeline = toString(m_space.at(candidate.point));
        result.searched = m_figures[std::size_t(&candidate - m_seen.data())];
        result.isWithinLimits = m_goal.isMetBy(candidate.outcome);
        return result;
    }

    void preferBestSoFar() {
        m_result.start = told(m_seen.front());
        if (m_request.pareto)
            for (const std::size_t i : tuning::bestOf(m_seen, m_goal, kMostOfFront))
                m_result.front.push_back(told(m_seen[i]));
        m_result.winner = m_request.pareto ? m_result.start : told(m_seen[tuning::bestOf(m_seen, m_goal, 1).front()]);
    }

    /// The start and the best few on the cameras that the search has not seen.
    void holdOut() {
        const bool isFront = m_request.pareto;
        std::vector<std::size_t> finalists{0};
        const std::size_t most = isFront ? kMostOfFront : std::size_t(m_request.finalists);
        for (const std::size_t i : tuning::bestOf(m_seen, m_goal, isFront ? most : m_seen.size()))
            if (finalists.size() <= most && (isFront ? i != 0 : isApart(i, finalists))) finalists.push_back(i);
        std::vector<Candidate> held;
        std::vector<TuneCandidate> candidates;
        for (const std::size_t i : finalists) {
            const TuneFigures figures = figuresOf(m_seen[i].point, true);
            TuneCandidate candidate = told(m_seen[i]);
            candidate.heldOut = figures;
            Outcome outcome = outcomeOf(figures);
            // The budget holds on every camera, the error bound on those that decide.
            if (!isFront) outcome.cost = std::max(outcome.cost, m_seen[i].outcome.cost);
            candidate.isWithinLimits = m_goal.isMetBy(outcome);
            held.push_back({m_seen[i].point, outcome});
            candidates.push_back(candidate);
        }
        m_result.start = candidates.front();
        if (isFront) {
            for (const std::size_t i : tuning::bestOf(held, m_goal, held.size()))
                m_result.front.push_back(candidates[i]);
            m_result.winner = m_result.start;
            return;
        }
        std::vector<Outcome> outcomes;
        for (const Candidate& candidate : held) outcomes.push_back(candidate.outcome);
        const std::size_t best = tuning::decide(outcomes, m_goal);
        m_result.winner = candidates[best];
        if (best != 0) simplify(held[best], m_seen[finalists[best]].outcome, held.front().outcome);
    }

    /// Whether a candidate differs from all of the others in a choice or by a tenth of a range: the best few of a
    /// search lie close together, and what one of them has learnt by heart they all have.
    bool isApart(std::size_t candidate, const std::vector<std::size_t>& others) const {
        return std::all_of(others.begin(), others.end(), [&](std::size_t other) {
            for (std::size_t d = 0; d < m_space.dimensions().size(); ++d) {
                const tuning::Dimension& dimension = m_space.dimensions()[d];
                const double a = m_seen[candidate].point[d], b = m_seen[other].point[d];
                if (dimension.kind == tuning::Dimension::Kind::Choice
                        ? a != b
                        : std::abs(placeOf(dimension, a) - placeOf(dimension, b)) >= 0.1)
                    return true;
            }
            return false;
        });
    }

    /// Puts back, one after another, what the search has changed and what changes nothing for the worse: a bias that
    /// the mode does not use is no part of the answer. Times that differ by less than counts as a difference are as
    /// good.
    void simplify(const Candidate& winner, const Outcome& searched, const Outcome& startHeld) {
        const double slack =
            m_goal.kind == Goal::Kind::LeastCost && m_request.cost == TuneCost::Time ? 1 - kLeastDifference : 1;
        const auto isWorse = [&](Outcome now, const Outcome& before) {
            if (!m_goal.isMetBy(now) && m_goal.isMetBy(before)) return true;
            now.cost *= slack;
            return m_goal.isBetter(before, now);
        };
        const tuning::Point start = m_space.start();
        tuning::Point point = winner.point;
        for (std::size_t i = 0; i < start.size(); ++i) {
            if (point[i] == start[i]) continue;
            tuning::Point tried = point;
            tried[i] = start[i];
            const TuneFigures onSearched = figuresOf(tried, false);
            const Outcome searchedNow = outcomeOf(onSearched);
            if (isWorse(searchedNow, searched)) continue;
            const TuneFigures onHeld = figuresOf(tried, true);
            Outcome heldNow = outcomeOf(onHeld);
            heldNow.cost = std::max(heldNow.cost, searchedNow.cost);
            if (isWorse(heldNow, winner.outcome) || !m_goal.isBetter(heldNow, startHeld)) continue;
            point = tried;
            m_result.winner = {toString(m_space.at(tried)), onSearched, onHeld, m_goal.isMetBy(heldNow)};
        }
    }

    const TuneRequest& m_request;
    const MetricInfo& m_metric;
    Goal m_goal;
    tuning::Space m_space;
    std::chrono::steady_clock::time_point m_begin;
    std::string m_what;
    std::vector<Candidate> m_seen;
    std::vector<TuneFigures> m_figures;  ///< of m_seen
    bool m_isSearched = false;
    TuneResult m_result;
    tuning::Measurer m_measurer;  // last: it tells while it is made
};

}  // namespace

std::pair<std::string, double> parseTuneWeight(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    double weight = 0;
    if (equals == std::string::npos || equals == 0 || !parseDouble(text.substr(equals + 1), weight) || weight <= 0)
        throw Error(ErrorCode::Usage, "--weight: '" + text + "' is not SCENE=WEIGHT", "as in menger=2, over 0");
    return {text.substr(0, equals), weight};
}

std::pair<std::string, double> parseErrorBelow(const std::string& text) {
    const std::size_t equals = text.find('=');
    double bound = 0;
    if (equals == std::string::npos || !parseDouble(text.substr(equals + 1), bound))
        throw Error(ErrorCode::Usage, "--error-below: '" + text + "' is not METRIC=NUMBER", "as in rmse=0.05");
    const MetricInfo& metric = tuning::metricOf(text.substr(0, equals));
    if (metric.lowerIsBetter && bound < 0)
        throw Error(ErrorCode::Usage, "--error-below: no " + metric.key + " has a size below 0", "as in rmse=0.05");
    return {metric.key, bound};
}

TuneResult tune(const TuneRequest& request, const RendererOptions& options) {
    checkRequest(request);
    return Tuner(request, options).run();
}

}  // namespace ombrage
