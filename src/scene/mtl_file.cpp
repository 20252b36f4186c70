// SPDX-License-Identifier: MIT
#include "scene/mtl_file.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "core/strings.h"
#include "scene/text_lines.h"

namespace ombrage {

namespace {
constexpr std::string_view kBlanks = " \t\r\f\v";

/// Takes the next word off the front of `rest`.
std::string_view takeWord(std::string_view& rest) {
    const std::size_t begin = std::min(rest.find_first_not_of(kBlanks), rest.size());
    const std::size_t end = std::min(rest.find_first_of(kBlanks, begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

std::vector<double> takeNumbers(std::string_view& rest, std::size_t most) {
    std::vector<double> numbers;
    while (numbers.size() < most) {
        std::string_view after = rest;
        double value = 0;
        const std::string_view word = takeWord(after);
        if (word.empty() || !parseDouble(word, value)) break;
        numbers.push_back(value);
        rest = after;
    }
    return numbers;
}

/// Takes an option and its values off the front of `rest`; false when there is none.
bool takeOption(std::string_view& rest, MtlMap& map) {
    std::string_view after = rest;
    const std::string option = toLower(takeWord(after));
    if (option == "-bm") {
        if (const auto n = takeNumbers(after, 1); !n.empty()) map.bumpMultiplier = float(n[0]);
    } else if (option == "-o" || option == "-s") {
        glm::vec2& target = option == "-s" ? map.scale : map.offset;
        const auto n = takeNumbers(after, 3);
        for (std::size_t i = 0; i < std::min<std::size_t>(2, n.size()); ++i) target[int(i)] = float(n[i]);
    } else if (option == "-clamp") {
        map.clamp = toLower(takeWord(after)) == "on";
    } else if (option == "-t") {
        takeNumbers(after, 3);
    } else if (option == "-mm") {
        takeNumbers(after, 2);
    } else if (option == "-boost" || option == "-texres") {
        takeNumbers(after, 1);
    } else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-imfchan" ||
               option == "-type") {
        takeWord(after);
    } else {
        return false;
    }
    rest = after;
    return true;
}

/// Reads the options of a map and its path, which may hold blanks: the options stand before it, in some files behind.
MtlMap readMap(std::string_view rest) {
    MtlMap map;
    while (takeOption(rest, map)) {
    }
    for (std::size_t at = rest.find(" -"); at != std::string_view::npos; at = rest.find(" -", at + 1)) {
        std::string_view behind = rest.substr(at);
        MtlMap changed = map;
        bool options = takeOption(behind, changed);
        while (options && takeOption(behind, changed)) {
        }
        if (!options || !trim(behind).empty()) continue;
        map = changed;
        rest = rest.substr(0, at);
        break;
    }
    map.file = trim(rest);
    return map;
}
}  // namespace

MtlLibrary parseMtl(const std::string& text, const std::string& name, std::vector<std::string>& warnings) {
    MtlLibrary library;
    MtlMaterial* current = nullptr;
    TextLines lines(text);
    std::string_view line;
    while (lines.next(line)) {
        const std::string key = toLower(takeWord(line));
        if (key == "newmtl") {
            current = &library[trim(line)];
            continue;
        }
        if (current == nullptr || key.empty() || key[0] == '#') continue;

        const auto complain = [&] {
            warnings.push_back(name + ":" + std::to_string(lines.number()) + ": '" + key + "' without its numbers");
        };
        const auto color = [&](std::optional<glm::vec3>& out) {
            const auto n = takeNumbers(line, 3);
            if (n.size() == 3)
                out = glm::vec3(float(n[0]), float(n[1]), float(n[2]));
            else if (n.size() == 1)
                out = glm::vec3(float(n[0]));
            else
                complain();
        };
        const auto number = [&](std::optional<float>& out, float largest) {
            const auto n = takeNumbers(line, 1);
            if (n.size() != 1) return complain();
            const float value = float(n[0]), used = value >= 0.0f ? std::min(value, largest) : 0.0f;
            out = used;
            if (used != value)
                warnings.push_back(fmt::format("{}:{}: '{}' of {} is out of its range; {} is used", name,
                                               lines.number(), key, value, used));
        };
        if (key == "kd")
            color(current->diffuse);
        else if (key == "ks")
            color(current->specular);
        else if (key == "ke")
            color(current->emissive);
        else if (key == "ns")
            number(current->shininess, std::numeric_limits<float>::max());
        else if (key == "pr")
            number(current->roughness, 1.0f);
        else if (key == "pm")
            number(current->metallic, 1.0f);
        else if (key == "d")
            number(current->opacity, 1.0f);
        else if (key == "tr") {
            number(current->opacity, 1.0f);
            if (current->opacity) current->opacity = 1.0f - *current->opacity;
        } else if (key == "map_kd")
            current->diffuseMap = readMap(line);
        else if (key == "map_d")
            current->opacityMap = readMap(line);
        else if (key == "map_ke")
            current->emissiveMap = readMap(line);
        else if (key == "map_bump" || key == "bump")
            current->heightMap = readMap(line);
        else if (key == "norm" || key == "map_norm" || key == "map_kn")
            current->normalMap = readMap(line);
    }
    return library;
}

}  // namespace ombrage
