// SPDX-License-Identifier: MIT
#include "techniques/shared/edge_stop_params.h"

namespace ombrage {

ParamTable edgeStopTable(std::vector<ParamField> own) {
    using P = EdgeStopParams;
    own.push_back(field(&P::planeTolerance_px, "plane-tolerance", Unit::Pixel)
                      .range(0.01, 1000, Scale::Log)
                      .tune(0.1, 20)
                      .help("Distance from the tangent plane at which a neighbour's weight has fallen by exp(-1/2), "
                            "in sizes of a pixel at the surface: larger lets light and shade bleed over steps, "
                            "smaller leaves noise on curved surfaces."));
    own.push_back(field(&P::normalPower, "normal-power")
                      .range(0, 256)
                      .tune(0, 64)
                      .help("Exponent of the cosine between the shading normals: higher keeps creases and bumps "
                            "apart, 0 ignores normals."));
    return ParamTable(std::move(own));
}

ParamTable BilateralParams::describe() {
    using P = BilateralParams;
    return edgeStopTable(
        {field(&P::radius_px, "radius", Unit::Pixel)
             .range(0, 32)
             .tune(1, 12)
             .help("Neighbours taken on each side: more remove more noise and cost more; 0 changes nothing."),
         field(&P::sigma_px, "sigma", Unit::Pixel)
             .range(0.25, 32, Scale::Log)
             .tune(1, 8)
             .help("Standard deviation of the Gaussian over the picture: larger is smoother, and blurs "
                   "contacts.")});
}

}  // namespace ombrage
