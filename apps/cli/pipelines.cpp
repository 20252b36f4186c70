// SPDX-License-Identifier: MIT
#include "pipelines.h"

#include <ombrage/error.h>
#include <algorithm>

#include "options.h"

namespace ombrage::cli {

namespace {

/// "--filter" may leave its family out; behind '+' a pipeline may not.
Pipeline filterPipeline(const std::string& text) {
    const std::string id = text.substr(0, text.find_first_of(":+"));
    const Pipeline filters = parsePipeline(Family::Filter, technique(Family::Filter, id).id + text.substr(id.size()));
    for (const TechniqueSpec& spec : filters)
        if (technique(spec.id).family != Family::Filter)
            throw Error(ErrorCode::Usage, "--filter: " + spec.id + " is not a filter",
                        "'ombrage list --family filter' shows them");
    return filters;
}

/// Puts the value of "ID.param=value" into every place where the technique is in use.
void applySet(const std::string& text, const std::vector<Pipeline*>& pipelines) {
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.substr(0, equals).rfind('.');
    if (equals == std::string::npos || dot == std::string::npos || dot == 0)
        throw Error(ErrorCode::Usage, "--set: '" + text + "' is not ID.param=value");
    const std::string id = text.substr(0, dot), key = text.substr(dot + 1, equals - dot - 1),
                      value = text.substr(equals + 1);

    // A name without its family means whatever is in use under that name.
    std::vector<std::string> known;
    bool found = false, exists = false;
    for (const TechniqueInfo& info : techniques()) {
        known.push_back(info.id);
        exists = exists || info.id == id || info.name == id;
    }
    if (!exists) throw unknownName("technique in --set", id, known);
    for (Pipeline* pipeline : pipelines)
        for (TechniqueSpec& spec : *pipeline) {
            if (spec.id != id && technique(spec.id).name != id) continue;
            found = true;
            const auto same = std::find_if(spec.params.begin(), spec.params.end(),
                                           [&](const auto& param) { return param.first == key; });
            if (same != spec.params.end())
                same->second = value;
            else
                spec.params.emplace_back(key, value);
            resolveParams(spec);  // checks the key and the value
        }
    if (!found)
        throw Error(ErrorCode::Usage, "--set: " + id + " is not in use",
                    "choose it first with the option of its family");
}

}  // namespace

void setPipelines(const Options& options, RenderSettings& settings) {
    const auto take = [&](const char* key, Family family, Pipeline& place) {
        if (options.has(key)) place = parsePipeline(family, options.text(key));
    };
    take("shadow", Family::Shadow, settings.shadow);
    take("ao", Family::Ao, settings.ao);
    take("indirect", Family::Indirect, settings.indirect);
    take("aa", Family::Aa, settings.aa);
    if (options.has("filter")) {
        const Pipeline filters = filterPipeline(options.text("filter"));
        const bool cleansShadow = !options.has("ao") && options.has("shadow");
        Pipeline& place = cleansShadow ? settings.shadow : settings.ao;
        place.insert(place.end(), filters.begin(), filters.end());
    }
    for (const std::string& text : options.texts("set"))
        applySet(text, {&settings.shadow, &settings.ao, &settings.indirect, &settings.aa});
}

}  // namespace ombrage::cli
