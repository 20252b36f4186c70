// SPDX-License-Identifier: MIT
#include "scene/asset_path.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <ombrage/error.h>

#include "core/strings.h"
#include "scene/load_record.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {
/// Indices of 32 bits and the model library's own limits end near here.
constexpr std::uintmax_t kLargestFile = std::uintmax_t(4) << 30;

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

std::optional<fs::path> search(const fs::path& folder, const std::string& name) {
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
}  // namespace

std::optional<fs::path> findAsset(const fs::path& folder, const std::string& name) {
    const std::optional<fs::path> found = search(folder, name);
    LoadRecord::search(folder, name, found);
    return found;
}

std::string whyNotFound(const fs::path& folder, const std::string& name) {
    std::string slashes = trim(name);
    if (slashes.find('\0') != std::string::npos) return "is missing";
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    std::error_code failed;
    const fs::path place = folder / slashes;  // an absolute path stays as it is
    const fs::file_status status = fs::status(place, failed);
    LoadRecord::presence(place, fs::exists(status));
    if (fs::is_directory(status)) return "is a folder";
    return fs::exists(status) ? "is no file but a pipe, a socket or a device" : "is missing";
}

std::string readWholeFile(const fs::path& file) {
    std::error_code failed;
    const fs::file_status status = fs::status(file, failed);
    if (fs::is_directory(status))
        throw Error(ErrorCode::Input, "'" + file.string() + "' is a folder", "name a file in it");
    // A pipe makes its reader wait, a device may have no end.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(ErrorCode::Input, "'" + file.string() + "' is not a regular file");
    if (const std::uintmax_t size = fs::file_size(file, failed); !failed && size > kLargestFile)
        throw Error(ErrorCode::Input,
                    "'" + file.string() + "' holds " + std::to_string(size >> 20) + " MiB; files of more than " +
                        std::to_string(kLargestFile >> 20) + " MiB are not read",
                    "split it into several models");
    LoadRecord::content(file);
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    if (!stream || !(content << stream.rdbuf())) {
        if (stream && fs::file_size(file, failed) == 0) return {};
        throw Error(ErrorCode::Input, "cannot read '" + file.string() + "'");
    }
    return content.str();
}

}  // namespace ombrage
