// SPDX-License-Identifier: MIT
#include "core/param_table.h"

#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/strings.h"

namespace ombrage {

namespace detail {

double roundToFloatDigits(double value) {
    const std::string text = fmt::format("{:.7g}", value);
    double rounded = value;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return rounded;
}

}  // namespace detail

namespace {

std::string identifierOf(std::string key) {
    for (char& c : key)
        if (c == '-') c = '_';
    return key;
}

std::string upperIdentifierOf(const std::string& key) {
    std::string name = identifierOf(key);
    for (char& c : name)
        if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    return name;
}

std::string rangeText(const ParamInfo& info) {
    std::string unit = unitName(info.unit);
    if (!unit.empty()) unit = " " + unit;
    return formatNumber(info.minimum) + " to " + formatNumber(info.maximum) + unit;
}

Error outOfRange(const ParamInfo& info, const std::string& value, const std::string& owner) {
    return Error(ErrorCode::Usage, fmt::format("{}: {}={} is out of range", owner, info.key, value),
                 fmt::format("{} takes {}", info.key, rangeText(info)));
}

Error wrongType(const ParamInfo& info, const std::string& value, const std::string& owner) {
    std::string takes;
    switch (info.type) {
        case ParamType::Bool:
            takes = "true or false";
            break;
        case ParamType::Int:
            takes = "a whole number, " + rangeText(info);
            break;
        case ParamType::Float:
            takes = "a number, " + rangeText(info);
            break;
        case ParamType::Vec3:
            takes = "(x;y;z), each " + rangeText(info);
            break;
        case ParamType::Enum:
            takes = "one of " + join(info.choices, ", ");
            break;
    }
    return Error(ErrorCode::Usage, fmt::format("{}: {}={} is not understood", owner, info.key, value),
                 fmt::format("{} takes {}", info.key, takes));
}

bool inRange(const ParamInfo& info, double value) {
    return value >= info.minimum && value <= info.maximum;
}

const char* glslType(ParamType type) {
    switch (type) {
        case ParamType::Float:
            return "float";
        case ParamType::Vec3:
            return "vec3";
        case ParamType::Bool:
            return "bool";
        default:
            return "int";
    }
}

/// A float literal from its bits.
std::string glslNumber(std::uint32_t word) {
    float value;
    static_assert(sizeof value == sizeof word);
    std::memcpy(&value, &word, sizeof value);
    std::string text = formatNumber(double(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

/// Offset of each Uniform field under std140: scalars on 4 bytes, vec3 on 16, and the next free byte after vec3 at 12.
std::vector<int> layoutOffsets(const std::vector<ParamField>& fields, int& size) {
    std::vector<int> offsets(fields.size(), -1);
    int cursor = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].info.effect != ParamEffect::Uniform) continue;
        const bool isVector = fields[i].info.type == ParamType::Vec3;
        if (isVector) cursor = (cursor + 15) / 16 * 16;
        offsets[i] = cursor;
        cursor += isVector ? 12 : 4;
    }
    size = (cursor + 15) / 16 * 16;
    return offsets;
}

/// "    PREFIXTYPE NAME;" of every Uniform field.
std::string glslMembers(const std::vector<ParamField>& fields, const char* prefix) {
    std::string members;
    for (const ParamField& field : fields)
        if (field.info.effect == ParamEffect::Uniform)
            members += fmt::format("    {}{} {};\n", prefix, glslType(field.info.type), identifierOf(field.info.key));
    return members;
}

/// The constants of the choices of every Uniform field.
std::string glslChoices(const std::vector<ParamField>& fields) {
    std::string constants;
    for (const ParamField& field : fields)
        for (std::size_t i = 0; field.info.effect == ParamEffect::Uniform && i < field.info.choices.size(); ++i)
            constants += fmt::format("const int {}_{} = {};\n", upperIdentifierOf(field.info.key),
                                     upperIdentifierOf(field.info.choices[i]), i);
    return constants;
}

}  // namespace

const ParamField& ParamTable::find(const std::string& key, const std::string& owner) const {
    std::vector<std::string> keys;
    for (const ParamField& field : m_fields) {
        if (field.info.key == key) return field;
        keys.push_back(field.info.key);
    }
    if (keys.empty())
        throw Error(ErrorCode::Usage, fmt::format("{} has no parameter '{}'", owner, key),
                    "it has no parameters at all");
    throw unknownName("parameter of " + owner, key, keys);
}

ParamValue ParamTable::check(const ParamInfo& info, const ParamValue& value, const std::string& owner) {
    switch (info.type) {
        case ParamType::Bool:
            if (std::holds_alternative<bool>(value)) return value;
            break;
        case ParamType::Int: {
            std::int64_t whole = 0;
            if (const auto* integer = std::get_if<std::int64_t>(&value)) {
                whole = *integer;
            } else if (const auto* real = std::get_if<double>(&value);
                       real && *real == std::floor(*real) && std::abs(*real) < 1e15) {
                whole = std::int64_t(*real);
            } else {
                break;
            }
            if (!inRange(info, double(whole))) throw outOfRange(info, std::to_string(whole), owner);
            return whole;
        }
        case ParamType::Float: {
            double real = 0;
            if (const auto* integer = std::get_if<std::int64_t>(&value))
                real = double(*integer);
            else if (const auto* number = std::get_if<double>(&value))
                real = *number;
            else
                break;
            if (!inRange(info, real)) throw outOfRange(info, formatNumber(real), owner);
            return real;
        }
        case ParamType::Vec3:
            if (const auto* v = std::get_if<Vec3Value>(&value)) {
                if (!inRange(info, double(v->x)) || !inRange(info, double(v->y)) || !inRange(info, double(v->z)))
                    throw outOfRange(info, toString(value), owner);
                return value;
            }
            break;
        case ParamType::Enum:
            if (const auto* name = std::get_if<std::string>(&value)) {
                for (const std::string& choice : info.choices)
                    if (choice == *name) return value;
                throw unknownName("value of " + owner + " " + info.key, *name, info.choices);
            }
            break;
    }
    throw wrongType(info, toString(value), owner);
}

ParamValue ParamTable::parse(const ParamInfo& info, const std::string& text, const std::string& owner) {
    double number = 0;
    switch (info.type) {
        case ParamType::Bool:
            if (text == "true" || text == "on" || text == "1") return true;
            if (text == "false" || text == "off" || text == "0") return false;
            break;
        case ParamType::Int: {
            long long whole = 0;
            if (parseInt(text, whole)) return check(info, std::int64_t(whole), owner);
            break;
        }
        case ParamType::Float:
            if (parseDouble(text, number)) return check(info, number, owner);
            break;
        case ParamType::Enum:
            return check(info, text, owner);
        case ParamType::Vec3: {
            if (text.size() < 2 || text.front() != '(' || text.back() != ')') break;
            const auto parts = split(std::string_view(text).substr(1, text.size() - 2), ';');
            double xyz[3];
            if (parts.size() != 3 || !parseDouble(trim(parts[0]), xyz[0]) || !parseDouble(trim(parts[1]), xyz[1]) ||
                !parseDouble(trim(parts[2]), xyz[2]))
                break;
            return check(info, Vec3Value{float(xyz[0]), float(xyz[1]), float(xyz[2])}, owner);
        }
    }
    throw wrongType(info, text, owner);
}

std::string ParamTable::glslBlock(unsigned binding) const {
    const std::string members = glslMembers(m_fields, "");
    if (members.empty()) return {};
    return fmt::format("{}layout(std140, binding = {}) uniform Params {{\n{}}} params;\n", glslChoices(m_fields),
                       binding, members);
}

std::string ParamTable::flatMembers() const {
    constexpr std::size_t kMostWords = 16;  // of the 64 components that every vertex stage may hand over
    std::size_t words = 0;
    for (const ParamField& field : m_fields) {
        if (field.info.effect != ParamEffect::Uniform) continue;
        if (field.info.type == ParamType::Bool) return {};  // no such inputs in GLSL
        words += field.info.type == ParamType::Vec3 ? 3 : 1;
    }
    return words <= kMostWords ? glslMembers(m_fields, "flat ") : std::string();
}

std::string ParamTable::glslPerPass(unsigned binding) const {
    const std::string members = flatMembers();
    if (members.empty()) return glslBlock(binding);
    return fmt::format("{}in PassedParams {{\n{}}} params;\n", glslChoices(m_fields), members);
}

std::string ParamTable::glslPassing(unsigned binding) const {
    const std::string members = flatMembers();
    if (members.empty()) return "void passParams() {}\n";
    std::string copies;
    for (const ParamField& field : m_fields)
        if (field.info.effect == ParamEffect::Uniform)
            copies += fmt::format("    passedParams.{0} = params.{0};\n", identifierOf(field.info.key));
    return fmt::format("{}out PassedParams {{\n{}}} passedParams;\nvoid passParams() {{\n{}}}\n", glslBlock(binding),
                       members, copies);
}

std::vector<std::pair<std::string, std::string>> ParamTable::glslDefines(const void* params) const {
    std::vector<std::pair<std::string, std::string>> defines;
    for (const ParamField& field : m_fields) {
        if (field.info.effect != ParamEffect::Define) continue;
        const std::string name = upperIdentifierOf(field.info.key);
        for (std::size_t i = 0; i < field.info.choices.size(); ++i)
            defines.emplace_back(name + "_" + upperIdentifierOf(field.info.choices[i]), std::to_string(i));
        const auto words = field.words(params);
        if (field.info.type == ParamType::Float) {
            defines.emplace_back(name, glslNumber(words[0]));
        } else if (field.info.type == ParamType::Vec3) {
            defines.emplace_back(name, fmt::format("vec3({}, {}, {})", glslNumber(words[0]), glslNumber(words[1]),
                                                   glslNumber(words[2])));
        } else {
            defines.emplace_back(name, std::to_string(std::int32_t(words[0])));
        }
    }
    return defines;
}

std::vector<std::byte> ParamTable::packBlock(const void* params) const {
    int size = 0;
    const std::vector<int> offsets = layoutOffsets(m_fields, size);
    std::vector<std::byte> bytes{std::size_t(size)};
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (offsets[i] < 0) continue;
        const auto words = m_fields[i].words(params);
        std::memcpy(bytes.data() + offsets[i], words.data(), words.size() * 4);
    }
    return bytes;
}

int ParamTable::blockOffset(const std::string& key) const {
    int size = 0;
    const std::vector<int> offsets = layoutOffsets(m_fields, size);
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (m_fields[i].info.key == key) return offsets[i];
    return -1;
}

std::string ParamTable::markdown() const {
    constexpr const char* kEffects[] = {"uniform", "variant", "resize", "host"};
    std::string text = "| parameter | default | range | effect | meaning |\n|---|---|---|---|---|\n";
    for (const ParamField& field : m_fields) {
        const ParamInfo& info = field.info;
        std::string range;
        if (info.type == ParamType::Enum)
            range = join(info.choices, ", ");
        else if (info.type == ParamType::Bool)
            range = "true, false";
        else
            range = rangeText(info);
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", info.key, toString(info.defaultValue), range,
                            kEffects[int(info.effect)], info.help);
    }
    return text;
}

}  // namespace ombrage
