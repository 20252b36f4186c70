// SPDX-License-Identifier: MIT
#include "trace_file.h"

#include <ombrage/error.h>
#include <unistd.h>
#include <fstream>
#include <system_error>

#include "commands.h"

namespace ombrage::cli {

TraceFile::TraceFile(const std::string& file) : m_file(file) {
    write();
}

TraceFile::~TraceFile() {
    if (!m_isOpen) return;
    try {
        close();
    } catch (const std::exception& error) {
        printMessage(std::string("warning: ") + error.what());
    }
}

void TraceFile::close() {
    m_isOpen = false;
    write();
}

void TraceFile::write() const {
    const auto fail = [&](const std::string& why) {
        return Error(ErrorCode::Environment, "cannot write the trace '" + m_file.string() + "': " + why,
                     "check the folder's permissions and the free space");
    };
    std::error_code failed;
    if (m_file.has_parent_path()) std::filesystem::create_directories(m_file.parent_path(), failed);
    if (std::filesystem::is_directory(m_file, failed)) throw fail("it is a folder");
    const std::filesystem::path part = m_file.string() + "." + std::to_string(::getpid()) + ".part";
    std::ofstream out(part, std::ios::binary);
    out << m_trace.json();
    out.close();
    if (out)
        std::filesystem::rename(part, m_file, failed);
    else
        failed = std::make_error_code(std::errc::io_error);
    if (!failed) return;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw fail(failed.message());
}

}  // namespace ombrage::cli
