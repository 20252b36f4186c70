// SPDX-License-Identifier: MIT
// Planted techniques: pictures made of the truth, as it is, late, or wrong in a known way.
#include "lab/motion_stage.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

constexpr int kWidth = 96, kHeight = 54;

class MotionStageTest : public testing::Test {
protected:
    static ReferenceOptions options() {
        ReferenceOptions made;
        made.width = kWidth;
        made.height = kHeight;
        return made;
    }

    MotionQuestion question(const std::string& motion, bool screenSpace = false) const {
        return {parseMotion(motion), Family::Shadow, TruthKind::Shadow, 0, screenSpace};
    }

    /// What a perfect renderer shows of the stage as posed: the ids of its own camera's picture and its exact shadows.
    MotionShot perfect() const {
        const Reference reference(m_stage.scene());
        const Camera& camera = m_stage.scene().cameras[0];
        const Receivers seen = reference.receivers(camera, options());
        return {reference.shadow(seen, camera, 0, options()).visibility, seen.instance, seen.triangle};
    }

    static double metric(const MotionMeasurement& measured, const char* key) {
        return measured.metrics.at(key).value_or(-1);
    }

    const Scene m_scene = loadScene("gap");
    MotionStage m_stage{m_scene, 0, options()};
};

TEST_F(MotionStageTest, TheTruthNeitherFlickersNorLags) {
    for (const MotionScript& script : motionScripts()) {
        if (script.kind == MotionKind::CameraWalk || script.kind == MotionKind::CameraTurn) continue;
        m_stage.ask(question(script.name));
        const MotionMeasurement measured = measureMotion(m_stage, [&](int, bool) { return perfect(); });
        EXPECT_EQ(metric(measured, "flicker_mean"), 0.0) << script.name;
        EXPECT_EQ(metric(measured, "flicker_patch"), 0.0) << script.name;
        EXPECT_EQ(metric(measured, "lag"), script.jumpAt > 0 ? 0.0 : -1.0) << script.name;
        EXPECT_TRUE(measured.settled);
        // The floor is most of the picture and stays where it is.
        EXPECT_LT(measured.maskedShare, 0.5) << script.name;
    }
}

TEST_F(MotionStageTest, APlantedDelayIsReadInFrames) {
    for (const char* name : {"light-jump", "caster-jump"})
        for (const int late : {0, 1, 3, 7}) {
            m_stage.ask(question(name));
            const int jumpAt = m_stage.question().motion.script.jumpAt;
            std::vector<float> old;
            int sequence = 0;
            const MotionMeasurement measured = measureMotion(m_stage, [&](int frame, bool isFirst) {
                sequence += isFirst ? 1 : 0;
                MotionShot shot = perfect();
                if (isFirst) old = shot.visibility;
                if (frame < jumpAt + late) shot.visibility = old;
                return shot;
            });
            EXPECT_EQ(metric(measured, "lag"), late) << name;
            EXPECT_EQ(sequence, 2);
            EXPECT_TRUE(measured.settled);
            if (late > 0) {
                EXPECT_GT(metric(measured, "flicker_patch"), 0.0);
            }
        }
}

TEST_F(MotionStageTest, AStaleAnswerNeverSettles) {
    m_stage.ask(question("light-jump"));
    std::vector<float> old;
    const MotionMeasurement measured = measureMotion(m_stage, [&](int, bool isFirst) {
        MotionShot shot = perfect();
        if (isFirst) old = shot.visibility;
        shot.visibility = old;
        return shot;
    });
    EXPECT_FALSE(measured.settled);
    EXPECT_EQ(metric(measured, "lag"), 30.0);
}

TEST_F(MotionStageTest, WhatIsAlwaysWrongDoesNotLag) {
    // All lit, before and after: no worse than where the jump had always happened.
    m_stage.ask(question("light-jump"));
    const MotionMeasurement measured = measureMotion(m_stage, [&](int, bool) {
        MotionShot shot = perfect();
        shot.visibility.assign(shot.visibility.size(), 1.0f);
        return shot;
    });
    EXPECT_EQ(metric(measured, "lag"), 0.0);
    EXPECT_GT(metric(measured, "flicker_mean"), 0.0) << "its error changes where the shadow comes or goes";
}

