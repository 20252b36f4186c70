// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/glm.hpp>
#include <ombrage/error.h>
#include <ombrage/params.h>

namespace ombrage {

/// One declared parameter: what is known of it and how to reach the member of the parameter struct.
struct ParamField {
    ParamInfo info;
    std::function<ParamValue(const void*)> get;        ///< at the user's edge (degrees, choice names)
    std::function<void(void*, const ParamValue&)> set; ///< value already checked
    /// Bits of the member as GLSL sees it (int, float or vec3; radians), 1 or 3 words.
    std::function<std::vector<std::uint32_t>(const void*)> words;
};

/// The parameters of one technique, in declaration order. Everything that shows or takes a parameter goes through it.
class ParamTable {
public:
    ParamTable() = default;
    explicit ParamTable(std::vector<ParamField> fields) : m_fields(std::move(fields)) {}

    const std::vector<ParamField>& fields() const { return m_fields; }

    /// @throws Error(Usage) with the nearest key; `owner` names the technique in the message.
    const ParamField& find(const std::string& key, const std::string& owner) const;

    /// Text to value, type and range checked. @throws Error(Usage) stating the range or the choices.
    static ParamValue parse(const ParamInfo& info, const std::string& text, const std::string& owner);

    /// Value from JSON or the tuner, type and range checked. An integral double is accepted for Int.
    static ParamValue check(const ParamInfo& info, const ParamValue& value, const std::string& owner);

    /// "layout(std140, binding = B) uniform Params { ... } params;" of the Uniform fields, constants for the choices of
    /// enums, and nothing for the rest. Keys become identifiers: '-' turns into '_'. Empty when there is nothing to say.
    std::string glslBlock(unsigned binding) const;

    /// The same names for the fragments of a full-screen pass, as flat inputs that glslPassing() writes; the block itself
    /// where that cannot be (a bool, or more than 16 numbers).
    std::string glslPerPass(unsigned binding) const;

    /// GLSL of that pass's vertex stage: `void passParams()`.
    std::string glslPassing(unsigned binding) const;

    /// Name and value of the #define of every Define field: key in capitals; enums also define KEY_CHOICE constants.
    std::vector<std::pair<std::string, std::string>> glslDefines(const void* params) const;

    /// The std140 bytes of the block (a multiple of 16; empty when there is no Uniform field).
    std::vector<std::byte> packBlock(const void* params) const;

    /// Byte offset of a Uniform field in the block, -1 for others.
    int blockOffset(const std::string& key) const;

    /// A Markdown table: key, default, range, unit, effect, meaning.
    std::string markdown() const;

private:
    /// "    flat TYPE NAME;" of the Uniform fields; empty where they cannot be passed.
    std::string flatMembers() const;

    std::vector<ParamField> m_fields;
};

/// Names of the choices of an enum class whose values count from 0. Specialise next to the enum:
///   template <> struct EnumChoices<BiasMode> { static std::vector<std::string> names() { return {"constant", "slope"}; } };
template <typename E>
struct EnumChoices;

/// Fluent declaration of one field; see field().
class FieldBuilder {
public:
    explicit FieldBuilder(ParamField field) : m_field(std::move(field)) {}

