// SPDX-License-Identifier: MIT
#include "gl/gpu_timer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/trace.h"
#include "gl/context.h"
#include "gl/objects.h"
#include "gl/shader_library.h"

namespace ombrage::gl {

namespace {

using SteadyClock = std::chrono::steady_clock;

double elapsed_ms(SteadyClock::time_point since) {
    return std::chrono::duration<double, std::milli>(SteadyClock::now() - since).count();
}

// Long enough for the cost of glFinish itself (tens of microseconds) to stay far below the 25 % that decide.
constexpr double kLoadTime_ms = 3.0;
constexpr double kMaxDifference = 0.25;
constexpr int kRepeats = 3;
constexpr int kDraws = 4;
constexpr int kMaxIterations = 1 << 20;

/// A draw whose cost grows with a number of iterations.
class KnownLoad {
public:
    KnownLoad()
        : m_target({TextureKind::Tex2D, GL_RGBA8, 256, 256}, "timer load"),
          m_framebuffer({Attachment{&m_target, 0, -1}}, {}, "timer load") {
        ProgramDesc desc;
        desc.stages = {{GL_VERTEX_SHADER, "timer/load.vert"}, {GL_FRAGMENT_SHADER, "timer/load.frag"}};
        desc.virtuals = {{"timer/load.vert", kVertex}, {"timer/load.frag", kFragment}};
        m_program = &m_library.program(desc);
    }

    void run(int iterations) const {
        beginFrameState();
        m_framebuffer.bind();
        apply({});
        m_program->use();
        m_program->set("iterations", iterations);
        for (int i = 0; i < kDraws; ++i) drawFullscreen();
    }

private:
    static constexpr const char* kVertex = R"(
void main() { gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
)";
    static constexpr const char* kFragment = R"(
uniform int iterations;
out vec4 color;
void main() {
    float x = gl_FragCoord.x * 0.001;
    for (int i = 0; i < iterations; ++i) x = x * 0.999 + 0.001 * float(i & 3);
    color = vec4(x);
}
)";
    Texture m_target;
    Framebuffer m_framebuffer;
    ShaderLibrary m_library;
    const Program* m_program = nullptr;
};

/// A pool of timestamp queries.
class Timestamps {
public:
    Timestamps() = default;
    ~Timestamps() { glDeleteQueries(GLsizei(m_all.size()), m_all.data()); }
    Timestamps(const Timestamps&) = delete;
    Timestamps& operator=(const Timestamps&) = delete;

    /// Asks for the time when the GPU has come this far.
    GLuint record() {
        if (m_free.empty()) {
            GLuint query = 0;
            glCreateQueries(GL_TIMESTAMP, 1, &query);
            m_all.push_back(query);
            m_free.push_back(query);
        }
        const GLuint query = m_free.back();
        m_free.pop_back();
        glQueryCounter(query, GL_TIMESTAMP);
        return query;
    }

    /// Waits for the time in nanoseconds and takes the query back.
    GLuint64 collect(GLuint query) {
        GLuint64 time_ns = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time_ns);
        m_free.push_back(query);
        return time_ns;
    }

private:
    std::vector<GLuint> m_all, m_free;
};

struct SelfCheck {
    Clock clock = Clock::Wall;
    std::string verdict;
};

struct Figures {
    double wall_ms = 0, timestamp_ms = 0;
    GLuint64 begin_ns = 0, end_ns = 0;
};

Figures measure(const KnownLoad& load, Timestamps& timestamps, int iterations) {
    Figures f;
    glFinish();
    const auto start = SteadyClock::now();
    const GLuint begin = timestamps.record();
    load.run(iterations);
    const GLuint end = timestamps.record();
    glFinish();
    f.wall_ms = elapsed_ms(start);
    f.begin_ns = timestamps.collect(begin);
    f.end_ns = timestamps.collect(end);
    f.timestamp_ms = f.end_ns >= f.begin_ns ? double(f.end_ns - f.begin_ns) * 1e-6 : -1.0;
    return f;
}

