// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "lab/run_record.h"

namespace ombrage {

/// Keys of the metrics that the tables of a family show; the details hold all of them.
const std::vector<std::string>& metricColumns(const RunRecord& record);

/// A sortable table with one row per record; the best value of every column is marked.
std::string recordTable(const std::vector<const RunRecord*>& group);

/// Folded away: every metric, pass and parameter of every record.
std::string recordDetails(const std::vector<const RunRecord*>& group);

}  // namespace ombrage
