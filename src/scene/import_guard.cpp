// SPDX-License-Identifier: MIT
#include "scene/import_guard.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <ombrage/error.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "core/log.h"
#include "scene/archive.h"
#include "core/file_handle.h"
#include "scene/import_protocol.h"

extern char** environ;

namespace ombrage {

namespace fs = std::filesystem;

namespace {
constexpr const char* kProgramName = "ombrage-import";

bool isProgram(const fs::path& file) {
    std::error_code failed;
    return fs::is_regular_file(file, failed) && ::access(file.c_str(), X_OK) == 0;
}

/// The guarded program; empty when guarding is off or there is none.
fs::path findProgram(const SceneOptions& options) {
    const char* const environment = std::getenv("OMBRAGE_IMPORT");
    const std::string asked = !options.importer.empty() ? options.importer : environment != nullptr ? environment : "";
    if (asked == "off") return {};
    if (!asked.empty()) {
        if (!isProgram(asked))
            throw Error(ErrorCode::Usage,
                        "the program for guarded import '" + asked + "' is not there or may not be run",
                        "name " + std::string(kProgramName) + ", or 'off'");
        return asked;
    }
    std::error_code failed;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
    if (!failed)
        for (const char* place : {"", "../bin", "../libexec/ombrage"})
            if (const fs::path file = folder / place / kProgramName; isProgram(file)) return file;
    static std::atomic<bool> told = false;
    if (!told.exchange(true))
        warn(std::string(kProgramName) +
             " is not beside the program: files are read without a guard, and a damaged one may crash it");
    return {};
}

[[noreturn]] void failForLackOf(const std::string& what) {
    throw Error(ErrorCode::Environment, "cannot start the guarded import: " + what + ": " + std::strerror(errno),
                "OMBRAGE_IMPORT=off reads files without a guard");
}

/// A descriptor out of the way of those that the child gets.
FileHandle lifted(FileHandle file) {
    FileHandle result(::fcntl(file.get(), F_DUPFD_CLOEXEC, 10));
    if (!result.isOpen()) failForLackOf("no file descriptor");
    return result;
}

/// A child process; killed and waited for at the end unless it has ended.
class Child {
public:
    explicit Child(pid_t pid) : m_pid(pid) {}
    ~Child() {
        if (m_pid <= 0) return;
        ::kill(m_pid, SIGKILL);
        wait();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// The status of waitpid; nothing when the host collects children itself.
    std::optional<int> wait() {
        int status = 0;
        pid_t done = -1;
        do done = ::waitpid(m_pid, &status, 0);
        while (done < 0 && errno == EINTR);
        const bool known = done == std::exchange(m_pid, -1);
        return known ? std::optional(status) : std::nullopt;
    }

private:
    pid_t m_pid;
};

/// Starts the program; nothing when it cannot be run.
std::optional<pid_t> start(const fs::path& program, const LoadRequest& request, const FileHandle& result,
                           const FileHandle& alive) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, result.get(), kResultFile);
    posix_spawn_file_actions_adddup2(&actions, alive.get(), kAliveFile);
    // Whatever signals the host blocks or ignores, the child's limits must be able to end it.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    std::array<std::string, 6> arguments = {program.string(),           std::to_string(archiveFormat()),
                                            std::to_string(::getpid()), request.allowOutside ? "1" : "0",
                                            request.ground ? "1" : "0", request.file};
    std::array<char*, arguments.size() + 1> pointers{};
    for (std::size_t i = 0; i < arguments.size(); ++i) pointers[i] = arguments[i].data();
    pid_t pid = -1;
    const int failed = ::posix_spawn(&pid, program.c_str(), &actions, &attributes, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failed == 0) return pid;
    warn("cannot run " + program.string() + " (" + std::strerror(failed) + "): files are read without a guard");
    return std::nullopt;
}

/// Waits until the child closes its end, by dying at the latest.
void waitForEnd(const FileHandle& alive, const SceneOptions& options) {
    constexpr int kPause_ms = 30;
    pollfd waiting{alive.get(), POLLIN, 0};
    while (true) {
        const int ready = ::poll(&waiting, 1, options.cancelled ? kPause_ms : -1);
        if (options.cancelled && options.cancelled())
            throw Error(ErrorCode::Interrupted, "interrupted", "no scene was loaded");
        if (ready > 0 || (ready < 0 && errno != EINTR)) return;
    }
}

std::string lastFile(const ImportNotice& notice) {
    return std::string(notice.file.data(), ::strnlen(notice.file.data(), notice.file.size()));
}

