// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace ombrage::msm {

/// Four moments of depths in [-1,1] turned into four numbers in [0,1] that are rounded with the least harm: of all
/// polynomials that stay in [0,1] there, two odd ones about 1/2 and two even ones, those that span the most volume.
///
/// An odd one whose extremum of 1/2 lies at s is 3z/(4s) - z^3/(4s^3), for s in [1/2,1]. Two of them span
/// 3/16 |s^2 - t^2| / (st)^3, which is largest for s = 1/2 and t = sqrt(3)/2.
struct Quantisation {
    glm::dvec2 odd[2];   ///< coefficients of z and z^3, of the first and second number; 1/2 is added
    glm::dvec2 even[2];  ///< of z^2 and z^4, of the third and fourth
};

inline Quantisation quantisation() {
    const double root3 = std::sqrt(3.0);
    return {{{1.5, -2.0}, {root3 / 2, -2 * root3 / 9}}, {{4.0, -4.0}, {0.5, 0.5}}};
}

/// The rows of the inverse of a matrix of two rows.
inline glm::dmat2 inverseRows(const glm::dvec2 (&rows)[2]) {
    return glm::inverse(glm::dmat2(rows[0], rows[1]));
}

}  // namespace ombrage::msm
