// SPDX-License-Identifier: MIT
// compare and report.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

TEST_F(Cli, ComparesGatesAndReports) {
    const Result result = run({"compare", "gap", "--all", "shadow", "-o", "out", "--size", "96x54", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["schema"], "ombrage/records/1");
    ASSERT_GE(json["records"].size(), 1u);
    for (const Json& record : json["records"]) {
        EXPECT_EQ(record["schema"], "ombrage/record/1");
        EXPECT_TRUE(record["metrics"].contains("rmse"));
        EXPECT_TRUE(record["metrics"].contains("flip"));
        EXPECT_EQ(record["truth"]["kind"], "shadow");
        EXPECT_TRUE(record["images"].contains("classes"));
        for (const auto& [kind, path] : record["images"].items())
            EXPECT_TRUE(fs::exists(m_folder / "out" / path.get<std::string>())) << kind;
    }
    const std::string lines = content(m_folder / "out/records.jsonl");
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), std::ptrdiff_t(json["records"].size()));
    EXPECT_TRUE(fs::exists(m_folder / "out/report.html"));
    EXPECT_EQ(run({"report", "out", "-o", "again.html"}).code, 0);
    EXPECT_TRUE(fs::exists(m_folder / "again.html"));

    // Everything has a mean error of 0 or more, so this gate holds for every record.
    const Result gated =
        run({"compare", "gap", "--technique", idOf("shadow"), "-o", "gated", "--size", "96x54", "--fail-on", "mae>=0"});
    EXPECT_EQ(gated.code, 1) << gated.err;
    EXPECT_NE(gated.err.find("mae>=0"), std::string::npos);
}

