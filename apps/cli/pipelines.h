// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/renderer.h>

namespace ombrage::cli {

class Options;

/// Fills the pipelines of the settings from --shadow, --ao, --filter, --indirect, --aa and --set.
/// @throws Error(Usage) with a suggestion for every unknown name.
void setPipelines(const Options& options, RenderSettings& settings);

}  // namespace ombrage::cli
