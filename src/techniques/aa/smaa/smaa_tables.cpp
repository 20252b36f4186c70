// SPDX-License-Identifier: MIT
#include "techniques/aa/smaa/smaa_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ombrage {

namespace {

/// Integral of max(y, 0) over a stretch of `width` on which y goes linearly from y0 to y1.
double integralAbove(double y0, double y1, double width) {
    if (y0 <= 0 && y1 <= 0) return 0;
    if (y0 >= 0 && y1 >= 0) return width * (y0 + y1) / 2;
    const double top = std::max(y0, y1);
    return width * top * top / (2 * std::abs(y1 - y0));
}

/// Areas between a line and the axis within the pixels above and below it, whose height is 1.
SmaaAreas areasOfPiece(double y0, double y1, double width) {
    return {integralAbove(y0, y1, width) - integralAbove(y0 - 1, y1 - 1, width),
            integralAbove(-y0, -y1, width) - integralAbove(-y0 - 1, -y1 - 1, width)};
}

/// The same of the stretch of a segment from (x0, y0) to (x1, y1) that lies in [left, left + 1].
SmaaAreas areasInColumn(double x0, double y0, double x1, double y1, double left) {
    const double from = std::max(x0, left), to = std::min(x1, left + 1);
    if (!(from < to)) return {0, 0};
    const double slope = (y1 - y0) / (x1 - x0);
    return areasOfPiece(y0 + slope * (from - x0), y0 + slope * (to - x0), to - from);
}

/// Height at which the true line passes an end, where one crossing edge tells it.
double heightAt(SmaaCrossing crossing) {
    if (crossing == SmaaCrossing::Own) return 0.5;
    return crossing == SmaaCrossing::Neighbour ? -0.5 : 0.0;
}

}  // namespace

SmaaAreas smaaAreas(SmaaCrossing atStart, SmaaCrossing atEnd, double before, double after) {
    double start = heightAt(atStart), end = heightAt(atEnd);
    // An end with edges on both sides goes the other way than the other end, if that tells anything.
    if (atStart == SmaaCrossing::Both) start = -end;
    if (atEnd == SmaaCrossing::Both) end = -start;
    const double length = before + 1 + after, middle = length / 2;
    // One line from side to side, or two half ones that meet the run in its middle.
    if (start * end < 0) return areasInColumn(0, start, length, end, before);
    return areasInColumn(0, start, middle, 0, before) + areasInColumn(middle, 0, length, end, before);
}

SmaaAreas smaaDiagonalAreas(SmaaDiagonalEnd atStart, SmaaDiagonalEnd atEnd, int before, int after) {
    // The line y = x - 1/2 halves every step of a run through (0, 0) to (1, 0). A long step shifts the end by half a
    // pixel.
    const auto shift = [](SmaaDiagonalEnd end) {
        if (end == SmaaDiagonalEnd::Along) return 0.5;
        return end == SmaaDiagonalEnd::Across ? -0.5 : 0.0;
    };
    const double x0 = -before, x1 = 1 + after;
    const double y0 = x0 - 0.5 + shift(atStart), y1 = x1 - 0.5 - shift(atEnd);
    return areasInColumn(x0, y0, x1, y1, 0);
}

std::vector<glm::vec2> smaaAreaTable() {
    std::vector<glm::vec2> table;
    for (int layer = 0; layer < 16; ++layer)
        for (int after = 0; after < kSmaaAreaSize; ++after)
            for (int before = 0; before < kSmaaAreaSize; ++before)
                table.emplace_back(
                    smaaAreas(SmaaCrossing(layer % 4), SmaaCrossing(layer / 4), before * before, after * after));
    return table;
}

std::vector<glm::vec2> smaaDiagonalTable() {
    std::vector<glm::vec2> table;
    for (int layer = 0; layer < 9; ++layer)
        for (int after = 0; after < kSmaaDiagonalSize; ++after)
            for (int before = 0; before < kSmaaDiagonalSize; ++before)
                table.emplace_back(
                    smaaDiagonalAreas(SmaaDiagonalEnd(layer % 3), SmaaDiagonalEnd(layer / 3), before, after));
    return table;
}

namespace {

/// The four edges of a sum: near own, far own, near neighbour, far neighbour. No set of edges has some of the sums;
/// they are read as if they had fewer edges.
std::array<bool, 4> edgesOf(int sum) {
    std::array<bool, 4> edges{};
    const std::array<int, 4> weights{kSmaaNearOwn, kSmaaFarOwn, kSmaaNearNeighbour, kSmaaFarNeighbour};
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (sum >= weights[i]) {
            edges[i] = true;
            sum -= weights[i];
        }
    return edges;
}

}  // namespace

glm::ivec2 smaaSearch(int crossing, int along) {
    const auto [nearOwn, farOwn, nearNeighbour, farNeighbour] = edgesOf(crossing);
    const auto [nearAlong, farAlong, unusedNear, unusedFar] = edgesOf(along);
    const bool isNearCrossed = nearOwn || nearNeighbour, isFarCrossed = farOwn || farNeighbour;
    // A pixel's crossing edges stand at its start: walking against the axis they end the run beyond the pixel, walking
    // along it before the pixel.
    int against = 0, forward = 0;
    if (nearAlong) against = !isNearCrossed && farAlong ? 2 : 1;
    if (nearAlong && !isNearCrossed) forward = farAlong && !isFarCrossed ? 2 : 1;
    return {against, forward};
}

std::vector<std::uint8_t> smaaSearchTable() {
    std::vector<std::uint8_t> table;
    for (int along = 0; along < kSmaaSearchSize; ++along)
        for (int crossing = 0; crossing < kSmaaSearchSize; ++crossing) {
            const glm::ivec2 pixels = smaaSearch(crossing, along);
            table.push_back(std::uint8_t(pixels.x));
            table.push_back(std::uint8_t(pixels.y));
        }
    return table;
}

}  // namespace ombrage
