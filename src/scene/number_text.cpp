// SPDX-License-Identifier: MIT
#include "scene/number_text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace ombrage {

namespace {
bool isWhite(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}
}  // namespace

std::string_view takeWord(std::string_view text, std::size_t& position) {
    while (position < text.size() && isWhite(text[position])) ++position;
    const std::size_t begin = position;
    while (position < text.size() && !isWhite(text[position])) ++position;
    return text.substr(begin, position - begin);
}

bool parseNumber(std::string_view word, double& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ptr != end || result.ec == std::errc::invalid_argument) return false;
    if (result.ec == std::errc::result_out_of_range) {
        const bool small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
        value = small ? 0.0 : std::numeric_limits<double>::infinity() * (word[0] == '-' ? -1.0 : 1.0);
    }
    return true;
}

}  // namespace ombrage
