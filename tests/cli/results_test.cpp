// SPDX-License-Identifier: MIT
// Folders of results: what is there is used again, and nothing that was done is lost.
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

TEST_F(Cli, RepeatedComparisonMeasuresOnlyWhatIsMissing) {
    const std::vector<std::string> command{"compare",     "gap",      "corner", "--technique", idOf("shadow"),
                                           "--technique", idOf("ao"), "-o",     "out",         "--size",
                                           "64x36",       "--spp",    "8",      "--json"};
    const Json first = Json::parse(run(command).out);
    EXPECT_EQ(first["reused"], 0);
    const std::string lines = content(m_folder / "out/records.jsonl");
    const Result second = run(command);
    ASSERT_EQ(second.code, 0) << second.err;
    const Json again = Json::parse(second.out);
    EXPECT_EQ(again["reused"], again["records"].size());
    EXPECT_NE(second.err.find("in the folder already"), std::string::npos) << second.err;
    EXPECT_EQ(again["records"], first["records"]);
    EXPECT_EQ(content(m_folder / "out/records.jsonl"), lines);

    // A picture that is gone takes its record with it, a gate holds for what is only looked up.
    fs::remove(m_folder / "out" / first["records"][0]["images"]["visibility"].get<std::string>());
    std::vector<std::string> gated = command;
    gated.insert(gated.end(), {"--fail-on", "mae>=0"});
    const Result mended = run(gated);
    EXPECT_EQ(mended.code, 1);
    EXPECT_EQ(Json::parse(mended.out)["reused"], first["records"].size() - 1);
    EXPECT_EQ(Json::parse(mended.out)["failed_gates"].size(), first["records"].size());

    std::vector<std::string> anew = command;
    anew.push_back("--again");
    EXPECT_EQ(Json::parse(run(anew).out)["reused"], 0);
    // Another seed is another question.
    std::vector<std::string> other = command;
    other.insert(other.end(), {"--seed", "2"});
    EXPECT_EQ(Json::parse(run(other).out)["reused"], 0);
    EXPECT_EQ(untimed("out").size(), 2 * first["records"].size());
}

TEST_F(Cli, ComparisonKilledTenTimesEndsAsTheOneThatWasNot) {
    const auto command = [](const char* folder) {
        return std::vector<std::string>{"compare", "gap",    "sphere", "corner", "room", "comb",
                                        "menger",  "--all",  "shadow", "--all",  "ao",   "-o",
                                        folder,    "--size", "160x90", "--spp",  "16"};
    };
    ASSERT_EQ(run(command("whole")).code, 0);
    const std::vector<std::string> expected = untimed("whole");
    std::mt19937 random(3);
    int killed = 0;
    for (int i = 0; i < 10; ++i) {
        const pid_t child = start(command("killed"));
        std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(20, 450)(random)));
        kill(child, SIGKILL);
        killed += finish(child).code == 1000 + SIGKILL;
        untimed("killed");  // throws for a line that is not whole
    }
    // A machine that is through in half a second would have tested nothing.
    EXPECT_GE(killed, 5);
    const Result last = run(command("killed"));
    ASSERT_EQ(last.code, 0) << last.err;
    expectSame(untimed("killed"), expected);
    EXPECT_EQ(content(m_folder / "killed/runs.jsonl").find("\"interrupted\":true"), std::string::npos);
}

TEST_F(Cli, TwoComparisonsShareAFolder) {
    const auto command = [](const char* folder, const char* scene) {
        return std::vector<std::string>{"compare", "sphere", scene,  "comb",   "--all",
                                        "shadow",  "-o",     folder, "--size", "96x54"};
    };
    ASSERT_EQ(run(command("alone", "gap")).code, 0);
    ASSERT_EQ(run(command("alone", "menger")).code, 0);
    const pid_t one = start(command("shared", "gap")), two = start(command("shared", "menger"));
    const Result first = finish(one), second = finish(two);
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(second.code, 0) << second.err;
    expectSame(untimed("shared"), untimed("alone"));
}

TEST_F(Cli, ResultsThatCannotBeUsedSayWhy) {
    const std::vector<std::string> command{"compare", "gap", "--technique", idOf("shadow"),
                                           "-o",      "out", "--size",      "64x36"};
    fs::create_directories(m_folder / "out/images");
    std::ofstream(m_folder / "out/results.sqlite") << std::string(4096, 'z');
    for (const auto& arguments : {command, {"report", "out"}}) {
        const Result damaged = run(arguments);
        EXPECT_EQ(damaged.code, 3) << damaged.err;
        EXPECT_NE(damaged.err.find("results.sqlite' are damaged"), std::string::npos) << damaged.err;
        EXPECT_NE(damaged.err.find("hint: "), std::string::npos) << damaged.err;
    }

    // A folder that cannot be written. Root may write anywhere, so it becomes somebody else.
    fs::remove_all(m_folder / "out");
    ASSERT_EQ(run(command).code, 0);
    fs::permissions(m_folder / "out", fs::perms(0555));
    for (const auto& arguments : {command, {"report", "out"}}) {
        const Result closed = finish(start(arguments, {}, [] { return getuid() == 0 && setuid(65534) != 0 ? 97 : 0; }));
        EXPECT_EQ(closed.code, 4) << closed.err;
        EXPECT_EQ(closed.out, "");
    }
    const Result elsewhere = finish(
        start({"report", "out", "-o", "/dev/null"}, {}, [] { return getuid() == 0 && setuid(65534) != 0 ? 97 : 0; }));
    EXPECT_EQ(elsewhere.code, 0) << elsewhere.err;
    fs::permissions(m_folder / "out", fs::perms(0755));
}

TEST_F(Cli, FullDiskIsToldAndWhatWasDoneIsKept) {
    fs::create_directories(m_folder / "out");
    const std::vector<std::string> command{"compare", "gap", "sphere", "room",   "--all", "shadow",
                                           "-o",      "out", "--size", "160x90", "--json"};
    // A disk of 256 KiB that only the child sees. It fills up; the second run, below, finds more space.
    constexpr int kNoDisk = 97, kNotFull = 96;
    const auto fillSmallDisk = [&] {
        const bool own = unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
        if (!own || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            mount("tmpfs", "out", "tmpfs", 0, "size=256k") != 0)
            return kNoDisk;
        const Result full = run(command);
        if (full.code != 4 || full.out != "" || full.err.find("hint: ") == std::string::npos) return kNotFull;
        return mount("tmpfs", "out", "tmpfs", MS_REMOUNT, "size=64m") == 0 ? 0 : kNoDisk;
    };
    const Result resumed = finish(start(command, {}, fillSmallDisk));
    if (resumed.code == kNoDisk) GTEST_SKIP() << "this machine lets nobody mount a small disk";
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_GT(Json::parse(resumed.out)["reused"], 0);
}

}  // namespace
}  // namespace ombrage::test
