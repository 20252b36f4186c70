// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/volumetric/volumetric_params.h"

namespace ombrage::volumetric {

/// What the technique claims (volumetric.md), with endlessly many samples, in a picture without pixels and without
/// border.
std::unique_ptr<AoIntegrand> makeIntegrand(const VolumetricParams& params);

}  // namespace ombrage::volumetric
