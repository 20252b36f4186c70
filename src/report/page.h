// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "lab/run_record.h"
#include "report/previews.h"

namespace ombrage {

/// What a report shows. Records that repeat an earlier one (same scene, camera, light, size, seed and pipeline) have
/// been dropped.
struct ReportData {
    std::vector<RunRecord> records;
    std::vector<RunNote> notes;
    Previews previews;
};

/// The whole report.html: self-contained, no network.
std::string reportPage(const ReportData& data);

/// The sentence at the top: which technique of each family came nearest to the truth, and what it cost.
std::string headline(const std::vector<RunRecord>& records);

}  // namespace ombrage
