// SPDX-License-Identifier: MIT
#include "core/param_table.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

enum class Mode { Off, NormalOffset, Slope };

}  // namespace

template <>
struct EnumChoices<Mode> {
    static std::vector<std::string> names() { return {"off", "normal-offset", "slope"}; }
};

namespace {

/// Every type and every unit, and in the block every alignment that std140 knows for them: a vec3 after 1, 2 and 3
/// scalars and after a vec3, a scalar in a vec3's fourth place.
struct Everything {
    bool flag = true;
    glm::vec3 tint{1, 0.5f, 0};
    float radius_m = 0.1f;
    float cone_rad = 0.5235988f;
    int blur_px = 3;
    glm::vec3 axis{0, 1, 0};
    glm::vec3 second{0, 0, 1};
    Mode mode = Mode::Slope;
    float bias_texels = 1.5f;
    glm::vec3 third{-1, 0, 0};
    float share_percent = 50;
    float budget_ms = 2;
    int samples = 16;
    float sharpness = 2;
    bool fast = false;
    Mode variant = Mode::NormalOffset;
    glm::vec3 offset{0.5f, 1, -2};
    int resolution = 1024;
    bool cached = true;

    static ParamTable describe() {
        using P = Everything;
        return fields(
            field(&P::flag, "flag").help("A switch."), field(&P::tint, "tint").range(0, 1).help("A colour."),
            field(&P::radius_m, "max-radius", Unit::Metre).range(0.01, 10, Scale::Log).tune(0.1, 2).help("A length."),
            field(&P::cone_rad, "cone", Unit::Degree).range(0, 90).help("An angle."),
            field(&P::blur_px, "blur", Unit::Pixel).range(-8, 8).help("A number of pixels."),
            field(&P::axis, "axis").range(-1, 1).help("A direction."),
            field(&P::second, "second").range(-1, 1).help("Another."), field(&P::mode, "mode").help("A choice."),
            field(&P::bias_texels, "bias", Unit::Texel).range(0, 16).help("A number of texels."),
            field(&P::third, "third").range(-1, 1).help("A third."),
            field(&P::share_percent, "share", Unit::Percent).range(0, 100).help("A share."),
            field(&P::budget_ms, "budget", Unit::Millisecond).range(0, 16).help("A time."),
            field(&P::samples, "sample-count").range(1, 64).effect(ParamEffect::Define).help("A count."),
            field(&P::sharpness, "sharpness").range(0, 8).effect(ParamEffect::Define).help("A number."),
            field(&P::fast, "fast").effect(ParamEffect::Define).help("A switch of the shader."),
            field(&P::variant, "variant").effect(ParamEffect::Define).help("A choice of the shader."),
            field(&P::offset, "offset").range(-9, 9).effect(ParamEffect::Define).help("A constant."),
            field(&P::resolution, "resolution", Unit::Texel)
                .range(16, 8192)
                .effect(ParamEffect::Resize)
                .help("A size."),
            field(&P::cached, "cache").effect(ParamEffect::Host).help("A switch of the program."));
    }
};

const ParamTable& table() {
    static const ParamTable made = Everything::describe();
    return made;
}

const ParamInfo& info(const std::string& key) {
    return table().find(key, "test").info;
}

ParamValue parse(const std::string& key, const std::string& text) {
    return ParamTable::parse(info(key), text, "shadow/test");
}

/// The sentence of the usage error that parsing gives.
std::string refusal(const std::string& key, const std::string& text) {
    try {
        const ParamValue value = parse(key, text);
        ADD_FAILURE() << key << "=" << text << " was taken as " << toString(value);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Usage);
        return e.what();
    }
    return {};
}

TEST(ParamTable, DefaultsComeFromTheMembers) {
    EXPECT_EQ(info("flag").defaultValue, ParamValue(true));
    EXPECT_EQ(info("blur").defaultValue, ParamValue(std::int64_t(3)));
    EXPECT_EQ(info("mode").defaultValue, ParamValue(std::string("slope")));
    EXPECT_EQ(info("tint").defaultValue, ParamValue(Vec3Value{1, 0.5f, 0}));
    EXPECT_EQ(toString(info("max-radius").defaultValue), "0.1") << "not 0.10000000149011612";
    EXPECT_EQ(toString(info("cone").defaultValue), "30") << "degrees at the edge, radians inside";
}

