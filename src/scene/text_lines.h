// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace ombrage {

/// The lines of a text. LF, CR LF and CR end a line; one whose last character is a backslash goes on in the next, with
/// a blank between; comments (#) end with their line. A byte order mark of UTF-8 before the first is no part of it.
class TextLines {
public:
    /// The text must outlive this object.
    explicit TextLines(std::string_view text) : m_rest(text) {
        constexpr std::string_view kMark = "\xEF\xBB\xBF";
        if (m_rest.substr(0, kMark.size()) == kMark) m_rest.remove_prefix(kMark.size());
    }

    /// False at the end. The view holds until the next call.
    bool next(std::string_view& line);
    /// Number, from 1, of the first line of those that next() put together.
    int number() const { return m_number; }

private:
    std::string_view takePhysical();

    std::string_view m_rest;
    std::string m_joined;
    int m_number = 0;
    int m_nextNumber = 1;
};

}  // namespace ombrage
