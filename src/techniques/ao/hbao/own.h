// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/hbao/hbao_params.h"

namespace ombrage::hbao {

/// What the technique claims (hbao.md): the attenuated horizon of every direction about the line of sight, found by 24
/// steps moved at random, in a picture without pixels and border.
std::unique_ptr<AoIntegrand> makeIntegrand(const HbaoParams& params);

}  // namespace ombrage::hbao
