// SPDX-License-Identifier: MIT
#include "core/log.h"

#include <mutex>
#include <utility>

namespace ombrage {

namespace {

struct SinkHolder {
    std::mutex mutex;
    LogSink sink;
};

SinkHolder& holder() {
    static SinkHolder instance;
    return instance;
}

}  // namespace

LogSink setLogSink(LogSink sink) {
    const std::lock_guard lock(holder().mutex);
    return std::exchange(holder().sink, std::move(sink));
}

void log(LogLevel level, const std::string& message) {
    const std::lock_guard lock(holder().mutex);
    if (holder().sink) holder().sink(level, message);
}

}  // namespace ombrage
