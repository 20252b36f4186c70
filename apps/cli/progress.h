// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace ombrage::cli {

/// Makes Ctrl-C set a flag; a second one ends the program at once.
void catchInterrupt();
bool interrupted();

/// Shows long work on standard error: a bar with the time left on a terminal, otherwise a line for every new step.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @return false when the user asked to stop; the form that the library's callbacks want.
    bool operator()(const std::string& what, double share);

    /// Takes the bar away, so that a message can stand in its place.
    static void clearLine();

private:
    std::chrono::steady_clock::time_point m_start, m_drawn;
    std::string m_what;
    bool m_terminal;
};

}  // namespace ombrage::cli
