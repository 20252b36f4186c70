// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/page.h"

namespace ombrage {

/// What the reader must know before the numbers: gates that failed, missing pictures, times that mean little.
std::string notices(const ReportData& data);

/// Device, clock, version, sizes, seeds, and the commands that made the folder.
std::string environment(const ReportData& data);

/// Pairs that were not run and why; "" where there are none.
std::string skippedTable(const std::vector<RunNote>& notes);

}  // namespace ombrage
