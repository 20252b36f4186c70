// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/scene.h>

#include "techniques/ao/baked/layout.h"

namespace ombrage::baked {

/// What is asked of every vertex or texel.
struct BakeOptions {
    double radius_m = 0;  ///< above 0
    int samples = 128;    ///< rays of each
    /// What stands inside of something is filled from its neighbours: a floor's texels under a box do not darken those
    /// beside it.
    bool dilate = true;
};

/// Ambient visibility T1 of the layout's texels, row by row: the reference's estimator on the CPU, all cores. The
/// normals are the interpolated ones; bump and normal maps are left out.
std::vector<float> bake(const Scene& scene, const FlatScene& flat, const Layout& layout, const BakeOptions& options);

/// Tells bakes apart: a hash of the geometry that stops rays, of the layout's spacing and of the options.
std::string bakeKey(const Scene& scene, const FlatScene& flat, const Layout& layout, const BakeOptions& options);

}  // namespace ombrage::baked
