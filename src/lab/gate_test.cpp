// SPDX-License-Identifier: MIT
#include "lab/gate.h"

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "lab/plan.h"
#include "lab/record_sample.h"

namespace ombrage {
namespace {

/// Any technique of the family beside its baseline: the laboratory knows none by name.
std::string someId(Family family) {
    std::string id;
    for (const TechniqueInfo& info : techniques())
        if (info.family == family) id = info.id;
    return id;
}

template <typename Call>
Error thrown(Call call) {
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    return {ErrorCode::Environment, "nothing was thrown"};
}

TEST(Gate, ReadsMetricOperatorAndBound) {
    const Gate gate = parseGate("rmse >= 0.25");
    EXPECT_EQ(gate.technique, "");
    EXPECT_EQ(gate.metric, "rmse");
    EXPECT_EQ(gate.op, '>');
    EXPECT_TRUE(gate.orEqual);
    EXPECT_EQ(gate.bound, 0.25);
}

TEST(Gate, ReadsTheTechnique) {
    const std::string id = someId(Family::Shadow);
    EXPECT_EQ(parseGate(id + ".wrong<1e-3").technique, id);
    EXPECT_EQ(parseGate(id + ".wrong<1e-3").bound, 1e-3);
}

TEST(Gate, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(thrown([] { parseGate("rmse"); }).code(), ErrorCode::Usage);
    EXPECT_EQ(thrown([] { parseGate("rmse>a lot"); }).code(), ErrorCode::Usage);
    const Error metric = thrown([] { parseGate("rmsee>1"); });
    EXPECT_EQ(metric.code(), ErrorCode::Usage);
    EXPECT_NE(metric.hint().find("'rmse'"), std::string::npos) << metric.hint();
    EXPECT_EQ(thrown([] { parseGate("shadow/not-there.rmse>1"); }).code(), ErrorCode::Usage);
}

TEST(Gate, IsMetByTheRightSideOfItsBoundOnly) {
    Gate gate;
    gate.metric = "rmse";
    gate.bound = 0.5;
    RunRecord record = sampleRecord();
    const auto met = [&](char op, bool orEqual, double value) {
        gate.op = op;
        gate.orEqual = orEqual;
        record.metrics["rmse"] = value;
        return metGate(gate, record).has_value();
    };
    EXPECT_TRUE(met('>', false, 0.6));
    EXPECT_FALSE(met('>', false, 0.5));
    EXPECT_TRUE(met('>', true, 0.5));
    EXPECT_FALSE(met('>', true, 0.4));
    EXPECT_TRUE(met('<', false, 0.4));
    EXPECT_FALSE(met('<', false, 0.5));
    EXPECT_TRUE(met('<', true, 0.5));
}

TEST(Gate, ConcernsItsTechniqueOnlyAndNoNullMetric) {
    Gate gate;
    gate.metric = "rmse";
    gate.technique = "shadow/sample";
    EXPECT_TRUE(metGate(gate, sampleRecord("shadow/sample", 1)).has_value());
    EXPECT_FALSE(metGate(gate, sampleRecord("shadow/other", 1)).has_value());
    gate.metric = "acne";  // null in the sample
    EXPECT_FALSE(metGate(gate, sampleRecord("shadow/sample", 1)).has_value());
}

TEST(ParseTechnique, TellsTheFamily) {
    const std::string id = someId(Family::Ao);
    const auto [family, pipeline] = parseTechnique(id);
    EXPECT_EQ(family, Family::Ao);
    ASSERT_EQ(pipeline.size(), 1u);
    EXPECT_EQ(pipeline.front().id, id);
    const std::string piped = id + "+" + someId(Family::Filter);
    EXPECT_EQ(techniqueText(parseTechnique(piped).second), piped);
}

TEST(ParseTechnique, RefusesAFilterAloneAndAnAmbiguousName) {
    EXPECT_NE(thrown([] { parseTechnique(someId(Family::Filter)); }).message().find("nothing to filter"),
              std::string::npos);
    // Every family has its baseline, so that name alone says nothing.
    const std::string id = RenderSettings{}.shadow.front().id;
    const Error error = thrown([&] { parseTechnique(id.substr(id.find('/') + 1)); });
    EXPECT_NE(error.message().find("several families"), std::string::npos) << error.message();
}

}  // namespace
}  // namespace ombrage
