// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ombrage {

enum class ParamType { Bool, Int, Float, Enum, Vec3 };

/// The unit at the user's edge. Degrees are radians inside; everything else is stored as shown.
enum class Unit { None, Metre, Degree, Pixel, Texel, Percent, Millisecond };

/// How a slider and the tuner walk the range.
enum class Scale { Linear, Log };

/// What a change of the value costs (style: "say how a change behaves").
enum class ParamEffect {
    Uniform,  ///< a member of the generated GLSL block
    Define,   ///< a generated #define: a new shader variant
    Resize,   ///< render targets or caches are made anew
    Host      ///< seen by the C++ side only
};

struct Vec3Value {
    float x = 0, y = 0, z = 0;
    bool operator==(const Vec3Value&) const = default;
};

/// A parameter's value at the user's edge: Enum values are their names, angles are in degrees.
using ParamValue = std::variant<bool, std::int64_t, double, std::string, Vec3Value>;

/// "true", "16", "0.5", "slope", "(1;0;0)": the form that the command line takes.
std::string toString(const ParamValue& value);

/// Everything that is known of one parameter, made from its single declaration in the technique's source.
struct ParamInfo {
    std::string key;                   ///< lower-case, words joined by '-'
    std::string help;                  ///< one sentence: what it does and which artefact it trades
    ParamType type = ParamType::Float;
    Unit unit = Unit::None;
    Scale scale = Scale::Linear;
    ParamEffect effect = ParamEffect::Uniform;
    ParamValue defaultValue;
    double minimum = 0, maximum = 0;          ///< inclusive; Int, Float and each component of Vec3
    double tuneMinimum = 0, tuneMaximum = 0;  ///< where the tuner searches; equal when it does not
    std::vector<std::string> choices;         ///< of an Enum
};

/// "m", "deg", "px", "texels", "%", "ms" or "".
const char* unitName(Unit unit);

}  // namespace ombrage
