// SPDX-License-Identifier: MIT
// The rules that the compiler does not see: who may include whom, what a technique's folder holds, what no file may
// say.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = OMBRAGE_SOURCE_DIR;

std::string textOf(const fs::path& file) {
    std::ifstream input(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
}

std::vector<fs::path> filesUnder(const fs::path& folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> files;
    if (!fs::exists(kRoot / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
        if (entry.is_regular_file() && extensions.count(entry.path().extension().string()))
            files.push_back(entry.path());
    return files;
}

const std::set<std::string> kCpp = {".h", ".cpp"};
const std::set<std::string> kGlsl = {".glsl", ".vert", ".frag", ".geom", ".comp"};

std::vector<std::string> includesOf(const std::string& text, char open) {
    const std::regex pattern(open == '"' ? R"re((?:^|\n)#include "([^"]+)")re" : R"re((?:^|\n)#include <([^>]+)>)re");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) found.push_back((*it)[1]);
    return found;
}

// The layers of docs/dev/architecture.md.
TEST(Lint, LayersIncludeOnlyWhatIsBelowThem) {
    const std::map<std::string, std::set<std::string>> allowed = {
        {"core", {"core"}},
        {"scene", {"scene", "core"}},
        {"reference", {"reference", "scene", "core"}},
        {"metrics", {"metrics", "core"}},
        {"gl", {"gl", "core"}},
        {"render", {"render", "gl", "scene", "core", "reference"}},
        // Its own folder; other techniques are refused below.
        {"techniques", {"techniques", "render", "gl", "scene", "core", "reference"}},
        {"lab", {"lab", "core", "scene", "metrics", "report"}},
        // The legend of the error maps is drawn from the table that coloured them.
        {"report", {"report", "core", "lab/run_record.h", "lab/store.h", "metrics/error_colors.h"}},
    };
    for (const auto& [layer, mayUse] : allowed)
        for (const fs::path& file : filesUnder("src/" + layer, kCpp)) {
            if (file.filename().string().find("_test.") != std::string::npos) continue;
            for (const std::string& include : includesOf(textOf(file), '"')) {
                const bool fits = std::any_of(mayUse.begin(), mayUse.end(), [&](const std::string& prefix) {
                    return include == prefix || include.rfind(prefix + "/", 0) == 0;
                });
                EXPECT_TRUE(fits) << file << " includes " << include;
            }
        }
}

TEST(Lint, AppsAndExamplesUsePublicHeadersOnly) {
    for (const char* folder : {"apps", "examples"})
        for (const fs::path& file : filesUnder(folder, kCpp))
            for (const std::string& include : includesOf(textOf(file), '"'))
                EXPECT_TRUE(fs::exists(file.parent_path() / include)) << file << " includes " << include;
}

TEST(Lint, PublicHeadersStayFreeOfOtherLibraries) {
    for (const fs::path& file : filesUnder("include", kCpp)) {
        EXPECT_TRUE(includesOf(textOf(file), '"').empty()) << file;
        for (const std::string& include : includesOf(textOf(file), '<')) {
            const bool isStandard = include.find('.') == std::string::npos && include.find('/') == std::string::npos;
            EXPECT_TRUE(isStandard || include.rfind("ombrage/", 0) == 0 || include.rfind("glm/", 0) == 0)
                << file << " includes " << include;
        }
    }
}

TEST(Lint, RawGlCallsLiveInGlAndInTechniques) {
    const std::regex call(R"(\bgl[A-Z][A-Za-z0-9]+\s*\()");
    for (const char* folder :
         {"src/core", "src/scene", "src/reference", "src/metrics", "src/render", "src/lab", "src/report", "apps"})
        for (const fs::path& file : filesUnder(folder, kCpp)) {
            if (file.filename().string().find("_test.") != std::string::npos) continue;
            const std::string text = textOf(file);
            std::smatch match;
            EXPECT_FALSE(std::regex_search(text, match, call)) << file << ": " << match.str();
        }
}

TEST(Lint, NoTechniqueIsNamedOutsideItsFolder) {
    std::vector<std::string> ids;
    for (const auto& family : fs::directory_iterator(kRoot / "src/techniques")) {
        if (!family.is_directory() || family.path().filename() == "shared") continue;
        for (const auto& folder : fs::directory_iterator(family))
            // "none" is every family's neutral element, which settings start from.
            if (folder.path().filename() != "none")
                ids.push_back(family.path().filename().string() + "/" + folder.path().filename().string());
    }
    ASSERT_FALSE(ids.empty());
    for (const char* folder : {"apps", "src/lab", "src/report", "src/render", "include"})
        for (const fs::path& file : filesUnder(folder, kCpp)) {
            if (file.filename().string().find("_test.") != std::string::npos) continue;
            // Comments may give examples; code may not.
            const std::string text = std::regex_replace(textOf(file), std::regex("//[^\n]*"), "");
            for (const std::string& id : ids) EXPECT_EQ(text.find(id), std::string::npos) << file << " names " << id;
        }
}

TEST(Lint, EveryTechniqueFolderIsWhole) {
    for (const auto& family : fs::directory_iterator(kRoot / "src/techniques")) {
        if (!family.is_directory() || family.path().filename() == "shared") continue;
        for (const auto& folder : fs::directory_iterator(family)) {
            const std::string name = folder.path().filename().string();
            for (const char* part : {".md", ".tests.json"})
                EXPECT_TRUE(fs::exists(folder.path() / (name + part))) << folder.path() << " lacks " << name << part;
            // Sources are lower_snake; what carries the technique's name keeps its hyphens.
            std::string source = name + ".cpp";
            std::replace(source.begin(), source.end(), '-', '_');
            EXPECT_TRUE(fs::exists(folder.path() / source)) << folder.path() << " lacks " << source;
        }
    }
}

TEST(Lint, TechniquesIncludeNoOtherTechnique) {
    const std::regex include(R"re(#include "((?:techniques/)?(?:shadow|ao|filter|indirect|aa)/([a-z0-9-]+)/[^"]+)")re");
    for (const fs::path& file :
         filesUnder("src/techniques", {".h", ".cpp", ".glsl", ".vert", ".frag", ".geom", ".comp"})) {
        const std::string text = textOf(file);
        for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
            EXPECT_EQ((*it)[2], file.parent_path().filename().string()) << file << " includes " << (*it)[1];
    }
}

TEST(Lint, EverySourceFileStartsWithItsLicence) {
    for (const char* folder : {"include", "src", "apps", "tests", "examples"}) {
        for (const auto& extensions : {kCpp, kGlsl})
            for (const fs::path& file : filesUnder(folder, extensions))
                EXPECT_EQ(textOf(file).rfind("// SPDX-License-Identifier: MIT\n", 0), 0u) << file;
    }
}

TEST(Lint, NothingIsLeftForLater) {
    const std::regex promise(
        "\\b(TO"
        "DO|FIX"
        "ME|XX"
        "X|HA"
        "CK)\\b");
    for (const char* folder : {"include", "src", "apps", "tests", "examples", "cmake"})
        for (const fs::path& file :
             filesUnder(folder, {".h", ".cpp", ".glsl", ".vert", ".frag", ".geom", ".comp", ".cmake", ".txt"}))
            EXPECT_FALSE(std::regex_search(textOf(file), promise)) << file;
}

}  // namespace