TEST(ParamTable, InfoHoldsWhatWasDeclared) {
    const ParamInfo& radius = info("max-radius");
    EXPECT_EQ(radius.type, ParamType::Float);
    EXPECT_EQ(radius.unit, Unit::Metre);
    EXPECT_EQ(radius.scale, Scale::Log);
    EXPECT_EQ(radius.effect, ParamEffect::Uniform);
    EXPECT_EQ(radius.minimum, 0.01);
    EXPECT_EQ(radius.maximum, 10);
    EXPECT_EQ(radius.tuneMinimum, 0.1);
    EXPECT_EQ(radius.tuneMaximum, 2);
    EXPECT_EQ(info("blur").tuneMinimum, info("blur").tuneMaximum) << "not searched";
    EXPECT_EQ(info("mode").choices, (std::vector<std::string>{"off", "normal-offset", "slope"}));
}

TEST(ParamTable, SetAndGetAgreeAtTheUsersEdge) {
    Everything p;
    const auto roundTrip = [&](const std::string& key, const std::string& text) {
        const ParamField& field = table().find(key, "test");
        field.set(&p, parse(key, text));
        return toString(field.get(&p));
    };
    for (const auto& [key, text] : std::initializer_list<std::pair<const char*, const char*>>{{"flag", "false"},
                                                                                              {"max-radius", "0.3"},
                                                                                              {"cone", "45"},
                                                                                              {"cone", "0.1"},
                                                                                              {"blur", "-8"},
                                                                                              {"mode", "normal-offset"},
                                                                                              {"tint", "(0.1;0.2;0.3)"},
                                                                                              {"share", "12.5"}})
        EXPECT_EQ(roundTrip(key, text), text) << key;
    roundTrip("cone", "45");
    EXPECT_FLOAT_EQ(p.cone_rad, 0.7853982f);
    EXPECT_EQ(p.mode, Mode::NormalOffset);
    EXPECT_EQ(p.blur_px, -8);
}

TEST(ParamTable, ParsesEveryWayOfWriting) {
    for (const char* text : {"true", "on", "1"}) EXPECT_EQ(parse("flag", text), ParamValue(true));
    for (const char* text : {"false", "off", "0"}) EXPECT_EQ(parse("flag", text), ParamValue(false));
    EXPECT_EQ(parse("blur", "+4"), ParamValue(std::int64_t(4)));
    EXPECT_EQ(parse("max-radius", "1e-1"), ParamValue(0.1));
    EXPECT_EQ(parse("tint", "( 0 ; 0.5;1 )"), ParamValue(Vec3Value{0, 0.5f, 1}));
}

TEST(ParamTable, RangesAreInclusiveAndStated) {
    EXPECT_EQ(parse("max-radius", "0.01"), ParamValue(0.01));
    EXPECT_EQ(parse("max-radius", "10"), ParamValue(10.0));
    EXPECT_EQ(refusal("max-radius", "10.01"),
              "shadow/test: max-radius=10.01 is out of range (max-radius takes 0.01 to 10 m)");
    EXPECT_EQ(refusal("cone", "90.5"), "shadow/test: cone=90.5 is out of range (cone takes 0 to 90 deg)");
    EXPECT_EQ(refusal("blur", "-9"), "shadow/test: blur=-9 is out of range (blur takes -8 to 8 px)");
    EXPECT_EQ(refusal("tint", "(0;0;1.5)"), "shadow/test: tint=(0;0;1.5) is out of range (tint takes 0 to 1)");
    EXPECT_NE(refusal("tint", "(1e300;0;0)").find("out of range"), std::string::npos) << "beyond a float as well";
    EXPECT_NE(refusal("share", "101").find("0 to 100 %"), std::string::npos);
    EXPECT_NE(refusal("budget", "17").find("0 to 16 ms"), std::string::npos);
    EXPECT_NE(refusal("bias", "17").find("0 to 16 texels"), std::string::npos);
}

