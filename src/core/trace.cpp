// SPDX-License-Identifier: MIT
#include "core/trace.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <vector>

#include <ombrage/error.h>
#include <ombrage/version.h>
#include <nlohmann/json.hpp>

namespace ombrage {

namespace {

using Json = nlohmann::ordered_json;

// The GPU is shown as a process of its own, so that its passes stand together below the threads of the CPU.
constexpr int kCpuProcess = 1, kGpuProcess = 2, kGpuThread = 1;

struct Event {
    std::string name, detail;
    std::int64_t begin_ns = 0, end_ns = 0;
    int thread = 0;  ///< 0: the GPU
};

struct Collector {
    std::mutex mutex;
    std::vector<Event> events;
    std::map<std::string, std::string> facts;
    std::string gpuClock;
    std::uint64_t dropped = 0;
    std::int64_t start_ns = 0;
};

Collector& collector() {
    static Collector instance;
    return instance;
}

/// Number of the trace that collects, 0: none.
std::atomic<std::uint64_t> g_active = 0;
std::atomic<std::uint64_t> g_made = 0;

/// 1 for the first thread that ends a scope, and so on.
int threadNumber() {
    static std::atomic<int> last = 0;
    thread_local const int mine = ++last;
    return mine;
}

void keep(std::uint64_t trace, Event&& event) {
    Collector& to = collector();
    const std::lock_guard lock(to.mutex);
    // A scope may outlive its trace.
    if (g_active.load(std::memory_order_relaxed) != trace) return;
    if (to.events.size() < Trace::kMostEvents)
        to.events.push_back(std::move(event));
    else
        ++to.dropped;
}

std::string toText(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json nameOf(const char* kind, int process, int thread, const std::string& name) {
    Json json{{"name", kind}, {"ph", "M"}, {"pid", process}};
    if (thread > 0) json["tid"] = thread;
    json["args"] = {{"name", name}};
    return json;
}

Json spanOf(const Event& event, std::int64_t start_ns, const std::string& gpuClock) {
    const bool gpu = event.thread == 0;
    Json json{{"name", event.name},
              {"cat", gpu ? "gpu" : "cpu"},
              {"ph", "X"},
              {"ts", double(event.begin_ns - start_ns) * 1e-3},
              {"dur", double(event.end_ns - event.begin_ns) * 1e-3},
              {"pid", gpu ? kGpuProcess : kCpuProcess},
              {"tid", gpu ? kGpuThread : event.thread}};
    if (gpu) json["args"] = {{"clock", gpuClock}};
    if (!event.detail.empty()) json["args"]["detail"] = event.detail;
    return json;
}

}  // namespace

bool isTracing() {
    return g_active.load(std::memory_order_relaxed) != 0;
}

std::int64_t traceTime_ns() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

void traceGpuSpan(const std::string& name, std::int64_t begin_ns, std::int64_t end_ns, const char* clock) {
    const std::uint64_t trace = g_active.load(std::memory_order_relaxed);
    if (trace == 0) return;
    {
        const std::lock_guard lock(collector().mutex);
        collector().gpuClock = clock;
    }
    keep(trace, {name, {}, begin_ns, end_ns, 0});
}

void traceFact(const std::string& key, const std::string& value) {
    if (!isTracing()) return;
    const std::lock_guard lock(collector().mutex);
    collector().facts[key] = value;
}

Trace::Trace() {
    Collector& to = collector();
    const std::lock_guard lock(to.mutex);
    if (isTracing()) throw Error(ErrorCode::Usage, "a trace is being collected already", "end it first");
    to.events.clear();
    to.facts.clear();
    to.gpuClock.clear();
    to.dropped = 0;
    to.start_ns = traceTime_ns();
    g_active = ++g_made;
}

Trace::~Trace() {
    Collector& from = collector();
    const std::lock_guard lock(from.mutex);
    g_active = 0;
    from.events = {};
}

std::string Trace::json() const {
    Collector& from = collector();
    const std::lock_guard lock(from.mutex);
    std::string text = "{\"displayTimeUnit\":\"ms\",\"otherData\":";
    Json facts{{"version", versionString()}, {"clock", from.gpuClock.empty() ? Json(nullptr) : Json(from.gpuClock)}};
    for (const auto& [key, value] : from.facts) facts[key] = value;
    facts["dropped_events"] = from.dropped;
    text += toText(facts) + ",\n\"traceEvents\":[\n";

    // Names first; then the spans by their start, the longer one first where two start together: outer before inner.
    text += toText(nameOf("process_name", kCpuProcess, 0, "ombrage"));
    std::vector<int> threads;
    std::vector<const Event*> order;
    for (const Event& event : from.events) {
        order.push_back(&event);
        if (std::find(threads.begin(), threads.end(), event.thread) == threads.end()) threads.push_back(event.thread);
    }
    std::sort(threads.begin(), threads.end());
    for (const int thread : threads) {
        if (thread == 0) {
            text += ",\n" + toText(nameOf("process_name", kGpuProcess, 0, "GPU"));
            text += ",\n" + toText(nameOf("thread_name", kGpuProcess, kGpuThread, "passes, clock: " + from.gpuClock));
        } else {
            text += ",\n" + toText(nameOf("thread_name", kCpuProcess, thread, "thread " + std::to_string(thread)));
        }
    }
    std::stable_sort(order.begin(), order.end(), [](const Event* a, const Event* b) {
        return a->begin_ns != b->begin_ns ? a->begin_ns < b->begin_ns : a->end_ns > b->end_ns;
    });
    for (const Event* event : order) text += ",\n" + toText(spanOf(*event, from.start_ns, from.gpuClock));
    return text + "\n]}\n";
}

TraceScope::TraceScope(std::string_view name, std::string_view detail)
    : m_trace(g_active.load(std::memory_order_relaxed)) {
    if (m_trace == 0) return;
    m_name = name;
    m_detail = detail;
    m_begin_ns = traceTime_ns();
}

void TraceScope::end() {
    if (m_trace == 0) return;
    const std::int64_t end_ns = traceTime_ns();
    keep(m_trace, {std::move(m_name), std::move(m_detail), m_begin_ns, end_ns, threadNumber()});
    m_trace = 0;
}

}  // namespace ombrage
