// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ombrage {

/// The file that `name`, written in a file of `folder`, means: backslashes are slashes, then as written, then without
/// regard to case, then (for paths of another machine) its last part in `folder`. Nothing when there is no such file.
std::optional<std::filesystem::path> findAsset(const std::filesystem::path& folder, const std::string& name);

/// What there is in the place of a `name` that findAsset does not find: "is missing", or that it is no file.
std::string whyNotFound(const std::filesystem::path& folder, const std::string& name);

/// The whole content. @throws Error(Input) naming the file.
std::string readWholeFile(const std::filesystem::path& file);

}  // namespace ombrage
