// SPDX-License-Identifier: MIT
#include <ombrage/metrics.h>

namespace ombrage {

const std::vector<MetricInfo>& metricInfos() {
    static const std::vector<MetricInfo> infos = {
        {"mae", "", "Mean absolute error of the visibility over the valid pixels."},
        {"rmse", "", "Root of the mean square error of the visibility over the valid pixels."},
        {"bias", "", "Mean error of the visibility: above 0 too light, below 0 too dark; its distance from 0 counts."},
        {"p95", "", "95th percentile of the absolute error of the visibility."},
        {"psnr", "dB", "Peak signal-to-noise ratio of the visibility with peak 1; stops at 99 dB.", false},
        {"gain_db", "dB", "psnr minus that of the best constant picture, the mean of the truth.", false},
        {"ssim", "",
         "Mean structural similarity (Wang et al. 2004) of the visibility, windows centred on valid pixels.", false},
        {"wrong", "share",
         "Share of the valid pixels with an absolute error over 0.5, without those whose n_g.l is below 0.02."},
        {"wrong_domain", "share", "The same within the technique's declared domain."},
        {"wrong_lit", "share", "The same, each pixel weighted by its unshadowed irradiance."},
        {"over", "share",
         "Share of the valid pixels with an absolute error over the tolerance (0.1 for hard lights, 0.05 for soft "
         "ones) plus "
         "three standard errors of the truth."},
        {"contact_gap", "share",
         "Share of the valid pixels that are over, too light, in true umbra and nearer to their blocker than four "
         "texels (four "
         "pixels for techniques without texels)."},
        {"alias", "share",
         "Share of the valid pixels that are over, of no class before, and within 2 pixels or the projected texel "
         "times one "
         "plus the kernel's radius of a true hard edge."},
        {"penumbra", "share",
         "Share of the valid pixels that are over, of no class before, and in a soft light's true penumbra."},
        {"acne", "share",
         "Share of the valid pixels that are over, of no class before, too dark and in full light in truth."},
        {"other", "share", "Share of the valid pixels that are over and of no class before."},
        {"leak_mass", "", "Mean visibility over the true umbra more than 4 pixels inside its edge."},
        {"flip", "", "Mean LDR-FLIP (Andersson et al. 2020) of the final sRGB picture at 67 pixels per degree."},
    };
    return infos;
}

}  // namespace ombrage
