// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/starcraft2/starcraft2_params.h"

namespace ombrage::starcraft2 {

/// What the technique claims (starcraft2.md), with endlessly many samples, in a picture without pixels and without
/// border.
std::unique_ptr<AoIntegrand> makeIntegrand(const Starcraft2Params& params);

}  // namespace ombrage::starcraft2
