// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace ombrage {

/// What the truth is asked for.
enum class Quantity { Shadow, Ao, Indirect, Picture };

/// Which question about it is answered; docs/dev/truth.md defines them.
enum class TruthKind {
    Shadow,  ///< the share of the light that a point sees
    Self,    ///< the same with casters limited to the receiver's own scene model
    T1,      ///< cosine-weighted, occluders nearer than R count fully
    T2,      ///< cosine-weighted, an occluder at distance t < R counts 1 - t^2/R^2
    T3,      ///< uniform over the hemisphere, occluders nearer than R count fully
    T4,      ///< cosine-weighted, without bound
    T5,      ///< free volume of the half-ball of radius R about the shading normal
    T5Ball,  ///< free volume of the whole ball
    Own,     ///< the integral that a technique claims
    Displaced,  ///< T1 of the scene with its height maps made geometry, on that geometry's receivers
    Area     ///< the first kind of the quantity, averaged over 16 points of each pixel
};

/// "shadow", "ao", "indirect", "picture".
const char* quantityName(Quantity quantity);
/// @throws Error(Usage) with a suggestion.
Quantity quantityFromName(const std::string& name);

/// "shadow", "self", "T1" ... "T5", "T5-ball", "own", "displaced", "area".
const char* truthKindName(TruthKind kind);

/// The kinds that the quantity has, its default first.
const std::vector<TruthKind>& truthKindsOf(Quantity quantity);

/// @throws Error(Usage) with a suggestion for a name that no kind has, and naming the quantity's kinds for one of another.
TruthKind truthKindFromName(const std::string& name, Quantity quantity);

/// @throws Error(Usage) with a suggestion for a name that no kind has.
TruthKind truthKindFromName(const std::string& name);

}  // namespace ombrage
