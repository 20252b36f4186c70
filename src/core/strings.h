// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ombrage {

/// Parts between separators, empty ones included: split("a,,b", ',') = {"a", "", "b"}; split("", ',') = {""}.
std::vector<std::string> split(std::string_view text, char separator);

/// Without white space at both ends.
std::string trim(std::string_view text);

std::string toLower(std::string_view text);

std::string join(const std::vector<std::string>& parts, std::string_view separator);

/// The whole text as a number in the C locale, whatever the global locale; false for anything else, inf and nan included.
bool parseDouble(std::string_view text, double& value);
bool parseInt(std::string_view text, long long& value);

/// Shortest text that reads back as the same number, C locale.
std::string formatNumber(double value);

}  // namespace ombrage
