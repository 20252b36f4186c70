// SPDX-License-Identifier: MIT
#include "lab/motion_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/flicker.h"
#include "scene/camera_view.h"

namespace ombrage {

namespace {

constexpr double kHardTolerance = 0.1, kSoftTolerance = 0.05;

Scene standingStill(Scene scene) {
    scene.animations.clear();
    return scene;
}

}  // namespace

bool isScreenSpace(const Pipeline& pipeline) {
    return std::any_of(pipeline.begin(), pipeline.end(),
                       [](const TechniqueSpec& spec) { return technique(spec.id).screenSpace; });
}

MotionStage::MotionStage(const Scene& scene, int camera, ReferenceOptions options)
    : m_start(scene),
      m_camera(camera),
      m_options(std::move(options)),
      m_scene(standingStill(scene)),
      m_reference(scene) {}

void MotionStage::ask(const MotionQuestion& question) {
    m_question = question;
    m_caster = question.motion.movesCaster() ? chosenCaster(m_start, question.motion.caster) : Caster{};
    const std::string traced = toString(question.motion) + "\n" + std::to_string(question.light) + "\n" +
                               truthKindName(question.kind) + "\n" + familyName(question.family);
    if (traced != m_tracedFor) m_truths.clear();
    m_tracedFor = traced;
    m_truths.resize(std::size_t(question.motion.script.frames));
    pose(0);
}

void MotionStage::pose(int frame) {
    poseScene(m_scene, m_start, m_question.motion, m_camera, m_question.light, m_caster, frame);
    m_fitCamera.reset();
    if (!m_question.motion.movesCamera() || movesPicture()) return;
    m_fitCamera = m_scene.cameras[std::size_t(m_camera)];
    m_scene.cameras[std::size_t(m_camera)] = m_start.cameras[std::size_t(m_camera)];
}

const Receivers& MotionStage::receivers() {
    if (!m_receivers) m_receivers = m_reference.receivers(m_start.cameras[std::size_t(m_camera)], m_options);
    return *m_receivers;
}

std::vector<bool> MotionStage::onCaster() {
    std::vector<bool> moves(m_start.instances.size(), false), on;
    for (const int instance : m_caster.instances) moves[std::size_t(instance)] = true;
    for (const std::uint32_t instance : receivers().instance)
        on.push_back(instance != kNoHit && moves[std::size_t(instance)]);
    return on;
}

std::vector<glm::dvec2> MotionStage::placesInPicture() {
    const Receivers& seen = receivers();
    const Bounds bounds = m_start.bounds();
    const CameraView view =
        makeCameraView(m_scene.cameras[std::size_t(m_camera)], seen.width, seen.height, bounds.center(), bounds);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& position : m_reference.positions(seen)) {
        const glm::dvec3 d = position - bounds.center() - glm::dvec3(view.eye);
        const double depth = glm::dot(d, glm::dvec3(view.forward));
        const double half = view.orthographic ? view.orthoHeight_m * 0.5 : depth * double(view.tanHalfFovY);
        if (!(depth > 0)) {
            places.emplace_back(nan, nan);
            continue;
        }
        // Pixels are square: both axes have the scale of the height.
        const double pixels = seen.height * 0.5 / half;
        places.emplace_back(seen.width * 0.5 + glm::dot(d, glm::dvec3(view.right)) * pixels,
                            seen.height * 0.5 - glm::dot(d, glm::dvec3(view.up)) * pixels);
    }
    return places;
}

const MotionStage::Truth& MotionStage::truth(int frame) {
    // A camera changes nothing of the truth at the same points, and after a jump all stands still.
    const MotionScript& script = m_question.motion.script;
    int asIn = frame;
    if (m_question.motion.movesCamera())
        asIn = 0;
    else if (script.jumpAt > 0)
        asIn = frame < script.jumpAt ? 0 : script.jumpAt;
    std::optional<Truth>& known = m_truths[std::size_t(asIn)];
    if (!known) known = asIn == 0 ? trace(m_reference) : trace(Reference(m_scene));
    return *known;
}

MotionStage::Truth MotionStage::trace(const Reference& reference) {
    const Camera& camera = m_start.cameras[std::size_t(m_camera)];
    ReferenceOptions options = m_options;
    options.kind = m_question.kind;
    if (m_question.family == Family::Shadow) {
        ShadowTruth t = reference.shadow(receivers(), camera, m_question.light, options);
        return {std::move(t.visibility), std::move(t.mask), t.samplesPerPixel,
                t.meanStandardError,     t.maskedShare,     t.soft ? kSoftTolerance : kHardTolerance};
    }
    AoTruth t = reference.ao(receivers(), camera, options);
    return {std::move(t.visibility), std::move(t.mask), t.samplesPerPixel,
            t.meanStandardError,     t.maskedShare,     kSoftTolerance};
}

