// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/hash.h"
#include "gl/shader_source.h"

namespace ombrage::gl {

namespace fs = std::filesystem;

namespace {

bool startsWith(const std::string& text, const std::string& prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

// Moves `path` from under `from` to under `to`; false when it is not there.
bool movePrefix(std::string& path, const std::string& from, const std::string& to) {
    if (!startsWith(path, from)) return false;
    path = to + path.substr(from.size());
    return true;
}

bool isShaderFile(const fs::path& file) {
    for (const char* extension : {".glsl", ".vert", ".frag", ".geom", ".comp", ".tesc", ".tese"})
        if (file.extension() == extension) return true;
    return false;
}

}  // namespace

ShaderFiles::ShaderFiles(std::string directory) : m_directory(std::move(directory)) {
    if (m_directory.empty()) return;
    std::error_code ignored;
    if (!fs::is_directory(m_directory, ignored))
        throw Error(ErrorCode::Input, fmt::format("the shader directory '{}' is no directory", m_directory),
                    "Give a folder laid out as shader paths are, or the 'src' folder of Ombrage's sources.");
    m_isSourceTree = fs::is_directory(fs::path(m_directory) / "render" / "glsl", ignored);
}

std::string ShaderFiles::filePath(const std::string& path) const {
    std::string relative = path;
    if (m_isSourceTree && !movePrefix(relative, "ombrage/", "render/glsl/")) relative = "techniques/" + path;
    return (fs::path(m_directory) / relative).string();
}

std::optional<std::string> ShaderFiles::find(const std::string& path) const {
    if (!m_directory.empty()) {
        std::ifstream file(filePath(path), std::ios::binary);
        std::error_code ignored;
        if (file && fs::is_regular_file(filePath(path), ignored))
            return std::string(std::istreambuf_iterator<char>(file), {});
    }
    for (std::size_t i = 0; i < kEmbeddedShaderCount; ++i)
        if (path == kEmbeddedShaders[i].path) return std::string(kEmbeddedShaders[i].text);
    return std::nullopt;
}

std::vector<std::string> ShaderFiles::paths() const {
    std::set<std::string> found;
    for (std::size_t i = 0; i < kEmbeddedShaderCount; ++i) found.insert(kEmbeddedShaders[i].path);
    if (!m_directory.empty()) {
        std::error_code ignored;
        for (fs::recursive_directory_iterator it(m_directory, ignored), end; it != end; it.increment(ignored)) {
            if (!isShaderFile(it->path())) continue;
            std::string path = it->path().lexically_relative(m_directory).generic_string();
            if (m_isSourceTree && !movePrefix(path, "render/glsl/", "ombrage/") && !movePrefix(path, "techniques/", ""))
                continue;
            found.insert(path);
        }
    }
    return {found.begin(), found.end()};
}

std::uint64_t ShaderFiles::stamp(const std::string& path) const {
    if (m_directory.empty()) return 0;
    // Size beside time: two saves within the clock's grain usually differ in length.
    std::error_code error;
    const fs::path file = filePath(path);
    const auto time = fs::last_write_time(file, error);
    if (error) return 0;
    const auto size = fs::file_size(file, error);
    if (error) return 0;
    Hasher hasher;
    hasher.value(std::int64_t(time.time_since_epoch().count()));
    hasher.value(std::uint64_t(size));
    return hasher.digest();
}

}  // namespace ombrage::gl
