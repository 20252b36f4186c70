// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/ao/blocks/blocks_params.h"

namespace ombrage::blocks {

/// What the technique claims (blocks.md): its formula with the mean over the kernel's distribution in place of the sum
/// over its samples, in a picture without pixels and without border.
std::unique_ptr<AoIntegrand> makeIntegrand(const BlocksParams& params);

}  // namespace ombrage::blocks
