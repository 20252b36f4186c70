// SPDX-License-Identifier: MIT
// The figures that the first systems of this kind published: frames per second, share of the processor, memory.
#include <ombrage/bench.h>
#include <ombrage/error.h>
#include <unistd.h>
#include <chrono>
#include <fstream>
#include <limits>
#include <locale>

#include "core/process_time.h"
#include "lab/statistics.h"

namespace ombrage {

namespace {

/// Pages of this process in memory; 0 where the system does not tell.
double residentPages() {
    std::ifstream in("/proc/self/statm");
    double whole = 0, resident = 0;
    in.imbue(std::locale::classic());
    in >> whole >> resident;
    return in ? resident : 0;
}

}  // namespace

ProgramFigures measureProgram(const Scene& scene, const RenderSettings& settings, int seconds,
                              const RendererOptions& options) {
    using Clock = std::chrono::steady_clock;
    Renderer renderer(options);
    renderer.setScene(scene);
    RenderSettings endless = settings;
    endless.timing = Timing::Frame;
    endless.warmupFrames = 0;
    endless.frames = std::numeric_limits<int>::max();

    // Called between frames: whole frames of every second, the first of which only warms up.
    ProgramFigures figures;
    Clock::time_point second{};
    double startTime_ms = 0, wall_s = 0, cpu_ms = 0;
    int frames = -1;
    bool warm = false, stopped = false;
    endless.progress = [&](double share) {
        if (settings.progress && !settings.progress(share)) {
            stopped = true;
            return false;
        }
        const Clock::time_point now = Clock::now();
        const double passed_s = std::chrono::duration<double>(now - second).count();
        if (frames >= 0) ++frames;
        if (frames >= 0 && passed_s < 1) return true;
        const double time_ms = processTime_ms();
        if (frames > 0 && warm) {
            figures.fpsOfSeconds.push_back(frames / passed_s);
            wall_s += passed_s;
            cpu_ms += time_ms - startTime_ms;
        }
        warm = frames > 0;
        second = now;
        startTime_ms = time_ms;
        frames = 0;
        return int(figures.fpsOfSeconds.size()) < seconds;
    };
    try {
        renderer.render(endless);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::Interrupted || stopped) throw;
    }
    figures.scene = scene.name;
    figures.fps = medianOf(figures.fpsOfSeconds);
    figures.cpuPercent = 100 * cpu_ms / (1000 * wall_s);
    figures.memory_MiB = residentPages() * double(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
    figures.memoryPercent = 100 * residentPages() / double(sysconf(_SC_PHYS_PAGES));
    figures.device = renderer.device();
    return figures;
}

}  // namespace ombrage
