// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/picture_files.h"

namespace ombrage {

/// The pictures of a report as data: URIs.
struct Previews {
    std::map<std::string, std::string> uris;  ///< path in the record -> "data:image/png;base64,..."
    int width_px = 0;                         ///< no preview is wider
    bool shrunk = false;                      ///< some preview is smaller than its picture
    std::vector<std::string> leftOut;         ///< kinds that did not fit at the smallest width
};

/// All pictures, scaled down until they fit together.
/// @param budget  bytes that the URIs may take together
Previews makePreviews(const PictureFiles& pictures, std::size_t budget);

/// All pictures as they are.
Previews fullPreviews(const PictureFiles& pictures);

}  // namespace ombrage
