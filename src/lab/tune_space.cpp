// SPDX-License-Identifier: MIT
#include "lab/tune_space.h"

#include <ombrage/error.h>
#include <algorithm>
#include <set>

#include "core/strings.h"

namespace ombrage::tuning {

namespace {

/// Nothing where the search leaves the parameter alone.
std::optional<Dimension> dimensionOf(const ParamInfo& info) {
    switch (info.type) {
        case ParamType::Bool:
            return Dimension{Dimension::Kind::Choice, 0, 0, false, 2};
        case ParamType::Enum:
            if (info.choices.size() < 2) return {};
            return Dimension{Dimension::Kind::Choice, 0, 0, false, int(info.choices.size())};
        case ParamType::Int:
        case ParamType::Float:
            break;
        case ParamType::Vec3:
            return {};
    }
    if (info.tuneMinimum >= info.tuneMaximum) return {};
    return Dimension{info.type == ParamType::Int ? Dimension::Kind::Integer : Dimension::Kind::Real, info.tuneMinimum,
                     info.tuneMaximum, info.scale == Scale::Log && info.tuneMinimum > 0, 0};
}

double numberOf(const ParamInfo& info, const ParamValue& value) {
    if (const bool* on = std::get_if<bool>(&value)) return *on ? 1 : 0;
    if (const std::int64_t* whole = std::get_if<std::int64_t>(&value)) return double(*whole);
    if (const double* real = std::get_if<double>(&value)) return *real;
    const auto found = std::find(info.choices.begin(), info.choices.end(), std::get<std::string>(value));
    return double(found - info.choices.begin());
}

std::string textOf(const ParamInfo& info, double value) {
    switch (info.type) {
        case ParamType::Bool:
            return value != 0 ? "true" : "false";
        case ParamType::Enum:
            return info.choices.at(std::size_t(value));
        default:
            return formatNumber(value);
    }
}

}  // namespace

Space::Space(const Pipeline& start, const std::vector<std::string>& keep) : m_start(start) {
    std::set<std::string> unused(keep.begin(), keep.end());
    std::vector<std::string> known;
    for (std::size_t element = 0; element < start.size(); ++element)
        for (const ParamInfo& info : technique(start[element].id).params) {
            const std::string name = start[element].id + "." + info.key;
            known.insert(known.end(), {info.key, name});
            const bool isKept = std::any_of(keep.begin(), keep.end(),
                                            [&](const std::string& kept) { return kept == info.key || kept == name; });
            unused.erase(info.key);
            unused.erase(name);
            const std::optional<Dimension> dimension = dimensionOf(info);
            if (isKept || !dimension) continue;
            m_dimensions.push_back(*dimension);
            m_places.push_back({element, info});
        }
    if (!unused.empty()) throw unknownName("parameter to keep", *unused.begin(), known);
    if (m_dimensions.empty())
        throw Error(ErrorCode::Usage, "'" + toString(start) + "' has no parameter to vary",
                    "'ombrage list params ID' shows what a technique has");
}

std::vector<std::string> Space::names() const {
    std::vector<std::string> names;
    for (const Place& place : m_places) names.push_back(m_start[place.element].id + "." + place.info.key);
    return names;
}

Point Space::valuesOf(const Pipeline& pipeline) const {
    Point point;
    for (const Place& place : m_places)
        for (const auto& [key, value] : resolveParams(pipeline[place.element]))
            if (key == place.info.key) point.push_back(numberOf(place.info, value));
    return point;
}

Point Space::start() const {
    return valuesOf(m_start);
}

Point Space::defaults() const {
    Point point;
    for (const Place& place : m_places) point.push_back(numberOf(place.info, place.info.defaultValue));
    return point;
}

Pipeline Space::at(const Point& point) const {
    Pipeline pipeline = m_start;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        auto& params = pipeline[m_places[i].element].params;
        const std::string& key = m_places[i].info.key;
        const std::string text = textOf(m_places[i].info, point[i]);
        const auto same = std::find_if(params.begin(), params.end(), [&](const auto& p) { return p.first == key; });
        if (same != params.end())
            same->second = text;
        else
            params.emplace_back(key, text);
    }
    for (const TechniqueSpec& spec : pipeline) resolveParams(spec);
    return pipeline;
}

}  // namespace ombrage::tuning
