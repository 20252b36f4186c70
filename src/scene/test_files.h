// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace ombrage {

/// A folder for one test, removed with everything in it.
class TestFolder {
public:
    TestFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "ombrage-scene-XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::string write(const std::string& name, const std::string& content) const {
        const std::filesystem::path file = m_path / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << content;
        return file.string();
    }
    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

/// One triangle.
inline const char* const kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace ombrage

/// The path of a file of the real test data, or a loud skip.
#define OMBRAGE_DATA_FILE(variable, relative)                                                             \
    const char* const variable##Folder = std::getenv("OMBRAGE_DATA");                                     \
    if (variable##Folder == nullptr) GTEST_SKIP() << "SKIPPED: OMBRAGE_DATA is not set, no " << relative; \
    const std::string variable = std::string(variable##Folder) + "/" + relative
