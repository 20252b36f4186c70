// SPDX-License-Identifier: MIT
// render, reference and diff.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <ombrage/image.h>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

TEST_F(Cli, InterruptingEndsAnImport) {
    std::ofstream(m_folder / "t.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(m_folder / "sleeper") << "#!/bin/sh\necho $$ > \"" << (m_folder / "pid").string()
                                        << "\"\nexec sleep 60\n";
    fs::permissions(m_folder / "sleeper", fs::perms::owner_all);
    const pid_t child =
        start({"render", "t.obj", "-o", "x.png"}, {{"OMBRAGE_IMPORT", (m_folder / "sleeper").string()}});
    while (content(m_folder / "pid").empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    kill(child, SIGINT);
    EXPECT_EQ(finish(child).code, 130);
    EXPECT_NE(kill(std::stoi(content(m_folder / "pid")), 0), 0) << "the importing process lives on";
}

TEST_F(Cli, DiffKnownAnswers) {
    // Grey 0 and grey 51/255 = 0.2 survive 8 bits exactly; the difference is 0.2 everywhere.
    for (const auto& [name, value] : {std::pair("a.png", 0.0f), std::pair("b.png", 0.2f)}) {
        ombrage::Image image = ombrage::Image::grey(40, 30);
        for (float& v : image.plane(0)) v = value;
        ombrage::writeImage(m_folder / name, image);
    }
    const Result rmse = run({"diff", "a.png", "b.png", "--metric", "rmse", "--json", "--map", "map.png"});
    EXPECT_EQ(rmse.code, 0) << rmse.err;
    EXPECT_NEAR(Json::parse(rmse.out)["value"].get<double>(), 0.2, 1e-6);  // float rounding
    EXPECT_TRUE(fs::exists(m_folder / "map.png"));
    EXPECT_EQ(run({"diff", "a.png", "b.png", "--metric", "rmse", "--fail-above", "0.1"}).code, 1);
    EXPECT_EQ(run({"diff", "a.png", "b.png", "--metric", "rmse", "--fail-above", "0.3"}).code, 0);
    const Json equal = Json::parse(run({"diff", "a.png", "a.png", "--metric", "psnr", "--json"}).out);
    EXPECT_TRUE(equal["value"].is_null());
    EXPECT_TRUE(equal["exact"].get<bool>());
}

TEST_F(Cli, RendersPngAndKeepsStdoutClean) {
    const Result result =
        run({"render", "gap", "-o", "sub/out.png", "--size", "64x36", "--eye", "-4,3,5", "--target", "0,0.5,0"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    const ombrage::Image image = ombrage::readImage(m_folder / "sub/out.png");
    EXPECT_EQ(image.width(), 64);
    EXPECT_EQ(image.height(), 36);
    const auto plane = image.plane(0);
    EXPECT_GT(*std::max_element(plane.begin(), plane.end()) - *std::min_element(plane.begin(), plane.end()), 0.1f)
        << "not one flat colour";
}

TEST_F(Cli, ShowAllFillsAFolder) {
    expectUsageError({"render", "gap", "--show", "all", "-o", "one.png"}, "name a folder");
    EXPECT_EQ(run({"render", "gap", "--size", "32x18", "--show", "all", "-o", "views"}).code, 0);
    for (const char* name : {"final", "visibility", "ao", "indirect", "depth", "normal", "position", "albedo"})
        EXPECT_EQ(ombrage::readImage(m_folder / "views" / (std::string(name) + ".png")).width(), 32) << name;
}

TEST_F(Cli, RenderJsonShowAndState) {
    const std::string shadow = idOf("shadow");
    std::ofstream(m_folder / "state.json")
        << Json{{"scene", "gap"}, {"shadow", shadow}, {"size", {48, 27}}, {"output", "state.png"}};
    const Result result = run({"render", "--state", "state.json", "--size", "32x18", "--json", "--show", "visibility"});
    EXPECT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["size"], Json::array({32, 18})) << "the command line wins";
    EXPECT_EQ(json["pipelines"]["shadow"], shadow);
    EXPECT_EQ(ombrage::readImage(m_folder / "state.png").width(), 32);

    const Json names = Json::parse(run({"render", "gap", "--show", "list", "--json"}).out);
    EXPECT_TRUE(
        std::any_of(names["names"].begin(), names["names"].end(), [](const Json& n) { return n["name"] == "depth"; }));

    std::ofstream(m_folder / "typo.json") << Json{{"scene", "gap"}, {"shadwo", shadow}};
    expectUsageError({"render", "--state", "typo.json", "-o", "x.png"}, "did you mean 'shadow'?");
}

TEST_F(Cli, ReferenceWritesItsPlanes) {
    const Result result =
        run({"reference", "gap", "-o", "ref.exr", "--quantity", "shadow", "--size", "64x36", "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out)["quantity"], "shadow");
    const ombrage::Image image = ombrage::readImage(m_folder / "ref.exr");
    for (const char* plane : {"visibility", "standard_error", "mask"}) EXPECT_GE(image.findPlane(plane), 0) << plane;
    EXPECT_EQ(run({"reference", "gap", "-o", "ref.png", "--quantity", "ao", "--spp", "8", "--size", "32x18"}).code, 0);
    EXPECT_EQ(ombrage::readImage(m_folder / "ref.png").planeCount(), 1);
    EXPECT_EQ(
        run({"reference", "gap", "-o", "look.png", "--quantity", "picture", "--spp", "8", "--size", "32x18"}).code, 0);
}

TEST_F(Cli, TracesEveryKindOfTruth) {
    const std::vector<std::vector<std::string>> questions = {
        {"shadow", "shadow"}, {"shadow", "self"},  {"shadow", "area"}, {"ao", "T1"},      {"ao", "T2"},
        {"ao", "T3"},         {"ao", "T4"},        {"ao", "T5"},       {"ao", "T5-ball"}, {"ao", "displaced"},
        {"ao", "area"},       {"picture", "area"}, {"indirect"}};
    for (const auto& question : questions) {
        std::vector<std::string> arguments = {"reference", "gap", "-o",     "x.png",      "--size",   "16x9",
                                              "--spp",     "8",   "--json", "--quantity", question[0]};
        if (question.size() > 1) arguments.insert(arguments.end(), {"--truth", question[1]});
        const Result result = run(arguments);
        ASSERT_EQ(result.code, 0) << question[0] << ": " << result.err;
        if (question.size() > 1) {
            EXPECT_EQ(Json::parse(result.out)["truth"], question[1]);
        }
    }
    const Result own = run({"reference", "gap", "-o", "x.exr", "--quantity", "ao", "--truth", "own", "--technique",
                            idOf("ao"), "--size", "16x9", "--json"});
    ASSERT_EQ(own.code, 0) << own.err;
    EXPECT_EQ(Json::parse(own.out)["technique"], idOf("ao"));
}

}  // namespace
}  // namespace ombrage::test
