// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage {

namespace {

std::string describe(const std::string& message, const std::string& hint, const std::string& where) {
    std::string text = where.empty() ? message : where + ": " + message;
    if (!hint.empty()) text += " (" + hint + ")";
    return text;
}

// Optimal string alignment distance: Levenshtein with transpositions of neighbours.
std::size_t editDistance(std::string_view a, std::string_view b) {
    const std::size_t columns = b.size() + 1;
    std::vector<std::size_t> beforeLast(columns), last(columns), current(columns);
    for (std::size_t j = 0; j < columns; ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j < columns; ++j) {
            const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + cost});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], beforeLast[j - 2] + 1);
        }
        beforeLast.swap(last);
        last.swap(current);
    }
    return last[b.size()];
}

}  // namespace

Error::Error(ErrorCode code, const std::string& message, std::string hint, std::string where)
    : std::runtime_error(describe(message, hint, where)),
      m_code(code),
      m_message(message),
      m_hint(std::move(hint)),
      m_where(std::move(where)) {}

std::string nearestName(std::string_view name, const std::vector<std::string>& candidates) {
    const std::string wanted = toLower(name);
    std::string best;
    std::size_t bestDistance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        // The last part of a path-like id counts as well: "pcff" is near "shadow/pcf".
        const std::size_t slash = candidate.rfind('/');
        std::size_t distance = editDistance(wanted, toLower(candidate));
        if (slash != std::string::npos)
            distance = std::min(distance, editDistance(wanted, toLower(candidate.substr(slash + 1))));
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

Error unknownName(std::string_view kind, std::string_view name, const std::vector<std::string>& candidates) {
    const std::string nearest = nearestName(name, candidates);
    std::string hint;
    if (!nearest.empty())
        hint = fmt::format("did you mean '{}'?", nearest);
    else if (!candidates.empty())
        hint = "there are: " + join(candidates, ", ");
    return Error(ErrorCode::Usage, fmt::format("unknown {} '{}'", kind, name), hint);
}

}  // namespace ombrage
