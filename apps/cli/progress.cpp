// SPDX-License-Identifier: MIT
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <cstdlib>

namespace ombrage::cli {

namespace {

volatile std::sig_atomic_t g_interrupted = 0;
bool g_barOnScreen = false;

void onInterrupt(int) {
    g_interrupted = 1;
}

/// Colours and bars are for terminals that understand them.
bool plainTerminal() {
    const char* term = std::getenv("TERM");
    return term == nullptr || std::string(term) == "dumb";
}

bool noColor() {
    const char* value = std::getenv("NO_COLOR");
    return value != nullptr && *value != '\0';
}

}  // namespace

void catchInterrupt() {
    struct sigaction action = {};
    action.sa_handler = onInterrupt;
    action.sa_flags = int(SA_RESETHAND);  // the second one acts as it always does
    sigaction(SIGINT, &action, nullptr);
}

bool interrupted() {
    return g_interrupted != 0;
}

Progress::Progress()
    : m_start(std::chrono::steady_clock::now()), m_terminal(isatty(STDERR_FILENO) == 1 && !plainTerminal()) {}

Progress::~Progress() {
    clearLine();
}

void Progress::clearLine() {
    if (g_barOnScreen) fmt::print(stderr, "\r\x1b[K");
    g_barOnScreen = false;
}

bool Progress::operator()(const std::string& what, double share) {
    using namespace std::chrono;
    const bool isNew = what != m_what;
    m_what = what;
    if (!m_terminal) {
        if (isNew) fmt::print(stderr, "[{:3.0f} %] {}\n", 100 * share, what);
        return !interrupted();
    }
    // Ten pictures a second are enough for the eye.
    const auto now = steady_clock::now();
    if (!isNew && now - m_drawn < milliseconds(100)) return !interrupted();
    m_drawn = now;
    const double elapsed_s = duration<double>(now - m_start).count();
    constexpr int kCells = 24;
    const int full = std::clamp(int(share * kCells + 0.5), 0, kCells);
    const std::string left = share > 0.02 ? fmt::format(", {:.0f} s left", elapsed_s / share * (1 - share)) : "";
    const std::string text = fmt::format("{:3.0f} %{} {}", 100 * share, left, what).substr(0, 90);
    fmt::print(stderr, "\r\x1b[K{}[{}{}]{} {}", noColor() ? "" : "\x1b[36m", std::string(std::size_t(full), '#'),
               std::string(std::size_t(kCells - full), '.'), noColor() ? "" : "\x1b[0m", text);
    std::fflush(stderr);
    g_barOnScreen = true;
    return !interrupted();
}

}  // namespace ombrage::cli
