// SPDX-License-Identifier: MIT
#include "render/request.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "render/standard_views.h"
#include "render/technique.h"

namespace ombrage {

namespace {

/// The first element belongs to `family`, later ones to it or to the filters; families without filters have one
/// element.
void checkPipeline(const Pipeline& pipeline, Family family) {
    const bool takesFilters = family == Family::Shadow || family == Family::Ao;
    if (pipeline.empty())
        throw Error(ErrorCode::Usage, fmt::format("the {} pipeline is empty", familyName(family)),
                    fmt::format("use {}/none", familyName(family)));
    for (std::size_t i = 0; i < pipeline.size(); ++i) {
        const TechniqueEntry& entry = techniqueEntry(pipeline[i].id);
        const bool fits = entry.family == family || (i > 0 && takesFilters && entry.family == Family::Filter);
        if (!fits)
            throw Error(
                ErrorCode::Usage,
                fmt::format("{} cannot stand at place {} of a {} pipeline", entry.id(), i + 1, familyName(family)),
                takesFilters ? fmt::format("write {}/NAME+filter/NAME", familyName(family))
                             : fmt::format("only {} techniques can", familyName(family)));
        if (i > 0 && entry.family == Family::Shadow) {
            const auto technique = createTechnique(pipeline[i]);
            if (!static_cast<const ShadowTechnique&>(*technique).refinesInput())
                throw Error(ErrorCode::Usage, fmt::format("{} does not refine another shadow", entry.id()),
                            "put it first, without '+'");
        }
    }
}

/// What the first anti-aliasing technique asks of the G-buffer; none after it may ask.
GeometrySamples samplesOf(const Pipeline& pipeline) {
    GeometrySamples samples;
    for (std::size_t i = 0; i < pipeline.size(); ++i) {
        const auto technique = createTechnique(pipeline[i]);
        const GeometrySamples asked = static_cast<const AaTechnique&>(*technique).geometrySamples();
        if (i == 0)
            samples = asked;
        else if (asked != GeometrySamples{})
            throw Error(ErrorCode::Usage, fmt::format("{} takes samples of its own", pipeline[i].id),
                        "put it first in the pipeline");
    }
    return samples;
}

/// What the scene says of techniques, and what it holds that they do not see.
void warnOfScene(const Scene& scene, const RenderSettings& settings, RenderRequest& request) {
    std::vector<std::string> ids;
    for (const TechniqueEntry* entry : techniqueEntries()) ids.push_back(entry->id());
    for (const std::string& meant : scene.techniques)
        if (std::find(ids.begin(), ids.end(), meant) == ids.end()) {
            const std::string nearest = nearestName(meant, ids);
            request.warnings.push_back(
                fmt::format("the scene is meant for an unknown technique '{}'{}", meant,
                            nearest.empty() ? "" : fmt::format(" (did you mean '{}'?)", nearest)));
        }
    const bool hasHoles = std::any_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        return scene.materials[std::size_t(mesh.material)].alphaMode == AlphaMode::Mask;
    });
    for (const Pipeline* pipeline : {&settings.shadow, &settings.ao, &settings.indirect, &settings.aa})
        for (const TechniqueSpec& spec : *pipeline) {
            const TechniqueEntry& entry = techniqueEntry(spec.id);
            if (hasHoles && entry.family == Family::Shadow && !entry.traits.neutral && !entry.traits.domain.alphaTest)
                request.warnings.push_back(
                    fmt::format("{} does not see the holes of the scene's alpha-tested casters", spec.id));
        }
}

void checkLight(const Light& light, const RenderSettings& settings, RenderRequest& request) {
    for (const TechniqueSpec& spec : settings.shadow) {
        const TechniqueEntry& entry = techniqueEntry(spec.id);
        if (entry.family != Family::Shadow) continue;
        const Domain& domain = entry.traits.domain;
        if (!supports(domain, light.type))
            throw Error(
                ErrorCode::Usage,
                fmt::format("{} does not support the {} light '{}'", entry.id(), lightTypeName(light.type), light.name),
                "choose another light with --light or another technique");
        if (light.hasSize() && !domain.soft && !entry.traits.neutral)
            request.warnings.push_back(
                fmt::format("{} takes the sized light '{}' as a point at its centre", entry.id(), light.name));
    }
}

}  // namespace

