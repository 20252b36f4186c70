// SPDX-License-Identifier: MIT
#include "core/strings.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include <gtest/gtest.h>
#include <ombrage/params.h>

namespace ombrage {
namespace {

using Parts = std::vector<std::string>;

TEST(Strings, SplitKeepsEmptyParts) {
    EXPECT_EQ(split("a,,b", ','), (Parts{"a", "", "b"}));
    EXPECT_EQ(split("", ','), (Parts{""}));
    EXPECT_EQ(split(",", ','), (Parts{"", ""}));
}

TEST(Strings, JoinUndoesSplit) {
    EXPECT_EQ(join(split("a,,b", ','), ","), "a,,b");
    EXPECT_EQ(join({}, ", "), "");
}

TEST(Strings, TrimTakesWhiteSpaceOffBothEnds) {
    EXPECT_EQ(trim(" \t a b \r\n"), "a b");
    EXPECT_EQ(trim(" \n"), "");
}

TEST(Strings, ToLowerLeavesOtherBytesAlone) {
    EXPECT_EQ(toLower("AbC-\xc3\x84Z9"), "abc-\xc3\x84z9");
}

TEST(Strings, ParseDoubleTakesWholeFiniteNumbersOnly) {
    double value = -1;
    for (const auto& [text, expected] : std::initializer_list<std::pair<const char*, double>>{
             {"0.5", 0.5}, {"+2", 2}, {"-3e-2", -0.03}, {".25", 0.25}, {"1e3", 1000}}) {
        EXPECT_TRUE(parseDouble(text, value)) << text;
        EXPECT_EQ(value, expected) << text;
    }
    value = 7;
    for (const char* text :
         {"", " 1", "1 ", "1,5", "1.5x", "inf", "-inf", "nan", "1e999", "0x10", "+-1", "++1", "+", "--1"})
        EXPECT_FALSE(parseDouble(text, value)) << text;
    EXPECT_EQ(value, 7) << "a failure leaves the value alone";
}

TEST(Strings, ParseIntTakesWholeNumbersOnly) {
    long long value = 0;
    EXPECT_TRUE(parseInt("-9223372036854775808", value));
    EXPECT_EQ(value, std::numeric_limits<long long>::min());
    EXPECT_TRUE(parseInt("+16", value));
    EXPECT_EQ(value, 16);
    for (const char* text : {"", "1.0", "1e3", "9223372036854775808", "16 ", "0x10", "+-5"})
        EXPECT_FALSE(parseInt(text, value)) << text;
}

TEST(Strings, FormatNumberIsTheShortestThatReadsBack) {
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(1), "1");
    EXPECT_EQ(formatNumber(-0.0), "-0");
    for (double value : {1.0 / 3, 1e-300, 6.02214076e23, 5e-324, double(0.1f)}) {
        double back = 0;
        EXPECT_TRUE(parseDouble(formatNumber(value), back));
        EXPECT_EQ(back, value);
    }
}

/// What every number must look like, whatever the locale.
void expectPoints() {
    EXPECT_EQ(formatNumber(1234567.5), "1234567.5");
    EXPECT_EQ(toString(ParamValue(0.25)), "0.25");
    EXPECT_EQ(toString(ParamValue(std::int64_t(1234567))), "1234567");
    EXPECT_EQ(toString(ParamValue(Vec3Value{0.5f, -1.25f, 1000})), "(0.5;-1.25;1000)");
    double value = 0;
    EXPECT_TRUE(parseDouble("1234.5", value));
    EXPECT_EQ(value, 1234.5);
    EXPECT_FALSE(parseDouble("1234,5", value));
}

TEST(Strings, NumbersIgnoreAGlobalLocaleWithDecimalComma) {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    std::ostringstream proof;
    proof << 1234.5;
    EXPECT_EQ(proof.str(), "1.234,5") << "the locale is in force";
    expectPoints();
    std::locale::global(before);
}

TEST(Strings, NumbersIgnoreACLocaleWithDecimalComma) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const char* set = nullptr;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8"})
        if (!set) set = std::setlocale(LC_ALL, name);
    if (!set) GTEST_SKIP() << "SKIPPED: no locale with a decimal comma is installed (de_DE.UTF-8, fr_FR.UTF-8)";
    EXPECT_STREQ(std::localeconv()->decimal_point, ",") << "the locale is in force";
    expectPoints();
    std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace ombrage
