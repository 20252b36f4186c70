// SPDX-License-Identifier: MIT
// Wrong usage and bad input: exit codes and messages. What the environment must not change.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "cli/cli_fixture.h"

namespace ombrage::test {
namespace {

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

TEST_F(Cli, EmptyTextsAndSilentGatesAreErrors) {
    expectUsageError({"render", "gap", "--light", "", "-o", "x.png"}, "--light is given an empty text");
    expectUsageError(
        {"compare", "gap", "--technique", idOf("shadow"), "--fail-on", idOf("ao") + ".rmse>0", "-o", "out"},
        "not compared");
    expectUsageError({"compare", "gap", "--technique", idOf("shadow"), "--fail-on", "flicker_mean>0.1", "-o", "out"},
                     "nothing moves");
    expectUsageError({"render", "gap", "--shader-dir", ".", "-o", "x.png"}, "holds no shader");
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
}  // namespace ombrage::test
