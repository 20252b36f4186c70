// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/ao_integrand.h>
#include <ombrage/image.h>
#include <ombrage/scene.h>
#include <ombrage/truth_kind.h>

namespace ombrage {

/// The ray-traced truth of a scene, made on the CPU (Embree, robust mode). It knows nothing of techniques or OpenGL.
/// Same scene, options and seed give the same bits, whatever the thread count.

/// Called with the share done in [0,1]; returning false stops the work with Error(Interrupted).
using Progress = std::function<bool(double)>;

struct ReferenceOptions {
    int width = 640;
    int height = 360;
    int samplesPerPixel = 0;  ///< per receiver; 0: 1 for hard lights, 1024 for soft ones, 256 for ao. Rounded up to
                              ///< a multiple of kScramblings.
    std::uint64_t seed = 1;
    int threads = 0;                         ///< 0: all
    std::optional<TruthKind> kind;           ///< nothing: the quantity's first
    const AoIntegrand* integrand = nullptr;  ///< of TruthKind::Own; must outlive the call
    glm::dvec2 pixelPoint{0.5, 0.5};         ///< where in its pixel a receiver lies, (0,0) the top left corner
    Progress progress;
};

/// Independent scramblings of the Sobol points, from which standard errors come.
inline constexpr int kScramblings = 8;

/// TruthKind::Area looks at the centres of kAreaGrid x kAreaGrid equal parts of each pixel: those of the pixels of a
/// picture that is so many times wider and higher.
inline constexpr int kAreaGrid = 4;

/// Receiver of one pixel: the primary hit through the pixel centre (or ReferenceOptions::pixelPoint).
struct Receivers {
    int width = 0, height = 0;
    std::vector<std::uint32_t> instance;   ///< index into Scene::instances, kNoHit for sky
    std::vector<std::uint32_t> triangle;   ///< index over all triangles of all instances in order, kNoHit for sky
    std::vector<glm::vec2> barycentric;    ///< weights of the second and third vertex
    std::vector<glm::vec3> normal;         ///< n_g, unit, on the side seen
    std::vector<glm::vec3> shadingNormal;  ///< interpolated n_s, unit, on the side of n_g
    std::vector<float> distance_m;         ///< along the primary ray
    std::vector<float> pixelSize_m;        ///< world size of one pixel there
};

inline constexpr std::uint32_t kNoHit = 0xffffffffu;

/// Why a pixel is not measured.
enum class Mask : std::uint8_t { Valid = 0, Sky = 1, BelowHorizon = 2, NotReceiving = 3, OutOfRange = 4, Disagree = 5 };

/// Truth of one light's visibility. All arrays are width*height, row 0 at the top.
struct ShadowTruth {
    int width = 0, height = 0;
    int samplesPerPixel = 0;
    bool soft = false;                   ///< the light has a size
    std::vector<float> visibility;       ///< v*: share of the light seen
    std::vector<float> standardError;    ///< of v*, from the scramblings; 0 for hard lights
    std::vector<float> irradianceShare;  ///< the irradiance-weighted share
    std::vector<float> irradiance;       ///< unshadowed irradiance (luminance), the weight of wrong_lit
    std::vector<float> cosine;           ///< n_g . l to the light's centre
    std::vector<float> lightDistance_m;  ///< to the light's centre; +inf for suns
    std::vector<std::uint8_t>
        centreSeen;  ///< of a soft light: 1 where its centre is above the horizon and free, else
                     ///< and where the mask is not Valid 0. Empty for hard ones: visibility says it
    std::vector<Mask> mask;
    double meanStandardError = 0;  ///< over valid pixels
    double maskedShare = 0;        ///< of all pixels that are not sky
};

/// What a picture of the scene taken from the light would show around one pixel's point, at the height of the point's
/// own surface: whether some of it is lit, and whether other surfaces shade some of it. Both: a shadow's edge passes
/// there.
struct LightSurroundings {
    bool lit = false, shaded = false;
    bool ownCasts = false;  ///< the point's own surface is among those that shade this light
};

/// What stands nearest to a point on the way from it to a light's centre.
struct Blocker {
    float distance_m = std::numeric_limits<float>::infinity();  ///< from the point
    std::uint32_t instance = kNoHit;                            ///< kNoHit where nothing is
};

/// What error classes ask of the truth beside ShadowTruth. The fields without rays are there; what costs rays is asked
/// for the pixels where it matters. Pixels are indices of receivers that are not sky.
struct ShadowFeatures {
    std::vector<float> shadingCosine;  ///< n_s . l to the light's centre; 0 for sky

