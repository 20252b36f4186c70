// SPDX-License-Identifier: MIT
#include <ombrage/json_lines.h>

#include <algorithm>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

namespace ombrage {

namespace {
/// Deeper nesting is refused: nothing needs it, and pointers would grow without bound.
constexpr std::size_t kDeepest = 32;

int lineOfByte(const std::string& text, std::size_t byte) {
    const std::size_t end = std::min(byte, text.size());
    return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n'));
}

/// What the parser says, without its "[json.exception...] parse error at line 3, column 4: " prefix.
std::string plainMessage(const std::string& what) {
    std::string text = what;
    if (!text.empty() && text[0] == '[') text.erase(0, text.find("] ") + 2);
    if (text.rfind("parse error", 0) == 0 && text.find(": ") != std::string::npos) text.erase(0, text.find(": ") + 2);
    return text;
}

/// The place of a number that is out of range: the parser quotes it, and says no more.
std::size_t placeOfQuoted(const std::string& text, const std::string& what) {
    const std::size_t begin = what.find('\''), end = what.rfind('\'');
    if (begin == std::string::npos || end <= begin + 1) return 0;
    const std::size_t found = text.find(what.substr(begin + 1, end - begin - 1));
    return found == std::string::npos ? 0 : found;
}

void requireSyntax(const std::string& file, const std::string& text) {
    const auto fail = [&](std::size_t byte, const std::string& message) {
        throw Error(ErrorCode::Input, "not valid JSON: " + message, {},
                    file + ":" + std::to_string(lineOfByte(text, byte)));
    };
    // The parser takes a zero byte for the end of the text and drops what follows.
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) fail(zero, "the text holds a zero byte");
    try {
        [[maybe_unused]] const auto parsed = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& e) {
        fail(e.byte > 0 ? e.byte - 1 : 0, plainMessage(e.what()));
    } catch (const nlohmann::json::exception& e) {
        fail(placeOfQuoted(text, e.what()), plainMessage(e.what()));
    }
}
}  // namespace

std::string escapedKey(const std::string& key) {
    std::string escaped;
    for (const char c : key) {
        if (c == '~')
            escaped += "~0";
        else if (c == '/')
            escaped += "~1";
        else
            escaped += c;
    }
    return escaped;
}

JsonLines::JsonLines(std::string file, const std::string& text) : m_file(std::move(file)) {
    requireSyntax(m_file, text);
    index(text);
}

void JsonLines::index(const std::string& text) {
    // The text is valid JSON, so brackets, commas and strings alone tell where each value begins.
    struct Level {
        bool isObject;
        std::string pointer;
        std::size_t index = 0;
        std::string key;
        bool expectsKey;
        std::set<std::string> seen;
    };
    std::vector<Level> levels;
    int line = 1;
    const auto pointerHere = [&] {
        if (levels.empty()) return std::string();
        const Level& level = levels.back();
        return level.pointer + "/" + (level.isObject ? escapedKey(level.key) : std::to_string(level.index));
    };
    const auto stringEnd = [&](std::size_t start) {
        std::size_t i = start + 1;
        while (text[i] != '"') i += text[i] == '\\' ? 2 : 1;
        return i;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n')
            ++line;
        else if (c == '"' && !levels.empty() && levels.back().isObject && levels.back().expectsKey) {
            // A member's name; names that occur twice would hide a value.
            const std::size_t end = stringEnd(i);
            Level& level = levels.back();
            level.key = nlohmann::json::parse(text.substr(i, end + 1 - i)).get<std::string>();
            level.expectsKey = false;
            const std::string pointer = pointerHere();
            m_lines[pointer] = line;
            if (!level.seen.insert(level.key).second)
                throw error(pointer, "the key '" + level.key + "' is given twice", "keep one of the two");
            i = end;
        } else if (c == '{' || c == '[') {
            const std::string pointer = pointerHere();
            m_lines[pointer] = line;
            if (levels.size() >= kDeepest)
                throw error(pointer, "nested more than " + std::to_string(kDeepest) + " deep");
            levels.push_back({c == '{', pointer, 0, {}, c == '{', {}});
        } else if (c == '}' || c == ']') {
            levels.pop_back();
        } else if (c == ',') {
            ++levels.back().index;
            levels.back().expectsKey = levels.back().isObject;
        } else if (c == '"' || c == '-' || (c >= '0' && c <= '9') || c == 't' || c == 'f' || c == 'n') {
            m_lines[pointerHere()] = line;
            if (c == '"')
                i = stringEnd(i);
            else
                i = std::min(text.find_first_of(",]} \t\r\n", i), text.size()) - 1;
        }
    }
}

std::string JsonLines::where(const std::string& pointer) const {
    const auto found = m_lines.find(pointer);
    const int line = found == m_lines.end() ? 1 : found->second;
    return m_file + ":" + std::to_string(line) + ": " + (pointer.empty() ? "/" : pointer);
}

Error JsonLines::error(const std::string& pointer, const std::string& message, const std::string& hint) const {
    return Error(ErrorCode::Input, message, hint, where(pointer));
}

}  // namespace ombrage
