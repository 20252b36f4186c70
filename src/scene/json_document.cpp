// SPDX-License-Identifier: MIT
#include "scene/json_document.h"

#include <algorithm>

#include "core/strings.h"

namespace ombrage {

namespace {
const char* typeName(const nlohmann::json& value) {
    if (value.is_number()) return "a number";
    if (value.is_string()) return "a text";
    if (value.is_boolean()) return "true or false";
    if (value.is_array()) return "a list";
    if (value.is_object()) return "an object";
    return "null";
}
}  // namespace

JsonDocument::JsonDocument(const std::string& file, const std::string& text)
    : m_lines(file, text), m_root(nlohmann::json::parse(text)) {}

Error JsonDocument::error(const std::string& pointer, const std::string& message, const std::string& hint) const {
    return m_lines.error(pointer, message, hint);
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
        throw m_document->error(m_pointer + "/" + escapedKey(key), what + " has no key '" + key + "'", hint);
    }
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
    requireObject();
    const auto found = m_value->find(key);
    if (found == m_value->end()) return std::nullopt;
    return JsonNode(*m_document, *found, m_pointer + "/" + escapedKey(key));
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
    // The system would read a file's name only up to it.
    if (value.find('\0') != std::string::npos) throw error("the text holds a zero byte");
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
