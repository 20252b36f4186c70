// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "lab/record_sample.h"
#include "lab/store.h"
#include "report/assets.h"
#include "report/crops.h"
#include "report/html_text.h"
#include "report/page.h"
#include "report/record_groups.h"

namespace ombrage {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<unsigned char> bytesOf(const fs::path& file) {
    const std::string text = content(file);
    return {text.begin(), text.end()};
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// A picture that PNG cannot compress: the worst case for the size of a report.
Image noise(int width, int height, unsigned seed) {
    Image image = Image::rgb(width, height, ColorSpace::Srgb);
    for (int p = 0; p < 3; ++p)
        for (float& v : image.plane(p)) v = float((seed = seed * 1664525u + 1013904223u) >> 24) / 255.0f;
    return image;
}

class ReportTest : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::path(testing::TempDir()) /
                   ("ombrage_report_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(m_folder);
        fs::create_directories(m_folder / "images");
    }
    void TearDown() override { fs::remove_all(m_folder); }

    void add(RunRecord record, int width = 64, int height = 36) {
        unsigned seed = 1;
        for (auto& [kind, path] : record.images) {
            path = "images/" + kind + std::to_string(m_count) + ".png";
            writeImage(m_folder / path, noise(width, height, ++seed + unsigned(m_count)));
        }
        ++m_count;
        appendLine(m_folder / kRecordsFile, record.toJson());
    }

    std::string page() { return content(writeReport(m_folder)); }

