// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/bench.h>

namespace ombrage {

/// A pipeline as it takes part in a bench.
struct BenchVariant {
    Family family = Family::Shadow;
    Pipeline pipeline;
    std::string label;
};

/// Axes of a sweep that are no parameter of a technique.
inline constexpr const char* kSizeAxis = "size";
inline constexpr const char* kTrianglesAxis = "triangles";
inline constexpr const char* kLightsAxis = "lights";

/// One point of a sweep, or all that there is without one.
struct BenchPoint {
    std::string value;  ///< "" without a sweep
    double x = 0;       ///< the value, or its place where it is no number
    int width = 0, height = 0;
    std::size_t triangles = 0;  ///< of a generated scene; 0: the scene is named
    int lights = 0;
    std::vector<std::pair<std::string, std::string>> params;  ///< to set wherever a technique has them
};

/// The values in order, checked. @throws Error(Usage)
std::vector<BenchPoint> benchPoints(const BenchRequest& request);

/// What runs on a scene at a point; what `--all` names and the lights forbid is added to `skipped`.
/// @throws Error(Usage) for a pipeline asked for by name that a light forbids, and for a value out of a parameter's
/// range.
std::vector<BenchVariant> benchVariants(const BenchRequest& request, const Scene& scene, const BenchPoint& point,
                                        std::vector<SkippedPair>& skipped);

}  // namespace ombrage
