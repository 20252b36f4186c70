// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ombrage {

/// Collects what the library does and when, in every thread, while it lives: scopes on the CPU and passes on the GPU.
/// Off unless one is made; then every scope costs one look at a flag.
class Trace {
public:
    /// Beyond this many events the rest is counted, not kept.
    static constexpr std::size_t kMostEvents = 1'000'000;

    /// @throws Error(Usage) while another one collects.
    Trace();
    ~Trace();
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;

    /// What has ended so far, as a whole JSON document in Chrome's trace-event format, which Perfetto and
    /// chrome://tracing open. Times are microseconds since the trace was made. "otherData" holds the version, the
    /// device and the clock of the GPU passes ("timestamp" or "wall"), and "dropped_events".
    std::string json() const;
};

/// A named span of work on the CPU, from here to the end of the block. Spans of one thread nest.
class TraceScope {
public:
    /// @param detail shown beside the name: which file, which shader
    explicit TraceScope(std::string_view name, std::string_view detail = {});
    ~TraceScope() { end(); }
    TraceScope(const TraceScope&) = delete;
    TraceScope& operator=(const TraceScope&) = delete;

    /// Ends the span before the block does.
    void end();

private:
    std::uint64_t m_trace = 0;  ///< number of the trace that collects it, 0: none
    std::int64_t m_begin_ns = 0;
    std::string m_name, m_detail;
};

}  // namespace ombrage
