// SPDX-License-Identifier: MIT
#pragma once

#include "options.h"

namespace ombrage::cli {

/// `bench --program`: each technique on each scene in a process of its own, so that none counts what another left
/// behind.
int runWholeProgram(const Options& options);

}  // namespace ombrage::cli
