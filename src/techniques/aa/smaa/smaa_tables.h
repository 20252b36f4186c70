// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// What lies at an end of a straight run of edges: nothing, or an edge that crosses its line, on the side of the pixel
/// itself, on its neighbour's, or on both.
enum class SmaaCrossing { None, Own, Neighbour, Both };

/// How a diagonal run of single steps ends: in a step like the others, or in one of two pixels along the line of the
/// edge asked for, or across it.
enum class SmaaDiagonalEnd { Regular, Along, Across };

/// Of a pixel at an edge: x the share of itself that lies beyond the true line, y the share of its neighbour that does.
using SmaaAreas = glm::dvec2;

/// Areas at a pixel of a straight run that goes on for `before` pixels to one side of it and `after` to the other. The
/// true line passes through the middle of the crossing edges; where only one end tells, it meets the run in its middle.
SmaaAreas smaaAreas(SmaaCrossing atStart, SmaaCrossing atEnd, double before, double after);

/// Areas at one edge of a diagonal run that goes on for `before` and `after` more steps and rises towards the pixel's
/// side. The true line passes through the middle of the steps, at an end through the middle of the long one.
SmaaAreas smaaDiagonalAreas(SmaaDiagonalEnd atStart, SmaaDiagonalEnd atEnd, int before, int after);

/// Tables of both: layer atStart + n * atEnd (n choices of an end), row `after`, column `before`. The first one's
/// distances are the squares of row and column.
inline constexpr int kSmaaAreaSize = 16, kSmaaDiagonalSize = 20;
std::vector<glm::vec2> smaaAreaTable();
std::vector<glm::vec2> smaaDiagonalTable();

/// A linear fetch between four pixels, near and far along the run, in the own row and in the neighbour's. Its position
/// is such that 32 times what comes out is a sum of these, a different one for each of the 16 sets of edges.
inline constexpr int kSmaaNearOwn = 21, kSmaaFarOwn = 7, kSmaaNearNeighbour = 3, kSmaaFarNeighbour = 1;

/// Pixels of a fetched pair that belong to the run, walking against its axis (x of the result) and along it (y).
/// `crossing` and `along` are such sums of the edges that cross the run's line and that lie in it.
glm::ivec2 smaaSearch(int crossing, int along);

/// For all sums, row `along`, column `crossing`.
inline constexpr int kSmaaSearchSize = 33;
std::vector<std::uint8_t> smaaSearchTable();

}  // namespace ombrage
