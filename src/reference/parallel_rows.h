// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <ombrage/reference.h>

namespace ombrage {

/// Calls `row(y)` for every y in [0, height) on options.threads threads. Calls the progress, one call at a time and
/// with rising shares; stops early when it returns false. @throws Error(Interrupted) then.
void parallelRows(int height, const ReferenceOptions& options, const std::function<void(int)>& row);

}  // namespace ombrage
