// SPDX-License-Identifier: MIT
#include <ombrage/tune.h>

#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ombrage {

namespace {

using Json = nlohmann::ordered_json;

Json figuresJson(const TuneFigures& figures) {
    Json json{{"error", figures.error}, {"memory_MiB", figures.memory_MiB}};
    json["time_ms"] = figures.time_ms ? Json(*figures.time_ms) : Json();
    return json;
}

Json candidateJson(const TuneCandidate& candidate) {
    Json json{{"pipeline", candidate.pipeline}, {"searched", figuresJson(candidate.searched)}};
    json["held_out"] = candidate.heldOut ? figuresJson(*candidate.heldOut) : Json();
    json["within_limits"] = candidate.isWithinLimits;
    return json;
}

std::string costText(const TuneFigures& figures, const std::string& clock) {
    std::string text = fmt::format("{:.1f} MiB", figures.memory_MiB);
    if (figures.time_ms) text = fmt::format("{:.2f} ms ({} clock) and ", *figures.time_ms, clock) + text;
    return text;
}

std::string changeText(double from, double to) {
    if (from == 0 || from == to) return "";
    const double percent = 100 * (to - from) / std::abs(from);
    return fmt::format(" ({:.1f} % {})", std::abs(percent), percent < 0 ? "less" : "more");
}

}  // namespace

std::string TuneResult::sentence() const {
    const auto figures = [](const TuneCandidate& c) { return c.heldOut.value_or(c.searched); };
    const std::string where = winner.heldOut ? "on the held-out cameras" : "on the cameras that were searched";
    const std::string begin = interrupted ? "Interrupted, not yet decided on the held-out cameras: " : "";
    if (pareto) {
        if (front.empty())
            return fmt::format("{}Nothing within the limits was found; the start, {}, has {} {:.4g} at {} {}.", begin,
                               start.pipeline, metric, figures(start).error, costText(figures(start), clock), where);
        const auto end = [&](const TuneCandidate& candidate) {
            return fmt::format("{} with {} {:.4g} at {}", candidate.pipeline, metric, figures(candidate).error,
                               costText(figures(candidate), clock));
        };
        if (front.size() == 1) return fmt::format("{}Nothing beats {} {}.", begin, end(front.front()), where);
        return fmt::format("{}Nothing beats these {} {}: from {} to {}.", begin, front.size(), where,
                           end(front.front()), end(front.back()));
    }
    const TuneFigures from = figures(start), to = figures(winner);
    if (!winner.isWithinLimits)
        return fmt::format("{}Nothing within the limits was found; the nearest is {}, with {} {:.4g} at {} {}.", begin,
                           winner.pipeline, metric, to.error, costText(to, clock), where);
    if (winner.pipeline == start.pipeline)
        return fmt::format("{}Keep {}: of {} candidates none is better {}, where it has {} {:.4g} at {}.", begin,
                           start.pipeline, searched.size(), where, metric, from.error, costText(from, clock));
    return fmt::format("{}Take {}: {} it has {} {:.4g} instead of {:.4g}{}, at {} instead of {}{}.", begin,
                       winner.pipeline, where, metric, to.error, from.error, changeText(from.error, to.error),
                       costText(to, clock), costText(from, clock),
                       start.isWithinLimits ? "" : ", which is outside the limits");
}

std::string TuneResult::json() const {
    Json json{{"schema", "ombrage/tune/1"},
              {"sentence", sentence()},
              {"metric", metric},
              {"lower_is_better", lowerIsBetter},
              {"parameters", parameters},
              {"start", candidateJson(start)},
              {"winner", pareto ? Json() : candidateJson(winner)},
              {"front", Json::array()},
              {"cases", Json::array()},
              {"candidates", Json::array()}};
    for (const TuneCandidate& candidate : front) json["front"].push_back(candidateJson(candidate));
    for (const TuneCase& one : cases)
        json["cases"].push_back({{"scene", one.scene},
                                 {"camera", one.camera},
                                 {"light", one.light.empty() ? Json() : Json(one.light)},
                                 {"held_out", one.isHeldOut},
                                 {"made", one.isMade}});
    for (const TuneCandidate& candidate : searched) json["candidates"].push_back(candidateJson(candidate));
    json["measured"] = measured;
    json["reused"] = reused;
    json["interrupted"] = interrupted;
    json["clock"] = clock;
    json["device"] = {{"renderer", device.renderer}, {"version", device.version}, {"software", device.software}};
    json["command"] = commandLine;
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace ombrage
