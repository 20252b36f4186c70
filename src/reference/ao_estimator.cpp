// SPDX-License-Identifier: MIT
#include "reference/ao_estimator.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

void directions(const glm::dvec3& n_d, Spread spread, const PolarSamples& samples, RayBundle& bundle) {
    glm::dvec3 t_d, b_d;
    basis(n_d, t_d, b_d);
    const glm::vec3 n(n_d), t(t_d), b(b_d);
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        // Height over the base and distance from the axis: a uniform disk point lifted to the sphere is cosine-weighted
        // (Malley), uniform heights are uniform in solid angle (Archimedes).
        const float u = samples.u[i];
        float z, r;
        if (spread == Spread::Cosine) {
            z = std::sqrt(1 - u);
            r = std::sqrt(u);
        } else if (spread == Spread::Hemisphere) {
            z = 1 - u;
            r = std::sqrt(u * (2 - u));
        } else {
            z = 1 - 2 * u;
            r = 2 * std::sqrt(u * (1 - u));
        }
        const float x = r * samples.cosine[i], y = r * samples.sine[i];
        bundle.x[i] = t.x * x + b.x * y + n.x * z;
        bundle.y[i] = t.y * x + b.y * y + n.y * z;
        bundle.z[i] = t.z * x + b.z * y + n.z * z;
    }
}

namespace {

/// The cosine of a direction as it is traced to a normal.
double cosineTo(const RayBundle& bundle, std::size_t i, const glm::dvec3& n) {
    return double(bundle.x[i]) * n.x + double(bundle.y[i]) * n.y + double(bundle.z[i]) * n.z;
}

Ray rayOf(const SurfacePoint& point, const RayBundle& bundle, std::size_t i, double length_m) {
    Ray ray;
    ray.origin = point.position;
    ray.direction = glm::dvec3(bundle.x[i], bundle.y[i], bundle.z[i]);
    ray.length_m = length_m;
    ray.ownTriangle = point.triangle;
    return ray;
}

/// The scene as an integrand may ask for it at one point.
class ScenePoint final : public AoProbe {
public:
    ScenePoint(const RayScene& rays, const CameraView& view, const SurfacePoint& point)
        : m_rays(rays), m_view(view), m_point(point), m_eye(view.eye), m_forward(view.forward) {}

    std::optional<double> distanceTo(const glm::dvec3& direction, double length_m) const override {
        Ray ray;
        ray.origin = m_point.position;
        ray.direction = direction;
        ray.length_m = length_m;
        ray.ownTriangle = m_point.triangle;
        const auto hit = m_rays.nearest(ray);
        return hit ? std::optional(hit->distance_m) : std::nullopt;
    }

    std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const override {
        const glm::dvec3 target = m_point.position + offset;
        const double depth_m = glm::dot(target - m_eye, m_forward);
        if (!(depth_m > 0)) return std::nullopt;
        Ray ray;
        ray.origin = m_view.orthographic ? target - m_forward * depth_m : m_eye;
        ray.direction = m_view.orthographic ? m_forward : glm::normalize(target - m_eye);
        const auto hit = m_rays.nearest(ray);
        if (!hit) return std::nullopt;
        return ray.origin + ray.direction * hit->distance_m - m_point.position;
    }

private:
    const RayScene& m_rays;
    const CameraView& m_view;
    const SurfacePoint& m_point;
    const glm::dvec3 m_eye, m_forward;
};

}  // namespace

double AoEstimator::openShare(const SurfacePoint& point, const RayOrigin& origin, int scrambling,
                              std::uint32_t seed) const {
    const Spread spread = m_question.kind == TruthKind::T3 ? Spread::Hemisphere : Spread::Cosine;
    const SampleSets::Move move = SampleSets::moveOf(seed, scrambling);
    PolarSamples samples;
    RayBundle bundle;
    bundle.length_m.fill(float(m_question.radius_m));
    int open = 0;
    for (int b = 0; b < m_sets.bundles(); ++b) {
        m_sets.polar(scrambling, b, move, samples);
        directions(point.shadingNormal, spread, samples, bundle);
        // Below the geometric horizon the surface itself is in the way.
        std::uint32_t above = 0;
        for (std::size_t i = 0; i < RayBundle::kSize; ++i)
            above |= std::uint32_t(cosineTo(bundle, i, point.normal) > 0) << i;
        above &= m_sets.wanted(b);
        open += __builtin_popcount(above & ~m_rays.occluded(origin, bundle, above));
    }
    return double(open) / m_sets.samples();
}

