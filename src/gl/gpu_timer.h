// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace ombrage::gl {

enum class Clock { Timestamp, Wall };

/// "timestamp" or "wall".
const char* clockName(Clock clock);

/// Times named spans of GPU work.
///
/// At construction it times a known load with GL_TIMESTAMP pairs and with a glFinish-bracketed wall clock; when the two
/// differ by more than 25 % or timestamps run backwards it uses the wall clock (software OpenGL runs late and its
/// queries have been seen to lie). The wall clock finishes the queue at each end of a span, so spans must not nest.
class GpuTimer {
public:
    /// @param forced use this clock without testing
    GpuTimer();
    explicit GpuTimer(Clock forced);
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;

    Clock clock() const;
    /// Why this clock: the two figures of the self-check.
    const std::string& verdict() const;

    void begin(const std::string& name);
    void end();

    struct Span {
        std::string name;
        double time_ms = 0;
    };
    /// Spans since the last call, in order. Waits for the GPU.
    std::vector<Span> take();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace ombrage::gl
