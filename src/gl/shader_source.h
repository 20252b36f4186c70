// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gl/shader_library.h"

namespace ombrage::gl {

/// Finds source texts: virtual ones, then files of the shader directory, then the embedded ones.
class ShaderFiles {
public:
    /// @param directory "" for the embedded sources alone. A folder that holds "render/glsl" counts as a source tree.
    /// @throws Error(Input) when it is no directory.
    explicit ShaderFiles(std::string directory);

    /// The text, or nothing when no source has the path.
    std::optional<std::string> find(const std::string& path) const;

    /// Every embedded path and every file in the directory, for suggestions.
    std::vector<std::string> paths() const;

    /// Changes whenever the directory's file of that path does; 0 when there is no such file.
    std::uint64_t stamp(const std::string& path) const;

private:
    std::string filePath(const std::string& path) const;
    std::string m_directory;
    bool m_isSourceTree = false;
};

/// The paths that were looked up, each with its stamp from just before it was read: a file that changes meanwhile shows
/// as changed later.
using Dependencies = std::map<std::string, std::uint64_t>;

/// Where a line of the text that the driver sees comes from.
struct SourceLine {
    std::string path;
    int line = 0;
};

/// A stage's text for the driver, and the origin of each of its lines. No #line is used: Mesa 22.3 forgets the source
/// number in about half of its messages, but the line counted from the start of the text is right on every driver.
struct ExpandedSource {
    std::string text;
    std::vector<SourceLine> lines;
};

/// Resolves the includes of `path`, puts "#version 450 core", the defines and the #extension lines in front.
/// @param dependencies receives what was looked up, also when this throws
/// @throws Error(Usage) for an unknown path, a cycle of includes, a malformed directive or a #version in a source
ExpandedSource expandSource(const ShaderFiles& files, const std::string& path, const ProgramDesc& desc,
                            Dependencies& dependencies);

/// A driver's log with "path:line" in the place of the numbers that Mesa ("0:12(5): error"), NVIDIA ("0(12) : error")
/// and others ("ERROR: 0:12: ") write.
std::string mapLog(const std::string& log, const std::vector<SourceLine>& lines);

}  // namespace ombrage::gl
