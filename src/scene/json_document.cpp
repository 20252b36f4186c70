// SPDX-License-Identifier: MIT
#include "scene/json_document.h"

#include <algorithm>
#include <set>

#include "core/strings.h"

namespace ombrage {

namespace {
/// Deeper nesting is refused: no scene needs it, and pointers would grow without bound.
constexpr std::size_t kDeepest = 32;

std::string escapeKey(const std::string& key) {
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

int lineOfByte(const std::string& text, std::size_t byte) {
    const std::size_t end = std::min(byte, text.size());
    return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n'));
}

const char* typeName(const nlohmann::json& value) {
    if (value.is_number()) return "a number";
    if (value.is_string()) return "a text";
    if (value.is_boolean()) return "true or false";
    if (value.is_array()) return "a list";
    if (value.is_object()) return "an object";
    return "null";
}

/// What nlohmann says, without its "[json.exception...] parse error at line 3, column 4: " prefix.
std::string syntaxMessage(const std::string& what) {
    const std::size_t cut = what.find(": ");
    return cut == std::string::npos ? what : what.substr(cut + 2);
}
}  // namespace

JsonDocument::JsonDocument(std::string file, const std::string& text) : m_file(std::move(file)) {
    try {
        m_root = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& e) {
        const std::size_t byte = e.byte > 0 ? e.byte - 1 : 0;
        throw Error(ErrorCode::Input, "not valid JSON: " + syntaxMessage(e.what()), {},
                    m_file + ":" + std::to_string(lineOfByte(text, byte)));
    } catch (const nlohmann::json::exception& e) {
        throw Error(ErrorCode::Input, "not valid JSON: " + syntaxMessage(e.what()), {}, m_file);
    }
    indexLines(text);
}

void JsonDocument::indexLines(const std::string& text) {
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
        return level.pointer + "/" + (level.isObject ? escapeKey(level.key) : std::to_string(level.index));
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

Error JsonDocument::error(const std::string& pointer, const std::string& message, const std::string& hint) const {
    const auto found = m_lines.find(pointer);
    const int line = found == m_lines.end() ? 1 : found->second;
    return Error(ErrorCode::Input, message, hint,
                 m_file + ":" + std::to_string(line) + ": " + (pointer.empty() ? "/" : pointer));
}

Error JsonNode::error(const std::string& message, const std::string& hint) const {
    return m_document->error(m_pointer, message, hint);
}

void JsonNode::requireObject() const {
    if (!m_value->is_object()) throw error(std::string("expected an object, found ") + typeName(*m_value));
}

void JsonNode::requireKeys(const std::string& what, const std::vector<std::string>& known) const {
    requireObject();
    for (const auto& [key, value] : m_value->items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string nearest = nearestName(key, known);
        const std::string hint =
            nearest.empty() ? "known keys: " + join(known, ", ") : "did you mean '" + nearest + "'?";
        throw m_document->error(m_pointer + "/" + escapeKey(key), what + " has no key '" + key + "'", hint);
    }
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
    requireObject();
    const auto found = m_value->find(key);
    if (found == m_value->end()) return std::nullopt;
    return JsonNode(*m_document, *found, m_pointer + "/" + escapeKey(key));
}

JsonNode JsonNode::at(const std::string& key) const {
    const std::optional<JsonNode> node = find(key);
    if (!node) throw error("the key '" + key + "' is missing");
    return *node;
}

std::vector<JsonNode> JsonNode::elements() const {
    if (!m_value->is_array()) throw error(std::string("expected a list, found ") + typeName(*m_value));
    std::vector<JsonNode> nodes;
    for (std::size_t i = 0; i < m_value->size(); ++i)
        nodes.push_back(JsonNode(*m_document, (*m_value)[i], m_pointer + "/" + std::to_string(i)));
    return nodes;
}

bool JsonNode::boolean() const {
    if (!m_value->is_boolean()) throw error(std::string("expected true or false, found ") + typeName(*m_value));
    return m_value->get<bool>();
}

std::string JsonNode::text() const {
    if (!m_value->is_string()) throw error(std::string("expected a text, found ") + typeName(*m_value));
    return m_value->get<std::string>();
}

std::string JsonNode::name() const {
    const std::string value = text();
    if (trim(value).empty()) throw error("the text is empty");
    return value;
}

std::string JsonNode::choice(const std::string& kind, const std::vector<std::string>& choices) const {
    const std::string value = text();
    if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
        const Error unknown = unknownName(kind, value, choices);
        throw error(unknown.message(), unknown.hint());
    }
    return value;
}

double JsonNode::number(double minimum, double maximum) const {
    if (!m_value->is_number()) throw error(std::string("expected a number, found ") + typeName(*m_value));
    const double value = m_value->get<double>();
    if (!(value >= minimum && value <= maximum))
        throw error(formatNumber(value) + " is out of range",
                    "from " + formatNumber(minimum) + " to " + formatNumber(maximum));
    return value;
}

double JsonNode::numberAbove(double minimum, double maximum) const {
    const double value = number(minimum, maximum);
    if (!(value > minimum))
        throw error(formatNumber(value) + " is out of range",
                    "more than " + formatNumber(minimum) + ", at most " + formatNumber(maximum));
    return value;
}

std::vector<double> JsonNode::numbers(std::size_t count, double minimum, double maximum) const {
    const std::vector<JsonNode> nodes = elements();
    if (nodes.size() != count)
        throw error("expected " + std::to_string(count) + " numbers, found " + std::to_string(nodes.size()));
    std::vector<double> values;
    for (const JsonNode& node : nodes) values.push_back(node.number(minimum, maximum));
    return values;
}

glm::dvec3 JsonNode::vec3(double minimum, double maximum) const {
    const std::vector<double> values = numbers(3, minimum, maximum);
    return {values[0], values[1], values[2]};
}

glm::dvec3 JsonNode::direction() const {
    const glm::dvec3 value = vec3(-1e6, 1e6);
    if (!(glm::length(value) > 1e-9)) throw error("a direction of length 0");
    return glm::normalize(value);
}

}  // namespace ombrage
