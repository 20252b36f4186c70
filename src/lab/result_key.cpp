// SPDX-License-Identifier: MIT
#include "lab/result_key.h"

#include <nlohmann/json.hpp>

#include "core/hash.h"
#include "core/strings.h"

namespace ombrage {

ResultKey& ResultKey::add(std::string name, std::string value) {
    m_values.emplace_back(std::move(name), std::move(value));
    return *this;
}

ResultKey& ResultKey::add(std::string name, double value) {
    return add(std::move(name), formatNumber(value));
}

ResultKey& ResultKey::add(std::string name, std::uint64_t value) {
    return add(std::move(name), std::to_string(value));
}

std::string ResultKey::text() const {
    nlohmann::ordered_json json{{"result", m_kind}};
    for (const auto& [name, value] : m_values) json[name] = value;
    // A driver's name may hold bytes that are not UTF-8.
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string ResultKey::hash() const {
    Hasher hasher;
    hasher.text(text());
    return hasher.hex();
}

}  // namespace ombrage
