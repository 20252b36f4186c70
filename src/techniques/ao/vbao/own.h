// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/vbao/vbao_params.h"

namespace ombrage::vbao {

/// What the technique claims (vbao.md): the share of directions that nothing seen within the radius covers from its
/// front to `thickness` behind it, of all slices, all points of them and endlessly fine sectors (here 256 on each
/// side), in a picture without pixels and without border.
std::unique_ptr<AoIntegrand> makeIntegrand(const VbaoParams& params);

}  // namespace ombrage::vbao
