// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <ombrage/image.h>

namespace ombrage {

/// OpenEXR files, as readImage and writeImage describe.
Image readExr(const std::filesystem::path& file);
void writeExr(const std::filesystem::path& file, const Image& image);

}  // namespace ombrage
