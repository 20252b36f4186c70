// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ombrage::bad_inputs {

struct OddFile {
    std::filesystem::path path;
    bool mustLoad = false;  ///< odd, but a picture can be made of it
};

/// Broken scene files, and what is no file at all: a folder, a pipe, a link to itself, ...
std::vector<OddFile> writeOddFiles(const std::filesystem::path& folder);

/// Models whose geometry is degenerate: NaN, infinity, no area, huge, tiny, twice the same, indices out of range. They
/// must load.
std::vector<OddFile> writeDegenerateFiles(const std::filesystem::path& folder);

}  // namespace ombrage::bad_inputs
