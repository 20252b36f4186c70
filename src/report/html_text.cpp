// SPDX-License-Identifier: MIT
#include "report/html_text.h"

#include <fmt/format.h>
#include <cmath>

namespace ombrage {

std::string escapeHtml(std::string_view text) {
    std::string out;
    for (char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    return out;
}

std::string escapeScriptJson(std::string json) {
    // '<' occurs inside strings only, where the escape means the same.
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) json.replace(at, 1, "\\u003c");
    return json;
}

std::string base64(std::span<const unsigned char> bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const unsigned group = unsigned(bytes[i]) << 16 | (left > 1 ? unsigned(bytes[i + 1]) << 8 : 0u) |
                               (left > 2 ? unsigned(bytes[i + 2]) : 0u);
        out += kDigits[group >> 18];
        out += kDigits[group >> 12 & 63];
        out += left > 1 ? kDigits[group >> 6 & 63] : '=';
        out += left > 2 ? kDigits[group & 63] : '=';
    }
    return out;
}

std::string shortNumber(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return "–";
    // Below a millionth the digits say nothing in a table; the raw records keep them.
    if (*value != 0 && std::fabs(*value) < 1e-6) return *value > 0 ? "<0.000001" : ">-0.000001";
    if (std::fabs(*value) < 1e-3 && *value != 0) return fmt::format("{:.6f}", *value);
    return fmt::format("{:.4g}", *value);
}

std::string byteText(double bytes) {
    const char* units[] = {"B", "KiB", "MiB", "GiB"};
    std::size_t unit = 0;
    for (; bytes >= 1024 && unit < 3; ++unit) bytes /= 1024;
    return fmt::format("{:.{}f} {}", bytes, bytes < 10 && unit > 0 ? 1 : 0, units[unit]);
}

}  // namespace ombrage