    /// The nearest blocker of each pixel's point, whether it is above the light's horizon or not.
    std::function<std::vector<Blocker>(const std::vector<std::uint32_t>& pixels)> blockers;

    /// Looks at 16 rays to the light through a disk of `reach_m` about each pixel's ray. The point's own surface goes
    /// on as its tangent plane; walls that rise from it in a crease, and what lies lower than twice the reach, are part
    /// of it.
    std::function<std::vector<LightSurroundings>(const std::vector<std::uint32_t>& pixels,
                                                 const std::vector<float>& reach_m)>
        surroundings;

    /// Bodies between the point and the light's centre: surfaces that the ray meets on their front or on their back,
    /// whichever are more.
    std::function<std::vector<int>(const std::vector<std::uint32_t>& pixels)> layers;
};

/// Truth of ambient visibility, of the kind asked for; `radius_m` is the scene's (+inf for T4).
struct AoTruth {
    int width = 0, height = 0;
    int samplesPerPixel = 0;
    float radius_m = 0;
    std::vector<float> visibility;
    std::vector<float> standardError;
    std::vector<Mask> mask;
    double meanStandardError = 0;
    double maskedShare = 0;
};

/// The scene's triangles in a ray-tracing structure. Immutable after construction; safe to use from several threads.
class Reference {
public:
    /// The scene must outlive the reference. @throws Error(Environment) when Embree cannot start.
    explicit Reference(const Scene& scene);
    ~Reference();
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    Receivers receivers(const Camera& camera, const ReferenceOptions& options) const;

    /// @throws Error(Usage) for a kind that is not a kind of shadows, and for Area, which needs receivers of its own.
    ShadowTruth shadow(const Receivers& receivers, const Camera& camera, int light,
                       const ReferenceOptions& options) const;

    /// Of a light that shadow() was asked about with the same options. The reference, its scene and the receivers must
    /// outlive the result. @throws Error(Usage) as shadow().
    ShadowFeatures shadowFeatures(const Receivers& receivers, int light, const ReferenceOptions& options) const;

    /// World positions of the receivers, (0,0,0) for sky.
    std::vector<glm::dvec3> positions(const Receivers& receivers) const;

    /// @throws Error(Usage) for a kind that is not a kind of ambient occlusion, for Area, and for Own without
    /// integrand.
    AoTruth ao(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const;

    /// Called with the number of a point of the pixel (row by row of the grid) and what is seen there.
    using AreaShadowPart = std::function<void(int part, const ShadowTruth& truth)>;
    using AreaAoPart = std::function<void(int part, const AoTruth& truth)>;

    /// TruthKind::Area: visibility, irradianceShare and standardError are means over the points that are Valid, and a
    /// pixel is Valid where at least half of its points are. All else is that of the pixel's centre. Each point takes
    /// its share of options.samplesPerPixel.
    ShadowTruth areaShadow(const Camera& camera, int light, const ReferenceOptions& options,
                           const AreaShadowPart& part = {}) const;
    AoTruth areaAo(const Camera& camera, const ReferenceOptions& options, const AreaAoPart& part = {}) const;
    Image areaPicture(const Camera& camera, const ReferenceOptions& options) const;

    /// Direct light of all lights with the truth's visibility plus ambient times AO: linear RGB, Lambert surfaces with
    /// their textures, for looking at.
    Image picture(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const;

    /// One diffuse bounce: linear RGB radiance that leaves Lambert surfaces with their textures after light went from
    /// the lights (their centres) to another surface and from there to this one. 256 samples where none are asked for.
    Image indirect(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const;

    /// T1 to T5 (T1 with an infinite radius is T4) at one free point, for closed-form tests: mean and standard error.
    struct Estimate {
        double mean = 0, standardError = 0;
    };
    Estimate aoAt(const glm::dvec3& point, const glm::dvec3& normal, double radius_m, int samples, std::uint64_t seed,
                  TruthKind kind = TruthKind::T1) const;
    Estimate shadowAt(const glm::dvec3& point, const glm::dvec3& normal, int light, int samples,
                      std::uint64_t seed) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Marks valid pixels whose triangle differs from what the rasteriser saw as Mask::Disagree and updates maskedShare.
/// @param instance, triangle as in Receivers, read back from a G-buffer of the same size; without triangles the instances alone must agree.
void maskDisagreement(std::vector<Mask>& mask, double& maskedShare, const Receivers& receivers,
                      const std::vector<std::uint32_t>& instance, const std::vector<std::uint32_t>& triangle);

}  // namespace ombrage
