// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ombrage {

/// Text as it may stand in HTML content and in quoted attributes.
std::string escapeHtml(std::string_view text);

/// JSON as it may stand in a script element: no "</script" and no "<!--" can end or confuse it.
std::string escapeScriptJson(std::string json);

std::string base64(std::span<const unsigned char> bytes);

/// Four significant digits, or "–" where nothing was measured.
std::string shortNumber(const std::optional<double>& value);

/// "512 B", "1.5 KiB", "16 MiB".
std::string byteText(double bytes);

}  // namespace ombrage
