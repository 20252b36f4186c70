// SPDX-License-Identifier: MIT
#include "lab/gate.h"

#include <ombrage/error.h>
#include <algorithm>

#include "core/strings.h"

namespace ombrage {

namespace {

/// The text up to the first parameter or the next technique of a pipeline.
std::string firstId(const std::string& text) {
    return text.substr(0, text.find_first_of(":+"));
}

}  // namespace

std::pair<Family, Pipeline> parseTechnique(const std::string& text) {
    const std::string id = firstId(text);
    const std::size_t slash = id.find('/');
    std::optional<Family> family;
    if (slash != std::string::npos) {
        family = familyFromName(id.substr(0, slash));
    } else {
        // A bare name is enough where one family alone has it.
        std::vector<std::string> matches, all;
        for (const TechniqueInfo& info : techniques()) {
            all.push_back(info.id);
            if (info.name != id) continue;
            family = info.family;
            matches.push_back(info.id);
        }
        if (matches.size() > 1)
            throw Error(ErrorCode::Usage, "the technique '" + id + "' exists in several families",
                        "say which: " + join(matches, ", "));
        if (matches.empty()) throw unknownName("technique", id, all);
    }
    Pipeline pipeline = parsePipeline(*family, text);
    if (*family == Family::Filter) {
        const std::string example = RenderSettings{}.ao.front().id;
        throw Error(ErrorCode::Usage, "'" + text + "' has nothing to filter",
                    "put what it cleans before it, as in " + example + "+" + pipeline.front().id);
    }
    return {*family, std::move(pipeline)};
}

Gate parseGate(const std::string& text) {
    Gate gate;
    gate.text = text;
    const std::size_t op = text.find_first_of("<>");
    if (op == std::string::npos)
        throw Error(ErrorCode::Usage, "the gate '" + text + "' has no '>' or '<'",
                    "write it as METRIC>NUMBER or ID.METRIC>NUMBER");
    gate.op = text[op];
    gate.orEqual = op + 1 < text.size() && text[op + 1] == '=';
    if (const std::string number = trim(text.substr(op + (gate.orEqual ? 2 : 1))); !parseDouble(number, gate.bound))
        throw Error(ErrorCode::Usage, "'" + number + "' in the gate '" + text + "' is not a number",
                    "write it as METRIC>NUMBER");
    // What stands before the last dot names a technique; parameters may hold dots of their own.
    const std::string left = trim(text.substr(0, op));
    const std::size_t dot = left.rfind('.');
    gate.metric = dot == std::string::npos ? left : left.substr(dot + 1);
    if (dot != std::string::npos) gate.technique = toString(parseTechnique(left.substr(0, dot)).second);
    std::vector<std::string> keys;
    for (const MetricInfo& info : metricInfos()) keys.push_back(info.key);
    if (std::find(keys.begin(), keys.end(), gate.metric) == keys.end()) throw unknownName("metric", gate.metric, keys);
    return gate;
}

std::optional<std::string> metGate(const Gate& gate, const RunRecord& record) {
    if (!gate.technique.empty() && gate.technique != record.pipeline && gate.technique != record.technique) return {};
    const auto found = record.metrics.find(gate.metric);
    if (found == record.metrics.end() || !found->second) return {};
    const double value = *found->second;
    const bool met =
        (gate.orEqual && value == gate.bound) || (gate.op == '>' ? value > gate.bound : value < gate.bound);
    if (!met) return {};
    std::string where = record.scene + ", camera " + record.camera;
    if (!record.light.empty()) where += ", light " + record.light;
    return record.pipeline + " on " + where + ": " + gate.metric + " is " + formatNumber(value) +
           ", which meets the gate " + gate.text;
}

}  // namespace ombrage
