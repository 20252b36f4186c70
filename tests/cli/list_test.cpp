// SPDX-License-Identifier: MIT
// What the program tells: help, lists, info, doctor.
#include <algorithm>
#include <fstream>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

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

TEST_F(Cli, DoctorPrintsOneDocument) {
    const Result result = run({"doctor", "--json"});
    EXPECT_EQ(result.code, 0) << result.out;
    const Json json = Json::parse(result.out);
    EXPECT_TRUE(json["healthy"].get<bool>());
    EXPECT_GT(json["checks"].size(), 3u);
}

}  // namespace
}  // namespace ombrage::test
