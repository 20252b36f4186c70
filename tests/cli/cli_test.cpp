// SPDX-License-Identifier: MIT
// The program from outside: exit codes, streams, files. OMBRAGE_PROGRAM names the binary.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <ombrage/image.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Result {
    int code = -1;
    std::string out, err;
};

class Cli : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::path(testing::TempDir()) /
                   (std::string("ombrage_cli_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    /// @param prepare  runs in the child before the program; what is not 0 becomes the exit code in its place
    pid_t start(std::vector<std::string> arguments,
                const std::vector<std::pair<std::string, std::string>>& environment = {},
                const std::function<int()>& prepare = {}) {
        arguments.insert(arguments.begin(), OMBRAGE_PROGRAM);
        const pid_t child = fork();
        if (child != 0) return child;
        for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
        const auto redirect = [&](const char* file, int target) {
            dup2(open((m_folder / file).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), target);
        };
        redirect("stdout", STDOUT_FILENO);
        redirect("stderr", STDERR_FILENO);
        if (chdir(m_folder.c_str()) != 0) _exit(99);
        if (const int failed = prepare ? prepare() : 0) _exit(failed);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        execv(OMBRAGE_PROGRAM, pointers.data());
        _exit(98);
    }

    Result finish(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), content(m_folder / "stdout"),
                content(m_folder / "stderr")};
    }

    Result run(const std::vector<std::string>& arguments,
               const std::vector<std::pair<std::string, std::string>>& environment = {}) {
        return finish(start(arguments, environment));
    }

    /// The records of a folder without what is measured with a clock, sorted; every line is whole.
    std::vector<std::string> untimed(const char* folder) {
        std::vector<std::string> records;
        std::istringstream in(content(m_folder / folder / "records.jsonl"));
        for (std::string line; std::getline(in, line);) {
            Json record = Json::parse(line);
            record.erase("gpu_ms");
            record.erase("cpu_ms");
            for (Json& pass : record["passes"]) pass.erase("gpu_ms");
            // The folders differ in name only: the pictures must be there and equal.
            for (const auto& [kind, path] : record["images"].items())
                record["images"][kind] = {path, content(m_folder / folder / path.get<std::string>()).size()};
            records.push_back(record.dump());
        }
        std::sort(records.begin(), records.end());
        return records;
    }

    /// Shows the records that differ, and no others.
    static void expectSame(const std::vector<std::string>& found, const std::vector<std::string>& expected) {
        std::vector<std::string> missing, extra;
        std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(), std::back_inserter(missing));
        std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(extra));
        for (const std::string& record : missing) ADD_FAILURE() << "missing: " << record;
        for (const std::string& record : extra) ADD_FAILURE() << "not expected: " << record;
    }

    /// The first id of the family beside its baseline.
    std::string idOf(const std::string& family) {
        const Json json = Json::parse(run({"list", "--family", family, "--json"}).out);
        return json["techniques"].size() > 1 ? json["techniques"][1]["id"] : json["techniques"][0]["id"];
    }

    void expectUsageError(const std::vector<std::string>& arguments, const std::string& message) {
        const Result result = run(arguments);
        EXPECT_EQ(result.code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }

    fs::path m_folder;
};

TEST_F(Cli, VersionAndHelp) {
    const Result version = run({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.rfind("ombrage ", 0), 0u) << version.out;
    for (const char* command :
         {"list", "info", "doctor", "render", "reference", "compare", "bench", "diff", "report", "demo"})
        for (const char* option : {"--help", "-h"}) {
            const Result help = run({command, option});
            EXPECT_EQ(help.code, 0) << command;
            EXPECT_NE(help.out.find("Examples:\n  ombrage " + std::string(command)), std::string::npos) << help.out;
            EXPECT_NE(help.out.find("Usage: ombrage " + std::string(command)), std::string::npos) << help.out;
            EXPECT_EQ(help.err, "");
        }
}

TEST_F(Cli, NoCommandIsWrongUsage) {
    const Result result = run({});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("compare"), std::string::npos);
}

