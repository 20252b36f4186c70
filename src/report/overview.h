// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/record_groups.h"

namespace ombrage {

/// For each family that was held against one kind of truth in several places: a table of mean error and cost with a
/// column per place. "" where every family was measured in one place.
std::string overview(const std::vector<RecordGroup>& groups);

}  // namespace ombrage
