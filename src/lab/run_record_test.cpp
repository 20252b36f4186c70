// SPDX-License-Identifier: MIT
#include "lab/run_record.h"

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "lab/record_sample.h"

namespace ombrage {
namespace {

std::filesystem::path freshFile(const char* name) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::remove(file);
    return file;
}

TEST(RunRecord, ReadsBackWhatItWrote) {
    const RunRecord record = sampleRecord();
    EXPECT_EQ(RunRecord::fromJson(record.toJson(), "test"), record);
}

TEST(RunRecord, ReadsBackWithoutLightAndTruth) {
    RunRecord record = sampleRecord("aa/sample");
    record.light.clear();
    record.truth.reset();
    EXPECT_EQ(RunRecord::fromJson(record.toJson(), "test"), record);
}

TEST(RunRecord, TellsMotionsApart) {
    RunRecord record = sampleRecord();
    const std::string still = record.toJson(), identity = identityOf(record);
    EXPECT_TRUE(nlohmann::json::parse(still)["motion"].is_null());
    record.motion = "caster-jump:box";
    EXPECT_EQ(RunRecord::fromJson(record.toJson(), "test"), record);
    EXPECT_NE(identityOf(record), identity);
    // Records from before there were motions.
    auto old = nlohmann::ordered_json::parse(still);
    old.erase("motion");
    EXPECT_EQ(RunRecord::fromJson(old.dump(), "test"), sampleRecord());
}

TEST(RunRecord, TellsTimesAndHowItWasAskedFor) {
    RunRecord record = sampleRecord();
    const std::string identity = identityOf(record);
    record.time_s = 1.5;
    const std::string later = identityOf(record);
    record.normals = "bump";
    EXPECT_NE(identityOf(record), later) << "other normals are another question";
    record.asked = {"models/a b.obj", "--ground"};
    EXPECT_EQ(RunRecord::fromJson(record.toJson(), "test"), record);
    EXPECT_NE(identityOf(record), identity) << "another moment of an animation is another question";
    auto old = nlohmann::ordered_json::parse(record.toJson());
    old.erase("time_s");
    old.erase("normals");
    old.erase("asked");
    const RunRecord read = RunRecord::fromJson(old.dump(), "test");
    EXPECT_EQ(read.time_s, 0);
    EXPECT_EQ(read.normals, "map");
    EXPECT_TRUE(read.asked.empty());
}

TEST(RunRecord, ReadsFoldersWithoutSamples) {
    auto json = nlohmann::ordered_json::parse(sampleRecord().toJson());
    json["gpu_ms"].erase("samples");
    EXPECT_TRUE(RunRecord::fromJson(json.dump(), "test").frames_ms.empty());
}

// The keys are the contract of other programs (design section 8).
TEST(RunRecord, HasTheKeysOfTheSchema) {
    const auto json = nlohmann::json::parse(sampleRecord().toJson());
    EXPECT_EQ(json["schema"], "ombrage/record/1");
    for (const char* key : {"scene",   "scene_hash", "camera",  "light",   "motion", "size",      "technique", "params",
                            "metrics", "truth",      "passes",  "gpu_ms",  "cpu_ms", "gpu_bytes", "counters",  "seed",
                            "asked",   "time_s",     "normals", "version", "device", "images",    "warnings"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["size"], nlohmann::json::array({640, 360}));
    EXPECT_EQ(json["params"]["resolution"], 2048);
    EXPECT_EQ(json["params"]["tint"], nlohmann::json::array({1, 0.5, 0.25}));
    EXPECT_TRUE(json["metrics"]["acne"].is_null());
    EXPECT_EQ(json["gpu_ms"]["clock"], "wall");
    EXPECT_EQ(json["gpu_ms"]["samples"], nlohmann::json::array({2.1, 2.0, 2.4}));
    EXPECT_EQ(json["truth"]["spp"], 1024);
    EXPECT_EQ(json["passes"][0]["gpu_ms"]["p95"], 0.9);
}

TEST(RunRecord, StaysOneLineWhateverTheTexts) {
    RunRecord record = sampleRecord();
    record.warnings = {"two\nlines", "not UTF-8: \xff"};
    EXPECT_EQ(record.toJson().find('\n'), std::string::npos);
    EXPECT_NO_THROW(RunRecord::fromJson(record.toJson(), "test"));
}

TEST(RunRecord, RefusesOtherDocumentsAndSaysWhere) {
    for (const char* text :
         {"", "{", "{}", "[]", "{\"schema\":\"ombrage/record/9\"}", "{\"schema\":\"ombrage/record/1\"}"}) {
        try {
            RunRecord::fromJson(text, "records.jsonl:7");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Input);
            EXPECT_EQ(error.where(), "records.jsonl:7");
        }
    }
}

TEST(RunNote, ReadsBackWhatItWrote) {
    const RunNote note{{"ombrage", "compare", "a b"}, {{"gap", "shadow/sample", "no"}}, {"a gate"}, true};
    EXPECT_EQ(RunNote::fromJson(note.toJson(), "test"), note);
}

TEST(Lines, TornLastOneIsNotRead) {
    const auto file = freshFile("ombrage_torn.jsonl");
    std::ofstream(file, std::ios::binary) << "one\ntwo\n{\"half";
    EXPECT_EQ(readLines(file), (std::vector<std::string>{"one", "two"}));
}

TEST(Lines, MissingFileHasNone) {
    EXPECT_TRUE(readLines(freshFile("ombrage_no_such.jsonl")).empty());
}

TEST(RunRecord, IdentityIsWhatWasAskedNotWhatWasFound) {
    const RunRecord record = sampleRecord();
    RunRecord again = sampleRecord("shadow/sample", 0.5);
    again.gpu_ms = {1, 1};
    again.version = "9";
    EXPECT_EQ(identityOf(record), identityOf(again));
    for (const auto& change : std::vector<std::function<void(RunRecord&)>>{
             [](RunRecord& r) { r.light = "other"; }, [](RunRecord& r) { r.seed = 2; },
             [](RunRecord& r) { r.pipeline += ":resolution=1"; }, [](RunRecord& r) { r.truth->kind = "area"; },
             [](RunRecord& r) { r.truth.reset(); }}) {
        RunRecord other = sampleRecord();
        change(other);
        EXPECT_NE(identityOf(record), identityOf(other));
    }
}

}  // namespace
}  // namespace ombrage
