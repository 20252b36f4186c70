// SPDX-License-Identifier: MIT
// Bandwidth of a device's memory, from copies of a buffer much larger than its caches: every byte is read once and
// written once. Prints JSON with the median over the copies.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <ombrage/error.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "gl/context.h"
#include "gl/gpu_timer.h"
#include "gl/objects.h"

namespace ombrage::bench {
namespace {

int run(const std::string& device, std::size_t megabytes, int copies) {
    const auto context = gl::Context::createHeadless({device, false});
    gl::GpuTimer timer;
    const std::size_t bytes = megabytes << 20;
    const gl::Buffer source(bytes, nullptr, "source"), target(bytes, nullptr, "target");
    std::vector<double> rates;
    constexpr int kWarmup = 3;  // first touches of the memory
    for (int i = 0; i < copies + kWarmup; ++i) {
        timer.begin("copy");
        glCopyNamedBufferSubData(source.id(), target.id(), 0, 0, GLsizeiptr(bytes));
        timer.end();
        for (const auto& span : timer.take())
            if (i >= kWarmup) rates.push_back(2.0 * double(bytes) / (span.time_ms * 1e-3) * 1e-9);
    }
    std::sort(rates.begin(), rates.end());
    const nlohmann::json json{{"renderer", context->renderer()},
                              {"clock", gl::clockName(timer.clock())},
                              {"megabytes", megabytes},
                              {"copies", copies},
                              {"gigabytes_per_second", rates[rates.size() / 2]}};
    fmt::print("{}\n", json.dump(1));
    return 0;
}

}  // namespace
}  // namespace ombrage::bench

int main(int argc, char** argv) {
    std::string device;
    std::size_t megabytes = 256;
    int copies = 20;
    CLI::App app("Bandwidth of a device's memory");
    app.add_option("--device", device, "software, or the index of an EGL device");
    app.add_option("--megabytes", megabytes, "size of the buffer")->check(CLI::Range(1, 4096));
    app.add_option("--copies", copies)->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        return ombrage::bench::run(device, megabytes, copies);
    } catch (const ombrage::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
