// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/run_record.h"

namespace ombrage {

/// Runs that answer the same question: same scene, family, camera, light, time, motion, size and kind of truth. They
/// stand in one table and are compared with each other; others never are.
struct RecordGroup {
    std::vector<const RunRecord*> records;
    std::vector<std::size_t> indices;  ///< of the records in the report's list

    const RunRecord& first() const { return *records.front(); }
    /// "gap, light lamp"
    std::string place() const;
    /// "gap: shadow, light lamp"
    std::string title() const;
};

/// In the order in which they first occur. The groups point into `records`.
std::vector<RecordGroup> groupRecords(const std::vector<RunRecord>& records);

/// Every technique of the run is held against a truth of its own.
bool hasOwnTruth(const RunRecord& record);

/// Nothing where it was not measured.
std::optional<double> metricOf(const RunRecord& record, const std::string& key);

/// One argument of a command as a shell takes it.
std::string shellQuoted(const std::string& word);

/// The settings of this record as C++ for a program that has the library: the family names their member.
std::string settingsFor(const RunRecord& record);

/// "ombrage compare SCENE --technique ..." that measures this record again. Scene files are named as the commands did.
std::string commandFor(const RunRecord& record, const std::vector<RunNote>& notes);

}  // namespace ombrage
