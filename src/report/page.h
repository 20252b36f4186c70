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
    std::vector<std::string> benchGroups;  ///< JSON documents, groups of the schema ombrage/bench/1
    Previews previews;
    std::vector<std::string> missingPictures;  ///< paths that could not be read
    std::vector<std::string> crops;            ///< HTML per group of the records, or nothing at all
};

/// The whole report.html: self-contained, no network.
std::string reportPage(const ReportData& data);

/// The sentence at the top: which technique of each family came nearest to the truth, what it cost, and which of the
/// cheaper ones came nearest after it.
std::string headline(const std::vector<RunRecord>& records);

}  // namespace ombrage
