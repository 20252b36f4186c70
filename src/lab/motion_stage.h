// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/metrics.h>
#include <ombrage/reference.h>
#include <ombrage/technique.h>

#include "lab/motion.h"

namespace ombrage {

/// What a motion script asks of a pipeline.
struct MotionQuestion {
    Motion motion;
    Family family = Family::Shadow;  ///< Shadow or Ao
    TruthKind kind = TruthKind::Shadow;
    int light = -1;  ///< of shadows
    /// The answer depends on where in the picture a surface lies: the picture itself moves with the camera. Otherwise
    /// only the camera that the technique fits to does.
    bool screenSpace = false;
};

/// Whether a part of the pipeline is (TechniqueInfo::screenSpace).
bool isScreenSpace(const Pipeline& pipeline);

/// A scene in motion, the surface points that its first frame sees, and their truth in every frame.
class MotionStage {
public:
    /// @param scene    at the time of the first frame; must outlive the stage
    /// @param options  of the truth; their kind is the question's
    MotionStage(const Scene& scene, int camera, ReferenceOptions options);

    /// What is asked from now on, posed in frame 0.
    void ask(const MotionQuestion& question);
    void pose(int frame);

    const MotionQuestion& question() const { return m_question; }
    const Scene& scene() const { return m_scene; }  ///< as posed; without animations of its own
    const Receivers& receivers();
    /// What techniques fit to where the picture's camera stands still.
    const std::optional<Camera>& fitCamera() const { return m_fitCamera; }
    bool movesPicture() const { return m_question.screenSpace && m_question.motion.movesCamera(); }
    /// Per receiver, whether it lies on what moves.
    std::vector<bool> onCaster();
    /// Where the receivers' points stand in the picture as posed; not a number behind the camera.
    std::vector<glm::dvec2> placesInPicture();

    struct Truth {
        std::vector<float> visibility;
        std::vector<Mask> mask;
        int samplesPerPixel = 0;
        double standardError = 0, maskedShare = 0, tolerance = 0;
    };
    /// Of the receivers, as posed in the frame. Traced once for all that ask the same of the same script.
    const Truth& truth(int frame);

private:
    Truth trace(const Reference& reference);

    const Scene& m_start;
    const int m_camera;
    const ReferenceOptions m_options;
    Scene m_scene;
    Reference m_reference;  ///< of the first frame
    std::optional<Receivers> m_receivers;
    MotionQuestion m_question;
    Caster m_caster;
    std::optional<Camera> m_fitCamera;
    std::string m_tracedFor;
    std::vector<std::optional<Truth>> m_truths;
};

/// One rendered frame.
struct MotionShot {
    std::vector<float> visibility;
    std::vector<std::uint32_t> instance, triangle;
};

/// Renders the stage's scene as posed. The first frame of a sequence starts with a technique that knows nothing.
using MotionDraw = std::function<MotionShot(int frame, bool isFirst)>;

struct MotionMeasurement {
    Metrics metrics;             ///< those of MetricInfo::ofMotion
    std::vector<float> largest;  ///< per pixel of the first frame, the largest change between two frames
    std::vector<Mask> mask;      ///< per pixel; Disagree where it was never followed from one frame to the next
    bool settled = true;         ///< false: `lag` is only the number of frames in which it did not settle
    int samplesPerPixel = 0;     ///< of the truth
    double standardError = 0, maskedShare = 0;  ///< share of the surface that is not measured
};

/// Plays the script that the stage was asked about: once, and where something jumps once more with it already there.
MotionMeasurement measureMotion(MotionStage& stage, const MotionDraw& draw);

}  // namespace ombrage
