// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/image.h>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lab/run_record.h"

namespace ombrage {

/// The pictures that records name, as the files that they are. Decoded one at a time: all at once take gigabytes.
class PictureFiles {
public:
    struct File {
        std::string kind;                ///< "visibility"
        std::vector<unsigned char> png;  ///< never empty
    };

    PictureFiles(const std::filesystem::path& folder, const std::vector<RunRecord>& records);

    /// By the path in the record.
    const std::map<std::string, File>& files() const { return m_files; }

    /// Paths that could not be read or lie outside the folder.
    const std::vector<std::string>& missing() const { return m_missing; }

    /// The record's picture of this kind; empty where there is none.
    Image decoded(const RunRecord& record, const std::string& kind) const;

private:
    std::map<std::string, File> m_files;
    std::vector<std::string> m_missing;
};

/// "data:image/png;base64,..."
std::string pngUri(const std::vector<unsigned char>& png);

}  // namespace ombrage
