// SPDX-License-Identifier: MIT
#include "lab/bench_plan.h"

#include <ombrage/error.h>
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/strings.h"
#include "lab/domain.h"
#include "lab/plan.h"

namespace ombrage {

namespace {

bool makesScene(const std::string& axis) {
    return axis == kTrianglesAxis || axis == kLightsAxis;
}

bool hasParam(const TechniqueSpec& spec, const std::string& key) {
    const auto params = resolveParams({spec.id, {}});
    return std::any_of(params.begin(), params.end(), [&](const auto& param) { return param.first == key; });
}

void setParam(TechniqueSpec& spec, const std::string& key, const std::string& value) {
    const auto same =
        std::find_if(spec.params.begin(), spec.params.end(), [&](const auto& param) { return param.first == key; });
    if (same != spec.params.end())
        same->second = value;
    else
        spec.params.emplace_back(key, value);
}

/// A whole number in a range. @throws Error(Usage)
int wholeNumber(const std::string& axis, const std::string& text, int minimum, int maximum) {
    long long value = 0;
    if (!parseInt(text, value) || value < minimum || value > maximum)
        throw Error(ErrorCode::Usage, "--sweep: '" + text + "' is no value of " + axis,
                    fmt::format("it takes whole numbers from {} to {}", minimum, maximum));
    return int(value);
}

/// A parameter that none of the techniques has would vary nothing.
void checkParam(const BenchRequest& request, const std::string& axis) {
    std::vector<std::string> keys{kSizeAxis, kTrianglesAxis, kLightsAxis};
    std::vector<std::pair<Family, Pipeline>> pipelines = request.pipelines;
    for (const Family family : request.allOf)
        for (auto& entry : pipelinesOf(family)) pipelines.push_back(entry);
    for (const auto& [family, pipeline] : pipelines)
        for (const TechniqueSpec& spec : pipeline)
            for (const auto& [key, value] : resolveParams({spec.id, {}})) keys.push_back(key);
    if (std::find(keys.begin(), keys.end(), axis) == keys.end())
        throw unknownName("axis in --sweep (a parameter of the techniques, size, triangles or lights)", axis, keys);
}

}  // namespace

BenchSweep parseSweep(const std::string& text) {
    const Error wrong(ErrorCode::Usage, "--sweep: '" + text + "' is not AXIS=A..B or AXIS=V,V,...",
                      "as in resolution=256..8192, which doubles, or size=360,720,1080");
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) throw wrong;
    BenchSweep sweep{text.substr(0, equals), {}};
    const std::string values = text.substr(equals + 1);
    const std::size_t dots = values.find("..");
    if (dots == std::string::npos) {
        sweep.values = split(values, ',');
        for (std::size_t i = 0; i < sweep.values.size(); ++i) {
            if (sweep.values[i].empty()) throw wrong;
            if (std::find(sweep.values.begin(), sweep.values.begin() + std::ptrdiff_t(i), sweep.values[i]) !=
                sweep.values.begin() + std::ptrdiff_t(i))
                throw Error(ErrorCode::Usage, "--sweep: '" + sweep.values[i] + "' stands twice in '" + text + "'",
                            "as in size=360,720,1080");
        }
    } else {
        double from = 0, to = 0;
        if (!parseDouble(values.substr(0, dots), from) || !parseDouble(values.substr(dots + 2), to) || from <= 0 ||
            to < from || to / from > 1e9)
            throw wrong;
        for (double value = from; value <= to; value *= 2) sweep.values.push_back(formatNumber(value));
    }
    return sweep;
}

double parseSlowdown(const std::string& text) {
    double percent = 0;
    if (text.size() < 3 || text.front() != '+' || text.back() != '%' ||
        !parseDouble(text.substr(1, text.size() - 2), percent) || percent < 0)
        throw Error(ErrorCode::Usage, "--fail-on: '" + text + "' is not a slowdown", "write it as +5%");
    return percent / 100;
}

std::vector<BenchPoint> benchPoints(const BenchRequest& request) {
    BenchPoint plain;
    plain.width = request.base.width;
    plain.height = request.base.height;
    if (!request.sweep) return {plain};
    const std::string& axis = request.sweep->axis;
    checkParam(request, axis);
    if (makesScene(axis) != request.scenes.empty())
        throw Error(ErrorCode::Usage,
                    makesScene(axis) ? "a sweep over " + axis + " makes its own scenes" : "no scene to measure on",
                    makesScene(axis) ? "leave the scene out" : "'ombrage list scenes' shows the built-in ones");
    std::vector<BenchPoint> points;
    for (const std::string& value : request.sweep->values) {
        BenchPoint point = plain;
        point.value = value;
        if (!parseDouble(value, point.x)) point.x = double(points.size() + 1);
        if (axis == kSizeAxis) {
            point.height = wholeNumber(axis, value, 1, 16384);
            point.width = std::clamp(int(std::lround(double(plain.width) * point.height / plain.height)), 1, 16384);
        } else if (axis == kTrianglesAxis) {
            point.triangles = std::size_t(wholeNumber(axis, value, 1000, 50'000'000));
            point.lights = 1;
        } else if (axis == kLightsAxis) {
            // Few triangles, so that the lights are what costs.
            point.triangles = 5000;
            point.lights = wholeNumber(axis, value, 1, 4096);
        } else {
            point.params = {{axis, value}};
        }
        points.push_back(point);
    }
    return points;
}

std::vector<BenchVariant> benchVariants(const BenchRequest& request, const Scene& scene, const BenchPoint& point,
                                        std::vector<SkippedPair>& skipped) {
    std::vector<BenchVariant> variants;
    std::map<std::string, int> seen;
    const auto add = [&](Family family, Pipeline pipeline, bool named) {
        if (family == Family::Shadow)
            for (const int light : chosenLights(scene, request.base.light)) {
                const std::string reason = unsupportedReason(pipeline, scene.lights[std::size_t(light)]);
                if (reason.empty()) continue;
                if (named)
                    throw Error(ErrorCode::Usage, reason + " of the scene '" + scene.name + "'",
                                "choose another light with --light or another technique");
                skipped.push_back({scene.name, techniqueText(pipeline), reason});
                return;
            }
        // Along a sweep a pipeline keeps the name that it was asked for by.
        const std::string text = toString(pipeline);
        const int count = ++seen[text];
        for (const auto& [key, value] : point.params)
            for (TechniqueSpec& spec : pipeline)
                if (hasParam(spec, key)) {
                    setParam(spec, key, value);
                    resolveParams(spec);  // checks the value
                }
        variants.push_back({family, std::move(pipeline), count == 1 ? text : fmt::format("{} (#{})", text, count)});
    };
    for (const auto& [family, pipeline] : request.pipelines) add(family, pipeline, true);
    for (const Family all : request.allOf)
        for (const auto& [family, pipeline] : pipelinesOf(all)) add(family, pipeline, false);
    return variants;
}

}  // namespace ombrage
