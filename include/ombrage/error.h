// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ombrage {

/// What went wrong, seen from the caller. The value is the exit code of the command line (design: "The command line").
enum class ErrorCode {
    GateFailed = 1,    ///< a comparison or gate did not hold
    Usage = 2,         ///< a wrong name, option, parameter or range
    Input = 3,         ///< a file that cannot be read or used
    Environment = 4,   ///< no OpenGL 4.5, a shader that the driver refuses, a full disk
    Interrupted = 130  ///< stopped by the user
};

/// The one exception of the library. It is thrown for bad files, parameters, shaders and drivers; broken invariants
/// assert instead, and likely local failures are std::optional. The library never exits and never prints.
class Error : public std::runtime_error {
public:
    /// @param code    class of the error
    /// @param message what is wrong, one sentence, naming the offending value
    /// @param hint    what to do about it, one sentence; may be empty
    /// @param where   "file:line: /json/path" or "shader:line"; may be empty
    Error(ErrorCode code, const std::string& message, std::string hint = {}, std::string where = {});

    ErrorCode code() const noexcept { return m_code; }
    const std::string& message() const noexcept { return m_message; }
    const std::string& hint() const noexcept { return m_hint; }
    const std::string& where() const noexcept { return m_where; }

private:
    ErrorCode m_code;
    std::string m_message;
    std::string m_hint;
    std::string m_where;
};

/// The member of `candidates` nearest to `name` in edit distance (transpositions count 1), or "" when none is near
/// enough (more than max(2, length/3) edits) to be worth suggesting.
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// "unknown KIND 'NAME'" with the nearest candidate in the hint, or the list of all of them when none is near.
Error unknownName(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates);

}  // namespace ombrage
