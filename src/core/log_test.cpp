// SPDX-License-Identifier: MIT
#include "core/log.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// Puts the sink that was there back.
class LogTest : public testing::Test {
protected:
    ~LogTest() override { setLogSink(m_before); }

private:
    LogSink m_before = setLogSink({});
};

TEST_F(LogTest, TheSinkGetsLevelAndText) {
    std::vector<std::pair<LogLevel, std::string>> got;
    setLogSink([&](LogLevel level, const std::string& text) { got.emplace_back(level, text); });
    debug("one");
    info("two");
    warn("three");
    const std::vector<std::pair<LogLevel, std::string>> expected = {
        {LogLevel::Debug, "one"}, {LogLevel::Info, "two"}, {LogLevel::Warning, "three"}};
    EXPECT_EQ(got, expected);
}

TEST_F(LogTest, WithoutASinkNothingIsPrinted) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    warn("unheard");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LogTest, SettingASinkReturnsTheOldOne) {
    int first = 0, second = 0;
    setLogSink([&](LogLevel, const std::string&) { ++first; });
    const LogSink old = setLogSink([&](LogLevel, const std::string&) { ++second; });
    info("to the second");
    ASSERT_TRUE(old);
    old(LogLevel::Info, "to the first");
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 1);
}

TEST_F(LogTest, OneCallAtATime) {
    std::atomic<int> inside = 0;
    int overlaps = 0, count = 0;
    setLogSink([&](LogLevel, const std::string&) {
        if (++inside != 1) ++overlaps;
        ++count;
        std::this_thread::yield();
        --inside;
    });
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([] {
            for (int i = 0; i < 500; ++i) info("x");
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(overlaps, 0);
    EXPECT_EQ(count, 2000);
}

}  // namespace
}  // namespace ombrage
