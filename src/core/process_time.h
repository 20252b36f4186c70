// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace ombrage {

/// Processor time of all threads of this process so far, in ms: what a frame of a software renderer costs, whoever else
/// uses the machine.
inline double processTime_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

}  // namespace ombrage
