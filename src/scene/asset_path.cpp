// SPDX-License-Identifier: MIT
#include "scene/asset_path.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// Walks down from `folder`, taking at every part the first entry (in order of name) that is equal but for case.
std::optional<fs::path> findIgnoringCase(const fs::path& folder, const fs::path& relative) {
    fs::path current = folder;
    for (const fs::path& part : relative) {
        std::error_code failed;
        if (part == "." || part == ".." || fs::exists(current / part, failed)) {
            current /= part;
            continue;
        }
        std::vector<fs::path> matches;
        for (fs::directory_iterator entry(current, failed), end; !failed && entry != end; entry.increment(failed))
            if (toLower(entry->path().filename().string()) == toLower(part.string())) matches.push_back(entry->path());
        if (matches.empty()) return std::nullopt;
        current = *std::min_element(matches.begin(), matches.end());
    }
    return isFile(current) ? std::optional(current) : std::nullopt;
}
}  // namespace

std::optional<fs::path> findAsset(const fs::path& folder, const std::string& name) {
    std::string slashes = trim(name);
    // A NUL cannot be part of a file's name; the system would read the text only up to it.
    if (slashes.empty() || slashes.find('\0') != std::string::npos) return std::nullopt;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    const fs::path path(slashes);
    const fs::path direct = path.is_absolute() ? path : folder / path;
    if (isFile(direct)) return direct;
    if (!path.is_absolute())
        if (auto found = findIgnoringCase(folder, path)) return found;
    return findIgnoringCase(folder, path.filename());
}

std::string readWholeFile(const fs::path& file) {
    std::error_code failed;
    if (fs::is_directory(file, failed))
        throw Error(ErrorCode::Input, "'" + file.string() + "' is a folder", "name a file in it");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    if (!stream || !(content << stream.rdbuf())) {
        if (stream && fs::file_size(file, failed) == 0) return {};
        throw Error(ErrorCode::Input, "cannot read '" + file.string() + "'");
    }
    return content.str();
}

}  // namespace ombrage
