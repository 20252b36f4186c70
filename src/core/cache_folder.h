// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace ombrage {

/// A file's content, aligned for any type.
struct CachedBytes {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;
    std::span<const std::byte> span() const { return {bytes.get(), size}; }
};

/// A folder of files that make the next run faster and that may vanish at any time. Whatever goes wrong with it costs
/// the cache and nothing else: nothing here throws or warns.
class CacheFolder {
public:
    struct Bounds {
        std::uint64_t bytes = 0;
        std::size_t files = 0;
    };

    /// No cache.
    CacheFolder() = default;
    /// @param extension of the files that are this cache's, as in ".scene"
    CacheFolder(std::filesystem::path folder, std::string extension, Bounds bounds)
        : m_folder(std::move(folder)), m_extension(std::move(extension)), m_bounds(bounds) {}

    /// Where files of a kind ("scenes") lie: `asked`, else $OMBRAGE_CACHE, else a folder of that name in the user's
    /// cache folder. Empty for "off" and where there is no home.
    static std::filesystem::path locate(const std::string& asked, const std::string& kind);

    bool isOn() const { return !m_folder.empty(); }
    const std::filesystem::path& folder() const { return m_folder; }
    const Bounds& bounds() const { return m_bounds; }

    /// The whole file of this name (without extension); it counts as used now.
    std::optional<CachedBytes> read(const std::string& name) const;

    /// Writes a file beside its place and renames it, so that readers see the old one or the new one, never a part.
    /// @param write takes the open file; false when writing failed
    void write(const std::string& name, const std::function<bool(int file)>& write) const;
    void write(const std::string& name, std::span<const std::byte> bytes) const;

    /// Removes the files not used for longest until the rest is within the bounds.
    void evict() const;

private:
    std::filesystem::path fileOf(const std::string& name) const { return m_folder / (name + m_extension); }

    std::filesystem::path m_folder;
    std::string m_extension;
    Bounds m_bounds;
};

}  // namespace ombrage
