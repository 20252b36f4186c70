// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <ombrage/ao_integrand.h>
#include <ombrage/params.h>
#include <ombrage/scene.h>

namespace ombrage {

enum class Family { Shadow, Ao, Filter, Indirect, Aa };

/// "shadow", "ao", "filter", "indirect", "aa".
const char* familyName(Family family);

/// @throws Error(Usage) with a suggestion.
Family familyFromName(const std::string& name);

/// Where a technique claims to be right. Outside its domain it is measured and shown, but no budget applies.
struct Domain {
    bool sun = true, spot = true, point = true, rect = true;  ///< light types that it renders at all
    bool soft = false;  ///< shows the light's real size; a hard one takes the light's centre
    bool closedCastersOnly = false;
    bool planarReceiversOnly = false;  ///< surfaces in large planes of the scene alone (docs/user/metrics.md)
    bool alphaTest = true;             ///< sees the holes of alpha-tested casters
};

/// Whether a technique of this domain renders lights of the type at all.
bool supports(const Domain& domain, LightType type);

/// An intermediate picture that `render --show NAME` can write.
struct PassInfo {
    std::string name;
    std::string description;
};

/// What is known of a technique without running it.
struct TechniqueInfo {
    std::string id;  ///< "shadow/map"
    Family family = Family::Shadow;
    std::string name;  ///< "map"
    std::string title;
    std::string summary;  ///< one sentence
    std::vector<std::string> papers;
    std::string limits;  ///< one sentence: where it fails
    Domain domain;
    bool screenSpace = false;  ///< its answer depends on where in the picture a surface lies
    bool usesSeed = false;     ///< its answer depends on RenderSettings::seed for some of its parameters or lights
    std::vector<PassInfo> passes;
    std::vector<ParamInfo> params;
};

/// Every technique that is built in, ordered by family, then by name ("none" first).
const std::vector<TechniqueInfo>& techniques();

/// `id` may leave the family out when `family` is given. @throws Error(Usage) with a suggestion.
const TechniqueInfo& technique(const std::string& id);
const TechniqueInfo& technique(Family family, const std::string& nameOrId);

/// A technique with parameter values that differ from its defaults.
struct TechniqueSpec {
    std::string id;
    std::vector<std::pair<std::string, std::string>> params;  ///< key, text
    bool operator==(const TechniqueSpec&) const = default;
};

/// One or more techniques, each fed by the one before: "A+B".
using Pipeline = std::vector<TechniqueSpec>;

/// Parses "map:resolution=2048,bias=slope+filter/bilateral-separable". The first element belongs to `family` when its
/// own is left out, later ones must name theirs. Keys and values are checked against the declarations.
/// @throws Error(Usage) naming the place and suggesting the nearest name.
Pipeline parsePipeline(Family family, const std::string& text);

/// The canonical text: full ids, parameters in declaration order, defaults left out.
std::string toString(const Pipeline& pipeline);

/// Every parameter of the technique with its value under `spec`, in declaration order, checked.
std::vector<std::pair<std::string, ParamValue>> resolveParams(const TechniqueSpec& spec);

/// The integral that the pipeline's first technique claims to compute, under its parameters: the question of the truth
/// `own`. Null when it claims none. Needs no OpenGL. @throws Error(Usage) as parsePipeline.
std::unique_ptr<AoIntegrand> ownIntegrand(const Pipeline& pipeline);

}  // namespace ombrage
