// SPDX-License-Identifier: MIT
#include "program_run.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ombrage::bad_inputs {

Run run(const std::vector<std::string>& command, const std::filesystem::path& folder, double limit_s) {
    using Clock = std::chrono::steady_clock;
    const std::string messages = (folder / "messages.txt").string();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_t child = -1;
    const auto start = Clock::now();
    const int failed = posix_spawn(&child, command[0].c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("cannot run " + command[0]);

    Run result;
    int status = 0;
    rusage usage{};
    const auto elapsed_s = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    while (wait4(child, &status, WNOHANG, &usage) == 0) {
        if (elapsed_s() > limit_s && !result.hung) {
            result.hung = true;
            kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    result.time_s = elapsed_s();
    result.memory_MiB = double(usage.ru_maxrss) / 1024;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    std::ifstream in(messages, std::ios::binary);
    result.messages.assign(std::istreambuf_iterator<char>(in), {});
    return result;
}

}  // namespace ombrage::bad_inputs
