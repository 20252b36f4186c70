// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ombrage::bad_inputs {

/// How one run of the program ended.
struct Run {
    int signal = 0;     ///< that killed it, or 0
    int code = 0;       ///< exit code
    bool hung = false;  ///< did not end in time and was killed
    double time_s = 0;
    double memory_MiB = 0;  ///< the largest resident set of the program or of a process that it started
    std::string messages;   ///< standard error
};

/// Runs a program in `folder`, which must be there, for at most `limit_s` seconds, without the scene cache.
Run run(const std::vector<std::string>& command, const std::filesystem::path& folder, double limit_s);

}  // namespace ombrage::bad_inputs
