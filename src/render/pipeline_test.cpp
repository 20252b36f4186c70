// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/technique.h>

#include "render/technique.h"

namespace ombrage {
namespace {

std::string refusal(Family family, const std::string& text) {
    try {
        const Pipeline pipeline = parsePipeline(family, text);
        ADD_FAILURE() << text << " was taken as " << toString(pipeline);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Usage);
        return e.what();
    }
    return {};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Pipeline, TheCanonicalTextReadsBackAsTheSamePipeline) {
    for (const char* text : {"shadow/none", "shadow/map", "shadow/map:resolution=2048,bias=slope,constant-bias=1.5",
                             "shadow/map:cache=false+filter/none"}) {
        const Pipeline pipeline = parsePipeline(Family::Shadow, text);
        EXPECT_EQ(toString(pipeline), text);
        EXPECT_EQ(parsePipeline(Family::Shadow, toString(pipeline)), pipeline);
    }
}

TEST(Pipeline, TheCanonicalTextHasFullIdsDeclarationOrderAndNoDefaults) {
    EXPECT_EQ(toString(parsePipeline(Family::Shadow, "map")), "shadow/map");
    EXPECT_EQ(toString(parsePipeline(Family::Shadow, " map : bias = slope , resolution = 512 ")),
              "shadow/map:resolution=512,bias=slope");
    EXPECT_EQ(toString(parsePipeline(Family::Shadow, "map:resolution=1024,cache=on")), "shadow/map")
        << "defaults are left out";
    EXPECT_EQ(toString(parsePipeline(Family::Ao, "none+filter/none")), "ao/none+filter/none");
}

TEST(Pipeline, TheFamilyMayBeLeftOutOfTheFirstElementOnly) {
    EXPECT_EQ(parsePipeline(Family::Indirect, "none")[0].id, "indirect/none");
    EXPECT_TRUE(has(refusal(Family::Shadow, "map+none"), "needs its family"));
    EXPECT_EQ(parsePipeline(Family::Ao, "shadow/none")[0].id, "shadow/none") << "families are checked when rendering";
}

TEST(Pipeline, ErrorsSuggestTheNearest) {
    EXPECT_TRUE(has(refusal(Family::Shadow, "mpa"), "did you mean 'map'?"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "shadow/mapp"), "did you mean 'shadow/map'?"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:resolutoin=512"), "did you mean 'resolution'?"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:bias=slpoe"), "did you mean 'slope'?"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "none:size=1"), "no parameter 'size'"));
}

TEST(Pipeline, ErrorsNameThePlace) {
    EXPECT_TRUE(has(refusal(Family::Shadow, ""), "names no technique"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map+"), "names no technique"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:"), "is not key=value"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:resolution"), "'resolution' is not key=value"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:resolution=512,"), "is not key=value"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:resolution=8"), "resolution takes 16 to 8192 texels"));
    EXPECT_TRUE(has(refusal(Family::Shadow, "map:resolution=512,resolution=256"), "resolution is given twice"));
}

TEST(Pipeline, ResolveParamsListsEveryParameterInDeclarationOrder) {
    const auto resolved = resolveParams(parsePipeline(Family::Shadow, "map:bias=slope")[0]);
    const auto& params = technique("shadow/map").params;
    ASSERT_EQ(resolved.size(), params.size());
    for (std::size_t i = 0; i < params.size(); ++i) {
        EXPECT_EQ(resolved[i].first, params[i].key);
        const ParamValue expected = params[i].key == "bias" ? ParamValue(std::string("slope")) : params[i].defaultValue;
        EXPECT_EQ(resolved[i].second, expected) << params[i].key;
    }
    EXPECT_THROW(resolveParams({"shadow/map", {{"no-such", "1"}}}), Error);
    EXPECT_THROW(resolveParams({"shadow/map", {{"bias", "no-such"}}}), Error);
}

TEST(Pipeline, CreateTechniqueSetsTheParameters) {
    const auto made = createTechnique({"shadow/map", {{"resolution", "512"}}});
    const ParamField& field = made->table().find("resolution", "test");
    EXPECT_EQ(field.get(made->params()), ParamValue(std::int64_t(512)));
    EXPECT_EQ(made->entry().id(), "shadow/map");
    EXPECT_THROW(createTechnique({"shadow/map", {{"resolution", "8"}}}), Error);
}

TEST(Techniques, AreOrderedByFamilyThenNameNoneFirst) {
    const auto& all = techniques();
    ASSERT_FALSE(all.empty());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].id, std::string(familyName(all[i].family)) + "/" + all[i].name);
        EXPECT_FALSE(all[i].title.empty()) << all[i].id;
        EXPECT_FALSE(all[i].summary.empty()) << all[i].id;
        if (i == 0) continue;
        const auto& before = all[i - 1];
        EXPECT_LE(before.family, all[i].family);
        const bool ordered = before.name == "none" || (before.name < all[i].name && all[i].name != "none");
        EXPECT_TRUE(before.family != all[i].family || ordered) << before.id << " before " << all[i].id;
    }
    for (Family family : {Family::Shadow, Family::Ao, Family::Filter, Family::Indirect, Family::Aa})
        EXPECT_EQ(technique(family, "none").name, "none") << "every family has its baseline";
}

TEST(Techniques, FamiliesReadBackAndSuggest) {
    for (Family family : {Family::Shadow, Family::Ao, Family::Filter, Family::Indirect, Family::Aa})
        EXPECT_EQ(familyFromName(familyName(family)), family);
    try {
        familyFromName("shdow");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_TRUE(has(e.what(), "did you mean 'shadow'?"));
    }
}

TEST(Techniques, DeclarationsAreWhole) {
    for (const TechniqueInfo& info : techniques())
        for (const ParamInfo& param : info.params) {
            SCOPED_TRACE(info.id + " " + param.key);
            EXPECT_FALSE(param.help.empty());
            EXPECT_EQ(param.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos);
            // The default lies in its own range: reading its text back succeeds.
            EXPECT_NO_THROW(ParamTable::parse(param, toString(param.defaultValue), info.id));
            const bool hasRange = param.type != ParamType::Bool && param.type != ParamType::Enum;
            EXPECT_TRUE(!hasRange || param.minimum < param.maximum);
            EXPECT_TRUE(param.scale != Scale::Log || param.minimum > 0);
            EXPECT_GE(param.tuneMaximum, param.tuneMinimum);
            if (param.tuneMaximum > param.tuneMinimum) {
                EXPECT_GE(param.tuneMinimum, param.minimum);
                EXPECT_LE(param.tuneMaximum, param.maximum);
            }
        }
}

}  // namespace
}  // namespace ombrage
