// SPDX-License-Identifier: MIT
#include "core/trace.h"

#include <map>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <nlohmann/json.hpp>

namespace ombrage {
namespace {

using Json = nlohmann::json;

Json spansOf(const Trace& trace) {
    Json spans = Json::array();
    const Json json = Json::parse(trace.json());
    for (const Json& event : json["traceEvents"])
        if (event["ph"] == "X") spans.push_back(event);
    return spans;
}

TEST(Trace, KeepsNestedScopesOuterFirst) {
    const Trace trace;
    {
        const TraceScope outer("outer", "which");
        const TraceScope inner("inner");
    }
    const Json spans = spansOf(trace);
    ASSERT_EQ(spans.size(), 2u);
    EXPECT_EQ(spans[0]["name"], "outer");
    EXPECT_EQ(spans[0]["args"]["detail"], "which");
    EXPECT_EQ(spans[1]["name"], "inner");
    EXPECT_EQ(spans[0]["tid"], spans[1]["tid"]);
    // Whole nanoseconds in microseconds: the sums are off by rounding alone.
    const auto endOf = [](const Json& span) { return span["ts"].get<double>() + span["dur"].get<double>(); };
    EXPECT_GE(spans[0]["ts"].get<double>(), 0.0);
    EXPECT_LE(spans[0]["ts"].get<double>(), spans[1]["ts"].get<double>());
    EXPECT_GE(endOf(spans[0]) + 1e-4, endOf(spans[1]));
}

TEST(Trace, CollectsNothingUnlessAskedTo) {
    EXPECT_FALSE(isTracing());
    TraceScope early("begun before the trace");
    {
        const Trace trace;
        early.end();
        EXPECT_TRUE(isTracing());
        EXPECT_EQ(spansOf(trace).size(), 0u);
    }
    EXPECT_FALSE(isTracing());
    const Trace second;
    EXPECT_EQ(spansOf(second).size(), 0u);
}

TEST(Trace, AScopeThatOutlivesItsTraceIsNotTheNextOnes) {
    auto first = std::make_unique<Trace>();
    TraceScope scope("of the first");
    first.reset();
    const Trace second;
    scope.end();
    EXPECT_EQ(spansOf(second).size(), 0u);
}

TEST(Trace, OneAtATime) {
    const Trace trace;
    EXPECT_THROW(Trace{}, Error);
}

TEST(Trace, OddNamesStayValidJson) {
    const Trace trace;
    TraceScope("quote \" backslash \\ newline \n not UTF-8 \xff").end();
    EXPECT_EQ(spansOf(trace).size(), 1u);
}

TEST(Trace, ThreadsHaveTracksOfTheirOwn) {
    const Trace trace;
    TraceScope("here").end();
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([] {
            for (int i = 0; i < 1000; ++i) const TraceScope scope("there");
        });
    for (std::thread& thread : threads) thread.join();
    std::map<int, int> counts;
    for (const Json& span : spansOf(trace)) ++counts[span["tid"].get<int>()];
    EXPECT_EQ(counts.size(), 5u);
    for (const auto& [thread, count] : counts) EXPECT_TRUE(count == 1 || count == 1000) << thread;
}

TEST(Trace, GpuSpansNameTheirClock) {
    const Trace trace;
    const std::int64_t now = traceTime_ns();
    traceGpuSpan("lookup", now, now + 2'500'000, "wall");
    traceFact("device", "a device");
    const Json json = Json::parse(trace.json());
    EXPECT_EQ(json["otherData"]["clock"], "wall");
    EXPECT_EQ(json["otherData"]["device"], "a device");
    EXPECT_EQ(json["otherData"]["dropped_events"], 0);
    const Json span = spansOf(trace)[0];
    EXPECT_EQ(span["cat"], "gpu");
    EXPECT_NEAR(span["dur"].get<double>(), 2500.0, 1e-6);  // rounding of doubles
    EXPECT_EQ(span["args"]["clock"], "wall");
}

}  // namespace
}  // namespace ombrage
