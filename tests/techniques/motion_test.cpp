// SPDX-License-Identifier: MIT
// Real techniques under motion scripts, from the request to the record.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <nlohmann/json.hpp>

namespace ombrage::test {
namespace {

namespace fs = std::filesystem;

class MotionTest : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::path(testing::TempDir()) /
                   ("ombrage_motion_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    /// The metrics of one technique on one scene under one script.
    nlohmann::json play(const std::string& scene, const std::string& technique, const std::string& motion) {
        const char* device = std::getenv("OMBRAGE_DEVICE");
        CompareRequest request;
        request.scenes = {scene};
        request.pipelines = {parseTechnique(technique)};
        request.motions = parseMotions(motion);
        request.base.width = 160;
        request.base.height = 90;
        request.truthSamples = 16;
        request.outputDir = m_folder;
        m_result = compare(request, {device != nullptr ? device : "", "", true});
        for (const std::string& text : m_result.records) {
            const auto record = nlohmann::json::parse(text);
            if (!record["motion"].is_string()) continue;
            EXPECT_EQ(record["motion"], motion);
            EXPECT_TRUE(fs::exists(m_folder / record["images"]["flicker"].get<std::string>()));
            return record["metrics"];
        }
        ADD_FAILURE() << "no record of " << motion;
        return {};
    }

    fs::path m_folder;
    CompareResult m_result;
};

TEST_F(MotionTest, AMapThatIsFittedToTheViewSwimsAndOneOfTheSceneDoesNot) {
    const auto toScene = play("long-view", "shadow/map:resolution=256", "camera-walk");
    EXPECT_EQ(toScene["flicker_mean"], 0.0);
    EXPECT_EQ(toScene["flicker_patch"], 0.0);
    EXPECT_TRUE(toScene["lag"].is_null());
    // Measured 0.035 at 320 x 180 and 1024 texels.
    const auto toView = play("long-view", "shadow/map:resolution=256,fit=view", "camera-walk");
    EXPECT_GT(toView["flicker_mean"].get<double>(), 0.01);
    EXPECT_GT(toView["flicker_patch"].get<double>(), 10.0);
    // A turn leaves the map where it is as long as the casters' own extent is in view.
    EXPECT_EQ(play("gap", "shadow/map:resolution=256,fit=view", "camera-turn")["flicker_mean"], 0.0);
}

TEST_F(MotionTest, ExactShadowsNeitherFlickerNorLag) {
    for (const MotionScript& script : motionScripts()) {
        const auto metrics = play("gap", "shadow/ray-traced", script.name);
        // Rays of floats and of doubles differ at single points of an edge: 1 of 160 x 90 in a frame is 0.00007.
        EXPECT_LT(metrics["flicker_mean"].get<double>(), 0.0005) << script.name;
        EXPECT_EQ(metrics["flicker_p99"], 0.0) << script.name;
        if (script.jumpAt > 0) {
            EXPECT_EQ(metrics["lag"], 0) << script.name;
        } else {
            EXPECT_TRUE(metrics["lag"].is_null()) << script.name;
        }
    }
}

// A map or a volume that were kept over a move of what it was made from would never settle.
TEST_F(MotionTest, CachesFollowJumpsAtOnce) {
    for (const char* technique : {"shadow/map:cache=true", "shadow/map:cache=true,fit=view", "shadow/volume-zfail",
                                  "shadow/planar", "shadow/self"})
        for (const char* motion : {"light-jump", "caster-jump"}) {
            const auto metrics = play("two-casters", technique, motion);
            EXPECT_EQ(metrics["lag"], 0) << technique << " " << motion;
        }
}

TEST_F(MotionTest, CoarseMapsFlickerMoreUnderAMovingSun) {
    const double coarse = play("gap", "shadow/map:resolution=64", "sun-arc")["flicker_mean"],
                 fine = play("gap", "shadow/map:resolution=1024", "sun-arc")["flicker_mean"];
    EXPECT_GT(coarse, 2 * fine);
    EXPECT_GT(fine, 0.0);
}

TEST_F(MotionTest, OcclusionIsFollowedThroughThePicture) {
    // Samples in fixed places of the screen crawl over surfaces; nothing at all does not.
    EXPECT_EQ(play("corner", "ao/none", "camera-turn")["flicker_mean"], 0.0);
    EXPECT_GT(play("corner", "ao/blocks", "camera-turn")["flicker_mean"].get<double>(), 0.001);
    const auto blocks = play("gap", "ao/blocks", "caster-jump");
    EXPECT_EQ(blocks["lag"], 0);
}

TEST_F(MotionTest, StillRecordsKeepTheirMetricsAndGatesReadThoseOfMotion) {
    play("gap", "shadow/none", "light-jump");
    ASSERT_EQ(m_result.records.size(), 2u);
    const auto still = nlohmann::json::parse(m_result.records[0]), moving = nlohmann::json::parse(m_result.records[1]);
    EXPECT_TRUE(still["motion"].is_null());
    EXPECT_TRUE(still["metrics"].contains("rmse"));
    EXPECT_FALSE(still["metrics"].contains("flicker_mean"));
    EXPECT_EQ(moving["metrics"].size(), 4u);
    // The same once more: both come out of the store.
    play("gap", "shadow/none", "light-jump");
    EXPECT_EQ(m_result.reused, 2u);
}

}  // namespace
}  // namespace ombrage::test
