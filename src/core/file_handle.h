// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <unistd.h>

namespace ombrage {

/// An open file of the system, closed at the end; -1: none.
class FileHandle {
public:
    explicit FileHandle(int file = -1) : m_file(file) {}
    ~FileHandle() { close(); }
    FileHandle(FileHandle&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
    FileHandle& operator=(FileHandle&& other) noexcept {
        if (this != &other) {
            close();
            m_file = std::exchange(other.m_file, -1);
        }
        return *this;
    }
    int get() const { return m_file; }
    bool isOpen() const { return m_file >= 0; }
    /// False when closing told of a write that failed.
    bool close() {
        const int file = std::exchange(m_file, -1);
        return file < 0 || ::close(file) == 0;
    }

private:
    int m_file;
};

}  // namespace ombrage
