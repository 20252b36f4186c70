// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <ombrage/error.h>

#include "reference/ao_estimator.h"
#include "reference/parallel_rows.h"

namespace ombrage {
namespace {

constexpr std::uint32_t kStream = 0;

/// @throws Error(Usage) for what ao() does not answer.
TruthKind checkedKind(const ReferenceOptions& options) {
    const TruthKind kind = options.kind.value_or(truthKindsOf(Quantity::Ao).front());
    truthKindFromName(truthKindName(kind), Quantity::Ao);
    if (kind == TruthKind::Area)
        throw Error(ErrorCode::Usage, "the truth 'area' has receivers of its own", "Use Reference::areaAo.");
    if (kind == TruthKind::Displaced)
        throw Error(ErrorCode::Usage, "the truth 'displaced' is that of another scene",
                    "Make a Reference of displaced(scene) and ask it for T1.");
    if (kind == TruthKind::Own && !options.integrand)
        throw Error(ErrorCode::Usage, "the truth 'own' needs a technique that states what it claims");
    return kind;
}

}  // namespace

AoTruth Reference::ao(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    AoQuestion question;
    question.kind = checkedKind(options);
    question.radius_m = m_impl->scene.aoRadius_m;
    if (question.kind == TruthKind::T4) question.radius_m = std::numeric_limits<double>::infinity();
    if (!(question.radius_m > 0))
        throw Error(ErrorCode::Usage, "the scene has no radius of ambient occlusion", "Set ao_radius_m above 0.");
    question.integrand = options.integrand;
    CameraView view;
    if (question.kind == TruthKind::Own) {
        view = makeCameraView(camera, receivers.width, receivers.height, m_impl->flat.origin, m_impl->bounds);
        question.view = &view;
        question.sceneDiagonal_m = m_impl->bounds.diagonal();
    }
    const SampleSets sets(pointSeed(options.seed, kStream, kNoHit),
                          samplesPerScrambling(options.samplesPerPixel, kAoSamples));
    const AoEstimator estimator(m_impl->rays, m_impl->flat, question, sets);

    AoTruth t;
    t.width = receivers.width;
    t.height = receivers.height;
    t.samplesPerPixel = sets.samples() * kScramblings;
    t.radius_m = float(question.radius_m);
    t.visibility.assign(receivers.triangle.size(), 1.0f);
    t.standardError.assign(receivers.triangle.size(), 0.0f);
    t.mask.assign(receivers.triangle.size(), Mask::Sky);

    const double inset_m = m_impl->rays.positionError_m(0);
    parallelRows(receivers.height, options, [&](int y) {
        SurfacePoints points(m_impl->flat, receivers, inset_m);
        for (int x = 0; x < receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(receivers.width) + std::size_t(x);
            if (receivers.triangle[i] == kNoHit) continue;
            const Estimate e = estimator.at(points.at(i), pointSeed(options.seed, kStream, std::uint32_t(i)));
            t.mask[i] = Mask::Valid;
            t.visibility[i] = float(e.mean);
            t.standardError[i] = float(e.standardError);
        }
    });
    summarise(t.mask, t.standardError, t.meanStandardError, t.maskedShare);
    return t;
}

Reference::Estimate Reference::aoAt(const glm::dvec3& point, const glm::dvec3& normal, double radius_m, int samples,
                                    std::uint64_t seed, TruthKind kind) const {
    ReferenceOptions options;
    options.kind = kind;
    SurfacePoint p;
    p.position = point - m_impl->flat.origin;
    p.normal = p.shadingNormal = glm::normalize(normal);
    const AoQuestion question{checkedKind(options), radius_m, nullptr, 0, nullptr};
    const SampleSets sets(pointSeed(seed, kStream, kNoHit), samplesPerScrambling(samples, kAoSamples));
    return AoEstimator(m_impl->rays, m_impl->flat, question, sets).at(p, pointSeed(seed, kStream, 0));
}

}  // namespace ombrage
