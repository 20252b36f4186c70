// SPDX-License-Identifier: MIT
// --trace.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <thread>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

/// Checks that the spans of every track nest and take time; gives the summed length of those of a name and category.
double tracedTime_us(const Json& trace, const std::string& category, const std::string& name) {
    std::map<std::pair<int, int>, std::vector<double>> open;
    double sum = 0;
    for (const Json& event : trace["traceEvents"]) {
        if (event["ph"] != "X") continue;
        const double begin = event["ts"], length = event["dur"];
        EXPECT_GT(length, 0.0) << event;
        // Times are whole nanoseconds written in microseconds; sums are off by rounding alone.
        constexpr double kRounding_us = 1e-3;
        auto& ends = open[{event["pid"], event["tid"]}];
        while (!ends.empty() && ends.back() <= begin + kRounding_us) ends.pop_back();
        const double limit = ends.empty() ? begin + length : ends.back();
        EXPECT_LE(begin + length, limit + kRounding_us) << event;
        ends.push_back(begin + length);
        if (event["cat"] == category && (name.empty() || event["name"] == name)) sum += length;
    }
    return sum;
}

TEST_F(Cli, TraceHoldsPassesOfBothSides) {
    const Result result = run({"render", "gap", "-o", "a.png", "--shadow", idOf("shadow"), "--size", "64x36",
                               "--frames", "3", "--trace", "new/trace.json", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json render = Json::parse(result.out), trace = Json::parse(content(m_folder / "new/trace.json"));
    EXPECT_EQ(trace["otherData"]["clock"], render["gpu_ms"]["clock"]);
    EXPECT_EQ(trace["otherData"]["device"], render["device"]["renderer"]);
    for (const Json& pass : render["passes"]) {
        EXPECT_GT(tracedTime_us(trace, "gpu", pass["name"]), 0.0) << pass;
        EXPECT_GT(tracedTime_us(trace, "cpu", pass["name"]), 0.0) << pass;
    }
    for (const char* name : {"load scene", "start OpenGL", "check clocks", "set scene", "flatten", "upload geometry",
                             "compile shaders", "render", "read back", "encode PNG"})
        EXPECT_GT(tracedTime_us(trace, "cpu", name), 0.0) << name;
    // The GPU's passes do not overlap, and all end within their frames.
    const double frames_us = tracedTime_us(trace, "cpu", "frame");
    EXPECT_LE(tracedTime_us(trace, "gpu", ""), frames_us);
    EXPECT_LE(frames_us, tracedTime_us(trace, "cpu", "render"));
}

TEST_F(Cli, TraceIsWholeAfterAnErrorAndAfterCtrlC) {
    EXPECT_EQ(run({"render", "missing.obj", "-o", "a.png", "--trace", "error.json"}).code, 3);
    EXPECT_GT(tracedTime_us(Json::parse(content(m_folder / "error.json")), "cpu", "load scene"), 0.0);

    const pid_t child = start({"render", "gap", "-o", "a.png", "--frames", "100000", "--trace", "cut.json"});
    // The file is there, whole, before the work begins; then frames are drawn.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!fs::exists(m_folder / "cut.json") && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(Json::accept(content(m_folder / "cut.json")));
    std::this_thread::sleep_for(std::chrono::seconds(2));
    kill(child, SIGINT);
    EXPECT_EQ(finish(child).code, 130);
    EXPECT_GT(tracedTime_us(Json::parse(content(m_folder / "cut.json")), "cpu", "start OpenGL"), 0.0);
    EXPECT_FALSE(fs::exists(m_folder / "a.png"));
}

TEST_F(Cli, TraceThatCannotBeWrittenIsToldAtOnce) {
    fs::create_directories(m_folder / "folder");
    const Result result = run({"render", "gap", "-o", "a.png", "--trace", "folder"});
    EXPECT_EQ(result.code, 4);
    EXPECT_NE(result.err.find("cannot write the trace 'folder'"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(m_folder / "a.png"));
}

}  // namespace
}  // namespace ombrage::test
