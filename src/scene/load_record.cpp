// SPDX-License-Identifier: MIT
#include "scene/load_record.h"

#include <atomic>
#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "scene/asset_path.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
thread_local LoadRecord* t_current = nullptr;

Fingerprint toFingerprint(const XXH128_hash_t& hash) {
    return {hash.low64, hash.high64};
}

/// The fingerprint of a regular file's content; nothing when it cannot be read. Read, not mapped: a file that shrinks
/// meanwhile would kill the process.
std::optional<Fingerprint> fingerprintOfFile(const char* path) {
    const int file = ::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) return std::nullopt;
    struct stat info {};
    bool good = ::fstat(file, &info) == 0 && S_ISREG(info.st_mode);
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    std::vector<char> block(std::size_t(1) << 18);
    while (good) {
        const ssize_t size = ::read(file, block.data(), block.size());
        if (size < 0 && errno == EINTR) continue;
        good = size >= 0;
        if (size <= 0) break;
        XXH3_128bits_update(&state, block.data(), std::size_t(size));
    }
    ::close(file);
    if (!good) return std::nullopt;
    return toFingerprint(XXH3_128bits_digest(&state));
}

Dependency contentOf(const std::string& path) {
    Dependency dependency{Dependency::Kind::Content, path, {}, {}, {}};
    std::error_code failed;
    if (const auto fingerprint = fingerprintOfFile(path.c_str())) {
        dependency.fingerprint = *fingerprint;
        dependency.answer = fs::weakly_canonical(path, failed).string();
    }
    return dependency;
}

/// What the file system answers now.
Dependency askAgain(const Dependency& before) {
    Dependency now = before;
    std::error_code failed;
    switch (before.kind) {
        case Dependency::Kind::Content:
            return contentOf(before.path);
        case Dependency::Kind::Search:
            now.answer = findAsset(before.path, before.name).value_or(fs::path()).string();
            break;
        case Dependency::Kind::Presence:
            now.answer = fs::exists(before.path, failed) ? "yes" : "";
            break;
    }
    return now;
}
}  // namespace

LoadRecord::LoadRecord(OnFile onFile) : m_onFile(std::move(onFile)), m_outer(t_current) {
    t_current = this;
}

LoadRecord::~LoadRecord() {
    t_current = m_outer;
}

std::vector<Dependency> LoadRecord::dependencies() const {
    std::vector<Dependency> list;
    for (const auto& [key, dependency] : m_dependencies) list.push_back(dependency);
    return list;
}

void LoadRecord::add(Dependency dependency) {
    // NUL separates, as no path holds one. The first answer is what the load began with.
    const std::string key = std::to_string(int(dependency.kind)) + dependency.path + '\0' + dependency.name;
    m_dependencies.emplace(key, std::move(dependency));
}

void LoadRecord::content(const fs::path& file, bool isImage) {
    if (t_current == nullptr) return;
    LoadRecord& record = *t_current;
    std::error_code failed;
    const std::uintmax_t size = fs::is_regular_file(file, failed) ? fs::file_size(file, failed) : 0;
    if (record.m_onFile && !failed) record.m_onFile(file, size, isImage);
    record.add(contentOf(file.string()));
}

void LoadRecord::search(const fs::path& folder, const std::string& name, const std::optional<fs::path>& found) {
    if (t_current == nullptr) return;
    t_current->add({Dependency::Kind::Search, folder.string(), name, found.value_or(fs::path()).string(), {}});
}

void LoadRecord::presence(const fs::path& file, bool isThere) {
    if (t_current == nullptr) return;
    t_current->add({Dependency::Kind::Presence, file.string(), {}, isThere ? "yes" : "", {}});
}

bool unchanged(const std::vector<Dependency>& dependencies) {
    std::atomic<bool> same = true;
    tbb::parallel_for(std::size_t(0), dependencies.size(), [&](std::size_t i) {
        if (!same) return;
        const Dependency now = askAgain(dependencies[i]);
        if (now.answer != dependencies[i].answer || now.fingerprint != dependencies[i].fingerprint) same = false;
    });
    return same;
}

Fingerprint fingerprintOf(const void* data, std::size_t size) {
    return toFingerprint(XXH3_128bits(data, size));
}

}  // namespace ombrage