TEST(ParamTable, WrongTypesSayWhatIsTaken) {
    EXPECT_EQ(refusal("flag", "maybe"), "shadow/test: flag=maybe is not understood (flag takes true or false)");
    EXPECT_EQ(refusal("blur", "2.5"),
              "shadow/test: blur=2.5 is not understood (blur takes a whole number, -8 to 8 px)");
    EXPECT_EQ(refusal("max-radius", "wide"),
              "shadow/test: max-radius=wide is not understood (max-radius takes a number, 0.01 to 10 m)");
    EXPECT_EQ(refusal("max-radius", "0,5").substr(0, 48), "shadow/test: max-radius=0,5 is not understood (m");
    for (const char* text : {"1;2;3", "(1;2)", "(1;2;3;4)", "(1,2,3)", "()", "(1;2;x)", ""})
        EXPECT_NE(refusal("tint", text).find("tint takes (x;y;z), each 0 to 1"), std::string::npos) << text;
    EXPECT_NE(refusal("mode", "slpoe").find("did you mean 'slope'?"), std::string::npos);
    for (const char* text : {"nan", "inf", ""})
        EXPECT_NE(refusal("max-radius", text).find("not understood"), std::string::npos);
}

TEST(ParamTable, CheckTakesWhatJsonGives) {
    EXPECT_EQ(ParamTable::check(info("blur"), 4.0, "t"), ParamValue(std::int64_t(4))) << "a whole double";
    EXPECT_EQ(ParamTable::check(info("max-radius"), std::int64_t(2), "t"), ParamValue(2.0));
    EXPECT_THROW(ParamTable::check(info("blur"), 4.5, "t"), Error);
    EXPECT_THROW(ParamTable::check(info("blur"), 1e30, "t"), Error);
    EXPECT_THROW(ParamTable::check(info("blur"), std::string("4"), "t"), Error);
    EXPECT_THROW(ParamTable::check(info("flag"), std::int64_t(1), "t"), Error);
    EXPECT_THROW(ParamTable::check(info("max-radius"), std::numeric_limits<double>::quiet_NaN(), "t"), Error);
    EXPECT_THROW(ParamTable::check(info("mode"), std::int64_t(0), "t"), Error);
}

TEST(ParamTable, AnUnknownKeySuggestsTheNearest) {
    try {
        table().find("max-radus", "shadow/test");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "unknown parameter of shadow/test 'max-radus' (did you mean 'max-radius'?)");
    }
    try {
        ParamTable().find("size", "shadow/none");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "shadow/none has no parameter 'size' (it has no parameters at all)");
    }
}

TEST(ParamTable, GlslBlockNamesUniformFieldsAndChoices) {
    EXPECT_EQ(table().glslBlock(1),
              "const int MODE_OFF = 0;\n"
              "const int MODE_NORMAL_OFFSET = 1;\n"
              "const int MODE_SLOPE = 2;\n"
              "layout(std140, binding = 1) uniform Params {\n"
              "    bool flag;\n"
              "    vec3 tint;\n"
              "    float max_radius;\n"
              "    float cone;\n"
              "    int blur;\n"
              "    vec3 axis;\n"
              "    vec3 second;\n"
              "    int mode;\n"
              "    float bias;\n"
              "    vec3 third;\n"
              "    float share;\n"
              "    float budget;\n"
              "} params;\n");
    EXPECT_EQ(ParamTable().glslBlock(1), "");
    EXPECT_EQ(ParamTable().packBlock(nullptr).size(), 0u);
}

struct Passable {
    int blur = 2;
    glm::vec3 tint{0.5f};
    float bias = 1;
    bool cache = true;
    static ParamTable describe() {
        using P = Passable;
        return fields(field(&P::blur, "blur"), field(&P::tint, "tint"), field(&P::bias, "max-bias"),
                      field(&P::cache, "cache").effect(ParamEffect::Host));
    }
};

TEST(ParamTable, GlslOfAFullScreenPassHandsTheBlockOver) {
    const ParamTable small = Passable::describe();
    const std::string flats = "    flat int blur;\n    flat vec3 tint;\n    flat float max_bias;\n";
    EXPECT_EQ(small.glslPerPass(1), "in PassedParams {\n" + flats + "} params;\n");
    EXPECT_EQ(small.glslPassing(1), small.glslBlock(1) + "out PassedParams {\n" + flats +
                                        "} passedParams;\n"
                                        "void passParams() {\n"
                                        "    passedParams.blur = params.blur;\n"
                                        "    passedParams.tint = params.tint;\n"
                                        "    passedParams.max_bias = params.max_bias;\n"
                                        "}\n");
    // A bool cannot be handed over: the fragments then read the block.
    EXPECT_EQ(table().glslPerPass(1), table().glslBlock(1));
    EXPECT_EQ(table().glslPassing(1), "void passParams() {}\n");
    // Nor can more than 16 numbers be counted on.
    std::vector<ParamField> many(6, small.find("tint", "t"));
    EXPECT_EQ(ParamTable(many).glslPerPass(1), ParamTable(many).glslBlock(1));
    many.pop_back();
    EXPECT_NE(ParamTable(many).glslPerPass(1), ParamTable(many).glslBlock(1));
    EXPECT_EQ(ParamTable().glslPerPass(1), "");
}

