// SPDX-License-Identifier: MIT
#include <ombrage/metrics.h>

namespace ombrage {

const std::vector<MetricInfo>& metricInfos() {
    constexpr bool kHigher = false, kLower = true, kOfPoints = true, kOfMotion = true;
    static const std::vector<MetricInfo> infos = {
        {"mae", "", "Mean absolute error of the visibility over the valid pixels."},
        {"rmse", "", "Root of the mean square error of the visibility over the valid pixels."},
        {"bias", "", "Mean error of the visibility: above 0 too light, below 0 too dark; its distance from 0 counts."},
        {"p95", "", "95th percentile of the absolute error of the visibility."},
        {"psnr", "dB", "Peak signal-to-noise ratio of the visibility with peak 1; stops at 99 dB.", kHigher},
        {"gain_db", "dB", "psnr minus that of the best constant picture, the mean of the truth.", kHigher},
        {"ssim", "",
         "Mean structural similarity (Wang et al. 2004) of the visibility, windows centred on valid pixels.", kHigher},
        {"wrong", "share",
         "Share of the valid pixels with an absolute error over 0.5, without those whose n_g.l is below 0.02."},
        {"wrong_domain", "share", "The same within the technique's declared domain and range."},
        {"wrong_lit", "share", "The same, each pixel weighted by its unshadowed irradiance."},
        {"rmse_lit", "", "rmse with each pixel weighted by its unshadowed irradiance: what the eye can see."},
        {"rmse_penumbra", "",
         "rmse over a soft light's true penumbra and 4 pixels around it; null where there is none.", kLower, kOfPoints},
        {"hard_ratio", "",
         "rmse_penumbra over that of a plain hard shadow, the truth's own visibility of the light's centre: below 1 "
         "the "
         "penumbra is worth its cost.",
         kLower, kOfPoints},
        {"over", "share",
         "Share of the valid pixels with an absolute error over the tolerance (0.1 for hard lights, 0.05 for soft "
         "ones) plus three standard errors of the truth. The classes from missing to other partition it.",
         kLower, kOfPoints},
        {"missing", "share", "Of over: outside the technique's range, such as its last cascade.", kLower, kOfPoints},
        {"contact_gap", "share",
         "Of over, of no class before: too light in true umbra, nearer to the blocker than four texels (four pixels "
         "for "
         "techniques without texels).",
         kLower, kOfPoints},
        {"alias", "share",
         "Of over, of no class before: within 2 pixels or the projected texel times one plus the kernel's radius of a "
         "true hard edge, be it seen in the picture or in the light's own view of the point.",
         kLower, kOfPoints},
        {"penumbra", "share",
         "Of over, of no class before: in a soft light's true penumbra or within 4 pixels of it; the sum of over_blur "
         "and under_blur.",
         kLower, kOfPoints},
        {"over_blur", "share", "Of penumbra: nearer to one half than the truth, the transition is too wide.", kLower,
         kOfPoints},
        {"under_blur", "share",
         "Of penumbra: farther from one half than the truth, the transition is too narrow or in another place.", kLower,
         kOfPoints},
        {"acne", "share",
         "Of over, of no class before: too dark in full light, the technique has texels, and within their reach the "
         "point's own surface alone can be what it took for a blocker.",
         kLower, kOfPoints},
        {"leak", "share", "Of over, of no class before: too light in true umbra.", kLower, kOfPoints},
        {"leak_layered", "share",
         "Of leak: two or more bodies lie between the point and the light, which one depth or its moments cannot hold.",
         kLower, kOfPoints},
        {"false_shadow", "share", "Of over, of no class before: too dark in full light.", kLower, kOfPoints},
        {"other", "share", "Of over: of no class before.", kLower, kOfPoints},
        {"leak_mass", "", "Mean visibility over the true umbra more than 4 pixels inside its edge.", kLower, kOfPoints},
        {"edge_px", "px",
         "Mean displacement of the true hard edges: the area between them and the picture's, within the reach of "
         "alias, "
         "over their length.",
         kLower, kOfPoints},
        {"terminator", "share",
         "Share of the receiving pixels that shading takes for lit (n_s.l above 0) and geometry for turned away (n_g.l "
         "at most 0): a trait of the scene, the same for every technique.",
         kLower, kOfPoints},
        {"noise", "",
         "Root of the mean variance of the visibility among 8 seeds over the valid pixels; 0 for a technique that uses "
         "no random numbers."},
        {"residual", "",
         "Root mean square of the visibility without its median over 15x15 pixels, where the truth is flat: grain, "
         "bands and patterns of one picture that a filter has left."},
        {"flip", "", "Mean LDR-FLIP (Andersson et al. 2020) of the final sRGB picture at 67 pixels per degree."},
        {"flicker_mean", "",
         "Under a motion script: mean change of the error from frame to frame at the surface points that the first "
         "frame sees.",
         kLower, kOfPoints, kOfMotion},
        {"flicker_p99", "", "99th percentile of the same change.", kLower, kOfPoints, kOfMotion},
        {"flicker_patch", "px",
         "Pixels of the largest patch, connected by edges or corners, whose error changes by more than the tolerance "
         "(0.1 for hard lights, 0.05 else) from one frame to the next.",
         kLower, kOfPoints, kOfMotion},
        {"lag", "frames",
         "After a light or caster jumped: frames until 99 of 100 of the points whose truth the jump changed stay "
         "within "
         "the tolerance of what the technique shows where the jump had always happened; 0: in the frame of the jump. "
         "Null in scripts without a jump.",
         kLower, kOfPoints, kOfMotion},
    };
    return infos;
}

}  // namespace ombrage
