// SPDX-License-Identifier: MIT
#include "core/cache_folder.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <new>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/file_handle.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
constexpr const char* kUnfinished = ".part";

std::string fromEnvironment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
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

fs::path CacheFolder::locate(const std::string& asked, const std::string& kind) {
    const std::string named = !asked.empty() ? asked : fromEnvironment("OMBRAGE_CACHE");
    if (named == "off") return {};
    if (!named.empty()) return named;
    const std::string base = fromEnvironment("XDG_CACHE_HOME"), home = fromEnvironment("HOME");
    // The standard wants relative folders ignored.
    if (fs::path(base).is_absolute()) return fs::path(base) / "ombrage" / kind;
    return fs::path(home).is_absolute() ? fs::path(home) / ".cache" / "ombrage" / kind : fs::path();
}

std::optional<CachedBytes> CacheFolder::read(const std::string& name) const {
    if (!isOn()) return std::nullopt;
    const FileHandle file(::open(fileOf(name).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat info {};
    if (!file.isOpen() || ::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
    CachedBytes content{nullptr, std::size_t(info.st_size)};
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

void CacheFolder::write(const std::string& name, const std::function<bool(int file)>& write) const {
    if (!isOn()) return;
    std::error_code failed;
    if (fs::create_directories(m_folder, failed)) fs::permissions(m_folder, fs::perms::owner_all, failed);

    static std::atomic<unsigned> counter = 0;
    const fs::path target = fileOf(name);
    const fs::path part = target.string() + fmt::format(".{}.{}{}", ::getpid(), counter++, kUnfinished);
    FileHandle file(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!file.isOpen()) return;
    bool good = write(file.get());
    good = file.close() && good && ::rename(part.c_str(), target.c_str()) == 0;
    if (!good) ::unlink(part.c_str());
}

void CacheFolder::write(const std::string& name, std::span<const std::byte> bytes) const {
    write(name, [&](int file) { return writeAll(file, bytes); });
}

void CacheFolder::evict() const {
    if (!isOn()) return;
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
        if (path.extension() != m_extension || !it->is_regular_file(ignored)) continue;
        entries.push_back({used, it->file_size(ignored), path});
        total += entries.back().size;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
    std::size_t count = entries.size();
    for (const Entry& entry : entries) {
        if (total <= m_bounds.bytes && count <= m_bounds.files) return;
        fs::remove(entry.path, ignored);
        total -= entry.size;
        --count;
    }
}

}  // namespace ombrage
