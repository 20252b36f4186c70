// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace ombrage {

enum class LogLevel { Debug, Info, Warning };

/// Receives every message of the library. Called from any thread, one call at a time.
using LogSink = std::function<void(LogLevel, const std::string&)>;

/// Replaces the sink and returns the old one. The default sink drops everything: the library never prints by itself.
LogSink setLogSink(LogSink sink);

}  // namespace ombrage