[[noreturn]] void throwDeath(int signal, const LoadRequest& request, const ImportNotice& notice) {
    const std::string file = "'" + request.file + "'", last = lastFile(notice);
    switch (signal) {
        case SIGINT:
        case SIGTERM:
        case SIGHUP:
            throw Error(ErrorCode::Interrupted, "interrupted", "no scene was loaded");
        case SIGALRM:
        case SIGXCPU:
            throw Error(ErrorCode::Input, fmt::format("reading {} ran out of time ({} s)", file, notice.time_s),
                        "the file is damaged, or too slow to read: OMBRAGE_IMPORT_TIME_S allows more", last);
        case SIGKILL:
            throw Error(ErrorCode::Input,
                        fmt::format("reading {} was ended by the system, probably for lack of memory", file),
                        "the file is damaged, or too large for this machine", last);
        default:
            throw Error(
                ErrorCode::Input, fmt::format("the reader crashed while reading {} ({})", file, ::strsignal(signal)),
                "the file is damaged, or holds something that the reader does not know: try to export it again", last);
    }
}

/// The child's own error, or what stands for one that cannot be read.
[[noreturn]] void throwFailure(std::span<const std::byte> bytes, const LoadRequest& request) {
    ImportFailure failure;
    try {
        ArchiveReader archive(bytes);
        archive(failure);
    } catch (const ArchiveError&) {
        throw Error(ErrorCode::Input, "reading '" + request.file + "' failed without a reason");
    }
    const bool known = failure.code == int(ErrorCode::Usage) || failure.code == int(ErrorCode::Environment);
    throw Error(known ? ErrorCode(failure.code) : ErrorCode::Input, failure.message, failure.hint, failure.where);
}
}  // namespace

ImportedBytes::~ImportedBytes() {
    if (m_mapping != nullptr) ::munmap(const_cast<std::byte*>(m_mapping), m_size);
}

ImportedBytes::ImportedBytes(ImportedBytes&& other) noexcept
    : m_mapping(std::exchange(other.m_mapping, nullptr)), m_size(other.m_size) {}

std::span<const std::byte> ImportedBytes::archive() const {
    return {m_mapping + kResultStart, m_size - kResultStart};
}

std::optional<ImportedBytes> importGuarded(const LoadRequest& request, const SceneOptions& options) {
    const fs::path program = findProgram(options);
    if (program.empty()) return std::nullopt;

    // The result lies in memory that both processes hold; the pipe's end tells when the child is gone.
    FileHandle result(::memfd_create("ombrage-import", MFD_CLOEXEC));
    if (!result.isOpen() || ::ftruncate(result.get(), off_t(kResultStart)) != 0) failForLackOf("no memory");
    result = lifted(std::move(result));
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) failForLackOf("no pipe");
    FileHandle childLives(ends[0]), childEnd(ends[1]);
    childEnd = lifted(std::move(childEnd));
    const std::optional<pid_t> pid = start(program, request, result, childEnd);
    if (!pid) return std::nullopt;
    Child child(*pid);
    childEnd.close();
    waitForEnd(childLives, options);
    const std::optional<int> status = child.wait();

    struct stat info {};
    if (::fstat(result.get(), &info) != 0 || info.st_size < off_t(kResultStart)) failForLackOf("no result");
    const std::size_t size = std::size_t(info.st_size);
    void* const mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, result.get(), 0);
    if (mapping == MAP_FAILED) failForLackOf("no memory");
    ImportedBytes bytes(static_cast<const std::byte*>(mapping), size);
    ImportNotice notice;
    std::memcpy(static_cast<void*>(&notice), mapping, sizeof notice);

    if (status && WIFSIGNALED(*status)) throwDeath(WTERMSIG(*status), request, notice);
    const int code = status ? WEXITSTATUS(*status) : isWholeArchive(bytes.archive()) ? kImportDone : kImportFailed;
    switch (code) {
        case kImportDone:
            if (isWholeArchive(bytes.archive())) return bytes;
            break;
        case kImportFailed:
            throwFailure(bytes.archive(), request);
        case kImportOutOfMemory:
            throw Error(ErrorCode::Input,
                        fmt::format("reading '{}' needs more than {} MiB of memory", request.file, notice.memory_MiB),
                        "the file is damaged, or larger than it looks: OMBRAGE_IMPORT_MEMORY_MIB allows more",
                        lastFile(notice));
        case kImportWrongFormat:
            warn(program.string() + " belongs to another version of Ombrage: files are read without a guard");
            return std::nullopt;
        default:
            break;
    }
    throw Error(ErrorCode::Input, fmt::format("reading '{}' ended without a result (exit code {})", request.file, code),
                "OMBRAGE_IMPORT=off reads files without a guard", lastFile(notice));
}

}  // namespace ombrage
