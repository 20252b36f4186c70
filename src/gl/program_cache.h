// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "core/cache_folder.h"

namespace ombrage::gl {

/// Whether the current context's driver hands out compiled programs (OpenGL allows it to offer no format at all).
bool offersProgramBinaries();

/// One stage of a program: what the driver compiles.
struct StageSource {
    GLenum stage;
    std::string text;
};

/// Programs compiled by earlier runs, kept on disk. A binary is used only for the very same texts of all stages and the
/// same driver (vendor, renderer, version), all of which its file holds and which are compared as a whole. A file that
/// is damaged, or a binary that the driver refuses, is as good as none. Needs a current context.
class ProgramCache {
public:
    static constexpr CacheFolder::Bounds kBounds{std::uint64_t(64) << 20, 1024};

    /// @param asked folder, "off", or "" for $OMBRAGE_CACHE and then the user's cache folder. Off too when the driver
    /// hands out no binaries.
    explicit ProgramCache(const std::string& asked, CacheFolder::Bounds bounds = kBounds);
    /// Brings the folder within its bounds when something was stored.
    ~ProgramCache();
    ProgramCache(const ProgramCache&) = delete;
    ProgramCache& operator=(const ProgramCache&) = delete;

    bool isOn() const { return m_folder.isOn(); }
    const std::filesystem::path& folder() const { return m_folder.folder(); }

    /// Gives `program` the kept binary. False when there is none that the driver takes; the program is then as before.
    bool load(GLuint program, const std::vector<StageSource>& stages) const;

    /// Keeps a linked program. Call prepare() before it is linked.
    void store(GLuint program, const std::vector<StageSource>& stages) const;
    void prepare(GLuint program) const;

private:
    std::string keyOf(const std::vector<StageSource>& stages) const;

    CacheFolder m_folder;
    std::string m_driver;
    mutable bool m_stored = false;
};

}  // namespace ombrage::gl
