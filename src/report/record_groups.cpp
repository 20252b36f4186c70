// SPDX-License-Identifier: MIT
#include "report/record_groups.h"

#include <fmt/format.h>
#include <ombrage/truth_kind.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "core/strings.h"

namespace ombrage {

std::string RecordGroup::place() const {
    const RunRecord& r = first();
    return r.scene + (r.light.empty() ? "" : ", light " + r.light) + (r.motion.empty() ? "" : ", under " + r.motion);
}

std::string RecordGroup::title() const {
    const RunRecord& r = first();
    return r.scene + ": " + r.family + (r.light.empty() ? "" : ", light " + r.light) +
           (r.motion.empty() ? "" : ", under " + r.motion) +
           (hasOwnTruth(r) ? ", against what each technique claims" : "");
}

std::vector<RecordGroup> groupRecords(const std::vector<RunRecord>& records) {
    using Key =
        std::tuple<std::string, std::string, std::string, std::string, std::string, std::string, int, int, std::string>;
    std::vector<RecordGroup> groups;
    std::map<Key, std::size_t> places;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const RunRecord& r = records[i];
        const Key key{r.scene,  r.sceneHash, r.family,
                      r.camera, r.light,     r.motion,
                      r.width,  r.height,    r.truth ? r.truth->kind : std::string()};
        const auto [place, isNew] = places.emplace(key, groups.size());
        if (isNew) groups.emplace_back();
        groups[place->second].records.push_back(&r);
        groups[place->second].indices.push_back(i);
    }
    return groups;
}

bool hasOwnTruth(const RunRecord& record) {
    return record.truth && record.truth->kind == truthKindName(TruthKind::Own);
}

std::optional<double> metricOf(const RunRecord& record, const std::string& key) {
    const auto found = record.metrics.find(key);
    return found == record.metrics.end() ? std::nullopt : found->second;
}

std::string shellQuoted(const std::string& word) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./=,:+").find(c) != std::string_view::npos;
    });
    if (plain) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string commandFor(const RunRecord& r, const std::vector<RunNote>& notes) {
    // A record has its scene's name; a scene that came from a file is asked for by the file.
    std::string scene = r.scene;
    for (const RunNote& note : notes)
        for (const std::string& word : note.command)
            if (word != r.scene && std::filesystem::path(word).stem() == r.scene) scene = word;
    std::vector<std::string> words{"ombrage", "compare", scene, "--technique", r.pipeline, "--camera", r.camera};
    const auto add = [&](const std::string& option, const std::string& value) {
        words.insert(words.end(), {option, value});
    };
    if (!r.light.empty()) add("--light", r.light);
    add("--size", fmt::format("{}x{}", r.width, r.height));
    add("--seed", std::to_string(r.seed));
    if (r.truth) {
        add("--truth", r.truth->kind);
        add("--spp", std::to_string(r.truth->spp));
    }
    if (!r.motion.empty()) add("--motion", r.motion);
    add("-o", "again");
    for (std::string& word : words) word = shellQuoted(word);
    return join(words, " ");
}

}  // namespace ombrage
