// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/ao_integrand.h>

namespace ombrage {

/// A point even in the unit ball from three numbers of [0,1).
glm::dvec3 ballPoint(double u, double v, double w);

/// A direction of density cosine over pi about a unit normal, from two numbers of [0,1).
glm::dvec3 cosineDirection(const glm::dvec3& normal, double u, double v);

/// How far a surface that hides a point lies in front of it along the view axis; 0 or less where it lies behind it.
/// Both are offsets from the receiver.
double depthBetween(const AoReceiver& receiver, const glm::dvec3& surface, const glm::dvec3& point);

}  // namespace ombrage
