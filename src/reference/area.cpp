// SPDX-License-Identifier: MIT
// TruthKind::Area: the truth averaged over points of each pixel, for pictures that are anti-aliased.
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>

#include "reference/reference_impl.h"

namespace ombrage {
namespace {

constexpr int kParts = kAreaGrid * kAreaGrid;

/// Options of one point of the pixel: its place, its share of the samples, its own seed and its part of the progress.
ReferenceOptions partOptions(const ReferenceOptions& options, int part) {
    ReferenceOptions made = options;
    made.kind = std::nullopt;
    made.pixelPoint = {(part % kAreaGrid + 0.5) / kAreaGrid, (part / kAreaGrid + 0.5) / kAreaGrid};
    made.seed = std::uint64_t(hashCombine(std::uint32_t(options.seed), std::uint32_t(part))) << 32 | options.seed >> 32;
    if (options.progress)
        made.progress = [&options, part](double share) { return options.progress((part + share) / kParts); };
    return made;
}

int samplesOfPart(int samples, int fallback) {
    return ((samples > 0 ? samples : fallback) + kParts - 1) / kParts;
}

/// Means over the points of each pixel that are valid.
class PixelMeans {
public:
    explicit PixelMeans(std::size_t count) : m_sums(count), m_squares(count), m_counts(count) {}

    void add(const std::vector<float>& values, const std::vector<float>& errors, const std::vector<Mask>& mask) {
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (mask[i] != Mask::Valid) continue;
            m_sums[i] += double(values[i]);
            m_squares[i] += double(errors[i]) * double(errors[i]);
            ++m_counts[i];
        }
    }

    /// At least half of the points.
    bool isValid(std::size_t i) const { return 2 * m_counts[i] >= kParts; }
    float mean(std::size_t i) const { return float(m_sums[i] / m_counts[i]); }
    float error(std::size_t i) const { return float(std::sqrt(m_squares[i]) / m_counts[i]); }

private:
    std::vector<double> m_sums, m_squares;
    std::vector<int> m_counts;
};

/// The pixel's own mask where it is measured by its points, and a reason where it is not.
void settleMask(std::vector<Mask>& mask, const PixelMeans& means) {
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (means.isValid(i))
            mask[i] = Mask::Valid;
        else if (mask[i] == Mask::Valid)
            mask[i] = Mask::Sky;
    }
}

void checkArea(const ReferenceOptions& options) {
    if (options.kind && *options.kind != TruthKind::Area)
        throw Error(ErrorCode::Usage,
                    std::string("the truth '") + truthKindName(*options.kind) + "' is not averaged over the pixel",
                    "Use 'area'.");
    if (options.samplesPerPixel < 0) samplesPerScrambling(options.samplesPerPixel, 1);
}

}  // namespace

ShadowTruth Reference::areaShadow(const Camera& camera, int light, const ReferenceOptions& options,
                                  const AreaShadowPart& part) const {
    checkArea(options);
    // The pixel's centre tells everything but the visibility.
    ReferenceOptions centre = options;
    centre.kind = std::nullopt;
    centre.progress = nullptr;
    centre.samplesPerPixel = kScramblings;
    ShadowTruth truth = shadow(receivers(camera, centre), camera, light, centre);

    PixelMeans visibility(truth.mask.size()), irradiance(truth.mask.size());
    int samples = 0;
    for (int p = 0; p < kParts; ++p) {
        ReferenceOptions one = partOptions(options, p);
        one.samplesPerPixel = samplesOfPart(options.samplesPerPixel, kSoftSamples);
        const ShadowTruth seen = shadow(receivers(camera, one), camera, light, one);
        visibility.add(seen.visibility, seen.standardError, seen.mask);
        irradiance.add(seen.irradianceShare, seen.standardError, seen.mask);
        samples += seen.samplesPerPixel;
        if (part) part(p, seen);
    }
    for (std::size_t i = 0; i < truth.mask.size(); ++i) {
        if (!visibility.isValid(i)) continue;
        truth.visibility[i] = visibility.mean(i);
        truth.standardError[i] = visibility.error(i);
        truth.irradianceShare[i] = irradiance.mean(i);
    }
    settleMask(truth.mask, visibility);
    truth.samplesPerPixel = samples;
    summarise(truth.mask, truth.standardError, truth.meanStandardError, truth.maskedShare);
    return truth;
}

AoTruth Reference::areaAo(const Camera& camera, const ReferenceOptions& options, const AreaAoPart& part) const {
    checkArea(options);
    AoTruth truth;
    PixelMeans visibility(std::size_t(options.width) * std::size_t(options.height));
    int samples = 0;
    for (int p = 0; p < kParts; ++p) {
        ReferenceOptions one = partOptions(options, p);
        one.samplesPerPixel = samplesOfPart(options.samplesPerPixel, kAoSamples);
        const AoTruth seen = ao(receivers(camera, one), camera, one);
        visibility.add(seen.visibility, seen.standardError, seen.mask);
        samples += seen.samplesPerPixel;
        // The point next to the pixel's centre tells why a pixel is not measured.
        if (p == kParts / 2 + kAreaGrid / 2) truth = seen;
        if (part) part(p, seen);
    }
    for (std::size_t i = 0; i < truth.mask.size(); ++i) {
        if (!visibility.isValid(i)) continue;
        truth.visibility[i] = visibility.mean(i);
        truth.standardError[i] = visibility.error(i);
    }
    settleMask(truth.mask, visibility);
    truth.samplesPerPixel = samples;
    summarise(truth.mask, truth.standardError, truth.meanStandardError, truth.maskedShare);
    return truth;
}

Image Reference::areaPicture(const Camera& camera, const ReferenceOptions& options) const {
    checkArea(options);
    Image sum;
    for (int p = 0; p < kParts; ++p) {
        ReferenceOptions one = partOptions(options, p);
        one.samplesPerPixel = samplesOfPart(options.samplesPerPixel, kAoSamples);
        const Image seen = picture(receivers(camera, one), camera, one);
        if (p == 0) sum = Image::rgb(seen.width(), seen.height());
        for (int c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < seen.pixelCount(); ++i) sum.plane(c)[i] += seen.plane(c)[i] / float(kParts);
    }
    return sum;
}

}  // namespace ombrage
