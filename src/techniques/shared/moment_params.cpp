// SPDX-License-Identifier: MIT
#include "techniques/shared/moment_params.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

ParamTable momentTable(const std::vector<ParamField>& own, const MomentMapParams& defaults) {
    using P = MomentMapParams;
    std::vector<ParamField> all = {
        field(&P::kernel_texels, "kernel", Unit::Texel)
            .range(1, 31)
            .tune(1, 15)
            .effect(ParamEffect::Host)
            .help("Width of the blur over the map: wider, softer edges and more light through overlapping casters."),
        field(&P::blur, "blur").effect(ParamEffect::Host).help("Shape of the blur."),
        field(&P::mipmaps, "mipmaps")
            .effect(ParamEffect::Define)
            .help("Averages the map over the pixel's footprint where that is wider than the blur."),
        field(&P::anisotropy, "anisotropy")
            .range(1, 16)
            .tune(1, 16)
            .help("Most places that are averaged along a footprint that is longer than wide; needs mipmaps."),
        field(&P::crease, "crease")
            .range(0, 64)
            .tune(0, 16)
            .help("Steepest corner of two surfaces, height over width, that does not darken itself: higher, less acne "
                  "where walls meet; lower, less light at contacts."),
        field(&P::bleeding, "bleeding")
            .range(0, 0.99)
            .tune(0, 0.6)
            .help("Visibility up to which a point counts as in shadow; what is above is stretched: less light through "
                  "overlapping casters, harder and wider shadows.")};
    for (ParamField& shared : all) shared.info.defaultValue = shared.get(&defaults);
    all.insert(all.end(), own.begin(), own.end());
    return mapTable(all);
}

ParamTable varianceTable(std::vector<ParamField> own, const VarianceMapParams& defaults) {
    own.push_back(field(&VarianceMapParams::minDeviation_texels, "min-deviation", Unit::Texel)
                      .range(0, 8)
                      .tune(0, 2)
                      .help("Least standard deviation of depth that is believed, for each unit of slope: more, less "
                            "acne and more light at contacts."));
    own.back().info.defaultValue = own.back().get(&defaults);
    return momentTable(own, defaults);
}

std::vector<float> momentBlurWeights(MomentBlur blur, int width_texels) {
    const double half = 0.5 * width_texels;
    const int radius = width_texels / 2;
    // Two standard deviations on either side.
    const double scale = 1 / (std::sqrt(2.0) * 0.25 * width_texels);
    const auto integral = [&](double x) { return blur == MomentBlur::Gauss ? std::erf(x * scale) : x; };
    std::vector<double> shares;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        shares.push_back(integral(std::min(i + 0.5, half)) - integral(std::max(i - 0.5, -half)));
        sum += i == 0 ? shares.back() : 2 * shares.back();
    }
    std::vector<float> weights;
    for (double share : shares) weights.push_back(float(share / sum));
    return weights;
}

float momentBlurVariance(const std::vector<float>& weights) {
    float variance = 0;
    for (std::size_t i = 1; i < weights.size(); ++i) variance += 2 * weights[i] * float(i * i);
    return variance;
}

}  // namespace ombrage
