// SPDX-License-Identifier: MIT
#include "scene/mtl_file.h"

#include <algorithm>
#include <string_view>

#include "core/strings.h"

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

/// Reads the options in front of a map's path, and the path (the rest of the line: it may hold blanks).
std::string takeMap(std::string_view rest, float& bumpMultiplier) {
    for (;;) {
        std::string_view after = rest;
        const std::string option = toLower(takeWord(after));
        if (option == "-bm") {
            if (const auto numbers = takeNumbers(after, 1); !numbers.empty()) bumpMultiplier = float(numbers[0]);
        } else if (option == "-o" || option == "-s" || option == "-t") {
            takeNumbers(after, 3);
        } else if (option == "-mm") {
            takeNumbers(after, 2);
        } else if (option == "-boost" || option == "-texres") {
            takeNumbers(after, 1);
        } else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-clamp" ||
                   option == "-imfchan" || option == "-type") {
            takeWord(after);
        } else {
            return trim(rest);
        }
        rest = after;
    }
}

std::string_view nextLine(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\n\r"), text.size());
    const std::string_view line = text.substr(0, end);
    // A pair of carriage return and line feed ends one line.
    const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
    return line;
}
}  // namespace

MtlLibrary parseMtl(const std::string& text, const std::string& name, std::vector<std::string>& warnings) {
    MtlLibrary library;
    MtlMaterial* current = nullptr;
    std::string_view rest = text;
    for (int lineNumber = 1; !rest.empty(); ++lineNumber) {
        std::string_view line = nextLine(rest);
        const std::string key = toLower(takeWord(line));
        if (key == "newmtl") {
            current = &library[trim(line)];
            continue;
        }
        if (current == nullptr || key.empty() || key[0] == '#') continue;

        const auto complain = [&] {
            warnings.push_back(name + ":" + std::to_string(lineNumber) + ": '" + key + "' without its numbers");
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
        const auto number = [&](std::optional<float>& out) {
            const auto n = takeNumbers(line, 1);
            if (n.size() == 1)
                out = float(n[0]);
            else
                complain();
        };
        float ignored = 1.0f;
        if (key == "kd")
            color(current->diffuse);
        else if (key == "ks")
            color(current->specular);
        else if (key == "ke")
            color(current->emissive);
        else if (key == "ns")
            number(current->shininess);
        else if (key == "pr")
            number(current->roughness);
        else if (key == "pm")
            number(current->metallic);
        else if (key == "d")
            number(current->opacity);
        else if (key == "tr") {
            number(current->opacity);
            if (current->opacity) current->opacity = 1.0f - *current->opacity;
        } else if (key == "map_kd")
            current->diffuseMap = takeMap(line, ignored);
        else if (key == "map_d")
            current->opacityMap = takeMap(line, ignored);
        else if (key == "map_ke")
            current->emissiveMap = takeMap(line, ignored);
        else if (key == "map_bump" || key == "bump")
            current->heightMap = takeMap(line, current->bumpMultiplier);
        else if (key == "norm" || key == "map_norm" || key == "map_kn")
            current->normalMap = takeMap(line, ignored);
    }
    return library;
}

std::vector<std::string> mtlLibrariesOf(const std::string& objText) {
    std::vector<std::string> names;
    std::string_view rest = objText;
    while (!rest.empty()) {
        std::string_view line = nextLine(rest);
        if (line.find("mtllib") == std::string_view::npos || takeWord(line) != "mtllib") continue;
        const std::string file = trim(line);
        if (!file.empty() && std::find(names.begin(), names.end(), file) == names.end()) names.push_back(file);
    }
    return names;
}

}  // namespace ombrage
