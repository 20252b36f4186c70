// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace ombrage {

/// Blanks and line ends between the words of model files.
inline constexpr std::string_view kWhiteSpace = " \t\r\n\f\v";

/// The word of `text` that begins at or after `position`, which moves behind it; empty at the end.
std::string_view takeWord(std::string_view text, std::size_t& position);

/// The whole word as a number in the C locale. Unlike parseDouble it takes "nan" and "inf", which files of scanners
/// hold and which the loader drops with a warning; numbers too large for a double become infinite, too small ones 0.
bool parseNumber(std::string_view word, double& value);

}  // namespace ombrage
