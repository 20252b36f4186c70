// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace ombrage::docs {

/// The page of all built-in scenes: sentence, pictures and what each declares in tests/scenes/expectations.
std::string scenesPage(const std::filesystem::path& source);

/// Two small pictures per scene: with the ray-traced truth in every shadow technique's place, and with the first
/// technique that the scene declares to fail.
void renderScenePictures(const std::filesystem::path& source, const std::filesystem::path& images);

}  // namespace ombrage::docs
