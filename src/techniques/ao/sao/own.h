// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/sao/sao_params.h"

namespace ombrage::sao {

/// What the technique claims (sao.md): the mean of its term over the spiral's density, even in radius and angle, in
/// place of the sum, in a picture without pixels and border.
std::unique_ptr<AoIntegrand> makeIntegrand(const SaoParams& params);

}  // namespace ombrage::sao
