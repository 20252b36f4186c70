// SPDX-License-Identifier: MIT
#include <ombrage/params.h>

#include <charconv>

#include "core/strings.h"

namespace ombrage {

namespace {

/// Shortest text that reads back as the same float, C locale.
std::string shortest(float value) {
    char buffer[64];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, result.ptr);
}

}  // namespace

std::string toString(const ParamValue& value) {
    struct Visitor {
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::int64_t v) const { return std::to_string(v); }
        std::string operator()(double v) const { return formatNumber(v); }
        std::string operator()(const std::string& v) const { return v; }
        std::string operator()(const Vec3Value& v) const {
            return "(" + shortest(v.x) + ";" + shortest(v.y) + ";" + shortest(v.z) + ")";
        }
    };
    return std::visit(Visitor{}, value);
}

const char* unitName(Unit unit) {
    switch (unit) {
        case Unit::Metre: return "m";
        case Unit::Degree: return "deg";
        case Unit::Pixel: return "px";
        case Unit::Texel: return "texels";
        case Unit::Percent: return "%";
        case Unit::Millisecond: return "ms";
        case Unit::None: break;
    }
    return "";
}

}  // namespace ombrage
