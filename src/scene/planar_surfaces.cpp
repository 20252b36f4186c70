// SPDX-License-Identifier: MIT
#include "scene/planar_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ombrage {

namespace {

/// What is asked of a triangle again and again.
struct Facet {
    std::uint64_t cell = 0;  ///< roughly its plane, either side
    std::uint32_t triangle = 0;
    double area_m2 = 0;
    glm::dvec3 normal{0.0};  ///< unit, of the counter-clockwise side
    glm::dvec3 centre{0.0};
};

glm::dvec3 corner(const FlatScene& flat, std::uint32_t triangle, int k) {
    return flat.positions[flat.triangles[triangle][k]];
}

double extent_m(const FlatScene& flat) {
    double extent = 0;
    for (const glm::vec3& p : flat.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(p[axis])) extent = std::max(extent, std::abs(double(p[axis])));
    return extent;
}

/// The normal of the pair n and -n whose largest component is positive.
glm::dvec3 withoutSide(const glm::dvec3& n) {
    const glm::dvec3 size = glm::abs(n);
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    return n[axis] < 0 ? -n : n;
}

/// Normals to a 1000th, offsets to a 1000th of the extent.
std::uint64_t cellOf(const glm::dvec3& normal, const glm::dvec3& centre, double extent) {
    const glm::dvec3 n = withoutSide(normal);
    std::uint64_t cell = 0;
    for (const double value : {n.x, n.y, n.z, glm::dot(n, centre) / extent / 2})
        cell = cell << 13 | std::uint64_t(std::llround(value * 1000) + 4096);
    return cell;
}

std::vector<Facet> receivingFacets(const FlatScene& flat, double extent) {
    std::vector<Facet> facets;
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t) {
        if (!flat.instances[flat.triangleInstance[t]].receives) continue;
        const glm::dvec3 a = corner(flat, t, 0), b = corner(flat, t, 1), c = corner(flat, t, 2);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double length = glm::length(n);
        if (!(length > 0) || !std::isfinite(length)) continue;
        Facet facet{0, t, length / 2, n / length, (a + b + c) / 3.0};
        facet.cell = cellOf(facet.normal, facet.centre, extent);
        facets.push_back(facet);
    }
    return facets;
}

double areaOf(const Facet* first, const Facet* last) {
    return std::accumulate(first, last, 0.0, [](double sum, const Facet& f) { return sum + f.area_m2; });
}

/// The plane of the seed's neighbours in its cell, averaged: a small triangle alone would tilt it by its rounding.
Plane planeAround(const FlatScene& flat, const Facet& seed, const Facet* first, const Facet* last, double tolerance_m) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        longest =
            std::max(longest, glm::length(corner(flat, seed.triangle, k) - corner(flat, seed.triangle, (k + 1) % 3)));
    const double height_m = 2 * seed.area_m2 / longest;
    glm::dvec3 normal(0.0), centre(0.0);
    double area = 0;
    for (const Facet* f = first; f != last; ++f) {
        const glm::dvec3 away = f->centre - seed.centre;
        if (std::abs(glm::dot(seed.normal, away)) > tolerance_m * (1 + 2 * glm::length(away) / height_m)) continue;
        normal += f->normal * (f->area_m2 * (glm::dot(f->normal, seed.normal) < 0 ? -1.0 : 1.0));
        centre += f->centre * f->area_m2;
        area += f->area_m2;
    }
    Plane plane;
    plane.normal = glm::normalize(normal);
    plane.offset_m = glm::dot(plane.normal, centre / area);
    return plane;
}

}  // namespace

double planeTolerance_m(const FlatScene& flat) {
    return 8 * double(std::numeric_limits<float>::epsilon()) * extent_m(flat);
}

bool liesIn(const Plane& plane, const FlatScene& flat, std::uint32_t triangle, double tolerance_m) {
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(plane.heightOf(corner(flat, triangle, k))) <= tolerance_m)) return false;
    return true;
}

PlanarSurfaces findPlanarSurfaces(const FlatScene& flat) {
    PlanarSurfaces found;
    found.planeOf.assign(flat.triangles.size(), 0);
    const double extent = std::max(extent_m(flat), 1e-30), tolerance_m = planeTolerance_m(flat);
    std::vector<Facet> facets = receivingFacets(flat, extent);
    if (facets.empty()) return found;
    const double least_m2 = kLeastPlanarShare * areaOf(facets.data(), facets.data() + facets.size());

    // Triangles of roughly one plane stand together, the largest first; a plane on the border of cells is cut into
    // up to 16 of them, so cells far smaller than a plane may still hold a part of one.
    std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) {
        if (a.cell != b.cell) return a.cell < b.cell;
        return a.area_m2 != b.area_m2 ? a.area_m2 > b.area_m2 : a.triangle < b.triangle;
    });
    struct Cell {
        const Facet *first, *last;
        double area_m2;
    };
    std::vector<Cell> cells;
    for (std::size_t i = 0, end = 0; i < facets.size(); i = end) {
        while (end < facets.size() && facets[end].cell == facets[i].cell) ++end;
        const Cell cell{&facets[i], facets.data() + end, areaOf(&facets[i], facets.data() + end)};
        if (cell.area_m2 >= least_m2 / 16) cells.push_back(cell);
    }
    std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.area_m2 > b.area_m2; });

    // Every cell may hold a few planes close together: each is tried from its largest triangle that no plane has yet.
    constexpr int kPlanesPerCell = 4;
    struct Candidate {
        Plane plane;
        double area_m2 = 0;
        bool isFloor = false;
        std::vector<std::uint32_t> triangles;
    };
    std::vector<Candidate> accepted;
    std::vector<bool> tried(flat.triangles.size(), false);
    for (const Cell& cell : cells) {
        int planes = 0;
        for (const Facet* seed = cell.first; seed != cell.last && planes < kPlanesPerCell; ++seed) {
            if (tried[seed->triangle]) continue;
            ++planes;
            Candidate candidate;
            candidate.plane = planeAround(flat, *seed, cell.first, cell.last, tolerance_m);
            double up_m2 = 0;
            for (const Facet& facet : facets) {
                if (tried[facet.triangle] || !liesIn(candidate.plane, flat, facet.triangle, tolerance_m)) continue;
                tried[facet.triangle] = true;
                candidate.triangles.push_back(facet.triangle);
                candidate.area_m2 += facet.area_m2;
                up_m2 += facet.area_m2 * (glm::dot(facet.normal, candidate.plane.normal) < 0 ? -1.0 : 1.0);
            }
            tried[seed->triangle] = true;
            if (candidate.area_m2 < least_m2) continue;
            if (up_m2 < 0) candidate.plane = {-candidate.plane.normal, -candidate.plane.offset_m};
            candidate.isFloor = candidate.plane.normal.y > 0.999;
            accepted.push_back(std::move(candidate));
        }
    }

    std::stable_sort(accepted.begin(), accepted.end(), [](const Candidate& a, const Candidate& b) {
        return a.isFloor != b.isFloor ? a.isFloor : a.area_m2 > b.area_m2;
    });
    for (std::size_t i = 0; i < accepted.size(); ++i) {
        found.planes.push_back(accepted[i].plane);
        found.area_m2.push_back(accepted[i].area_m2);
        for (const std::uint32_t t : accepted[i].triangles) found.planeOf[t] = std::uint8_t(i + 1);
    }
    return found;
}

}  // namespace ombrage
