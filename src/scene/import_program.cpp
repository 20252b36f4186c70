// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <thread>

#include <ombrage/error.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include "scene/archive.h"
#include "scene/import_guard.h"
#include "scene/import_protocol.h"
#include "scene/load_files.h"

namespace ombrage {

namespace {
// Sanitizers reserve terabytes of addresses and keep shadow memory: their builds have limits of time only, and
// wider ones: they run several times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

constexpr double kMiB = 1024.0 * 1024.0;
constexpr int kMostThreads = 8;  // every thread's stack counts as memory

/// What a program may use before it has opened anything, and how much more each file allows. Measured on real files:
/// models take up to 20 times their size in memory and 0.1 s a MiB, so 32 times and 1 s leave room for slow machines; a
/// compressed picture of n bytes may hold 1000 n texels but seldom more than 8192 x 8192. The least time lets whatever
/// is small end within 10 s, the program's own start and end included.
constexpr double kBaseMemory_MiB = 1024, kMemoryPerByte = 32, kImageMemoryPerByte = 1024, kMostImage_MiB = 2560;
constexpr double kSlowness = kSanitized ? 8 : 1;
constexpr double kLeastTime_s = 8 * kSlowness, kTimePerMiB_s = 1 * kSlowness;

ImportNotice* g_notice = nullptr;

/// A whole number of an environment variable, or nothing.
std::optional<double> fromEnvironment(const char* name) {
    const char* const text = std::getenv(name);
    if (text == nullptr) return std::nullopt;
    const std::string_view view(text);
    unsigned value = 0;
    const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), value);
    if (error != std::errc() || end != view.data() + view.size() || value == 0)
        throw Error(ErrorCode::Usage, std::string(name) + ": '" + text + "' is not a whole number above 0");
    return double(value);
}

/// The limits of this process. They end it; the parent tells the user.
class Limits {
public:
    Limits()
        : m_fixedMemory_MiB(fromEnvironment("OMBRAGE_IMPORT_MEMORY_MIB")),
          m_fixedTime_s(fromEnvironment("OMBRAGE_IMPORT_TIME_S")) {
        const rlimit noCore{0, 0};
        ::setrlimit(RLIMIT_CORE, &noCore);
        apply();
    }

    void allow(std::uint64_t size, bool isImage) {
        const double size_MiB = double(size) / kMiB;
        m_memory_MiB += isImage ? std::min(size_MiB * kImageMemoryPerByte, kMostImage_MiB) : size_MiB * kMemoryPerByte;
        m_size_MiB += size_MiB;
        apply();
    }

private:
    void apply() {
        // Never so much that the machine itself runs out.
        const double physical_MiB = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE)) / kMiB;
        const double memory_MiB =
            m_fixedMemory_MiB.value_or(std::min(m_memory_MiB, std::max(kBaseMemory_MiB, 0.75 * physical_MiB)));
        const double time_s = m_fixedTime_s.value_or(std::max(kLeastTime_s, m_size_MiB * kTimePerMiB_s));
        g_notice->memory_MiB = std::uint64_t(memory_MiB);
        g_notice->time_s = std::uint64_t(time_s);
        const rlim_t bytes = rlim_t(memory_MiB * kMiB);
        const rlimit memory{bytes, RLIM_INFINITY};
        if (!kSanitized) ::setrlimit(RLIMIT_DATA, &memory);
        // Threads share the processor time; the clock on the wall also ends what sleeps.
        const rlimit time{rlim_t(std::ceil(time_s)) * 2, RLIM_INFINITY};
        ::setrlimit(RLIMIT_CPU, &time);
        // Counted from the start: many small files do not add up.
        const std::chrono::duration<double> used = std::chrono::steady_clock::now() - m_start;
        ::alarm(unsigned(std::ceil(std::max(time_s - used.count(), 1.0))));
    }

    std::optional<double> m_fixedMemory_MiB, m_fixedTime_s;
    double m_memory_MiB = kBaseMemory_MiB, m_size_MiB = 0;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

void note(const std::filesystem::path& file) {
    std::strncpy(g_notice->file.data(), file.c_str(), g_notice->file.size() - 1);
}

struct FileWriter {
    bool good = true;
    void operator()(const void* data, std::size_t size) {
        good = good && (size == 0 || ::write(kResultFile, data, size) == ssize_t(size));
    }
};

int reportFailure(const Error& error) {
    FileWriter writer;
    ArchiveWriter archive(writer);
    archive(ImportFailure{int(error.code()), error.message(), error.hint(), error.where()});
    return writer.good ? kImportFailed : kImportNoResult;
}

int load(const LoadRequest& request) {
    Limits limits;
    const LoadedScene loaded =
        loadFiles(request, [&](const std::filesystem::path& file, std::uint64_t size, bool isImage) {
            note(file);
            limits.allow(size, isImage);
        });
    return writeLoadedScene(kResultFile, loaded) ? kImportDone : kImportNoResult;
}
}  // namespace

int runImportProgram(int argc, char** argv) {
    // Run by hand it has nowhere to write to.
    if (argc != 6 || std::to_string(archiveFormat()) != argv[1]) return kImportWrongFormat;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (std::to_string(::getppid()) != argv[2]) return kImportNoResult;
    ::syscall(SYS_close_range, unsigned(kAliveFile) + 1u, ~0u, 0u);
    void* const page = ::mmap(nullptr, kResultStart, PROT_READ | PROT_WRITE, MAP_SHARED, kResultFile, 0);
    if (page == MAP_FAILED || ::lseek(kResultFile, off_t(kResultStart), SEEK_SET) != off_t(kResultStart))
        return kImportNoResult;
    g_notice = new (page) ImportNotice;
    // Told here: the libraries in between may take bad_alloc for a detail of the file.
    std::set_new_handler([] { ::_exit(kImportOutOfMemory); });

    const tbb::global_control threads(
        tbb::global_control::max_allowed_parallelism,
        std::size_t(std::clamp(int(std::thread::hardware_concurrency()), 1, kMostThreads)));
    std::error_code failed;
    const LoadRequest request{argv[5], std::filesystem::current_path(failed).string(), argv[3][0] == '1',
                              argv[4][0] == '1'};
    try {
        // What has been read need not be given back piece by piece.
        ::_exit(load(request));
    } catch (const Error& error) {
        ::_exit(reportFailure(error));
    } catch (const std::exception& error) {
        ::_exit(reportFailure(Error(ErrorCode::Input, "cannot read '" + request.file + "': " + error.what())));
    }
}

}  // namespace ombrage
