// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace ombrage {

/// Lets `write` make a file beside `target` and renames it there: readers, other writers and a process killed at any
/// moment see the old file or the new one, never a part. The name given to `write` ends as the target's does.
/// A target that is there and is no file (a pipe, a device) is written to directly.
/// @throws Error(Environment) when the rename fails, and whatever `write` throws; the target is then as it was.
void writeWhole(const std::filesystem::path& target, const std::function<void(const std::filesystem::path&)>& write);

/// @throws Error(Environment)
void writeWhole(const std::filesystem::path& target, std::string_view content);

/// Removes what writers killed over an hour ago left unfinished in a folder. What cannot be removed stays.
void removeUnfinished(const std::filesystem::path& folder);

}  // namespace ombrage
