// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <ombrage/trace.h>

namespace ombrage {

/// Whether a Trace collects: ask before making what only a trace needs.
bool isTracing();

/// The clock of all traces: std::chrono::steady_clock.
std::int64_t traceTime_ns();

/// A span of GPU work on that clock's scale. Those of one trace do not overlap.
/// @param clock "timestamp" or "wall": what measured it
void traceGpuSpan(const std::string& name, std::int64_t begin_ns, std::int64_t end_ns, const char* clock);

/// A fact about the whole trace, for its "otherData".
void traceFact(const std::string& key, const std::string& value);

}  // namespace ombrage
