// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
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
    double texel_m = 0;        ///< sun: size of a texel; 0: the technique has no texels, pixels count instead
    double texelPerMetre = 0;  ///< point and spot: texel size per metre of distance from the light
    double kernelRadius_texels = 0;
};

/// Where a technique has data at all. Points outside every one of the views, or farther from the camera, it cannot tell
/// from lit ones. The default covers everything.
struct ShadowRange {
    std::vector<glm::dmat4> clipFromWorld;  ///< covers abs(x) <= w and abs(y) <= w where w > 0; none: everywhere
    double farthest_m = std::numeric_limits<double>::infinity();  ///< along the camera's axis
};

/// Per pixel, whether the range covers its point. @param positions_world of the receivers (Reference::positions)
std::vector<bool> inRange(const ShadowRange& range, const std::vector<glm::dvec3>& positions_world,
                          const Camera& camera);

/// Metric values by key; a missing value (std::nullopt) means that no pixel was valid, and gates nothing.
using Metrics = std::map<std::string, std::optional<double>>;

struct MetricInfo {
    std::string key;
    std::string unit;
    std::string help;  ///< one sentence, the definition
    bool lowerIsBetter = true;
    bool ofPoints = false;  ///< asks about points: has no meaning against means over pixels (TruthKind::Area)
    bool ofMotion = false;  ///< measured under a motion script, where nothing else is
};

/// Every metric that is measured, in the order of the report.
const std::vector<MetricInfo>& metricInfos();

/// Why a pixel is wrong, in the order in which they are tried (docs/user/metrics.md).
enum class ErrorClass : std::uint8_t {
    None,
    Missing,
    ContactGap,
    Alias,
    OverBlur,
    UnderBlur,
    Acne,
    Leak,
    FalseShadow,
    Other
};
inline constexpr std::size_t kErrorClassCount = 10;

/// Its metric key, "contact_gap"; "right" of None.
const char* errorClassKey(ErrorClass errorClass);

/// What the measurement must know beside the picture and its truth.
struct ShadowQuestion {
    TexelFootprint footprint;
    std::vector<bool> inDomain;  ///< per pixel, whether the technique's declared domain covers it; empty: everywhere
    std::vector<bool> inRange;   ///< per pixel, whether the technique's range covers it; empty: everywhere
    /// Without it neither contact gaps nor shadow edges that lie on another surface are found, and `terminator` and
    /// `leak_layered` are null.
    const ShadowFeatures* features = nullptr;
};

struct ShadowMeasurement {
    Metrics metrics;                  ///< every key of metricInfos() but flip, noise, residual and those of motion
    std::vector<ErrorClass> classes;  ///< per pixel
    std::array<std::size_t, kErrorClassCount> classCounts{};  ///< of the valid pixels; None: those that are not over
    std::size_t validCount = 0;
};

/// Holds a visibility image (one plane, linear, same size) against the truth.
ShadowMeasurement measureShadow(std::span<const float> visibility, const ShadowTruth& truth, const Receivers& receivers,
                                const ShadowQuestion& question = {});

/// Least number of seeds that noiseOf() is asked with.
inline constexpr int kNoiseSeeds = 8;

/// Root of the mean over the valid pixels of the variance among pictures made with different seeds; null where no pixel
/// is valid. @throws Error(Usage) for fewer than two pictures or sizes that differ.
std::optional<double> noiseOf(const std::vector<std::vector<float>>& pictures, const std::vector<Mask>& mask);

/// What a picture has of its own where the truth is flat: the root mean square of what is left of it without its median
/// over 15x15 pixels, over the pixels whose window is valid and the truth's standard deviation there at most 0.02 and
/// its standard error; null where none is.
std::optional<double> residual(std::span<const float> visibility, const AoTruth& truth);

/// Every key of metricInfos() that concerns occlusion but flip, noise and those of motion.
Metrics measureAo(std::span<const float> visibility, const AoTruth& truth);

/// Mean structural similarity (Wang et al. 2004; 11x11 Gaussian, sigma 1.5, K1 = 0.01, K2 = 0.03, range 1) over the
/// windows whose centre is valid. `mask` may be empty.
std::optional<double> ssim(std::span<const float> a, std::span<const float> b, int width, int height,
                           const std::vector<Mask>& mask);

/// LDR-FLIP (Andersson et al. 2020) of two sRGB or linear RGB images of one size: per-pixel error in [0,1].
/// @param pixelsPerDegree 67 by default: 0.7 m from a 0.7 m wide 3840 pixel screen
Image flip(const Image& reference, const Image& test, double pixelsPerDegree = 67.0206);

struct DiffResult {
    std::string metric;
    std::optional<double> value;  ///< null: psnr of equal images
    bool exact = false;           ///< every value is equal
    double p95 = 0, max = 0;
    Image map;  ///< per-pixel error, one plane
};

/// Compares two images: metric is flip, rmse, mae, psnr or ssim. @throws Error(Usage) for sizes or planes that differ.
DiffResult diffImages(const Image& a, const Image& b, const std::string& metric);

/// Colours of an error map: magma, t in [0,1] to sRGB.
void magma(float t, float rgb[3]);

}  // namespace ombrage
