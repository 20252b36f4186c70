// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/record_groups.h"

namespace ombrage {

/// A column of a sortable table. What has a role can stand on an axis of the plot.
struct Column {
    std::string text, title;
    bool number = true;
    std::string role;  ///< "error", "cost" or ""
};

/// Opens a table that can be scrolled sideways, up to the first heading.
std::string tableStart(const std::string& id, const std::string& caption);
inline constexpr const char* kTableEnd = "</tbody></table></div>\n";
std::string heading(const Column& column);
/// The first cell of a row. @param pick  as a button that shows the run in the comparison
std::string rowHeading(const std::string& pipeline, bool pick);
std::string cell(const std::optional<double>& value, const std::string& shown, bool best = false);

/// Keys of the metrics that the table of the group shows: measured, and not 0 for every run. The details hold all.
std::vector<std::string> metricColumns(const RecordGroup& group);

/// A sortable table with one row per record; the best value of every column is marked.
std::string recordTable(const RecordGroup& group, std::size_t number);

/// Folded away: every metric, pass and parameter of every record, and the command that measures it again.
std::string recordDetails(const RecordGroup& group, const std::vector<RunNote>& notes);

}  // namespace ombrage