SelfCheck checkClocks() {
    const TraceScope trace("check clocks");
    const StateGuard guard;
    const KnownLoad load;
    Timestamps timestamps;

    // Grow the load until it takes long enough; the first run also compiles.
    int iterations = 16;
    measure(load, timestamps, iterations);
    while (iterations < kMaxIterations) {
        const double wall_ms = measure(load, timestamps, iterations).wall_ms;
        if (wall_ms >= kLoadTime_ms) break;
        iterations = int(iterations * std::clamp(1.2 * kLoadTime_ms / wall_ms, 2.0, 16.0));
    }

    // Every trial must hold: software OpenGL has been seen to answer rightly once and wrongly the next time.
    SelfCheck result{Clock::Timestamp, "timestamps and wall clock agree within 25 %"};
    std::string figures;
    GLuint64 last_ns = 0;
    for (int i = 0; i < kRepeats; ++i) {
        const Figures f = measure(load, timestamps, iterations);
        figures += fmt::format("{}{:.2f}/{:.2f}", i == 0 ? "" : ", ", f.timestamp_ms, f.wall_ms);
        if (f.begin_ns < last_ns || f.end_ns < f.begin_ns)
            result = {Clock::Wall, "timestamps run backwards"};
        else if (std::abs(f.timestamp_ms - f.wall_ms) > kMaxDifference * f.wall_ms && result.clock == Clock::Timestamp)
            result = {Clock::Wall, "timestamps and wall clock differ by more than 25 %"};
        last_ns = f.end_ns;
    }
    result.verdict += fmt::format(" (timestamp/wall in ms: {})", figures);
    return result;
}

}  // namespace

const char* clockName(Clock clock) {
    return clock == Clock::Timestamp ? "timestamp" : "wall";
}

struct GpuTimer::Impl {
    struct Pending {
        std::string name;
        GLuint begin = 0, end = 0;
        double time_ms = 0;
    };

    explicit Impl(SelfCheck check) : clock(check.clock), verdict(std::move(check.verdict)) {}

    Clock clock;
    std::string verdict;
    Timestamps timestamps;
    std::vector<Pending> pending;
    bool isOpen = false;
    SteadyClock::time_point start;
};

namespace {
/// What turns the GPU's timestamps into times of the steady clock: the difference of the two now.
std::int64_t steadyFromGpu_ns() {
    GLint64 gpu_ns = 0;
    glGetInteger64v(GL_TIMESTAMP, &gpu_ns);
    return traceTime_ns() - gpu_ns;
}
}  // namespace

GpuTimer::GpuTimer() : m_impl(std::make_unique<Impl>(checkClocks())) {}

GpuTimer::GpuTimer(Clock forced)
    : m_impl(
          std::make_unique<Impl>(SelfCheck{forced, std::string(clockName(forced)) + " clock as asked, not checked"})) {}

GpuTimer::~GpuTimer() = default;

Clock GpuTimer::clock() const {
    return m_impl->clock;
}

const std::string& GpuTimer::verdict() const {
    return m_impl->verdict;
}

void GpuTimer::begin(const std::string& name) {
    assert(!m_impl->isOpen);
    m_impl->isOpen = true;
    Impl::Pending& span = m_impl->pending.emplace_back();
    span.name = name;
    if (m_impl->clock == Clock::Timestamp) {
        span.begin = m_impl->timestamps.record();
    } else {
        glFinish();
        m_impl->start = SteadyClock::now();
    }
}

void GpuTimer::end() {
    assert(m_impl->isOpen);
    m_impl->isOpen = false;
    Impl::Pending& span = m_impl->pending.back();
    if (m_impl->clock == Clock::Timestamp) {
        span.end = m_impl->timestamps.record();
    } else {
        glFinish();
        span.time_ms = elapsed_ms(m_impl->start);
        if (isTracing()) {
            const std::int64_t now_ns = traceTime_ns();
            traceGpuSpan(span.name, now_ns - std::int64_t(span.time_ms * 1e6), now_ns, clockName(Clock::Wall));
        }
    }
}

std::vector<GpuTimer::Span> GpuTimer::take() {
    assert(!m_impl->isOpen);
    std::vector<Span> spans;
    const bool traced = m_impl->clock == Clock::Timestamp && !m_impl->pending.empty() && isTracing();
    const std::int64_t toSteady_ns = traced ? steadyFromGpu_ns() : 0;
    for (const Impl::Pending& span : m_impl->pending) {
        double time_ms = span.time_ms;
        if (m_impl->clock == Clock::Timestamp) {
            const GLuint64 begin_ns = m_impl->timestamps.collect(span.begin);
            const GLuint64 end_ns = m_impl->timestamps.collect(span.end);
            time_ms = double(GLint64(end_ns - begin_ns)) * 1e-6;
            if (traced)
                traceGpuSpan(span.name, std::int64_t(begin_ns) + toSteady_ns, std::int64_t(end_ns) + toSteady_ns,
                             clockName(Clock::Timestamp));
        }
        spans.push_back({span.name, time_ms});
    }
    m_impl->pending.clear();
    return spans;
}

}  // namespace ombrage::gl
