// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

namespace ombrage {

/// What the guarded program and its parent agree upon. Beside it stands the archive of loaded_scene.h; a program of
/// another archiveFormat() refuses to work.
///
/// Arguments: archiveFormat() in decimal, the parent's process id, "1" for allowOutside, "1" for ground, the file. The
/// result is written to the open file kResultFile: the Notice first, the archive (or the failure) from kResultStart on.
inline constexpr int kResultFile = 3;
inline constexpr int kAliveFile = 4;  ///< open as long as the program lives
inline constexpr std::size_t kResultStart = 4096;

enum ImportExit : int {
    kImportDone = 0,
    kImportFailed = 10,  ///< an ImportFailure is the result
    kImportOutOfMemory = 11,
    kImportWrongFormat = 12,  ///< the program belongs to another version
    kImportNoResult = 13      ///< the result could not be written
};

/// Kept up to date while the program works, for a parent that must tell how it died.
struct ImportNotice {
    std::uint64_t memory_MiB = 0;
    std::uint64_t time_s = 0;
    std::array<char, kResultStart - 2 * sizeof(std::uint64_t)> file{};  ///< the last one opened, cut to fit
};
static_assert(sizeof(ImportNotice) == kResultStart);

/// An ombrage::Error.
struct ImportFailure {
    int code = 0;
    std::string message, hint, where;
};

template <typename Archive, typename T>
requires std::same_as<std::remove_const_t<T>, ImportFailure>
void fields(Archive& archive, T& failure) {
    auto& [code, message, hint, where] = failure;
    archive(code, message, hint, where);
}

}  // namespace ombrage
