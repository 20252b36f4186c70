// SPDX-License-Identifier: MIT
#include "render/technique.h"

#include <algorithm>
#include <tuple>

#include <ombrage/error.h>

#include "render/frame_context.h"

namespace ombrage {

namespace detail {
std::vector<const TechniqueEntry*> generatedTechniqueEntries();
}

std::string techniqueNameFromIdentifier(const char* identifier) {
    std::string name = identifier;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

const std::vector<const TechniqueEntry*>& techniqueEntries() {
    static const std::vector<const TechniqueEntry*> entries = [] {
        auto all = detail::generatedTechniqueEntries();
        // By family, then by name, the family's cost baseline first.
        std::sort(all.begin(), all.end(), [](const TechniqueEntry* a, const TechniqueEntry* b) {
            const auto key = [](const TechniqueEntry* e) { return std::tuple(e->family, e->name != "none", e->name); };
            return key(a) < key(b);
        });
        return all;
    }();
    return entries;
}

const TechniqueEntry& techniqueEntry(const std::string& id) {
    std::vector<std::string> ids;
    for (const TechniqueEntry* entry : techniqueEntries()) {
        if (entry->id() == id) return *entry;
        ids.push_back(entry->id());
    }
    throw unknownName("technique", id, ids);
}

bool supports(const Domain& domain, LightType type) {
    switch (type) {
        case LightType::Sun:
            return domain.sun;
        case LightType::Spot:
            return domain.spot;
        case LightType::Point:
            return domain.point;
        case LightType::Rect:
            return domain.rect;
    }
    return false;
}

void setParams(const TechniqueSpec& spec, const ParamTable& table, void* params) {
    for (const auto& [key, text] : spec.params) {
        const ParamField& field = table.find(key, spec.id);
        field.set(params, ParamTable::parse(field.info, text, spec.id));
    }
}

std::unique_ptr<AoIntegrand> ownIntegrand(const Pipeline& pipeline) {
    if (pipeline.empty()) return nullptr;
    const IntegrandMaker& maker = techniqueEntry(pipeline.front().id).traits.integrand;
    return maker ? maker(pipeline.front()) : nullptr;
}

std::unique_ptr<Technique> createTechnique(const TechniqueSpec& spec) {
    const TechniqueEntry& entry = techniqueEntry(spec.id);
    std::unique_ptr<Technique> technique = entry.create();
    technique->setEntry(entry);
    setParams(spec, technique->table(), technique->params());
    return technique;
}

std::vector<std::pair<std::string, std::string>> includeOf(const ShadowLookup& lookup) {
    return {{kShadowLookupPath, "#include \"" + lookup.path + "\"\n"},
            {"ombrage/per_pass_lookup.glsl", lookup.perPass}};
}

void ShadowLookupTechnique::render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) {
    const ShadowLookup at = lookup(frame, light);
    const auto pass = frame.pass("visibility");
    const gl::Framebuffer target({{&visibility}}, {&frame.gbuffer->depth}, entry().id().c_str());
    target.bind();
    const gl::Program& program = frame.program(
        *this, {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "ombrage/visibility.frag"}},
        at.defines, includeOf(at));
    at.bind(program);
    frame.bindGBuffer();
    frame.drawSurfaces();
}

const char* familyName(Family family) {
    switch (family) {
        case Family::Shadow:
            return "shadow";
        case Family::Ao:
            return "ao";
        case Family::Filter:
            return "filter";
        case Family::Indirect:
            return "indirect";
        case Family::Aa:
            return "aa";
    }
    return "";
}

Family familyFromName(const std::string& name) {
    std::vector<std::string> names;
    for (Family family : {Family::Shadow, Family::Ao, Family::Filter, Family::Indirect, Family::Aa}) {
        if (name == familyName(family)) return family;
        names.emplace_back(familyName(family));
    }
    throw unknownName("family", name, names);
}

const std::vector<TechniqueInfo>& techniques() {
    static const std::vector<TechniqueInfo> infos = [] {
        std::vector<TechniqueInfo> made;
        for (const TechniqueEntry* entry : techniqueEntries()) {
            const TechniqueTraits& t = entry->traits;
            TechniqueInfo info{entry->id(), entry->family, entry->name,
                               t.title,     t.summary,     t.papers,
                               t.limits,    t.domain,      t.screenSpace || entry->family != Family::Shadow,
                               t.usesSeed,  t.passes,      {}};
            for (const ParamField& field : entry->table().fields()) info.params.push_back(field.info);
            made.push_back(std::move(info));
        }
        return made;
    }();
    return infos;
}

const TechniqueInfo& technique(const std::string& id) {
    const TechniqueEntry& entry = techniqueEntry(id);
    for (const TechniqueInfo& info : techniques())
        if (info.id == entry.id()) return info;
    throw unknownName("technique", id, {});
}

const TechniqueInfo& technique(Family family, const std::string& nameOrId) {
    if (nameOrId.find('/') != std::string::npos) return technique(nameOrId);
    std::vector<std::string> names;
    for (const TechniqueInfo& info : techniques()) {
        if (info.family != family) continue;
        if (info.name == nameOrId) return info;
        names.push_back(info.name);
    }
    throw unknownName(std::string(familyName(family)) + " technique", nameOrId, names);
}

}  // namespace ombrage
