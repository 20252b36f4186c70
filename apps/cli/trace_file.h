// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/trace.h>
#include <filesystem>
#include <string>

namespace ombrage::cli {

/// Traces while it lives and then writes the trace, whether the work was done, failed or was interrupted. From the
/// start the file holds a whole document, an empty trace, so that one that a killed process leaves is valid too.
class TraceFile {
public:
    /// @throws Error(Environment) when the file cannot be written.
    explicit TraceFile(const std::string& file);
    /// Writes the trace when close() was not reached; a failure is then a warning.
    ~TraceFile();
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;

    /// Writes the trace. @throws Error(Environment)
    void close();

private:
    /// Replaces the file as a whole.
    void write() const;

    std::filesystem::path m_file;
    Trace m_trace;
    bool m_isOpen = true;
};

}  // namespace ombrage::cli