    fs::path m_folder;
    int m_count = 0;
};

/// Every element that must be closed is closed in the right order; returns the first problem or "".
std::string structureProblem(const std::string& html) {
    static const std::vector<std::string> kVoid{"meta", "img", "br"};
    std::vector<std::string> open;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        if (html.compare(at, 2, "<!") == 0) continue;
        const bool closing = html[at + 1] == '/';
        const std::size_t start = at + (closing ? 2 : 1);
        const std::size_t end = html.find_first_of(" >\n", start);
        const std::string name = html.substr(start, end - start);
        if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])))
            return "stray '<' before " + html.substr(at, 20);
        if (std::find(kVoid.begin(), kVoid.end(), name) != kVoid.end()) continue;
        if (!closing) {
            open.push_back(name);
            // What stands in script and style is text up to their end.
            if (name == "script" || name == "style") at = html.find("</" + name, at) - 1;
        } else if (open.empty() || open.back() != name) {
            return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

TEST(HtmlText, Base64KnownAnswers) {
    // RFC 4648, section 10.
    const std::pair<std::string, std::string> known[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
    for (const auto& [plain, encoded] : known)
        EXPECT_EQ(base64({reinterpret_cast<const unsigned char*>(plain.data()), plain.size()}), encoded);
}

TEST(HtmlText, Numbers) {
    EXPECT_EQ(shortNumber(std::nullopt), "–");
    EXPECT_EQ(shortNumber(0.0), "0");
    EXPECT_EQ(shortNumber(0.123456), "0.1235");
    EXPECT_EQ(shortNumber(0.0001234), "0.000123");
    EXPECT_EQ(byteText(512), "512 B");
    EXPECT_EQ(byteText(1536), "1.5 KiB");
    EXPECT_EQ(byteText(16777216), "16 MiB");
}

TEST(Headline, NamesTheNearestToTheTruth) {
    const std::string text = headline({sampleRecord("shadow/worse", 0.3), sampleRecord("shadow/better", 0.1)});
    EXPECT_NE(text.find("of 2 pipelines for shadows, shadow/better came nearest to the truth"), std::string::npos)
        << text;
    EXPECT_NE(text.find("llvmpipe (software)"), std::string::npos) << text;
}

// One measured on fewer scenes is not compared with those measured on all.
TEST(Headline, PrefersWhatWasMeasuredEverywhere) {
    RunRecord elsewhere = sampleRecord("shadow/everywhere", 0.2);
    elsewhere.scene = "room";
    const std::string text =
        headline({sampleRecord("shadow/everywhere", 0.2), elsewhere, sampleRecord("shadow/once", 0.1)});
    EXPECT_NE(text.find("shadow/everywhere came nearest"), std::string::npos) << text;
}

TEST_F(ReportTest, IsOneSelfContainedPage) {
    add(sampleRecord("shadow/one"));
    add(sampleRecord("shadow/two"));
    appendLine(
        m_folder / kRunsFile,
        RunNote{{"ombrage", "compare", "it's"}, {{"gap", "shadow/three", "no such light"}}, {"a failed gate"}, false}
            .toJson());
    const std::string html = page();
    EXPECT_EQ(structureProblem(html), "");
    // The one address is the name of SVG's elements, which nobody asks.
    EXPECT_EQ(countOf(html, "http://"), countOf(html, "'http://www.w3.org/2000/svg'"));
    EXPECT_EQ(html.find("https://"), std::string::npos);
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(countOf(html, "<h2>gap: shadow, light lamp</h2>"), 1u) << "one table for one question";
    // The truth once, a visibility each.
    EXPECT_EQ(countOf(html, "data-path="), 3u);
    EXPECT_EQ(countOf(html, " alt=\"\""), 0u);
    EXPECT_NE(html.find("no such light"), std::string::npos);
    EXPECT_NE(html.find("a failed gate"), std::string::npos);
    EXPECT_NE(html.find(escapeHtml("ombrage compare 'it'\\''s'")), std::string::npos) << "the command can be pasted";
}

TEST_F(ReportTest, HoldsItsRecordsAsJson) {
    const RunRecord record = sampleRecord();
    appendLine(m_folder / kRecordsFile, record.toJson());
    const std::string html = page(), open = "id=\"records\">";
    const std::size_t start = html.find(open) + open.size();
    const auto json = nlohmann::ordered_json::parse(html.substr(start, html.find("</script>", start) - start));
    EXPECT_EQ(RunRecord::fromJson(json["records"][0].dump(), "page"), record);
}

TEST_F(ReportTest, NamesCannotBreakThePage) {
    RunRecord record = sampleRecord();
    record.scene = "</script><script>alert(1)</script>";
    record.warnings = {"\"><img src=x onerror=alert(1)>"};
    add(record);
    const std::string html = page();
    EXPECT_EQ(structureProblem(html), "");
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    EXPECT_EQ(html.find("<img src=x"), std::string::npos);
    EXPECT_EQ(countOf(html, "</script>"), 4u) << "three of data, one of code";
}

TEST_F(ReportTest, ALaterRunTakesTheEarlierOnesPlaceAndATornLineIsLeftOut) {
    add(sampleRecord("shadow/one", 0.75));
    add(sampleRecord("shadow/one", 0.25));
    std::ofstream(m_folder / kRecordsFile, std::ios::app | std::ios::binary) << "{\"schema\":";
    const std::string html = page();
    EXPECT_EQ(countOf(html, "data-v=\"0.25\""), 1u);
    EXPECT_EQ(countOf(html, "data-v=\"0.75\""), 0u);
}

TEST_F(ReportTest, StaysBelowEightMegabytes) {
    // 12 pictures of noise at 640x360 would take 11 MB as they are.
    for (int i = 0; i < 6; ++i) add(sampleRecord("shadow/t" + std::to_string(i)), 640, 360);
    const fs::path file = writeReport(m_folder);
    EXPECT_LT(fs::file_size(file), 8'000'000u);
    const std::string html = content(file);
    EXPECT_EQ(countOf(html, "data-path="), 7u) << "smaller, but all there";
}

TEST_F(ReportTest, APictureThatIsGoneIsSaid) {
    add(sampleRecord());
    fs::remove(m_folder / "images/visibility0.png");
    const std::string html = page();
    EXPECT_NE(html.find("1 picture(s) of the records could not be read, such as images/visibility0.png"),
              std::string::npos);
}

TEST_F(ReportTest, RecordsReachNoFileOutsideTheFolder) {
    writeImage(m_folder / "outside.png", noise(4, 4, 1));
    const fs::path inner = m_folder / "inner";
    fs::create_directories(inner);
    RunRecord record = sampleRecord();
    record.images = {{"visibility", "../outside.png"}, {"truth", (m_folder / "outside.png").string()}};
    appendLine(inner / kRecordsFile, record.toJson());
    EXPECT_EQ(countOf(content(writeReport(inner)), "<img "), 0u);
}

TEST_F(ReportTest, AFolderWithoutRecordsIsAnInputError) {
    try {
        writeReport(m_folder);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
    }
}

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_F(ReportTest, IsTheSameUnderADecimalComma) {
    add(sampleRecord());
    const std::string before = page();
    const std::locale old = std::locale::global(std::locale(std::locale(), new DecimalComma));
    const std::string after = page();
    std::locale::global(old);
    EXPECT_EQ(before, after);
}

// The picture budget is by bytes: noise has many, and 640 pixels of width do not fit.
TEST_F(ReportTest, SaysWhenPicturesAreShrunkAndEmbedsThemWholeWhenAsked) {
    for (int i = 0; i < 6; ++i) add(sampleRecord("shadow/t" + std::to_string(i)), 640, 360);
    EXPECT_NE(page().find("Pictures are shrunk to"), std::string::npos);
    const std::string full = content(writeReport(m_folder, {}, ReportPictures::Full));
    EXPECT_EQ(full.find("Pictures are shrunk to"), std::string::npos);
    EXPECT_NE(full.find(base64(bytesOf(m_folder / "images/visibility0.png"))), std::string::npos);
}

TEST_F(ReportTest, CommandsOfRunsCanBePasted) {
    RunRecord record = sampleRecord("shadow/one");
    record.pipeline = "shadow/one:mode=it's";
    appendLine(m_folder / kRecordsFile, record.toJson());
    EXPECT_NE(page().find(escapeHtml("ombrage compare gap --technique 'shadow/one:mode=it'\\''s' --camera main --light "
                                     "lamp --size 640x360 --seed 1 --truth shadow --spp 1024 -o again")),
              std::string::npos);
}

TEST_F(ReportTest, CommandsAskForTheSceneAsItWasAskedFor) {
    RunRecord record = sampleRecord("shadow/one");
    record.scene = "laboratory";
    record.asked = {"my lab.json", "--ground", "--eye", "-1,2.5,3", "--time", "1.5"};
    record.time_s = 1.5;
    EXPECT_EQ(commandFor(record, {}),
              "ombrage compare 'my lab.json' --ground --eye -1,2.5,3 --time 1.5 --technique shadow/one --camera main "
              "--light lamp --size 640x360 --seed 1 --truth shadow --spp 1024 -o again");
}

TEST_F(ReportTest, AnotherMomentIsAnotherSection) {
    add(sampleRecord("shadow/one"));
    RunRecord later = sampleRecord("shadow/two");
    later.time_s = 1.5;
    add(later);
    RunRecord bumpy = sampleRecord("shadow/three");
    bumpy.normals = "bump";
    add(bumpy);
    const std::string html = page();
    EXPECT_NE(html.find("gap: shadow, light lamp, at 1.5 s</h2>"), std::string::npos);
    EXPECT_NE(html.find("gap: shadow, light lamp, normals of bump</h2>"), std::string::npos);
    EXPECT_NE(settingsFor(bumpy).find("settings.normals = ombrage::NormalSource::Bump;"), std::string::npos);
    EXPECT_NE(html.find("gap: shadow, light lamp</h2>"), std::string::npos);
}

TEST_F(ReportTest, SettingsAreShownAsCode) {
    RunRecord record = sampleRecord("ao/one");
    record.camera = "the \"left\" one";
    record.light.clear();
    record.pipeline = "ao/blocks:radius=0.5+filter/bilateral-separable";
    const std::string code =
        "ombrage::RenderSettings settings;\nsettings.width = 640;\nsettings.height = 360;\n"
        "settings.camera = \"the \\\"left\\\" one\";\nsettings.seed = 1u;\n"
        "settings.ao = ombrage::parsePipeline(ombrage::Family::Ao, "
        "\"ao/blocks:radius=0.5+filter/bilateral-separable\");";
    EXPECT_EQ(settingsFor(record), code);
    appendLine(m_folder / kRecordsFile, record.toJson());
    EXPECT_NE(page().find(escapeHtml(code)), std::string::npos);
}

TEST_F(ReportTest, OfBenchesThatWereTakenAgainTheLatestCounts) {
    add(sampleRecord("shadow/one"));
    ResultStore store(m_folder);
    const auto put = [&](int build, const char* value, const char* label) {
        store.put(ResultKey(kBenchKind).add("build", build).add("value", value).add("label", label),
                  fmt::format(R"({{"scene":"gap","camera":"main","light":null,"size":[64,36],"axis":"resolution",)"
                              R"("value":"{}","build":{},"runs":[{{"label":"{}"}}]}})",
                              value, build, label),
                  {});
    };
    put(1, "256", "shadow/map");
    put(1, "512", "shadow/map");
    put(2, "256", "shadow/map");
    put(2, "256", "shadow/planar");
    const std::string html = page();
    EXPECT_EQ(countOf(html, "\"build\":1"), 1u) << "at 512, which was not measured again";
    EXPECT_EQ(countOf(html, "\"build\":2"), 2u);
}

TEST_F(ReportTest, ShowsMeansOverScenesOnceThereAreTwo) {
    add(sampleRecord("shadow/one", 0.25));
    EXPECT_EQ(page().find("Over all scenes"), std::string::npos);
    RunRecord other = sampleRecord("shadow/one", 0.75);
    other.scene = "room";
    add(other);
    const std::string html = page(), means = html.substr(html.find("Over all scenes: shadow, truth shadow"));
    EXPECT_EQ(structureProblem(html), "");
    EXPECT_NE(means.find("<td data-v=\"0.5\">0.5</td>"), std::string::npos);
}

TEST_F(ReportTest, ClassesAreSharesOfOnePage) {
    RunRecord record = sampleRecord("shadow/one");
    record.metrics["over"] = 0.5;
    record.metrics["alias"] = 0.125;
    record.metrics["leak"] = 0.375;
    add(record);
    record.pipeline = "shadow/two";
    record.metrics["over"] = record.metrics["leak"] = 0.0;
    record.metrics["alias"] = 0.0;
    add(record);
    const std::string html = page();
    EXPECT_NE(html.find("aria-label=\"alias 12.5 %, leak 37.5 %\""), std::string::npos);
    EXPECT_NE(html.find("<i style=\"width:75.000%;"), std::string::npos) << "of the longest bar";
    EXPECT_NE(html.find("aria-label=\"none\""), std::string::npos);
}

TEST(Crops, FindWhereImagesDifferAndNothingElse) {
    Image flat = Image::grey(256, 128), spot = flat;
    for (int y = 70; y < 80; ++y)
        for (int x = 200; x < 210; ++x) spot.at(0, x, y) = 1.0f;
    const std::vector<CropWindow> found = cropsWhereTheyDiffer({flat, spot}, {}, 3);
    ASSERT_FALSE(found.empty());
    EXPECT_LE(found[0].x, 200);
    EXPECT_GE(found[0].x + found[0].size, 210);
    EXPECT_LE(found[0].y, 70);
    EXPECT_GE(found[0].y + found[0].size, 80);
    // The spot is 10 pixels wide and windows do not overlap: no other holds half a grey level of it.
    EXPECT_EQ(found.size(), 1u);
    EXPECT_TRUE(cropsWhereTheyDiffer({flat, flat}, {}, 3).empty());
    EXPECT_TRUE(cropsWhereTheyDiffer({flat, spot}, std::vector<bool>(256 * 128, false), 3).empty());
    EXPECT_TRUE(cropsWhereTheyDiffer({spot}, {}, 3).empty());
}

/// Relative luminance of "rrggbb" (WCAG 2.1).
double luminance(const std::string& hex) {
    double sum = 0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] * double(linearFromSrgb(float(std::stoi(hex.substr(2 * i, 2), nullptr, 16)) / 255.0f));
    return sum;
}

TEST(Style, TextAndEdgesStandOutInLightAndDark) {
    const std::string style = kReportStyle;
    std::map<std::string, std::string> colors[2];
    const std::regex token(R"(--([a-z]+): light-dark\(#([0-9a-f]{6}), #([0-9a-f]{6})\))");
    for (std::sregex_iterator it(style.begin(), style.end(), token), end; it != end; ++it) {
        colors[0][(*it)[1]] = (*it)[2];
        colors[1][(*it)[1]] = (*it)[3];
    }
    const auto contrast = [](const std::string& a, const std::string& b) {
        const double x = luminance(a), y = luminance(b);
        return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
    };
    for (auto& theme : colors) {
        // WCAG 2.1, 1.4.3: 4.5 for text; 1.4.11: 3 for the edges of what can be used.
        for (const char* text : {"ink", "soft", "mark"})
            for (const char* ground : {"paper", "panel", "wash"})
                EXPECT_GE(contrast(theme.at(text), theme.at(ground)), 4.5) << text << " on " << ground;
        EXPECT_GE(contrast(theme.at("markpaper"), theme.at("mark")), 4.5);
        EXPECT_GE(contrast(theme.at("edge"), theme.at("paper")), 3.0);
        EXPECT_GE(contrast(theme.at("bad"), theme.at("panel")), 3.0);
    }
}

}  // namespace
}  // namespace ombrage