namespace {

/// The shot's errors at the stage's receivers, as posed.
ErrorFrame errorsOf(MotionStage& stage, const MotionStage::Truth& truth, const std::vector<bool>& onCaster,
                    const MotionShot& shot) {
    const Receivers& receivers = stage.receivers();
    const std::size_t count = receivers.triangle.size();
    ErrorFrame frame{std::vector<float>(count, 0.0f), std::vector<bool>(count, false)};
    std::vector<std::ptrdiff_t> pixels;
    if (stage.movesPicture())
        pixels = nearestOfTriangle(receivers, stage.placesInPicture(), shot.instance, shot.triangle);
    for (std::size_t i = 0; i < count; ++i) {
        if (truth.mask[i] != Mask::Valid || onCaster[i]) continue;
        const std::ptrdiff_t pixel = pixels.empty() ? std::ptrdiff_t(i) : pixels[i];
        if (pixel < 0) continue;
        // Where the picture stands still another triangle means that the caster came before the point.
        const auto at = std::size_t(pixel);
        frame.valid[i] = shot.instance[at] == receivers.instance[i] && shot.triangle[at] == receivers.triangle[i];
        frame.error[i] = shot.visibility[at] - truth.visibility[i];
    }
    return frame;
}

/// The points whose truth a jump changes, and what the shots after it show there.
struct Jump {
    std::vector<std::size_t> points;
    std::vector<std::vector<float>> shown, settled;

    std::vector<float> take(const MotionShot& shot) const {
        std::vector<float> values;
        for (const std::size_t point : points) values.push_back(shot.visibility[point]);
        return values;
    }
};

}  // namespace

MotionMeasurement measureMotion(MotionStage& stage, const MotionDraw& draw) {
    const Receivers& receivers = stage.receivers();
    const MotionScript& script = stage.question().motion.script;
    const std::vector<bool> onCaster = stage.onCaster();
    stage.pose(0);
    const double tolerance = stage.truth(0).tolerance;
    FlickerMeter meter(receivers.width, receivers.height, tolerance);
    MotionMeasurement measured;
    Jump jump;
    std::vector<bool> validBefore;
    for (int frame = 0; frame < script.frames; ++frame) {
        stage.pose(frame);
        const MotionStage::Truth& truth = stage.truth(frame);
        const MotionShot shot = draw(frame, frame == 0);
        ErrorFrame errors = errorsOf(stage, truth, onCaster, shot);
        measured.samplesPerPixel = truth.samplesPerPixel;
        measured.standardError = std::max(measured.standardError, truth.standardError);
        if (script.jumpAt > 0 && frame == script.jumpAt) {
            const std::vector<float>& before = stage.truth(frame - 1).visibility;
            for (std::size_t i = 0; i < errors.valid.size(); ++i)
                if (validBefore[i] && errors.valid[i] &&
                    std::fabs(double(truth.visibility[i]) - double(before[i])) > tolerance)
                    jump.points.push_back(i);
        }
        if (script.jumpAt > 0 && frame >= script.jumpAt) jump.shown.push_back(jump.take(shot));
        validBefore = errors.valid;
        meter.add(std::move(errors));
    }

    // The twin, for which the jump had always happened, in frames of the same numbers.
    for (int frame = 0; frame < script.frames && !jump.points.empty(); ++frame) {
        stage.pose(script.frames - 1);
        const MotionShot shot = draw(frame, frame == 0);
        if (frame >= script.jumpAt) jump.settled.push_back(jump.take(shot));
    }

    const Flicker flicker = meter.result();
    measured.metrics = {
        {"flicker_mean", flicker.mean}, {"flicker_p99", flicker.p99}, {"flicker_patch", {}}, {"lag", {}}};
    if (flicker.patch_px) measured.metrics["flicker_patch"] = double(*flicker.patch_px);
    if (!jump.points.empty())
        if (const std::optional<Lag> lag = lagOf(jump.shown, jump.settled, tolerance)) {
            measured.metrics["lag"] = lag->frames;
            measured.settled = lag->settled;
        }
    measured.largest = flicker.largest;
    std::size_t seen = 0, surface = 0;
    for (std::size_t i = 0; i < receivers.triangle.size(); ++i) {
        const bool isSky = receivers.triangle[i] == kNoHit;
        measured.mask.push_back(isSky ? Mask::Sky : flicker.seen[i] ? Mask::Valid : Mask::Disagree);
        surface += isSky ? 0 : 1;
        seen += flicker.seen[i] ? 1 : 0;
    }
    measured.maskedShare = surface > 0 ? double(surface - seen) / double(surface) : 0.0;
    return measured;
}

}  // namespace ombrage
