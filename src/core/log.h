// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ombrage/log.h>

namespace ombrage {

/// Sends one message to the current sink.
void log(LogLevel level, const std::string& message);
inline void warn(const std::string& message) { log(LogLevel::Warning, message); }
inline void info(const std::string& message) { log(LogLevel::Info, message); }
inline void debug(const std::string& message) { log(LogLevel::Debug, message); }

}  // namespace ombrage
