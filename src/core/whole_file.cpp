// SPDX-License-Identifier: MIT
#include "core/whole_file.h"

#include <unistd.h>
#include <atomic>
#include <chrono>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnfinished = ".part";

[[noreturn]] void cannotWrite(const fs::path& file, const std::string& why) {
    throw Error(ErrorCode::Environment, "cannot write '" + file.string() + "'" + (why.empty() ? "" : ": " + why),
                "check the folder's permissions and the free space", file.string());
}

}  // namespace

void writeWhole(const fs::path& named, const std::function<void(const fs::path&)>& write) {
    static std::atomic<unsigned> counter = 0;
    std::error_code failed, ignored;
    // A link keeps pointing where it points; a pipe or a device has no place beside it.
    const fs::path target = fs::is_symlink(named, ignored) && fs::exists(named, ignored) ? fs::canonical(named) : named;
    if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored)) return write(target);
    // Two processes, and two threads of one, never share a name.
    fs::path part = target;
    part.replace_filename(fmt::format(".{}.{}.{}{}{}", target.stem().string(), ::getpid(), counter++, kUnfinished,
                                      target.extension().string()));
    try {
        write(part);
    } catch (...) {
        fs::remove(part, ignored);
        throw;
    }
    fs::rename(part, target, failed);
    if (!failed) return;
    fs::remove(part, ignored);
    cannotWrite(target, failed.message());
}

void writeWhole(const fs::path& target, std::string_view content) {
    writeWhole(target, [&](const fs::path& part) {
        std::ofstream out(part, std::ios::binary);
        out.write(content.data(), std::streamsize(content.size()));
        out.close();
        if (!out) cannotWrite(target, "");
    });
}

void removeUnfinished(const fs::path& folder) {
    std::error_code failed, ignored;
    const auto now = fs::file_time_type::clock::now();
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        const fs::path& file = it->path();
        if (file.filename().string().front() != '.' || file.stem().extension() != kUnfinished) continue;
        const fs::file_time_type written = it->last_write_time(ignored);
        if (now - written > std::chrono::hours(1)) fs::remove(file, ignored);
    }
}

}  // namespace ombrage
