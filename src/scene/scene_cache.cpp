// SPDX-License-Identifier: MIT
#include "scene/scene_cache.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/log.h"
#include "scene/archive.h"
#include "scene/file_handle.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
constexpr const char* kExtension = ".scene";
constexpr const char* kUnfinished = ".part";

std::string fromEnvironment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

fs::path defaultFolder() {
    const std::string base = fromEnvironment("XDG_CACHE_HOME"), home = fromEnvironment("HOME");
    // The standard wants relative folders ignored.
    if (fs::path(base).is_absolute()) return fs::path(base) / "ombrage" / "scenes";
    return fs::path(home).is_absolute() ? fs::path(home) / ".cache" / "ombrage" / "scenes" : fs::path();
}

/// A file's content, aligned as archives need it.
struct Content {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t size = 0;
};

std::optional<Content> read(const fs::path& path) {
    const FileHandle file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat info {};
    if (!file.isOpen() || ::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
    Content content{nullptr, std::size_t(info.st_size)};
    content.bytes.reset(new (std::nothrow) std::byte[std::max<std::size_t>(content.size, 1)]);
    if (!content.bytes) return std::nullopt;
    for (std::size_t done = 0; done < content.size;) {
        const ssize_t count = ::read(file.get(), content.bytes.get() + done, content.size - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return std::nullopt;
        done += std::size_t(count);
    }
    // Used now: eviction goes by this time.
    ::futimens(file.get(), nullptr);
    return content;
}

bool writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(std::size_t(written));
    }
    return true;
}
}  // namespace

SceneCache::SceneCache(const SceneOptions& options) {
    const std::string asked = !options.cache.empty() ? options.cache : fromEnvironment("OMBRAGE_CACHE");
    if (asked == "off") return;
    m_folder = asked.empty() ? defaultFolder() : fs::path(asked);
}

fs::path SceneCache::fileOf(const LoadRequest& request) const {
    const std::string key =
        request.file + '\0' + request.folder + '\0' + (request.allowOutside ? '1' : '0') + (request.ground ? '1' : '0');
    const Fingerprint name = fingerprintOf(key.data(), key.size());
    return m_folder / fmt::format("{:016x}{:016x}{}", name[0], name[1], kExtension);
}

std::optional<Scene> SceneCache::find(const LoadRequest& request) const {
    if (!isOn()) return std::nullopt;
    const std::optional<Content> content = read(fileOf(request));
    if (!content) return std::nullopt;
    const std::span<const std::byte> bytes(content->bytes.get(), content->size);
    try {
        if (!isWholeArchive(bytes)) return std::nullopt;
        const ArchivedRequest archived = readArchivedRequest(bytes);
        if (archived.request != request || !unchanged(archived.dependencies)) return std::nullopt;
        return readLoadedScene(bytes).scene;
    } catch (const std::exception& error) {
        debug(std::string("a scene of the cache cannot be used: ") + error.what());
        return std::nullopt;
    }
}

template <typename Write>
void SceneCache::storeWith(const LoadRequest& request, Write write) const {
    if (!isOn()) return;
    std::error_code failed;
    if (fs::create_directories(m_folder, failed)) fs::permissions(m_folder, fs::perms::owner_all, failed);

    // Written beside its place and then renamed: a reader sees the old file or the new one, never a part.
    static std::atomic<unsigned> counter = 0;
    const fs::path target = fileOf(request);
    const fs::path part = target.string() + fmt::format(".{}.{}{}", ::getpid(), counter++, kUnfinished);
    FileHandle file(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!file.isOpen()) return;
    bool good = write(file.get());
    good = file.close() && good && ::rename(part.c_str(), target.c_str()) == 0;
    if (!good) ::unlink(part.c_str());
    evict();
}

void SceneCache::store(const LoadRequest& request, std::span<const std::byte> archive) const {
    if (archive.size() > m_mostBytes / 2) return;
    storeWith(request, [&](int file) { return writeAll(file, archive); });
}

void SceneCache::store(const LoadedScene& loaded) const {
    storeWith(loaded.request, [&](int file) { return writeLoadedScene(file, loaded); });
}

void SceneCache::evict() const {
    struct Entry {
        fs::file_time_type used;
        std::uint64_t size;
        fs::path path;
    };
    std::vector<Entry> entries;
    std::uint64_t total = 0;
    const auto now = fs::file_time_type::clock::now();
    std::error_code failed, ignored;
    for (fs::directory_iterator it(m_folder, failed), end; !failed && it != end; it.increment(failed)) {
        const fs::path& path = it->path();
        const fs::file_time_type used = it->last_write_time(ignored);
        // What a killed process left unfinished.
        if (path.extension() == kUnfinished && now - used > std::chrono::hours(1)) fs::remove(path, ignored);
        if (path.extension() != kExtension || !it->is_regular_file(ignored)) continue;
        entries.push_back({used, it->file_size(ignored), path});
        total += entries.back().size;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
    std::size_t count = entries.size();
    for (const Entry& entry : entries) {
        if (total <= m_mostBytes && count <= m_mostFiles) return;
        fs::remove(entry.path, ignored);
        total -= entry.size;
        --count;
    }
}

}  // namespace ombrage
