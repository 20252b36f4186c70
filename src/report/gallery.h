// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/previews.h"
#include "report/record_groups.h"

namespace ombrage {

/// Folded away: every picture of the group. The comparison takes its pictures from here, so that each stands in the
/// file once.
std::string gallery(const Previews& previews, const RecordGroup& group);

}  // namespace ombrage
