// SPDX-License-Identifier: MIT
// The program from outside: exit codes, streams, files. OMBRAGE_PROGRAM names the binary.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ombrage::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// All bytes of a file; none when it cannot be read.
std::string content(const fs::path& file);

/// What a run of the program left. A run that a signal ended has the code 1000 + signal.
struct Result {
    int code = -1;
    std::string out, err;
};

/// Runs the program in a folder of the test's own.
class Cli : public testing::Test {
protected:
    using Environment = std::vector<std::pair<std::string, std::string>>;

    void SetUp() override;
    void TearDown() override;

    /// @param prepare  runs in the child before the program; what is not 0 becomes the exit code in its place
    pid_t start(std::vector<std::string> arguments, const Environment& environment = {},
                const std::function<int()>& prepare = {});
    Result finish(pid_t child);
    Result run(const std::vector<std::string>& arguments, const Environment& environment = {});

    /// The records of a folder without what is measured with a clock, sorted; every line is whole.
    std::vector<std::string> untimed(const char* folder);

    /// Shows the records that differ, and no others.
    static void expectSame(const std::vector<std::string>& found, const std::vector<std::string>& expected);

    /// The first id of the family beside its baseline.
    std::string idOf(const std::string& family);

    void expectUsageError(const std::vector<std::string>& arguments, const std::string& message);

    fs::path m_folder;
};

}  // namespace ombrage::test
