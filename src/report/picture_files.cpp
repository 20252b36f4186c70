// SPDX-License-Identifier: MIT
#include "report/picture_files.h"

#include <ombrage/error.h>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "report/html_text.h"

namespace ombrage {

namespace {

/// Record paths stay inside the folder; anything else is treated as missing.
bool isInside(const std::filesystem::path& path) {
    return path.is_relative() && std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

std::vector<unsigned char> readBytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool isPicture(const std::vector<unsigned char>& bytes, const std::string& name) {
    try {
        return !bytes.empty() && !decodeImage(bytes, name).empty();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

PictureFiles::PictureFiles(const std::filesystem::path& folder, const std::vector<RunRecord>& records) {
    for (const RunRecord& record : records)
        for (const auto& [kind, path] : record.images) {
            if (m_files.count(path) != 0) continue;
            std::vector<unsigned char> png;
            if (isInside(path)) png = readBytes(folder / path);
            if (isPicture(png, path))
                m_files.emplace(path, File{kind, std::move(png)});
            else if (std::find(m_missing.begin(), m_missing.end(), path) == m_missing.end())
                m_missing.push_back(path);
        }
}

Image PictureFiles::decoded(const RunRecord& record, const std::string& kind) const {
    const auto path = record.images.find(kind);
    if (path == record.images.end()) return {};
    const auto file = m_files.find(path->second);
    return file == m_files.end() ? Image() : decodeImage(file->second.png, path->second);
}

std::string pngUri(const std::vector<unsigned char>& png) {
    return "data:image/png;base64," + base64(png);
}

}  // namespace ombrage
