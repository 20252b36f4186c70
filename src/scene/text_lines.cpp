// SPDX-License-Identifier: MIT
#include "scene/text_lines.h"

#include <algorithm>

namespace ombrage {

std::string_view TextLines::takePhysical() {
    const auto isEnd = [](char c) { return c == '\n' || c == '\r'; };
    const auto end = std::size_t(std::find_if(m_rest.begin(), m_rest.end(), isEnd) - m_rest.begin());
    const std::string_view line = m_rest.substr(0, end);
    const bool pair = end + 1 < m_rest.size() && m_rest[end] == '\r' && m_rest[end + 1] == '\n';
    m_rest.remove_prefix(std::min(end + (pair ? 2 : 1), m_rest.size()));
    ++m_nextNumber;
    return line;
}

bool TextLines::next(std::string_view& line) {
    if (m_rest.empty()) return false;
    m_number = m_nextNumber;
    line = takePhysical();
    if (line.empty() || line.back() != '\\' || line[0] == '#') return true;
    m_joined.clear();
    while (!line.empty() && line.back() == '\\') {
        m_joined.append(line.substr(0, line.size() - 1));
        m_joined += ' ';
        line = m_rest.empty() ? std::string_view() : takePhysical();
    }
    m_joined.append(line);
    line = m_joined;
    return true;
}

}  // namespace ombrage
