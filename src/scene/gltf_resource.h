// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ombrage {

/// The bytes of "data:[TYPE][;base64],DATA"; nothing when it is not of that form.
std::optional<std::string> decodeDataUri(const std::string& uri);

/// The file that an address in a glTF file means, percent codes and wrong case put right.
std::optional<std::filesystem::path> findGltfFile(const std::filesystem::path& folder, const std::string& uri);

}  // namespace ombrage