    /// Inclusive range at the user's edge (degrees for Unit::Degree).
    FieldBuilder& range(double minimum, double maximum, Scale scale = Scale::Linear) {
        m_field.info.minimum = minimum;
        m_field.info.maximum = maximum;
        m_field.info.scale = scale;
        return *this;
    }
    FieldBuilder& tune(double minimum, double maximum) {
        m_field.info.tuneMinimum = minimum;
        m_field.info.tuneMaximum = maximum;
        return *this;
    }
    FieldBuilder& effect(ParamEffect e) {
        m_field.info.effect = e;
        return *this;
    }
    FieldBuilder& help(std::string text) {
        m_field.info.help = std::move(text);
        return *this;
    }
    operator ParamField() const { return m_field; }

private:
    ParamField m_field;
};

namespace detail {
template <typename T>
constexpr ParamType paramTypeOf() {
    if constexpr (std::is_same_v<T, bool>) return ParamType::Bool;
    else if constexpr (std::is_enum_v<T>) return ParamType::Enum;
    else if constexpr (std::is_integral_v<T>) return ParamType::Int;
    else if constexpr (std::is_floating_point_v<T>) return ParamType::Float;
    else return ParamType::Vec3;
}

/// The value to the seven digits that a float holds, so that 0.1f shows as 0.1 and radians come back as whole degrees.
double roundToFloatDigits(double value);
}  // namespace detail

/// Declares `P::*member` under `key`. The unit is an argument because it decides how values are stored.
template <typename P, typename T>
FieldBuilder field(T P::*member, std::string key, Unit unit = Unit::None) {
    ParamField f;
    f.info.key = std::move(key);
    f.info.type = detail::paramTypeOf<T>();
    f.info.unit = unit;
    constexpr double kDegrees = 57.29577951308232;
    const double edge = unit == Unit::Degree ? kDegrees : 1.0;
    if constexpr (std::is_enum_v<T>) {
        f.info.choices = EnumChoices<T>::names();
        f.get = [member](const void* p) -> ParamValue {
            return EnumChoices<T>::names().at(std::size_t(static_cast<const P*>(p)->*member));
        };
        f.set = [member](void* p, const ParamValue& v) {
            const auto names = EnumChoices<T>::names();
            for (std::size_t i = 0; i < names.size(); ++i)
                if (names[i] == std::get<std::string>(v)) static_cast<P*>(p)->*member = T(i);
        };
        f.words = [member](const void* p) {
            return std::vector<std::uint32_t>{std::uint32_t(static_cast<const P*>(p)->*member)};
        };
    } else if constexpr (std::is_same_v<T, bool>) {
        f.get = [member](const void* p) -> ParamValue { return bool(static_cast<const P*>(p)->*member); };
        f.set = [member](void* p, const ParamValue& v) { static_cast<P*>(p)->*member = std::get<bool>(v); };
        f.words = [member](const void* p) {
            return std::vector<std::uint32_t>{static_cast<const P*>(p)->*member ? 1u : 0u};
        };
    } else if constexpr (std::is_integral_v<T>) {
        f.get = [member](const void* p) -> ParamValue { return std::int64_t(static_cast<const P*>(p)->*member); };
        f.set = [member](void* p, const ParamValue& v) { static_cast<P*>(p)->*member = T(std::get<std::int64_t>(v)); };
        f.words = [member](const void* p) {
            return std::vector<std::uint32_t>{std::uint32_t(std::int32_t(static_cast<const P*>(p)->*member))};
        };
    } else if constexpr (std::is_floating_point_v<T>) {
        f.get = [member, edge](const void* p) -> ParamValue {
            return detail::roundToFloatDigits(double(static_cast<const P*>(p)->*member) * edge);
        };
        f.set = [member, edge](void* p, const ParamValue& v) { static_cast<P*>(p)->*member = T(std::get<double>(v) / edge); };
        f.words = [member](const void* p) {
            const float value = float(static_cast<const P*>(p)->*member);
            std::uint32_t word;
            static_assert(sizeof word == sizeof value);
            __builtin_memcpy(&word, &value, sizeof word);
            return std::vector<std::uint32_t>{word};
        };
    } else {
        static_assert(std::is_same_v<T, glm::vec3>, "parameters are bool, int, float, enum or vec3");
        f.get = [member](const void* p) -> ParamValue {
            const glm::vec3 v = static_cast<const P*>(p)->*member;
            return Vec3Value{v.x, v.y, v.z};
        };
        f.set = [member](void* p, const ParamValue& value) {
            const auto v = std::get<Vec3Value>(value);
            static_cast<P*>(p)->*member = glm::vec3(v.x, v.y, v.z);
        };
        f.words = [member](const void* p) {
            const glm::vec3 v = static_cast<const P*>(p)->*member;
            std::vector<std::uint32_t> words(3);
            __builtin_memcpy(words.data(), &v[0], 12);
            return words;
        };
    }
    const P defaults{};
    f.info.defaultValue = f.get(&defaults);
    return FieldBuilder(std::move(f));
}

/// fields(field(...).range(...), field(...)...) as a table.
template <typename... F>
ParamTable fields(const F&... f) {
    return ParamTable(std::vector<ParamField>{ParamField(f)...});
}

}  // namespace ombrage
