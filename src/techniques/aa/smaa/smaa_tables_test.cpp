// SPDX-License-Identifier: MIT
#include "techniques/aa/smaa/smaa_tables.h"

#include <random>

#include <gtest/gtest.h>

namespace ombrage::test {
namespace {

using Crossing = SmaaCrossing;
using End = SmaaDiagonalEnd;

constexpr Crossing kCrossings[] = {Crossing::None, Crossing::Own, Crossing::Neighbour, Crossing::Both};
constexpr End kEnds[] = {End::Regular, End::Along, End::Across};

Crossing mirrored(Crossing c) {
    if (c == Crossing::Own) return Crossing::Neighbour;
    return c == Crossing::Neighbour ? Crossing::Own : c;
}

/// Areas between a height over [0,1] and the axis, in the pixel above and the one below, by many small columns.
template <typename Height>
SmaaAreas summed(Height&& height) {
    constexpr int kColumns = 20000;
    SmaaAreas areas{0, 0};
    for (int i = 0; i < kColumns; ++i) {
        const double y = height((i + 0.5) / kColumns);
        areas += SmaaAreas(std::clamp(y, 0.0, 1.0), std::clamp(-y, 0.0, 1.0)) / double(kColumns);
    }
    return areas;
}

void expectNear(const SmaaAreas& a, const SmaaAreas& b, double tolerance, const std::string& where) {
    EXPECT_NEAR(a.x, b.x, tolerance) << where;
    EXPECT_NEAR(a.y, b.y, tolerance) << where;
}

TEST(SmaaTables, KnownAreas) {
    // A step of one pixel, as in a diagonal: the line from -1/2 to 1/2 leaves a triangle of 1/2 by 1/2 on each side.
    expectNear(smaaAreas(Crossing::Own, Crossing::Neighbour, 0, 0), {0.125, 0.125}, 1e-15, "Z of 1");
    // Two pixels: the line falls from 1/2 to 0 over the first.
    expectNear(smaaAreas(Crossing::Own, Crossing::Neighbour, 0, 1), {0.25, 0}, 1e-15, "Z of 2");
    // One crossing edge at the start of four pixels: from 1/2 to 0 over the first two.
    expectNear(smaaAreas(Crossing::Own, Crossing::None, 0, 3), {0.375, 0}, 1e-15, "L, first");
    expectNear(smaaAreas(Crossing::Own, Crossing::None, 1, 2), {0.125, 0}, 1e-15, "L, second");
    expectNear(smaaAreas(Crossing::Own, Crossing::None, 2, 1), {0, 0}, 1e-15, "L, third");
    // Both ends on the neighbour's side of three pixels: 0 in the middle.
    expectNear(smaaAreas(Crossing::Neighbour, Crossing::Neighbour, 1, 1), {0, 1.0 / 24 * 2}, 1e-15, "U, middle");
    // An end that goes both ways is the opposite of the other; without one it tells nothing.
    expectNear(smaaAreas(Crossing::Both, Crossing::Neighbour, 0, 1), {0.25, 0}, 1e-15, "both");
    expectNear(smaaAreas(Crossing::Both, Crossing::None, 0, 5), {0, 0}, 1e-15, "both alone");
    expectNear(smaaAreas(Crossing::None, Crossing::None, 3, 5), {0, 0}, 1e-15, "none");
    // In the middle of a long diagonal half of each step's square lies beyond the line: a triangle of 1/2 by 1/2.
    expectNear(smaaDiagonalAreas(End::Regular, End::Regular, 4, 4), {0.125, 0.125}, 1e-15, "diagonal");
}

TEST(SmaaTables, AreasAreTheIntegralOfTheLine) {
    // By small columns: a kink costs up to the square of their width, the rest nothing.
    for (const Crossing start : kCrossings)
        for (const Crossing end : kCrossings)
            for (int before = 0; before < 6; ++before)
                for (int after = 0; after < 6; ++after) {
                    const auto value = [](Crossing c) {
                        return c == Crossing::Own ? 0.5 : c == Crossing::Neighbour ? -0.5 : 0.0;
                    };
                    double y0 = value(start), y1 = value(end);
                    if (start == Crossing::Both) y0 = -y1;
                    if (end == Crossing::Both) y1 = -y0;
                    const double length = before + 1 + after;
                    const auto height = [&](double t) {
                        const double x = (before + t) / length;
                        if (y0 * y1 < 0) return y0 + (y1 - y0) * x;
                        return x < 0.5 ? y0 * (1 - 2 * x) : y1 * (2 * x - 1);
                    };
                    expectNear(smaaAreas(start, end, before, after), summed(height), 1e-6,
                               std::to_string(int(start)) + " " + std::to_string(int(end)) + " " +
                                   std::to_string(before) + " " + std::to_string(after));
                }
    for (const End start : kEnds)
        for (const End end : kEnds)
            for (int before = 0; before < 5; ++before)
                for (int after = 0; after < 5; ++after) {
                    const auto shift = [](End e) { return e == End::Along ? 0.5 : e == End::Across ? -0.5 : 0.0; };
                    const double y0 = -before - 0.5 + shift(start), y1 = after + 0.5 - shift(end);
                    const auto height = [&](double t) { return y0 + (y1 - y0) * (before + t) / (before + 1 + after); };
                    expectNear(smaaDiagonalAreas(start, end, before, after), summed(height), 1e-6, "diagonal");
                }
}

TEST(SmaaTables, Symmetries) {
    const std::vector<glm::vec2> table = smaaAreaTable();
    ASSERT_EQ(table.size(), std::size_t(16 * kSmaaAreaSize * kSmaaAreaSize));
    const auto at = [&](Crossing start, Crossing end, int before, int after) {
        return table[std::size_t(((int(start) + 4 * int(end)) * kSmaaAreaSize + after) * kSmaaAreaSize + before)];
    };
    for (const Crossing start : kCrossings)
        for (const Crossing end : kCrossings)
            for (int before = 0; before < kSmaaAreaSize; ++before)
                for (int after = 0; after < kSmaaAreaSize; ++after) {
                    const glm::vec2 areas = at(start, end, before, after);
                    // Left and right, and the pixel and its neighbour, may change places.
                    const glm::vec2 turned = at(end, start, after, before);
                    const glm::vec2 swapped = at(mirrored(start), mirrored(end), before, after);
                    EXPECT_NEAR(areas.x, turned.x, 1e-6f);
                    EXPECT_NEAR(areas.y, turned.y, 1e-6f);
                    EXPECT_EQ(areas.x, swapped.y);
                    EXPECT_EQ(areas.y, swapped.x);
                    EXPECT_LE(areas.x + areas.y, 0.5f);
                }
    // A diagonal turned by 180 degrees: pixel and neighbour change places with start and end.
    for (const End start : kEnds)
        for (const End end : kEnds)
            for (int before = 0; before < kSmaaDiagonalSize; ++before)
                for (int after = 0; after < kSmaaDiagonalSize; ++after) {
                    const SmaaAreas areas = smaaDiagonalAreas(start, end, before, after);
                    const SmaaAreas turned = smaaDiagonalAreas(end, start, after, before);
                    expectNear(areas, {turned.y, turned.x}, 1e-12, "turned");
                }
}

/// Two rows of edges: along the line between them, and crossing it in the own row and in the neighbour's.
struct EdgeRow {
    std::vector<int> along, own, neighbour;
    int get(const std::vector<int>& row, int i) const {
        return i < 0 || i >= int(row.size()) ? 0 : row[std::size_t(i)];
    }
    /// Sums as a linear fetch gives them of two pixels, `near` first.
    glm::ivec2 pair(int near, int far) const {
        return {kSmaaNearOwn * get(own, near) + kSmaaFarOwn * get(own, far) +
                    kSmaaNearNeighbour * get(neighbour, near) + kSmaaFarNeighbour * get(neighbour, far),
                kSmaaNearOwn * get(along, near) + kSmaaFarOwn * get(along, far)};
    }
};

TEST(SmaaTables, SearchFindsWhatBruteForceFinds) {
    const std::vector<std::uint8_t> table = smaaSearchTable();
    std::mt19937 random(7);
    for (int trial = 0; trial < 20000; ++trial) {
        EdgeRow row;
        for (int i = 0; i < 24; ++i) {
            row.along.push_back(random() % 8 != 0);
            row.own.push_back(random() % 10 == 0);
            row.neighbour.push_back(random() % 10 == 0);
        }
        const int x = 10;
        row.along[std::size_t(x)] = 1;
        // One pixel at a time, by the definition: the run goes on through the next edge unless something crosses
        // between.
        const auto isCrossed = [&](int i) { return row.get(row.own, i) || row.get(row.neighbour, i); };
        int before = 0, after = 0;
        while (!isCrossed(x - before) && row.get(row.along, x - before - 1)) ++before;
        while (!isCrossed(x + after + 1) && row.get(row.along, x + after + 1)) ++after;
        // Two pixels at a time, by the table.
        int against = -1, forward = 0;
        const auto search = [&](const glm::ivec2& pair, std::size_t direction) {
            return int(table[std::size_t(pair.y * kSmaaSearchSize + pair.x) * 2 + direction]);
        };
        for (int i = 0; i < 12; ++i) {
            const glm::ivec2 pair = row.pair(x - 2 * i, x - 2 * i - 1);
            against += search(pair, 0);
            if (pair.x != 0 || pair.y < 28) break;
        }
        for (int i = 0; i < 12; ++i) {
            const glm::ivec2 pair = row.pair(x + 1 + 2 * i, x + 2 + 2 * i);
            forward += search(pair, 1);
            if (pair.x != 0 || pair.y < 28) break;
        }
        ASSERT_EQ(against, before) << trial;
        ASSERT_EQ(forward, after) << trial;
    }
}

}  // namespace
}  // namespace ombrage::test
