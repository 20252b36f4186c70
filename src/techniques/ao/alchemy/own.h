// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/alchemy/alchemy_params.h"

namespace ombrage::alchemy {

/// What the technique claims (alchemy.md): the mean of equation 10 over the disk in place of the sum, in a picture
/// without pixels and border. `bias` hides the rounding of depths and is no part of it.
std::unique_ptr<AoIntegrand> makeIntegrand(const AlchemyParams& params);

}  // namespace ombrage::alchemy
