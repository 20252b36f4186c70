// SPDX-License-Identifier: MIT
#include "cli/cli_fixture.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ombrage::test {

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void Cli::SetUp() {
    m_folder = fs::path(testing::TempDir()) /
               (std::string("ombrage_cli_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
}

void Cli::TearDown() {
    fs::remove_all(m_folder);
}

pid_t Cli::start(std::vector<std::string> arguments, const Environment& environment,
                 const std::function<int()>& prepare) {
    arguments.insert(arguments.begin(), OMBRAGE_PROGRAM);
    const pid_t child = fork();
    if (child != 0) return child;
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    const auto redirect = [&](const char* file, int target) {
        dup2(open((m_folder / file).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), target);
    };
    redirect("stdout", STDOUT_FILENO);
    redirect("stderr", STDERR_FILENO);
    if (chdir(m_folder.c_str()) != 0) _exit(99);
    if (const int failed = prepare ? prepare() : 0) _exit(failed);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(OMBRAGE_PROGRAM, pointers.data());
    _exit(98);
}

Result Cli::finish(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), content(m_folder / "stdout"),
            content(m_folder / "stderr")};
}

Result Cli::run(const std::vector<std::string>& arguments, const Environment& environment) {
    return finish(start(arguments, environment));
}

std::vector<std::string> Cli::untimed(const char* folder) {
    std::vector<std::string> records;
    std::istringstream in(content(m_folder / folder / "records.jsonl"));
    for (std::string line; std::getline(in, line);) {
        Json record = Json::parse(line);
        record.erase("gpu_ms");
        record.erase("cpu_ms");
        for (Json& pass : record["passes"]) pass.erase("gpu_ms");
        // The folders differ in name only: the pictures must be there and equal.
        for (const auto& [kind, path] : record["images"].items())
            record["images"][kind] = {path, content(m_folder / folder / path.get<std::string>()).size()};
        records.push_back(record.dump());
    }
    std::sort(records.begin(), records.end());
    return records;
}

void Cli::expectSame(const std::vector<std::string>& found, const std::vector<std::string>& expected) {
    std::vector<std::string> missing, extra;
    std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(), std::back_inserter(missing));
    std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(extra));
    for (const std::string& record : missing) ADD_FAILURE() << "missing: " << record;
    for (const std::string& record : extra) ADD_FAILURE() << "not expected: " << record;
}

std::string Cli::idOf(const std::string& family) {
    const Json json = Json::parse(run({"list", "--family", family, "--json"}).out);
    return json["techniques"].size() > 1 ? json["techniques"][1]["id"] : json["techniques"][0]["id"];
}

void Cli::expectUsageError(const std::vector<std::string>& arguments, const std::string& message) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
}

}  // namespace ombrage::test
