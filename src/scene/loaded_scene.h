// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ombrage/scene.h>

#include "scene/load_record.h"

namespace ombrage {

/// What is loaded: all that a load depends on beside the file system.
struct LoadRequest {
    std::string file;    ///< as the user wrote it: it stands in messages
    std::string folder;  ///< the working folder, which relative names start from
    bool allowOutside = false;
    bool ground = false;

    bool operator==(const LoadRequest&) const = default;
};

template <typename Archive, typename T>
requires std::same_as<std::remove_const_t<T>, LoadRequest>
void fields(Archive& archive, T& request) {
    auto& [file, folder, allowOutside, ground] = request;
    archive(file, folder, allowOutside, ground);
}

/// A scene read from files, and the files.
struct LoadedScene {
    LoadRequest request;
    std::vector<Dependency> dependencies;
    Scene scene;
};

/// Changes with everything that an archived scene depends on: the layout of the archive, the sources of the readers,
/// the versions of the libraries that read, the machine's byte order.
std::uint64_t archiveFormat();

/// Writes head, scene and checksum to an open file. False when that fails (a full disk).
bool writeLoadedScene(int file, const LoadedScene& loaded);

/// Checks head and checksum. Nothing when the bytes are not a whole archive of this program's format.
bool isWholeArchive(std::span<const std::byte> bytes);

/// What stands before the scene: enough to tell whether the scene is still that of the files.
struct ArchivedRequest {
    LoadRequest request;
    std::vector<Dependency> dependencies;
};

/// @throws ArchiveError for bytes that hold no scene that may be used: every index and size is checked.
/// isWholeArchive() comes first.
ArchivedRequest readArchivedRequest(std::span<const std::byte> bytes);
LoadedScene readLoadedScene(std::span<const std::byte> bytes);

/// The first thing that breaks a rule of Scene (an index out of range, arrays of unequal length, ...), or "".
std::string brokenRule(const Scene& scene);

}  // namespace ombrage
