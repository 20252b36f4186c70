// SPDX-License-Identifier: MIT
// bench and tune.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

TEST_F(Cli, BenchExportsAndHoldsAgainstABaseline) {
    const std::vector<std::string> command{"bench",    "gap", "--technique", idOf("shadow"),
                                           "--frames", "8",   "--size",      "32x18"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), command.begin(), command.end());
        return more;
    };
    const Result first =
        run(with({"--export-json", "a.json", "--export-csv", "deep/a.csv", "--export-markdown", "a.md"}));
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(first.out, content(m_folder / "a.md"));
    EXPECT_NE(content(m_folder / "deep/a.csv").find("\"gap\""), std::string::npos);
    Json baseline = Json::parse(content(m_folder / "a.json"));
    EXPECT_EQ(baseline["schema"], "ombrage/bench/1");

    // A baseline of a hundredth of the time: nothing on this machine is noisy enough to hide that.
    Json& deciding = baseline["groups"][0]["runs"][0][baseline["decided_by"].get<std::string>()];
    for (Json& sample : deciding["samples"]) sample = sample.get<double>() / 100;
    std::ofstream(m_folder / "fast.json") << baseline;
    const Result slower = run(with({"--baseline", "fast.json", "--fail-on", "+50%", "--json"}));
    EXPECT_EQ(slower.code, 1) << slower.err;
    EXPECT_NE(slower.err.find("against the baseline"), std::string::npos) << slower.err;
    EXPECT_EQ(Json::parse(slower.out)["regressions"].size(), 1u);
    for (Json& sample : deciding["samples"]) sample = sample.get<double>() * 10000;
    std::ofstream(m_folder / "slow.json") << baseline;
    EXPECT_EQ(run(with({"--baseline", "slow.json", "--fail-on", "+50%"})).code, 0);

    EXPECT_EQ(run(with({"--baseline", "none.json"})).code, 3);
    expectUsageError(with({"--fail-on", "+5%"}), "--baseline");
    expectUsageError(with({"--sweep", "resolution"}), "AXIS=A..B");
    expectUsageError(with({"--program", "--sweep", "size=1..2"}), "does not go with --program");
    expectUsageError(with({"--seconds", "3"}), "--program only");
    expectUsageError(with({"--sweep", "resolution=64,64"}), "stands twice");
}

TEST_F(Cli, BenchMeasuresWholeProgramsApart) {
    const Result result = run({"bench", "gap", "--program", "--technique", "shadow/none", "--technique", idOf("shadow"),
                               "--seconds", "1", "--size", "32x18", "--json", "--export-json", "p.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["schema"], "ombrage/program/1");
    ASSERT_EQ(json["programs"].size(), 2u);
    for (const Json& row : json["programs"]) {
        EXPECT_GT(row["fps"], 0);
        EXPECT_GT(row["memory_mib"], 10);
    }
    EXPECT_EQ(content(m_folder / "p.json"), result.out);
}

TEST_F(Cli, TunesAWrongDefaultAwayAndGoesOnWhereItWas) {
    // A bias of 32 texels at a coarse map: known to be wrong, contact shadows are gone.
    const auto command = [this](const char* folder, const char* evaluations) {
        return std::vector<std::string>{
            "tune",   "gap",   "--technique",   idOf("shadow") + ":constant-bias=32,resolution=64",
            "--size", "96x54", "--evaluations", evaluations,
            "-o",     folder,  "--export",      "threejs",
            "--json"};
    };
    const Result whole = run(command("whole", "50"));
    ASSERT_EQ(whole.code, 0) << whole.err;
    const Json tuned = Json::parse(whole.out);
    EXPECT_EQ(tuned["candidates"].size(), 50u);
    EXPECT_EQ(tuned["candidates"][0]["pipeline"], tuned["start"]["pipeline"]);
    // Half is far more than the defaults alone gain, and far less than is there to be gained.
    const double before = tuned["start"]["held_out"]["error"], after = tuned["winner"]["held_out"]["error"];
    EXPECT_LT(after, 0.5 * before);
    EXPECT_NE(tuned["sentence"].get<std::string>().find("held-out cameras"), std::string::npos);
    EXPECT_TRUE(fs::exists(m_folder / "whole/tune-threejs.json"));
    EXPECT_EQ(Json::parse(content(m_folder / "whole/tune.json"))["sentence"], tuned["sentence"]);

    // A shorter search and then the whole one: the same, and nothing is measured twice.
    const Json part = Json::parse(run(command("parts", "20")).out);
    const Json rest = Json::parse(run(command("parts", "50")).out);
    EXPECT_GE(rest["reused"], 20);
    EXPECT_EQ(rest["winner"], tuned["winner"]);
    EXPECT_EQ(rest["candidates"], tuned["candidates"]);
    const Json again = Json::parse(run(command("parts", "50")).out);
    EXPECT_EQ(again["measured"], 0);
    EXPECT_EQ(again["winner"], tuned["winner"]);
}

TEST_F(Cli, TuneEndsOnCtrlCAndKeepsTheBestSoFar) {
    const std::string technique = idOf("shadow");
    const pid_t child = start({"tune", "menger", "--technique", technique, "--size", "640x360", "--evaluations",
                               "100000", "-o", "out", "--json"});
    for (int i = 0;
         i < 600 && content(m_folder / "stderr").find("menger, main: " + technique + ":") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(child, SIGINT);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 130) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_TRUE(json["interrupted"].get<bool>());
    EXPECT_GE(json["candidates"].size(), 1u);
    EXPECT_LE(json["winner"]["searched"]["error"], json["start"]["searched"]["error"]);
}

TEST_F(Cli, TuneRefusesWhatDoesNotFit) {
    const std::string technique = idOf("shadow");
    const std::vector<std::vector<std::string>> wrong{
        {"tune", "--technique", technique, "-o", "out"},
        {"tune", "gap", "-o", "out"},
        {"tune", "gap", "--technique", technique},
        {"tune", "gap", "--technique", technique, "-o", "out", "--metric", "rmze"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--keep", "resolutoin"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--holdout", "nowhere"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--weight", "menger=2"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--export", "unreal"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--pareto", "--error-below", "rmse=0.1"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--metric", "flicker_mean"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--error-below", "lag=2"},
        {"tune", "gap", "--technique", technique, "-o", "out", "--seconds", "0"},
        {"tune", "gap", "--technique", idOf("ao"), "-o", "out", "--truth", "own"},
        {"tune", "gap", "--technique", "shadow/none", "-o", "out"}};
    for (const auto& arguments : wrong) {
        const Result result = run(arguments);
        EXPECT_EQ(result.code, 2) << arguments.back() << "\n" << result.err;
    }
    // An error bound that nothing meets is told, with the nearest, and fails.
    const Result unmet = run({"tune", "menger", "--technique", technique + ":resolution=16", "--size", "64x36",
                              "--evaluations", "1", "--cost", "memory", "--error-below", "rmse=0", "-o", "out"});
    EXPECT_EQ(unmet.code, 1) << unmet.err;
    EXPECT_EQ(unmet.out.rfind("Nothing within the limits was found", 0), 0u) << unmet.out;
    // So is a budget that leaves no front.
    const Result none = run({"tune", "gap", "--technique", technique, "--size", "64x36", "--evaluations", "4", "--cost",
                             "memory", "--memory", "0.001", "--pareto", "-o", "out"});
    EXPECT_EQ(none.code, 1) << none.out;
    EXPECT_EQ(none.out.rfind("Nothing within the limits was found", 0), 0u) << none.out;
}

}  // namespace
}  // namespace ombrage::test
