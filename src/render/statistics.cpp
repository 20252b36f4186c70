// SPDX-License-Identifier: MIT
#include "render/statistics.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace ombrage {

Stats statsOf(std::vector<double> samples) {
    if (samples.empty()) return {};
    std::sort(samples.begin(), samples.end());
    const std::size_t n = samples.size();
    const double median = n % 2 == 1 ? samples[n / 2] : (samples[n / 2 - 1] + samples[n / 2]) * 0.5;
    const auto rank = std::size_t(std::ceil(0.95 * double(n)));
    return {median, samples[std::max<std::size_t>(rank, 1) - 1]};
}

double threadTime_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

}  // namespace ombrage
