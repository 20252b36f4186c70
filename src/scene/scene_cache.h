// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "core/cache_folder.h"
#include "scene/loaded_scene.h"

namespace ombrage {

/// Scenes that were loaded before, archived in a folder. A scene is found again only when every file that its load read
/// has the same content, and every one that it looked for is where it was, or still missing. Whatever goes wrong here
/// costs the cache, never the load.
class SceneCache {
public:
    /// At most this much is kept; the scenes not used for longest go first.
    static constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 30;
    static constexpr std::size_t kMostFiles = 1024;

    /// The folder that the options or the environment name; no cache when they say "off" or there is no home.
    explicit SceneCache(const SceneOptions& options);
    /// A folder with bounds of its own.
    SceneCache(std::filesystem::path folder, std::uint64_t mostBytes, std::size_t mostFiles);

    bool isOn() const { return m_folder.isOn(); }
    std::optional<Scene> find(const LoadRequest& request) const;
    void store(const LoadRequest& request, std::span<const std::byte> archive) const;
    void store(const LoadedScene& loaded) const;

private:
    CacheFolder m_folder;
};

}  // namespace ombrage
