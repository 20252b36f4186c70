// SPDX-License-Identifier: MIT
#include "core/whole_file.h"

#include <chrono>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::path(testing::TempDir()) / "ombrage_whole_file";
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string content(const char* name) const {
        std::ifstream in(m_folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::ptrdiff_t fileCount() const { return std::distance(fs::directory_iterator(m_folder), {}); }

    fs::path m_folder;
};

TEST_F(WholeFile, TakesThePlaceOfTheOldOneAndLeavesNothingElse) {
    writeWhole(m_folder / "a.txt", std::string_view("one"));
    writeWhole(m_folder / "a.txt", std::string_view("two"));
    EXPECT_EQ(content("a.txt"), "two");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(WholeFile, OldOneStandsUntilTheNewOneIsWhole) {
    writeWhole(m_folder / "a.txt", std::string_view("one"));
    writeWhole(m_folder / "a.txt", [&](const fs::path& part) {
        EXPECT_EQ(part.extension(), ".txt");
        std::ofstream(part) << "two";
        EXPECT_EQ(content("a.txt"), "one");
    });
    EXPECT_EQ(content("a.txt"), "two");
}

TEST_F(WholeFile, FailureKeepsTheOldOne) {
    writeWhole(m_folder / "a.txt", std::string_view("one"));
    EXPECT_THROW(writeWhole(m_folder / "a.txt",
                            [](const fs::path& part) {
                                std::ofstream(part) << "half";
                                throw Error(ErrorCode::Environment, "full");
                            }),
                 Error);
    EXPECT_EQ(content("a.txt"), "one");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(WholeFile, LinksStayLinksAndDevicesStayDevices) {
    fs::create_symlink(m_folder / "a.txt", m_folder / "link.txt");
    writeWhole(m_folder / "a.txt", std::string_view("one"));
    writeWhole(m_folder / "link.txt", std::string_view("two"));
    EXPECT_TRUE(fs::is_symlink(m_folder / "link.txt"));
    EXPECT_EQ(content("a.txt"), "two");
    writeWhole("/dev/null", std::string_view("gone"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(WholeFile, FolderThatIsMissingIsAnEnvironmentError) {
    try {
        writeWhole(m_folder / "no-such-folder" / "a.txt", std::string_view("one"));
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Environment);
    }
}

TEST_F(WholeFile, OnlyWhatWasLeftLongAgoIsSweptUp) {
    fs::path left;
    try {
        writeWhole(m_folder / "a.png", [&](const fs::path& part) {
            left = part;
            throw 1;
        });
    } catch (int) {
    }
    const fs::path recent = m_folder / ".b.1.0.part.png", kept = m_folder / "c.part.png";
    for (const fs::path& file : {left, recent, kept}) std::ofstream(file) << "x";
    for (const fs::path& file : {left, kept})
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(2));
    removeUnfinished(m_folder);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(recent));
    EXPECT_TRUE(fs::exists(kept));
}

}  // namespace
}  // namespace ombrage