TEST_F(MotionStageTest, OnlyTheFittedCameraMovesWhereThePictureNeedNot) {
    m_stage.ask(question("camera-walk"));
    m_stage.pose(5);
    EXPECT_EQ(m_stage.scene().cameras[0].position, m_scene.cameras[0].position);
    ASSERT_TRUE(m_stage.fitCamera());
    EXPECT_NE(m_stage.fitCamera()->position, m_scene.cameras[0].position);

    // Everything turned by a tenth in every second frame.
    int frame = 0;
    const MotionMeasurement measured = measureMotion(m_stage, [&](int, bool) {
        MotionShot shot = perfect();
        for (float& v : shot.visibility) v = 0.5f + (frame % 2 == 1 ? 0.25f : 0.0f);
        ++frame;
        return shot;
    });
    EXPECT_EQ(metric(measured, "flicker_mean"), 0.25);
    EXPECT_EQ(metric(measured, "flicker_p99"), 0.25);

    m_stage.ask(question("sun-arc"));
    EXPECT_FALSE(m_stage.fitCamera());
}

TEST_F(MotionStageTest, PointsAreFollowedWhereThePictureMoves) {
    m_stage.ask(question("camera-turn", true));
    m_stage.pose(0);
    // Standing still every receiver stands in the middle of its own pixel; floats place it to a thousandth of one.
    const std::vector<glm::dvec2> places = m_stage.placesInPicture();
    const Receivers receivers = m_stage.receivers();
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (receivers.triangle[i] == kNoHit) continue;
        EXPECT_NEAR(places[i].x, double(i % kWidth) + 0.5, 1e-3);
        EXPECT_NEAR(places[i].y, double(i / kWidth) + 0.5, 1e-3);
    }
    m_stage.pose(5);
    EXPECT_NE(m_stage.scene().cameras[0].target, m_scene.cameras[0].target);
    EXPECT_FALSE(m_stage.fitCamera());

    // An answer that hangs on the triangle alone does not flicker, though every pixel shows other points now.
    const MotionMeasurement still = measureMotion(m_stage, [&](int, bool) {
        MotionShot shot = perfect();
        for (std::size_t i = 0; i < shot.visibility.size(); ++i) shot.visibility[i] = float(shot.triangle[i] % 7) / 7;
        return shot;
    });
    EXPECT_EQ(metric(still, "flicker_mean"), 0.0);
    EXPECT_LT(still.maskedShare, 0.5);

    // One that hangs on the pixel does: columns dark and light by turns, under a turn of several pixels.
    const MotionMeasurement columns = measureMotion(m_stage, [&](int, bool) {
        MotionShot shot = perfect();
        for (std::size_t i = 0; i < shot.visibility.size(); ++i) shot.visibility[i] = float(i % kWidth / 2 % 2);
        return shot;
    });
    EXPECT_GT(metric(columns, "flicker_mean"), 0.1);
}

TEST_F(MotionStageTest, WhatMovesIsLeftOut) {
    m_stage.ask(question("caster-move"));
    const std::vector<bool> on = m_stage.onCaster();
    const Receivers& receivers = m_stage.receivers();
    const Caster caster = chosenCaster(m_scene, "");
    ASSERT_GT(std::count(on.begin(), on.end(), true), 0);
    for (std::size_t i = 0; i < on.size(); ++i)
        EXPECT_EQ(on[i], receivers.instance[i] != kNoHit && std::count(caster.instances.begin(), caster.instances.end(),
                                                                       int(receivers.instance[i])) > 0);
    const MotionMeasurement measured = measureMotion(m_stage, [&](int, bool) { return perfect(); });
    for (std::size_t i = 0; i < on.size(); ++i)
        if (on[i]) {
            EXPECT_EQ(measured.mask[i], Mask::Disagree);
        }
}

}  // namespace
}  // namespace ombrage
