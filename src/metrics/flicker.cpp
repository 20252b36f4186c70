// SPDX-License-Identifier: MIT
#include "metrics/flicker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ombrage/error.h>

namespace ombrage {

FlickerMeter::FlickerMeter(int width, int height, double tolerance)
    : m_width(width), m_height(height), m_tolerance(tolerance) {
    const std::size_t count = std::size_t(width) * std::size_t(height);
    m_points.largest.assign(count, 0.0f);
    m_points.seen.assign(count, false);
}

void FlickerMeter::add(ErrorFrame frame) {
    const std::size_t count = m_points.largest.size();
    if (frame.error.size() != count || frame.valid.size() != count)
        throw Error(ErrorCode::Usage, "the frames of a script differ in size");
    if (m_last) {
        std::vector<bool> marked(count, false);
        for (std::size_t i = 0; i < count; ++i) {
            if (!frame.valid[i] || !m_last->valid[i]) continue;
            float change = std::fabs(frame.error[i] - m_last->error[i]);
            if (!std::isfinite(change)) change = 1.0f;
            m_points.seen[i] = true;
            m_points.largest[i] = std::max(m_points.largest[i], change);
            marked[i] = double(change) > m_tolerance;
            if (change > 0.0f)
                m_changes.push_back(change);
            else
                ++m_unchanged;
        }
        m_patch = std::max(m_patch, largestPatch(marked, m_width, m_height));
    }
    m_last = std::move(frame);
}

Flicker FlickerMeter::result() const {
    Flicker flicker = m_points;
    const std::size_t count = m_changes.size() + m_unchanged;
    if (count == 0) return flicker;
    double sum = 0;
    for (const float change : m_changes) sum += double(change);
    flicker.mean = sum / double(count);

    // Nearest rank: the smallest change that 99 of 100 do not exceed. Those that are 0 come first.
    const std::size_t rank = (count * 99 + 99) / 100;
    flicker.p99 = 0.0;
    if (rank > m_unchanged) {
        std::vector<float> sorted = m_changes;
        const auto place = sorted.begin() + std::ptrdiff_t(rank - m_unchanged - 1);
        std::nth_element(sorted.begin(), place, sorted.end());
        flicker.p99 = double(*place);
    }
    flicker.patch_px = m_patch;
    return flicker;
}

std::size_t largestPatch(const std::vector<bool>& marked, int width, int height) {
    std::vector<bool> open = marked;
    std::vector<std::size_t> edge;
    std::size_t largest = 0;
    for (std::size_t start = 0; start < open.size(); ++start) {
        if (!open[start]) continue;
        // Flood from here; every point is taken once.
        std::size_t size = 0;
        open[start] = false;
        edge.assign(1, start);
        while (!edge.empty()) {
            const int x = int(edge.back() % std::size_t(width)), y = int(edge.back() / std::size_t(width));
            edge.pop_back();
            ++size;
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height - 1); ++ny)
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width - 1); ++nx) {
                    const std::size_t near = std::size_t(ny) * std::size_t(width) + std::size_t(nx);
                    if (!open[near]) continue;
                    open[near] = false;
                    edge.push_back(near);
                }
        }
        largest = std::max(largest, size);
    }
    return largest;
}

std::optional<Lag> lagOf(const std::vector<std::vector<float>>& answers, const std::vector<std::vector<float>>& settled,
                         double tolerance) {
    if (answers.size() != settled.size())
        throw Error(ErrorCode::Usage, "the answers after a jump and the settled ones differ in number");
    if (answers.empty() || answers.front().empty()) return std::nullopt;
    constexpr std::size_t kPointsPerStray = 100;
    int frames = int(answers.size());
    // From the end: the first frame that is off ends the search.
    while (frames > 0) {
        const std::vector<float>&answer = answers[std::size_t(frames - 1)], &right = settled[std::size_t(frames - 1)];
        if (answer.size() != answers.front().size() || right.size() != answer.size())
            throw Error(ErrorCode::Usage, "the frames of a script differ in size");
        std::size_t off = 0;
        for (std::size_t i = 0; i < answer.size(); ++i)
            off += std::fabs(double(answer[i]) - double(right[i])) <= tolerance ? 0 : 1;
        if (off * kPointsPerStray > answer.size()) break;
        --frames;
    }
    return Lag{frames, frames < int(answers.size())};
}

std::vector<std::ptrdiff_t> nearestOfTriangle(const Receivers& receivers, std::span<const glm::dvec2> places_px,
                                              std::span<const std::uint32_t> instance,
                                              std::span<const std::uint32_t> triangle) {
    const std::size_t count = receivers.triangle.size();
    if (places_px.size() != count || instance.size() != count || triangle.size() != count)
        throw Error(ErrorCode::Usage, "the picture's ids and the receivers differ in size");
    std::vector<std::ptrdiff_t> found(count, -1);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 place = places_px[i];
        const bool inside = place.x >= 0 && place.y >= 0 && place.x < receivers.width && place.y < receivers.height;
        if (receivers.triangle[i] == kNoHit || !inside) continue;
        const int x = int(place.x), y = int(place.y);
        double nearest = std::numeric_limits<double>::infinity();
        for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, receivers.height - 1); ++ny)
            for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, receivers.width - 1); ++nx) {
                const std::size_t at = std::size_t(ny) * std::size_t(receivers.width) + std::size_t(nx);
                if (instance[at] != receivers.instance[i] || triangle[at] != receivers.triangle[i]) continue;
                const glm::dvec2 away = glm::dvec2(nx + 0.5, ny + 0.5) - place;
                if (const double distance = glm::dot(away, away); distance < nearest) {
                    nearest = distance;
                    found[i] = std::ptrdiff_t(at);
                }
            }
    }
    return found;
}

}  // namespace ombrage
