// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <ombrage/scene.h>

#include "scene/loaded_scene.h"

namespace ombrage {

/// A scene that a guarded process loaded, as archived bytes in memory that this process owns.
class ImportedBytes {
public:
    ImportedBytes(const std::byte* mapping, std::size_t size) : m_mapping(mapping), m_size(size) {}
    ~ImportedBytes();
    ImportedBytes(ImportedBytes&& other) noexcept;
    ImportedBytes& operator=(ImportedBytes&&) = delete;

    std::span<const std::byte> archive() const;

private:
    const std::byte* m_mapping;
    std::size_t m_size;
};

/// Loads a scene in a process of its own, with limits of memory and time that grow with the size of the files. Nothing
/// when guarding is off or there is no program for it (a warning says so, once a process): the caller then loads the
/// scene itself.
/// @throws Error(Input) when the files are bad, or when the process crashed, ran out of time or out of memory over
/// them;
///         Error(Interrupted) when options.cancelled says so; Error(Usage) when the program that was asked for is
///         missing.
std::optional<ImportedBytes> importGuarded(const LoadRequest& request, const SceneOptions& options);

/// The body of the guarded program.
int runImportProgram(int argc, char** argv);

}  // namespace ombrage
