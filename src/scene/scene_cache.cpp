// SPDX-License-Identifier: MIT
#include "scene/scene_cache.h"

#include <string>

#include <fmt/format.h>

#include "core/log.h"
#include "scene/archive.h"

namespace ombrage {

namespace {
constexpr const char* kExtension = ".scene";

std::string nameOf(const LoadRequest& request) {
    const std::string key =
        request.file + '\0' + request.folder + '\0' + (request.allowOutside ? '1' : '0') + (request.ground ? '1' : '0');
    const Fingerprint name = fingerprintOf(key.data(), key.size());
    return fmt::format("{:016x}{:016x}", name[0], name[1]);
}
}  // namespace

SceneCache::SceneCache(const SceneOptions& options)
    : SceneCache(CacheFolder::locate(options.cache, "scenes"), kMostBytes, kMostFiles) {}

SceneCache::SceneCache(std::filesystem::path folder, std::uint64_t mostBytes, std::size_t mostFiles)
    : m_folder(std::move(folder), kExtension, {mostBytes, mostFiles}) {}

std::optional<Scene> SceneCache::find(const LoadRequest& request) const {
    const std::optional<CachedBytes> content = m_folder.read(nameOf(request));
    if (!content) return std::nullopt;
    try {
        if (!isWholeArchive(content->span())) return std::nullopt;
        const ArchivedRequest archived = readArchivedRequest(content->span());
        if (archived.request != request || !unchanged(archived.dependencies)) return std::nullopt;
        return readLoadedScene(content->span()).scene;
    } catch (const std::exception& error) {
        debug(std::string("a scene of the cache cannot be used: ") + error.what());
        return std::nullopt;
    }
}

void SceneCache::store(const LoadRequest& request, std::span<const std::byte> archive) const {
    if (archive.size() > m_folder.bounds().bytes / 2) return;
    m_folder.write(nameOf(request), archive);
    m_folder.evict();
}

void SceneCache::store(const LoadedScene& loaded) const {
    m_folder.write(nameOf(loaded.request), [&](int file) { return writeLoadedScene(file, loaded); });
    m_folder.evict();
}

}  // namespace ombrage
