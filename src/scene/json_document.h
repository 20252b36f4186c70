// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ombrage/error.h>
#include <ombrage/json_lines.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

namespace ombrage {

/// A parsed JSON text that knows the line of every value. Member names that occur twice in an object are errors.
class JsonDocument {
public:
    /// @throws Error(Input) whose where() is "FILE:LINE: /json/pointer" (for bad syntax "FILE:LINE").
    JsonDocument(const std::string& file, const std::string& text);

    const nlohmann::json& root() const { return m_root; }

    /// An Error(Input) at a value.
    Error error(const std::string& pointer, const std::string& message, const std::string& hint = {}) const;

private:
    JsonLines m_lines;  // first: it refuses what the parser lets pass
    nlohmann::json m_root;
};

/// A value of a document with checked access. Every failed check throws JsonDocument::error() at the value.
class JsonNode {
public:
    explicit JsonNode(const JsonDocument& document) : JsonNode(document, document.root(), {}) {}

    Error error(const std::string& message, const std::string& hint = {}) const;

    /// Requires an object all of whose keys are listed; an unknown one gets the nearest as a suggestion. `what` names
    /// the object in the message ("a light").
    void requireKeys(const std::string& what, const std::vector<std::string>& known) const;

    /// A member, or nothing. Requires an object.
    std::optional<JsonNode> find(const std::string& key) const;
    /// A member that must be there.
    JsonNode at(const std::string& key) const;
    /// Requires an array; its elements.
    std::vector<JsonNode> elements() const;

    bool isNumber() const { return m_value->is_number(); }
    bool boolean() const;
    std::string text() const;
    /// A text that is not empty and holds no zero byte.
    std::string name() const;
    /// One of the choices, or an error with a suggestion; `kind` names them in the message.
    std::string choice(const std::string& kind, const std::vector<std::string>& choices) const;
    /// A number within [minimum, maximum].
    double number(double minimum, double maximum) const;
    /// A number within ]minimum, maximum].
    double numberAbove(double minimum, double maximum) const;
    /// Exactly `count` numbers within [minimum, maximum].
    std::vector<double> numbers(std::size_t count, double minimum, double maximum) const;
    glm::dvec3 vec3(double minimum, double maximum) const;
    /// A vector that is not zero, made unit length.
    glm::dvec3 direction() const;

private:
    JsonNode(const JsonDocument& document, const nlohmann::json& value, std::string pointer)
        : m_document(&document), m_value(&value), m_pointer(std::move(pointer)) {}

    void requireObject() const;

    const JsonDocument* m_document;
    const nlohmann::json* m_value;
    std::string m_pointer;
};

}  // namespace ombrage
