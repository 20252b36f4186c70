// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "techniques/shared/map_params.h"

namespace ombrage {

/// Shape of the filter that is laid over a map of moments.
enum class MomentBlur { Gauss, Box };

template <>
struct EnumChoices<MomentBlur> {
    static std::vector<std::string> names() { return {"gauss", "box"}; }
};

/// What is stored of each moment; the names are those that GLSL sees as BITS.
enum class MomentBits { Float32, Unorm16 };

template <>
struct EnumChoices<MomentBits> {
    static std::vector<std::string> names() { return {"32f", "16"}; }
};

/// What all techniques that filter statistics of a light's map have in common; shared/moment_map.glsl reads it.
/// Parameter structs derive from it, with it as their only base, and put their own fields through momentTable().
struct MomentMapParams : MapParams {
    int kernel_texels = 3;
    MomentBlur blur = MomentBlur::Gauss;
    bool mipmaps = false;
    int anisotropy = 4;
    float crease = 10.0f;
    float bleeding = 0.0f;
};

/// What those have in common that bound the lit share by a variance.
struct VarianceMapParams : MomentMapParams {
    float minDeviation_texels = 0.25f;
};

/// Their declarations, with `defaults` as defaults, followed by those of the technique.
ParamTable momentTable(const std::vector<ParamField>& own = {}, const MomentMapParams& defaults = {});

/// The same with those of VarianceMapParams at the end.
ParamTable varianceTable(std::vector<ParamField> own = {}, const VarianceMapParams& defaults = {});

/// Weights of the texels at 0, 1, 2, ... beside the middle, one side of a symmetric filter: the shape's share over each
/// texel, cut off at half the width. The middle and twice the rest sum to 1.
std::vector<float> momentBlurWeights(MomentBlur blur, int width_texels);

/// Its variance, in texels squared.
float momentBlurVariance(const std::vector<float>& weights);

}  // namespace ombrage
