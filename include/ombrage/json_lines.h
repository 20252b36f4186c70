// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <unordered_map>

#include <ombrage/error.h>

namespace ombrage {

/// Where the values of a JSON text stand. For files that people write: what a parser would take or drop silently is
/// refused, with its line.
class JsonLines {
public:
    /// @param file stands in messages
    /// @throws Error(Input) whose where() is "FILE:LINE" for bad syntax, zero bytes and numbers beyond the range of
    /// double,
    ///         "FILE:LINE: /json/pointer" for a key given twice and for more than 32 levels of nesting
    JsonLines(std::string file, const std::string& text);

    /// "FILE:LINE: /json/pointer" of a value; the pointer of the whole text is "".
    std::string where(const std::string& pointer) const;
    /// An Error(Input) at a value.
    Error error(const std::string& pointer, const std::string& message, const std::string& hint = {}) const;

private:
    void index(const std::string& text);

    std::string m_file;
    std::unordered_map<std::string, int> m_lines;  ///< by JSON pointer
};

/// A key as it stands in a JSON pointer: "~" is "~0", "/" is "~1".
std::string escapedKey(const std::string& key);

}  // namespace ombrage
