// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ombrage::bad_inputs {

/// A file that reads well, to be cut short.
struct GoodFile {
    std::string kind;    ///< as the table names it
    std::string opened;  ///< what the program opens, in the folder of the file
    std::string cut;     ///< what is cut: `opened` or something that it names
    std::filesystem::path folder;
};

/// Writes one small file of every kind below `folder`.
std::vector<GoodFile> writeGoodFiles(const std::filesystem::path& folder);

/// Those of the test data that are there.
std::vector<GoodFile> realFiles(const std::filesystem::path& data);

void writeFile(const std::filesystem::path& file, const std::string& content);
std::string readFile(const std::filesystem::path& file);

}  // namespace ombrage::bad_inputs
