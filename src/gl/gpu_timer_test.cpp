// SPDX-License-Identifier: MIT
#include "gl/gpu_timer.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "core/trace.h"
#include "gl/objects.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

class GpuTimerTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        ProgramDesc desc;
        desc.stages = {{GL_COMPUTE_SHADER, "c"}};
        desc.virtuals = {{"c", R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer b_Out { float values[]; };
uniform int iterations;
void main() {
    float x = float(gl_GlobalInvocationID.x);
    for (int i = 0; i < iterations; ++i) x = x * 0.999 + 0.001 * float(i & 3);
    values[gl_GlobalInvocationID.x] = x;
}
)"}};
        m_program = &m_library.program(desc);
        load(1);
        glFinish();
    }

    void load(int iterations) {
        m_program->use();
        m_program->set("iterations", iterations);
        m_out.bindStorage(0);
        dispatch(64, 1, 1);
        barrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }

    ShaderLibrary m_library;
    const Program* m_program = nullptr;
    Buffer m_out{64 * 64 * sizeof(float), nullptr, "out"};
};

TEST_F(GpuTimerTest, SelfCheckSaysWhatItSaw) {
    const GpuTimer timer;
    EXPECT_NE(timer.verdict().find("timestamp/wall in ms"), std::string::npos) << timer.verdict();
    if (context().renderer().find("llvmpipe") != std::string::npos) RecordProperty("verdict", timer.verdict());
    EXPECT_TRUE(timer.clock() == Clock::Wall || timer.clock() == Clock::Timestamp);
    EXPECT_STREQ(clockName(Clock::Wall), "wall");
    EXPECT_STREQ(clockName(Clock::Timestamp), "timestamp");
}

TEST_F(GpuTimerTest, SelfCheckLeavesStateAlone) {
    glViewport(1, 2, 30, 40);
    m_program->use();
    const GpuTimer timer;
    GLint viewport[4] = {}, program = 0;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    EXPECT_EQ(viewport[2], 30);
    EXPECT_EQ(GLuint(program), m_program->id());
}

TEST_F(GpuTimerTest, MoreWorkTakesLonger) {
    // The chosen clock must order loads a factor of 1000 apart, and stay under the wall time around everything. The
    // smallest of five spans each, because another process can stretch any one of them.
    GpuTimer timer;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 5; ++i) {
        timer.begin("small");
        load(10);
        timer.end();
        timer.begin("large");
        load(10000);
        timer.end();
    }
    const auto spans = timer.take();
    const double wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

    ASSERT_EQ(spans.size(), 10u);
    EXPECT_EQ(spans[0].name, "small");
    EXPECT_EQ(spans[1].name, "large");
    double small_ms = 1e9, large_ms = 1e9, sum_ms = 0;
    for (std::size_t i = 0; i < spans.size(); i += 2) {
        small_ms = std::min(small_ms, spans[i].time_ms);
        large_ms = std::min(large_ms, spans[i + 1].time_ms);
        sum_ms += spans[i].time_ms + spans[i + 1].time_ms;
    }
    EXPECT_GT(large_ms, 2 * small_ms);
    EXPECT_GE(small_ms, 0.0);
    EXPECT_LE(sum_ms, wall_ms);
    EXPECT_TRUE(timer.take().empty());
}

TEST_F(GpuTimerTest, ForcedClockIsUsed) {
    for (Clock clock : {Clock::Wall, Clock::Timestamp}) {
        GpuTimer timer(clock);
        EXPECT_EQ(timer.clock(), clock);
        for (int round = 0; round < 3; ++round) {  // queries are used again
            timer.begin("a");
            load(10);
            timer.end();
            EXPECT_EQ(timer.take().size(), 1u);
        }
    }
}

TEST_F(GpuTimerTest, TracesItsSpansOnTheSteadyClock) {
    for (const Clock clock : {Clock::Timestamp, Clock::Wall}) {
        GpuTimer timer(clock);
        const Trace trace;
        const std::int64_t before_ns = traceTime_ns();
        timer.begin("traced span");
        glFinish();
        timer.end();
        timer.take();
        const double sinceStart_us = double(traceTime_ns() - before_ns) * 1e-3;
        const std::string json = trace.json();
        const std::size_t span = json.find("\"name\":\"traced span\"");
        ASSERT_NE(span, std::string::npos) << clockName(clock);
        EXPECT_NE(json.find(std::string("\"clock\":\"") + clockName(clock), span), std::string::npos);
        // Times stand as "ts":NUMBER; on another clock's scale it would be the uptime, hours away. A second is room for
        // a busy machine.
        const double begin_us = std::strtod(json.c_str() + json.find("\"ts\":", span) + 5, nullptr);
        EXPECT_GT(begin_us, -1e6);
        EXPECT_LT(begin_us, sinceStart_us + 1e6);
    }
}

}  // namespace
}  // namespace ombrage::gl