TEST_F(Cli, StateErrorsNameTheLine) {
    const auto errorOf = [&](const std::string& text) {
        std::ofstream(m_folder / "s.json", std::ios::binary) << text;
        const Result result = run({"render", "gap", "-o", "x.png", "--state", "s.json"});
        EXPECT_NE(result.code, 0) << text;
        EXPECT_EQ(result.err.find("json.exception"), std::string::npos) << result.err;
        return result.err;
    };
    EXPECT_NE(errorOf("{\n\"seed\": }").find("s.json:2"), std::string::npos);
    EXPECT_NE(errorOf("{\n\n\"seed\": 1e999}").find("s.json:3"), std::string::npos);
    EXPECT_NE(errorOf("{\n\"sede\": 1}").find("s.json:2: /sede"), std::string::npos);
    EXPECT_NE(errorOf("{\"seed\": 1,\n\"seed\": 2}").find("s.json:2: /seed"), std::string::npos);
    EXPECT_NE(errorOf("{\"size\":\n[{}, 2]}").find("s.json:2: /size"), std::string::npos);
    EXPECT_NE(errorOf(std::string("{}\n\0", 4)).find("s.json:2"), std::string::npos);
    EXPECT_EQ(run({"render", "gap", "-o", "x.png", "--state", "/dev/zero"}).code, 3);
}

TEST_F(Cli, APictureThatNoMemoryHoldsIsRefused) {
    // The largest size takes 25 GiB: on a machine that has them nothing is asked.
    if (double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)) > 25.0 * 1024 * 1024 * 1024)
        GTEST_SKIP() << "SKIPPED: this machine has memory for the largest picture";
    const Result result = run({"render", "gap", "-o", "x.png", "--size", "16384x16384"});
    EXPECT_EQ(result.code, 4);
    EXPECT_NE(result.err.find("needs about 25 GiB"), std::string::npos) << result.err;
}

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

