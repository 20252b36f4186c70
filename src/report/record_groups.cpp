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

namespace {

/// What differs from a scene as it is.
std::string settingsText(const RunRecord& record) {
    return (record.time_s == 0 ? "" : ", at " + formatNumber(record.time_s) + " s") +
           (record.normals == "map" ? "" : ", normals of " + record.normals);
}

}  // namespace

std::string RecordGroup::place() const {
    const RunRecord& r = first();
    return r.scene + (r.light.empty() ? "" : ", light " + r.light) + settingsText(r) +
           (r.motion.empty() ? "" : ", under " + r.motion);
}

std::string RecordGroup::title() const {
    const RunRecord& r = first();
    return r.scene + ": " + r.family + (r.light.empty() ? "" : ", light " + r.light) + settingsText(r) +
           (r.motion.empty() ? "" : ", under " + r.motion) +
           (hasOwnTruth(r) ? ", against what each technique claims" : "");
}

std::vector<RecordGroup> groupRecords(const std::vector<RunRecord>& records) {
    using Key = std::tuple<std::string, std::string, std::string, std::string, std::string, double, std::string,
                           std::string, int, int, std::string>;
    std::vector<RecordGroup> groups;
    std::map<Key, std::size_t> places;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const RunRecord& r = records[i];
        const Key key{r.scene,
                      r.sceneHash,
                      r.family,
                      r.camera,
                      r.light,
                      r.time_s,
                      r.normals,
                      r.motion,
                      r.width,
                      r.height,
                      r.truth ? r.truth->kind : std::string()};
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
    std::vector<std::string> words{"ombrage", "compare"};
    // Records of earlier versions have their scene's name only; one that came from a file was asked for by the file.
    std::string scene = r.scene;
    for (const RunNote& note : notes)
        for (const std::string& word : note.command)
            if (word != r.scene && std::filesystem::path(word).stem() == r.scene) scene = word;
    if (r.asked.empty())
        words.push_back(scene);
    else
        words.insert(words.end(), r.asked.begin(), r.asked.end());
    words.insert(words.end(), {"--technique", r.pipeline, "--camera", r.camera});
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

std::string settingsFor(const RunRecord& r) {
    const auto quoted = [](const std::string& text) {
        std::string literal = "\"";
        for (const char c : text)
            literal += c == '\n' ? "\\n" : c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
        return literal + "\"";
    };
    std::string code = fmt::format("ombrage::RenderSettings settings;\nsettings.width = {};\nsettings.height = {};\n",
                                   r.width, r.height);
    code += "settings.camera = " + quoted(r.camera) + ";\n";
    if (!r.light.empty()) code += "settings.light = " + quoted(r.light) + ";\n";
    if (r.time_s != 0) code += "settings.time_s = " + formatNumber(r.time_s) + ";\n";
    if (r.normals != "map") {
        std::string source = r.normals;
        if (!source.empty() && source[0] >= 'a' && source[0] <= 'z') source[0] = char(source[0] - 'a' + 'A');
        code += "settings.normals = ombrage::NormalSource::" + source + ";\n";
    }
    code += fmt::format("settings.seed = {}u;\n", r.seed);
    std::string family = r.family;
    if (!family.empty() && family[0] >= 'a' && family[0] <= 'z') family[0] = char(family[0] - 'a' + 'A');
    return code + fmt::format("settings.{} = ombrage::parsePipeline(ombrage::Family::{}, {});", r.family, family,
                              quoted(r.pipeline));
}

}  // namespace ombrage
