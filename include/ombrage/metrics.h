// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ombrage/image.h>
#include <ombrage/reference.h>

namespace ombrage {

/// World size of a technique's texels at a receiver, and how far its filter reaches. Used only to say how near to an
/// edge or a contact an error may lie (design section 7).
struct TexelFootprint {
    double texel_m = 0;              ///< sun: size of a texel; 0: the technique has no texels, pixels count instead
    double texelPerMetre = 0;        ///< point and spot: texel size per metre of distance from the light
    double kernelRadius_texels = 0;
};

/// Metric values by key; a missing value (std::nullopt) means that no pixel was valid, and gates nothing.
using Metrics = std::map<std::string, std::optional<double>>;

struct MetricInfo {
    std::string key;
    std::string unit;
    std::string help;         ///< one sentence, the definition
    bool lowerIsBetter = true;
};

/// Every metric that is measured, in the order of the report.
const std::vector<MetricInfo>& metricInfos();

/// Pixel class of an error, drawn in the class picture.
enum class ErrorClass : std::uint8_t { None, ContactGap, Alias, Penumbra, Acne, Other };

struct ShadowMeasurement {
    Metrics metrics;                       ///< mae rmse bias p95 psnr gain_db ssim wrong wrong_domain wrong_lit acne contact_gap ...
    std::vector<ErrorClass> classes;       ///< per pixel
    std::size_t validCount = 0;
};

/// Holds a visibility image (one plane, linear, same size) against the truth.
/// @param inDomain per pixel, whether the technique's declared domain covers it; empty: everywhere
ShadowMeasurement measureShadow(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
                                const TexelFootprint& footprint, const std::vector<bool>& inDomain = {});

Metrics measureAo(std::span<const float> visibility, const AoTruth& truth);

/// Mean structural similarity (Wang et al. 2004; 11x11 Gaussian, sigma 1.5, K1 = 0.01, K2 = 0.03, range 1) over the
/// windows whose centre is valid. `mask` may be empty.
std::optional<double> ssim(std::span<const float> a, std::span<const float> b, int width, int height, const std::vector<Mask>& mask);

/// LDR-FLIP (Andersson et al. 2020) of two sRGB or linear RGB images of one size: per-pixel error in [0,1].
/// @param pixelsPerDegree 67 by default: 0.7 m from a 0.7 m wide 3840 pixel screen
Image flip(const Image& reference, const Image& test, double pixelsPerDegree = 67.0206);

struct DiffResult {
    std::string metric;
    std::optional<double> value;   ///< null: psnr of equal images
    bool exact = false;            ///< every value is equal
    double p95 = 0, max = 0;
    Image map;                     ///< per-pixel error, one plane
};

/// Compares two images: metric is flip, rmse, mae, psnr or ssim. @throws Error(Usage) for sizes or planes that differ.
DiffResult diffImages(const Image& a, const Image& b, const std::string& metric);

/// Colours of an error map: magma, t in [0,1] to sRGB.
void magma(float t, float rgb[3]);

}  // namespace ombrage
