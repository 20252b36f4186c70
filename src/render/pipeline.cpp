// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/technique.h>

#include "core/strings.h"
#include "render/technique.h"

namespace ombrage {

namespace {

/// Splits at a separator, but not inside parentheses: vectors are written (a;b;c).
std::vector<std::string> splitOutside(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == separator && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

TechniqueSpec parseSpec(Family family, const std::string& text, bool first) {
    const std::size_t colon = text.find(':');
    const std::string name = trim(text.substr(0, colon));
    if (name.empty())
        throw Error(ErrorCode::Usage, fmt::format("'{}' names no technique", text), "write FAMILY/NAME:key=value,key=value");
    if (!first && name.find('/') == std::string::npos)
        throw Error(ErrorCode::Usage, fmt::format("'{}' after '+' needs its family", name), "write FAMILY/NAME, as in filter/NAME");

    TechniqueSpec spec{technique(family, name).id, {}};
    if (colon == std::string::npos) return spec;
    const TechniqueEntry& entry = techniqueEntry(spec.id);
    for (const std::string& pair : splitOutside(text.substr(colon + 1), ',')) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos)
            throw Error(ErrorCode::Usage, fmt::format("{}: '{}' is not key=value", spec.id, pair), "separate parameters by ','");
        const std::string key = trim(pair.substr(0, equals)), value = trim(pair.substr(equals + 1));
        ParamTable::parse(entry.table().find(key, spec.id).info, value, spec.id);
        for (const auto& known : spec.params)
            if (known.first == key) throw Error(ErrorCode::Usage, fmt::format("{}: {} is given twice", spec.id, key));
        spec.params.emplace_back(key, value);
    }
    return spec;
}

}  // namespace

Pipeline parsePipeline(Family family, const std::string& text) {
    Pipeline pipeline;
    for (const std::string& part : splitOutside(text, '+')) pipeline.push_back(parseSpec(family, part, pipeline.empty()));
    return pipeline;
}

std::vector<std::pair<std::string, ParamValue>> resolveParams(const TechniqueSpec& spec) {
    const TechniqueEntry& entry = techniqueEntry(spec.id);
    for (const auto& [key, text] : spec.params) entry.table().find(key, spec.id);
    std::vector<std::pair<std::string, ParamValue>> resolved;
    for (const ParamField& field : entry.table().fields()) {
        ParamValue value = field.info.defaultValue;
        for (const auto& [key, text] : spec.params)
            if (key == field.info.key) value = ParamTable::parse(field.info, text, spec.id);
        resolved.emplace_back(field.info.key, std::move(value));
    }
    return resolved;
}

std::string toString(const Pipeline& pipeline) {
    std::vector<std::string> parts;
    for (const TechniqueSpec& spec : pipeline) {
        const TechniqueEntry& entry = techniqueEntry(spec.id);
        std::vector<std::string> pairs;
        const auto resolved = resolveParams(spec);
        for (std::size_t i = 0; i < resolved.size(); ++i)
            if (!(resolved[i].second == entry.table().fields()[i].info.defaultValue))
                pairs.push_back(resolved[i].first + "=" + toString(resolved[i].second));
        parts.push_back(pairs.empty() ? spec.id : spec.id + ":" + join(pairs, ","));
    }
    return join(parts, "+");
}

}  // namespace ombrage
