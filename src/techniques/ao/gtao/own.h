// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/gtao/gtao_params.h"

namespace ombrage::gtao {

/// What the technique claims (gtao.md): the integral between the horizons of all slices, each from all of its side's
/// points, in a picture without pixels and without border, and without what `multi-bounce` makes of it.
std::unique_ptr<AoIntegrand> makeIntegrand(const GtaoParams& params);

}  // namespace ombrage::gtao