RenderRequest checkRequest(const Scene& scene, const RenderSettings& settings) {
    constexpr int kLargest = 16384;
    if (settings.width < 1 || settings.height < 1 || settings.width > kLargest || settings.height > kLargest)
        throw Error(ErrorCode::Usage, fmt::format("a picture of {} x {} pixels", settings.width, settings.height),
                    fmt::format("width and height lie between 1 and {}", kLargest));
    if (settings.frames < 1 || settings.warmupFrames < 0)
        throw Error(ErrorCode::Usage,
                    fmt::format("{} frames after {} to warm up", settings.frames, settings.warmupFrames),
                    "render at least one, after none or more");
    if (settings.overlayOpacity < 0 || settings.overlayOpacity > 1)
        throw Error(ErrorCode::Usage, fmt::format("an overlay opacity of {}", settings.overlayOpacity),
                    "it lies between 0 and 1");

    checkPipeline(settings.shadow, Family::Shadow);
    checkPipeline(settings.ao, Family::Ao);
    checkPipeline(settings.indirect, Family::Indirect);
    checkPipeline(settings.aa, Family::Aa);

    RenderRequest request;
    request.camera = scene.cameraIndex(settings.camera);
    if (settings.light.empty()) {
        request.lights.resize(scene.lights.size());
        std::iota(request.lights.begin(), request.lights.end(), 0);
    } else {
        request.lights = {scene.lightIndex(settings.light)};
    }
    for (int light : request.lights) {
        request.places.push_back(fmt::format("shadow {}", light));
        if (settings.givenVisibility.count(light) == 0) checkLight(scene.lights[std::size_t(light)], settings, request);
    }
    warnOfScene(scene, settings, request);
    for (const char* place : {"ao", "indirect", "aa"}) request.places.emplace_back(place);
    for (const auto& [light, image] : settings.givenVisibility) {
        if (light < 0 || std::size_t(light) >= scene.lights.size())
            throw Error(ErrorCode::Usage, fmt::format("visibility is given for light {}", light),
                        fmt::format("the scene has {} lights, counted from 0", scene.lights.size()));
        if (image.width() != settings.width || image.height() != settings.height || image.planeCount() < 1)
            throw Error(ErrorCode::Usage,
                        fmt::format("the visibility given for light {} has another size than the picture", light));
    }
    for (const Pipeline* pipeline : {&settings.shadow, &settings.ao, &settings.indirect, &settings.aa})
        for (const TechniqueSpec& spec : *pipeline)
            request.needsStencil = request.needsStencil || techniqueEntry(spec.id).traits.needsStencil;

    // Lights are many by mistake more often than by will, and nothing says before the system ends the program.
    constexpr std::uint64_t kMostVisibilityBytes = std::uint64_t(4) << 30;
    const std::uint64_t texelBytes = settings.images ? 2 + 4 : 2;  // a target of 16 bits; its image of 32
    const std::uint64_t visibilityBytes =
        std::uint64_t(settings.width) * std::uint64_t(settings.height) * request.lights.size() * texelBytes;
    const bool hasShadows = settings.shadow.size() > 1 || !techniqueEntry(settings.shadow[0].id).traits.neutral;
    if ((hasShadows || settings.images) && visibilityBytes > kMostVisibilityBytes)
        throw Error(ErrorCode::Usage,
                    fmt::format("the visibility of {} lights at {} x {} pixels takes {} MiB; at most {} are used",
                                request.lights.size(), settings.width, settings.height, visibilityBytes >> 20,
                                kMostVisibilityBytes >> 20),
                    "make the picture smaller or choose one light");

    request.samples = samplesOf(settings.aa);
    request.needsMaterial = settings.shading == Shading::Pbr ||
                            std::any_of(settings.show.begin(), settings.show.end(),
                                        [](const std::string& name) { return name == "material" || name == "all"; });

    // A light beyond the first shows its visibility and its intermediates as NAME@LIGHT.
    std::vector<std::string> names{"all"}, perLight{"visibility"};
    for (const PassInfo& pass : showNamesOf(settings)) names.push_back(pass.name);
    for (const TechniqueSpec& spec : settings.shadow)
        for (const PassInfo& pass : techniqueEntry(spec.id).traits.passes) perLight.push_back(pass.name);
    for (std::size_t i = 1; i < request.lights.size(); ++i)
        for (const std::string& name : perLight)
            names.push_back(name + "@" + scene.lights[std::size_t(request.lights[i])].name);
    for (const std::string& wanted : settings.show)
        if (std::find(names.begin(), names.end(), wanted) == names.end())
            throw unknownName("picture to show", wanted, names);
    return request;
}

std::vector<PassInfo> showNamesOf(const RenderSettings& settings) {
    std::vector<PassInfo> names = {{"final", "the composed picture"},
                                   {"visibility", "of the first light, 1 = lit"},
                                   {"ao", "visibility of the surroundings after filtering, 1 = open"},
                                   {"indirect", "one-bounce radiance"}};
    const auto& views = standardGBufferViews();
    names.insert(names.end(), views.begin(), views.end());
    if (settings.ao.size() > 1) names.push_back({"ao-unfiltered", "visibility of the surroundings before filtering"});
    for (const Pipeline* pipeline : {&settings.shadow, &settings.ao, &settings.indirect, &settings.aa})
        for (const TechniqueSpec& spec : *pipeline) {
            const auto& passes = techniqueEntry(spec.id).traits.passes;
            names.insert(names.end(), passes.begin(), passes.end());
        }
    return names;
}

}  // namespace ombrage
