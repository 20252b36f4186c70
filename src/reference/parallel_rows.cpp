// SPDX-License-Identifier: MIT
#include "reference/parallel_rows.h"

#include <atomic>
#include <mutex>

#include <ombrage/error.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace ombrage {

void parallelRows(int height, const ReferenceOptions& options, const std::function<void(int)>& row) {
    if (options.threads < 0)
        throw Error(ErrorCode::Usage, "threads is " + std::to_string(options.threads),
                    "Use 0 for all or a positive number.");
    std::mutex progressMutex;
    int done = 0;
    std::atomic<bool> stopped{false};

    // An arena of its own keeps to the thread count and apart from the caller's work.
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::task_group_context group;
        tbb::parallel_for(
            tbb::blocked_range<int>(0, height, 1),
            [&](const tbb::blocked_range<int>& range) {
                for (int y = range.begin(); y < range.end() && !stopped; ++y) {
                    row(y);
                    if (!options.progress) continue;
                    const std::lock_guard lock(progressMutex);
                    ++done;
                    if (!stopped && !options.progress(double(done) / height)) {
                        stopped = true;
                        group.cancel_group_execution();
                    }
                }
            },
            tbb::simple_partitioner(), group);
    });
    if (stopped) throw Error(ErrorCode::Interrupted, "the reference was interrupted");
}

}  // namespace ombrage
