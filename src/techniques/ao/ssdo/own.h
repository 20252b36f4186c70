// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/ssdo/ssdo_params.h"

namespace ombrage::ssdo {

/// What the technique claims (ssdo.md), with endlessly many samples, in a picture without pixels and without border.
std::unique_ptr<AoIntegrand> makeIntegrand(const SsdoParams& params);

}  // namespace ombrage::ssdo
