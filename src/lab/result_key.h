// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ombrage {

/// Everything that decides a result, as one text, and a hash of it. Two results with one key are the same measurement
/// done twice.
class ResultKey {
public:
    /// @param kind what made the result: "compare"
    explicit ResultKey(std::string kind) : m_kind(std::move(kind)) {}

    /// Names are added in a fixed order; the order counts.
    ResultKey& add(std::string name, std::string value);
    ResultKey& add(std::string name, double value);
    ResultKey& add(std::string name, std::uint64_t value);
    ResultKey& add(std::string name, int value) { return add(std::move(name), double(value)); }

    const std::string& kind() const { return m_kind; }
    /// A JSON object on one line, the kind first.
    std::string text() const;
    std::string hash() const;  ///< of the text: 16 hexadecimal digits

private:
    std::string m_kind;
    std::vector<std::pair<std::string, std::string>> m_values;
};

}  // namespace ombrage
