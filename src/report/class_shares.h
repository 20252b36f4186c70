// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/record_groups.h"

namespace ombrage {

/// "rgb(12,34,56)" of colours in [0,1].
std::string cssColor(const float rgb[3]);

/// How to read error maps and class pictures: the one scale of the errors, and the classes with their definitions.
std::string errorLegend();

/// A table with one bar per run that shows its classes' shares of the pixels, or "" where none has classes.
std::string classShares(const RecordGroup& group);

/// {"ramp":["rgb(..)", ...],"classes":[{"key":"alias","color":[r,g,b]}, ...]}: what the script paints and probes with.
std::string colorTablesJson();

}  // namespace ombrage