double AoEstimator::fadedShare(const SurfacePoint& point, int scrambling, std::uint32_t seed) const {
    const SampleSets::Move move = SampleSets::moveOf(seed, scrambling);
    PolarSamples samples;
    RayBundle bundle;
    double sum = 0;
    for (int b = 0; b < m_sets.bundles(); ++b) {
        m_sets.polar(scrambling, b, move, samples);
        directions(point.shadingNormal, Spread::Cosine, samples, bundle);
        for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
            if (!(m_sets.wanted(b) >> i & 1u) || cosineTo(bundle, i, point.normal) <= 0) continue;
            // The nearest surface fades out towards the radius: W(r) = 1 - r^2 (Bavoil, Sainz and Dimitrov 2008).
            const auto hit = m_rays.nearest(rayOf(point, bundle, i, m_question.radius_m));
            const double share = hit ? std::min(1.0, hit->distance_m / m_question.radius_m) : 1.0;
            sum += share * share;
        }
    }
    return sum / m_sets.samples();
}

double AoEstimator::freeVolume(const SurfacePoint& point, int scrambling, std::uint32_t seed) const {
    const Spread spread = m_question.kind == TruthKind::T5Ball ? Spread::Sphere : Spread::Hemisphere;
    const SampleSets::Move move = SampleSets::moveOf(seed, scrambling);

    // Under the receiver's own surface lies its own solid, entered from the front or, where the receiver shows its
    // back, from the back.
    int ownSolid = 1;
    if (point.triangle != kNoHit) {
        const glm::uvec3 t = m_flat.triangles[point.triangle];
        const glm::vec3 a = m_flat.positions[t.x];
        const glm::vec3 n = glm::cross(m_flat.positions[t.y] - a, m_flat.positions[t.z] - a);
        if (glm::dot(glm::dvec3(n), point.normal) < 0) ownSolid = -1;
    }

    PolarSamples samples;
    RayBundle bundle;
    std::vector<RayCrossing> crossings;
    double sum = 0;
    for (int b = 0; b < m_sets.bundles(); ++b) {
        m_sets.polar(scrambling, b, move, samples);
        directions(point.shadingNormal, spread, samples, bundle);
        for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
            if (!(m_sets.wanted(b) >> i & 1u)) continue;
            m_rays.crossings(rayOf(point, bundle, i, m_question.radius_m), crossings);

            // Along the ray a part from s to t holds (t^3 - s^3) / R^3 of the volume. It is free where surfaces entered
            // and left cancel.
            int depth = cosineTo(bundle, i, point.normal) > 0 ? 0 : ownSolid;
            double from = 0;
            const auto walkTo = [&](double distance_m) {
                const double to = std::min(1.0, distance_m / m_question.radius_m);
                if (depth == 0) sum += to * to * to - from * from * from;
                from = to;
            };
            for (const RayCrossing& crossing : crossings) {
                walkTo(crossing.distance_m);
                depth += crossing.fromFront ? 1 : -1;
            }
            walkTo(m_question.radius_m);
        }
    }
    return sum / m_sets.samples();
}

double AoEstimator::ownMean(const SurfacePoint& point, int scrambling, std::uint32_t seed) const {
    const CameraView& view = *m_question.view;
    const AoReceiver receiver{point.normal, point.shadingNormal, glm::dvec3(view.right), glm::dvec3(view.up),
                              m_question.radius_m, m_question.sceneDiagonal_m};
    const ScenePoint probe(m_rays, view, point);
    const std::uint32_t own = hashCombine(seed, std::uint32_t(scrambling));
    double sum = 0;
    for (int i = 0; i < m_sets.samples(); ++i) {
        const glm::vec2 first = owenSobol2(std::uint32_t(i), own, 0), second = owenSobol2(std::uint32_t(i), own, 1);
        sum += m_question.integrand->sample(receiver, probe, {first.x, first.y, second.x, second.y});
    }
    return sum / m_sets.samples();
}

Reference::Estimate AoEstimator::at(const SurfacePoint& point, std::uint32_t seed) const {
    RayOrigin origin;
    const bool wholeRays =
        m_question.kind == TruthKind::T1 || m_question.kind == TruthKind::T3 || m_question.kind == TruthKind::T4;
    if (wholeRays) origin = m_rays.startAt(point.position, point.normal, point.triangle, nullptr);
    std::array<double, kScramblings> means{};
    for (int k = 0; k < kScramblings; ++k) {
        double& mean = means[std::size_t(k)];
        if (wholeRays)
            mean = openShare(point, origin, k, seed);
        else if (m_question.kind == TruthKind::T2)
            mean = fadedShare(point, k, seed);
        else if (m_question.kind == TruthKind::Own)
            mean = ownMean(point, k, seed);
        else
            mean = freeVolume(point, k, seed);
    }
    Reference::Estimate estimate = combine(means);
    // A technique's formula may leave the range that a visibility has; the technique then stops at its ends.
    estimate.mean = std::clamp(estimate.mean, 0.0, 1.0);
    return estimate;
}

}  // namespace ombrage
