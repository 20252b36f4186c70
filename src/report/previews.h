// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lab/run_record.h"

namespace ombrage {

/// The pictures of a report as data: URIs, scaled down until all of them together fit.
struct Previews {
    std::map<std::string, std::string> uris;  ///< path in the record -> "data:image/png;base64,..."
    int width_px = 0;                         ///< no preview is wider
    std::vector<std::string> leftOut;         ///< kinds that did not fit at the smallest width
    std::vector<std::string> missing;         ///< paths that could not be read
};

/// @param budget  bytes that the URIs may take together
Previews makePreviews(const std::filesystem::path& folder, const std::vector<RunRecord>& records, std::size_t budget);

}  // namespace ombrage
