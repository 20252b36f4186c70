// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/crytek/crytek_params.h"

namespace ombrage::crytek {

/// What the technique claims (crytek.md), with endlessly many samples, in a picture without pixels and without border.
std::unique_ptr<AoIntegrand> makeIntegrand(const CrytekParams& params);

}  // namespace ombrage::crytek