TEST_F(Cli, NamesEveryError) {
    const Result result =
        run({"compare", "area-overlap", "--all", "shadow", "-o", "out", "--size", "240x135", "--spp", "32", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    int noisy = 0, quiet = 0;
    const Json json = Json::parse(result.out);
    for (const Json& record : json["records"]) {
        const Json& metrics = record["metrics"];
        double sum = 0;
        for (const char* key :
             {"missing", "contact_gap", "alias", "over_blur", "under_blur", "acne", "leak", "false_shadow", "other"})
            sum += metrics.at(key).get<double>();
        // 1e-12: the sum of nine shares.
        EXPECT_NEAR(sum, metrics.at("over").get<double>(), 1e-12);
        for (const char* key :
             {"rmse_lit", "rmse_penumbra", "hard_ratio", "edge_px", "leak_mass", "terminator", "leak_layered", "noise"})
            EXPECT_TRUE(metrics.contains(key) && metrics[key].is_number()) << key << " of " << record["technique"];
        ++(metrics["noise"] > 0 ? noisy : quiet);
    }
    // Few rays to a large lamp differ from seed to seed; shadows of its centre do not.
    EXPECT_GT(noisy, 0);
    EXPECT_GT(quiet, 0);
    const std::string page = content(m_folder / "out/report.html");
    EXPECT_NE(page.find("false_shadow</dt>"), std::string::npos) << "the legend of the class pictures";
}

TEST_F(Cli, ComparesOcclusionAndFilters) {
    const Result result = run({"compare", "corner", "--all", "ao", "--all", "filter", "--all", "aa", "-o", "out",
                               "--size", "64x36", "--spp", "16", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(result.out);
    bool piped = false;
    int own = 0;
    for (const Json& record : json["records"]) {
        const std::string family = record["family"];
        EXPECT_TRUE(record["light"].is_null());
        if (family == "ao") {
            const std::string kind = record["truth"]["kind"];
            EXPECT_TRUE(kind == "T1" || kind == "own") << kind;
            own += kind == "own";
        } else {
            EXPECT_TRUE(record["truth"].is_null());
        }
        piped = piped || record["technique"].get<std::string>().find("+filter/") != std::string::npos;
    }
    EXPECT_TRUE(piped);
    EXPECT_GT(own, 0);

    // One kind instead, for a shadow, its occlusion and an edge filter's picture.
    const Result area = run({"compare", "gap", "--technique", idOf("shadow"), "--technique", idOf("ao"), "--all", "aa",
                             "--truth", "area", "-o", "area", "--size", "32x18", "--spp", "16", "--json"});
    ASSERT_EQ(area.code, 0) << area.err;
    const Json areas = Json::parse(area.out);
    EXPECT_GE(areas["records"].size(), 3u);
    for (const Json& record : areas["records"]) {
        EXPECT_EQ(record["truth"]["kind"], "area");
        EXPECT_FALSE(record["metrics"].contains("acne"));
        EXPECT_FALSE(record["metrics"].contains("edge_px"));
    }
}

TEST_F(Cli, InterruptKeepsWholeLinesAndExits130) {
    // Many scenes at a size that takes far longer than the wait.
    const pid_t child = start(
        {"compare", "gap", "sphere", "room", "menger", "comb", "--all", "shadow", "-o", "out", "--size", "640x360"});
    for (int i = 0; i < 600 && content(m_folder / "out/records.jsonl").empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(child, SIGINT);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 130) << result.err;
    const std::string lines = content(m_folder / "out/records.jsonl");
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.back(), '\n');
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);) EXPECT_TRUE(Json::accept(line)) << line;
    EXPECT_TRUE(fs::exists(m_folder / "out/report.html"));
}

// The report's command must measure the same again, whatever made the scene what it is.
TEST_F(Cli, TheReportsCommandMeasuresTheSameAgain) {
    std::ofstream(m_folder / "tri angle.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n";
    std::ofstream(m_folder / "lab.json") << R"({"name": "laboratory", "models": [{"file": "tri angle.obj"}],
        "lights": [{"name": "lamp", "type": "point", "position": [1, 3, 1]}],
        "cameras": [{"name": "it's", "position": [3, 2, 3], "target": [0, 0, 0]}],
        "animations": [{"type": "orbit-light", "light": "lamp"}]})";
    const std::vector<std::vector<std::string>> calls{
        {"lab.json", "--time", "2.5"}, {"tri angle.obj", "--ground", "--eye", "-2,1.5,2.5", "--target", "0,0.25,0"}};
    for (std::vector<std::string> words : calls) {
        words.insert(words.begin(), "compare");
        words.insert(words.end(),
                     {"--technique", "shadow/map:resolution=64", "--size", "64x36", "--seed", "5", "-o", "out"});
        const Result result = run(words);
        ASSERT_EQ(result.code, 0) << result.err;
        const std::string page = content(m_folder / "out/report.html"), begin = "<p class=\"command\"><code>";
        const std::size_t from = page.find(begin) + begin.size();
        ASSERT_GT(from, begin.size());
        std::string command = page.substr(from, page.find("</code>", from) - from);
        for (std::size_t at = 0; (at = command.find("&#39;", at)) != std::string::npos;) command.replace(at, 5, "'");
        const std::string shell = "cd '" + m_folder.string() + "' && '" OMBRAGE_PROGRAM "'" +
                                  command.substr(std::string("ombrage").size()) + " >/dev/null 2>&1";
        EXPECT_EQ(std::system(shell.c_str()), 0) << command;
        const auto recordIn = [&](const char* folder) {
            std::ifstream lines(m_folder / folder / "records.jsonl");
            std::string line;
            std::getline(lines, line);
            return Json::parse(line);
        };
        const Json first = recordIn("out"), again = recordIn("again");
        for (const char* key :
             {"scene", "scene_hash", "camera", "light", "time_s", "size", "seed", "pipeline", "metrics", "truth"})
            EXPECT_EQ(first[key], again[key]) << key << " of " << command;
        fs::remove_all(m_folder / "out");
        fs::remove_all(m_folder / "again");
    }
}

}  // namespace
}  // namespace ombrage::test
