// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/ao_integrand.h>
#include <glm/glm.hpp>

namespace ombrage {

/// shared/obscurance.glsl for integrands: (v.n - bias) / (v.v + epsilon^2), never below 0, of a surface at `v` from the
/// receiver, with the lower of its heights over the planes of n_s and n_g.
double obscuranceFrom(const AoReceiver& receiver, const glm::dvec3& v, double bias_m, double epsilon_m);

}  // namespace ombrage