TEST(ParamTable, GlslDefinesAreLiteralsOfTheirType) {
    Everything p;
    p.fast = true;
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"SAMPLE_COUNT", "16"},         {"SHARPNESS", "2.0"},   {"FAST", "1"},    {"VARIANT_OFF", "0"},
        {"VARIANT_NORMAL_OFFSET", "1"}, {"VARIANT_SLOPE", "2"}, {"VARIANT", "1"}, {"OFFSET", "vec3(0.5, 1.0, -2.0)"}};
    EXPECT_EQ(table().glslDefines(&p), expected);
}

TEST(ParamTable, OffsetsFollowStd140) {
    // By hand from the rules of std140 (OpenGL 4.5, 7.6.2.2): scalars on 4 bytes, vec3 on 16, a scalar fits behind a
    // vec3.
    const std::pair<const char*, int> expected[] = {{"flag", 0},  {"tint", 16},  {"max-radius", 28}, {"cone", 32},
                                                    {"blur", 36}, {"axis", 48},  {"second", 64},     {"mode", 76},
                                                    {"bias", 80}, {"third", 96}, {"share", 108},     {"budget", 112}};
    for (const auto& [key, offset] : expected) EXPECT_EQ(table().blockOffset(key), offset) << key;
    for (const char* key : {"sample-count", "resolution", "cache", "no-such"})
        EXPECT_EQ(table().blockOffset(key), -1) << key;
}

template <typename T>
T valueAt(const std::vector<std::byte>& bytes, const char* key, int add = 0) {
    T value;
    std::memcpy(&value, bytes.data() + table().blockOffset(key) + add, sizeof value);
    return value;
}

TEST(ParamTable, PackBlockPutsEachValueAtItsOffset) {
    Everything p;
    p.blur_px = -7;
    const std::vector<std::byte> bytes = table().packBlock(&p);
    EXPECT_EQ(bytes.size(), 128u) << "116 bytes, rounded up to 16";
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, "flag"), 1u);
    EXPECT_EQ(valueAt<float>(bytes, "tint", 4), 0.5f);
    EXPECT_EQ(valueAt<float>(bytes, "max-radius"), 0.1f);
    EXPECT_EQ(valueAt<float>(bytes, "cone"), p.cone_rad) << "radians";
    EXPECT_EQ(valueAt<std::int32_t>(bytes, "blur"), -7);
    EXPECT_EQ(valueAt<float>(bytes, "second", 8), 1.0f);
    EXPECT_EQ(valueAt<std::int32_t>(bytes, "mode"), 2);
    EXPECT_EQ(valueAt<float>(bytes, "third"), -1.0f);
    EXPECT_EQ(valueAt<float>(bytes, "budget"), 2.0f);
}

TEST(ParamTable, MarkdownHasARowPerField) {
    const std::string text = table().markdown();
    EXPECT_NE(text.find("| `max-radius` | 0.1 | 0.01 to 10 m | uniform | A length. |\n"), std::string::npos) << text;
    EXPECT_NE(
        text.find("| `variant` | normal-offset | off, normal-offset, slope | variant | A choice of the shader. |\n"),
        std::string::npos);
    EXPECT_NE(text.find("| `flag` | true | true, false | uniform | A switch. |\n"), std::string::npos);
    EXPECT_NE(text.find("| `resolution` | 1024 | 16 to 8192 texels | resize | A size. |\n"), std::string::npos);
    EXPECT_EQ(std::size_t(std::count(text.begin(), text.end(), '\n')), table().fields().size() + 2);
}

TEST(Params, UnitsHaveNames) {
    EXPECT_STREQ(unitName(Unit::None), "");
    EXPECT_STREQ(unitName(Unit::Metre), "m");
    EXPECT_STREQ(unitName(Unit::Degree), "deg");
    EXPECT_STREQ(unitName(Unit::Pixel), "px");
    EXPECT_STREQ(unitName(Unit::Texel), "texels");
    EXPECT_STREQ(unitName(Unit::Percent), "%");
    EXPECT_STREQ(unitName(Unit::Millisecond), "ms");
}

}  // namespace
}  // namespace ombrage