TEST_F(Cli, InfoTellsWhatASceneHolds) {
    const Result text = run({"info", "gap"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_EQ(text.err, "");
    for (const char* part : {"triangles  140", "meshes (2)", "closed", "open, 32 edges", "lights (1)", "cameras (3)"})
        EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
    const Json json = Json::parse(run({"info", "gap", "--json"}).out);
    EXPECT_EQ(json["schema"], "ombrage/info/1");
    EXPECT_EQ(json["triangles"], 140);
    EXPECT_EQ(json["meshes"][0]["shape"], "open");
    EXPECT_EQ(json["meshes"][0]["open_edges"], 32);
    EXPECT_EQ(json["meshes"][1]["shape"], "closed");
    EXPECT_EQ(json["bounds"]["size_m"][0], 6.0);
    EXPECT_EQ(json["content_hash"].get<std::string>().size(), 16u);
    EXPECT_EQ(json["ambient"], 0.2);
    EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(Cli, InfoOfModelFilesAndItsErrors) {
    std::ofstream(m_folder / "m.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nl 1 2\nusemtl \"gone\nf 1 2 3 4\n";
    const Json json = Json::parse(run({"info", "m.obj", "--json", "--ground"}).out);
    EXPECT_EQ(json["meshes"][0]["triangles"], 2);
    EXPECT_EQ(json["models"][1]["name"], "ground");
    ASSERT_EQ(json["warnings"].size(), 1u);
    EXPECT_EQ(json["warnings"][0], "1 points, lines and curves are left out, the first in m.obj:5: 'l'");

    std::ofstream(m_folder / "bad.obj") << "v 0 0 0\nv 1 0 0\nf 1 2 3\n";
    const Result bad = run({"info", "bad.obj", "--json"});
    EXPECT_EQ(bad.code, 3);
    EXPECT_EQ(bad.out, "");
    EXPECT_NE(bad.err.find("bad.obj:3"), std::string::npos) << bad.err;
    EXPECT_EQ(run({"info", "none.obj"}).code, 3);
    expectUsageError({"info"}, "no scene");
    expectUsageError({"info", "gapp"}, "did you mean 'gap'?");
}

TEST_F(Cli, ListScenesAndInfoAgree) {
    const Json scenes = Json::parse(run({"list", "scenes", "--json"}).out);
    EXPECT_GE(scenes["scenes"].size(), 13u);
    for (const Json& scene : scenes["scenes"]) {
        const Result info = run({"info", scene["name"].get<std::string>(), "--json"});
        ASSERT_EQ(info.code, 0) << scene["name"] << info.err;
        EXPECT_GT(Json::parse(info.out)["triangles"], 0) << scene["name"];
    }
}

TEST_F(Cli, MisspeltNamesAreSuggested) {
    expectUsageError({"rendr", "gap"}, "did you mean 'render'?");
    expectUsageError({"render", "gap", "-o", "x.png", "--shadwo", "y"}, "did you mean '--shadow'?");
    expectUsageError({"render", "gap", "-o", "x.png", "--sise=3x3"}, "did you mean '--size'?");
    expectUsageError({"render", "gapp", "-o", "x.png"}, "did you mean 'gap'?");
    expectUsageError({"render", "gap", "-o", "x.png", "--camera", "nowhere"}, "unknown camera 'nowhere'");
    expectUsageError({"render", "gap", "-o", "x.png", "--shading", "fong"}, "did you mean 'phong'?");
    expectUsageError({"list", "scnes"}, "did you mean 'scenes'?");
    expectUsageError({"list", "--family", "shadwo"}, "did you mean 'shadow'?");
    expectUsageError({"diff", "a.png", "b.png", "--metric", "rms"}, "did you mean 'rmse'?");
    expectUsageError({"compare", "gap", "--all", "shadwo", "-o", "out"}, "did you mean 'shadow'?");
    expectUsageError({"compare", "gap", "--all", "shadow", "-o", "out", "--fail-on", "rmsee>1"},
                     "did you mean 'rmse'?");
    EXPECT_FALSE(fs::exists(m_folder / "x.png"));
    EXPECT_FALSE(fs::exists(m_folder / "out"));
}

TEST_F(Cli, RefusesWrongValues) {
    expectUsageError({"render", "gap", "-o", "x.png", "--size", "640"}, "write WxH");
    expectUsageError({"render", "gap", "-o", "x.png", "--size", "0x9"}, "1 to 16384");
    expectUsageError({"render", "gap", "-o", "x.png", "--time", "0,5"}, "not a number");
    expectUsageError({"render", "gap", "-o", "x.png", "--frames", "0"}, "from 1");
    expectUsageError({"render", "gap", "-o", "x.png", "--composite", "overlay:2"}, "from 0 to 1");
    expectUsageError({"render", "gap", "-o", "x.png", "--eye", "1,2"}, "X,Y,Z");
    expectUsageError({"render", "gap"}, "-o out.png");
    expectUsageError({"render"}, "no scene");
    expectUsageError({"render", "gap", "sphere", "-o", "x.png"}, "one argument too many");
    expectUsageError({"compare", "gap", "-o", "out"}, "no technique");
    expectUsageError({"reference", "gap", "-o", "x.exr", "--quantity", "indirekt"}, "indirect");
    expectUsageError({"reference", "gap", "-o", "x.exr", "--quantity", "ao", "--truth", "T9"}, "T1");
    expectUsageError({"reference", "gap", "-o", "x.exr", "--quantity", "ao", "--truth", "self"}, "does not fit");
    expectUsageError({"reference", "gap", "-o", "x.exr", "--quantity", "ao", "--truth", "own"}, "--technique");
    expectUsageError({"reference", "gap", "-o", "x.exr", "--quantity", "shadow", "--technique", idOf("ao")},
                     "--truth own");
    expectUsageError({"compare", "gap", "--technique", idOf("shadow"), "--truth", "T2", "-o", "x"}, "does not fit");
    expectUsageError({"compare", "gap", "--technique", "ao/none", "--truth", "own", "-o", "x"}, "claims no integral");
}

TEST_F(Cli, SetChecksTechniqueParameterAndUse) {
    const std::string shadow = idOf("shadow"), ao = idOf("ao");
    expectUsageError({"render", "gap", "-o", "x.png", "--shadow", shadow, "--set", "no-such-thing.a=1"},
                     "unknown technique in --set");
    expectUsageError({"render", "gap", "-o", "x.png", "--shadow", shadow, "--set", shadow + ".no-such-key=1"},
                     "no-such-key");
    expectUsageError({"render", "gap", "-o", "x.png", "--set", shadow + "=1"}, "not ID.param=value");
    expectUsageError({"render", "gap", "-o", "x.png", "--set", shadow + ".a=1"}, "not in use");
}

TEST_F(Cli, BadInputFilesExitThree) {
    std::ofstream(m_folder / "bad.json") << "{ \"models\": ";
    std::ofstream(m_folder / "bad.png") << "not a picture";
    EXPECT_EQ(run({"render", "bad.json", "-o", "x.png"}).code, 3);
    EXPECT_EQ(run({"diff", "bad.png", "bad.png"}).code, 3);
    EXPECT_EQ(run({"report", "."}).code, 3);
    EXPECT_EQ(run({"render", "gap", "-o", "x.png", "--state", "missing.json"}).code, 3);
}

TEST_F(Cli, ListsAsJson) {
    const Json techniques = Json::parse(run({"list", "--json"}).out);
    EXPECT_EQ(techniques["schema"], "ombrage/techniques/1");
    ASSERT_GE(techniques["techniques"].size(), 5u) << "one of each family at least";
    for (const Json& t : techniques["techniques"])
        for (const Json& p : t["params"]) EXPECT_FALSE(p["help"].get<std::string>().empty()) << t["id"] << p["key"];
    const Json scenes = Json::parse(run({"list", "scenes", "--json"}).out);
    EXPECT_TRUE(std::any_of(scenes["scenes"].begin(), scenes["scenes"].end(),
                            [](const Json& s) { return s["name"] == "gap"; }));
    const Json metrics = Json::parse(run({"list", "metrics", "--json"}).out);
    EXPECT_TRUE(std::any_of(metrics["metrics"].begin(), metrics["metrics"].end(),
                            [](const Json& m) { return m["key"] == "rmse"; }));
    const Json params = Json::parse(run({"list", "params", idOf("shadow"), "--json"}).out);
    EXPECT_EQ(params["schema"], "ombrage/params/1");
}

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

TEST_F(Cli, DoctorPrintsOneDocument) {
    const Result result = run({"doctor", "--json"});
    EXPECT_EQ(result.code, 0) << result.out;
    const Json json = Json::parse(result.out);
    EXPECT_TRUE(json["healthy"].get<bool>());
    EXPECT_GT(json["checks"].size(), 3u);
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

TEST_F(Cli, EmptyTextsAndSilentGatesAreErrors) {
    expectUsageError({"render", "gap", "--light", "", "-o", "x.png"}, "--light is given an empty text");
    expectUsageError(
        {"compare", "gap", "--technique", idOf("shadow"), "--fail-on", idOf("ao") + ".rmse>0", "-o", "out"},
        "not compared");
    expectUsageError({"compare", "gap", "--technique", idOf("shadow"), "--fail-on", "flicker_mean>0.1", "-o", "out"},
                     "nothing moves");
    expectUsageError({"render", "gap", "--shader-dir", ".", "-o", "x.png"}, "holds no shader");
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

TEST_F(Cli, TracesEveryKindOfTruth) {
    const std::vector<std::vector<std::string>> questions = {
        {"shadow", "shadow"}, {"shadow", "self"}, {"shadow", "area"},  {"ao", "T1"},
        {"ao", "T2"},         {"ao", "T3"},       {"ao", "T4"},        {"ao", "T5"},
        {"ao", "T5-ball"},    {"ao", "area"},     {"picture", "area"}, {"indirect"}};
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

TEST_F(Cli, ADecimalCommaInTheEnvironmentChangesNothing) {
    // Without the locale installed the variable has no effect; with it, it must have none either.
    const std::vector<std::pair<std::string, std::string>> german{{"LC_ALL", "de_DE.UTF-8"}};
    const std::vector<std::string> command{"reference", "gap", "-o",     "a.exr", "--quantity", "shadow",
                                           "--time",    "0.5", "--size", "32x18", "--json"};
    const Result plain = run(command), comma = run(command, german);
    EXPECT_EQ(comma.code, 0) << comma.err;
    EXPECT_EQ(plain.out, comma.out);
    expectUsageError({"reference", "gap", "-o", "a.exr", "--quantity", "shadow", "--time", "0,5"}, "not a number");
}

TEST_F(Cli, ProgressIsPlainOffTerminals) {
    const Result result = run({"reference", "gap", "-o", "a.exr", "--quantity", "ao", "--spp", "8", "--size", "32x18"},
                              {{"NO_COLOR", "1"}});
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(result.err.find('\r'), std::string::npos);
}

}  // namespace
