// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <ombrage/ao_integrand.h>
#include <ombrage/metrics.h>
#include <ombrage/technique.h>

#include "core/param_table.h"
#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/geometry_samples.h"
#include "render/target_pool.h"

namespace ombrage {

class FrameContext;
struct LightFrame;
struct TechniqueEntry;

/// A technique at work. One object serves one place of a pipeline (for shadows: one light), so it may keep caches
/// between frames. Created and destroyed with the context current.
class Technique {
public:
    virtual ~Technique() = default;

    /// The parameter struct that the table describes.
    virtual void* params() = 0;
    virtual const ParamTable& table() const = 0;

    /// Called before the first frame and whenever the picture's size, the scene or a Define or Resize parameter changed:
    /// drop what depends on them.
    virtual void prepare(FrameContext&) {}

    /// Called in its place when instances of the scene moved and nothing else changed (Renderer::moveScene): drop what
    /// depends on where they were. The GpuScene and what is derived from it are new. A technique that gathers over frames
    /// keeps its history by overriding this; of lights and cameras that moved nothing is told.
    virtual void sceneMoved(FrameContext& frame) { prepare(frame); }

    /// The row that made this object; set by createTechnique().
    const TechniqueEntry& entry() const { return *m_entry; }
    void setEntry(const TechniqueEntry& entry) { m_entry = &entry; }

    /// Bytes of GPU memory held between frames (targets taken from the pool are counted there).
    virtual std::uint64_t gpuBytes() const { return 0; }

private:
    const TechniqueEntry* m_entry = nullptr;
};

/// Visibility of one light. `visibility` is R16F of the picture's size, cleared to 1; write [0,1], 1 = fully lit. Pixels of
/// the sky, facing away from the light, or out of its range need no work: composing multiplies by n.l anyway.
class ShadowTechnique : public Technique {
public:
    virtual void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) = 0;

    /// Texel size for the measurement of the frame just rendered; the default has no texels.
    virtual TexelFootprint footprint() const { return {}; }

    /// Where the frame just rendered has data; the default covers everything.
    virtual ShadowRange range() const { return {}; }

    /// The visibility just rendered in colour, RGBA16F, where shadows let some colours through and others not; null where
    /// red, green and blue are all `visibility`, which else is its luminance. Lighting takes it in the place of
    /// `visibility` when the technique ends its pipeline.
    virtual TargetPool::Target takeColored() { return nullptr; }

    /// What follows "+" in a pipeline refines the visibility before it instead of starting from 1.
    virtual bool refinesInput() const { return false; }
};

/// How a technique answers at any point of the scene, in whatever shader asks.
struct ShadowLookup {
    /// GLSL that defines `float shadowVisibility(vec3 p_world, vec3 n_g)`, 1 = lit, of the bound light, for a point of a
    /// surface with the normal n_g, of any length, on the side seen.
    std::string path;
    std::vector<std::pair<std::string, std::string>> defines;
    std::function<void(const gl::Program&)> bind;  ///< its textures, from kFirstFreeUnit on, and uniforms
    /// GLSL of the vertex stage of a full-screen pass that defines `void passLookup()`, which writes what the lookup reads
    /// as PER_PASS (ombrage/per_pass.glsl).
    std::string perPass = "void passLookup() {}\n";
};

/// A technique that answers at any point: where nobody wants its image, lighting asks it pixel by pixel.
class ShadowLookupTechnique : public ShadowTechnique {
public:
    /// Draws what the lookup reads.
    virtual ShadowLookup lookup(FrameContext& frame, const LightFrame& light) = 0;

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) final;
};

/// The include through which shaders reach a lookup, and the virtual one that leads there.
inline constexpr const char* kShadowLookupPath = "ombrage/shadow_lookup";
std::vector<std::pair<std::string, std::string>> includeOf(const ShadowLookup& lookup);

/// Visibility of the surroundings. `visibility` is R16F of the picture's size; write every pixel (sky: 1).
class AoTechnique : public Technique {
public:
    virtual void render(FrameContext& frame, const gl::Texture& visibility) = 0;
};

/// Cleans an R16F image of the picture's size. `output` is another texture of the same kind.
class FilterTechnique : public Technique {
public:
    virtual void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) = 0;
};

/// One bounce: RGBA16F radiance leaving the surface towards the eye, added to the picture. Write every pixel.
class IndirectTechnique : public Technique {
public:
    virtual void render(FrameContext& frame, const gl::Texture& radiance) = 0;
};

/// Takes the composed picture, RGBA16F linear; `output` is another texture of the same kind.
class AaTechnique : public Technique {
public:
    /// Where in its pixels the frame is seen, in pixels from their centres, right and up, at least one point. The renderer
    /// draws the frame for each of them, in order, and calls render() after each; the last call's output is the frame's
    /// picture. Asked once a frame, before anything of it is drawn.
    virtual std::vector<glm::vec2> samplePoints(const FrameContext&) { return {glm::vec2(0.0f)}; }

    /// How often the geometry of each pixel is sampled in one drawing. With more than one sample the composed picture shows
    /// one surface a pixel, and FrameContext::edgeColors every sample of the pixels that show several. Asked before
    /// prepare().
    virtual GeometrySamples geometrySamples() const { return {}; }

    virtual void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) = 0;
};

/// Base of technique classes: holds the parameters. P has a static ParamTable describe().
template <typename Base, typename P>
class WithParams : public Base {
public:
    void* params() final { return &m_params; }
    const ParamTable& table() const final { return staticTable(); }
    static const ParamTable& staticTable() {
        static const ParamTable table = P::describe();
        return table;
    }

protected:
    const P& p() const { return m_params; }

private:
    P m_params;
};

/// For techniques without parameters.
struct NoParams {
    static ParamTable describe() { return {}; }
};

template <typename P = NoParams> using ShadowTechniqueOf = WithParams<ShadowTechnique, P>;
template <typename P = NoParams> using ShadowLookupTechniqueOf = WithParams<ShadowLookupTechnique, P>;
template <typename P = NoParams> using AoTechniqueOf = WithParams<AoTechnique, P>;
template <typename P = NoParams> using FilterTechniqueOf = WithParams<FilterTechnique, P>;
template <typename P = NoParams> using IndirectTechniqueOf = WithParams<IndirectTechnique, P>;
template <typename P = NoParams> using AaTechniqueOf = WithParams<AaTechnique, P>;

/// Makes the integral that a technique of ambient occlusion claims, for parameters that differ from the defaults.
using IntegrandMaker = std::function<std::unique_ptr<AoIntegrand>(const TechniqueSpec&)>;

/// The values of `spec` put into a parameter struct. @throws Error(Usage) as createTechnique.
void setParams(const TechniqueSpec& spec, const ParamTable& table, void* params);

/// The maker for TechniqueTraits from a function of the technique's parameter struct.
template <typename P>
IntegrandMaker integrandOf(std::unique_ptr<AoIntegrand> (*make)(const P&)) {
    return [make](const TechniqueSpec& spec) {
        P params;
        setParams(spec, P::describe(), &params);
        return make(params);
    };
}

/// What a technique's source says of itself, beside its parameters.
struct TechniqueTraits {
    std::string title;
    std::string summary;
    std::vector<std::string> papers;   ///< keys of docs/references.bib
    std::string limits;
    Domain domain;
    std::vector<PassInfo> passes;      ///< every name that the technique exposes
    bool needsStencil = false;         ///< the G-buffer's depth must carry a stencil plane
    bool neutral = false;              ///< changes nothing (visibility 1, radiance 0, the input): rendering may leave it out
    bool screenSpace = false;          ///< of a shadow: its answer depends on where in the picture a surface lies; that of
                                       ///< every other family does
    bool usesSeed = false;             ///< its answer depends on RenderSettings::seed: `noise` is measured
    /// Frames after which a technique that gathers over them has settled; 0: it does not. A call that starts its history
    /// draws as many before those that count, and every frame has random numbers of its own.
    int settlingFrames = 0;
    IntegrandMaker integrand = {};     ///< ambient occlusion: what it claims to compute, for the truth `own`; none: no claim
};

/// A row of the generated table.
struct TechniqueEntry {
    Family family;
    std::string name;  ///< of the folder
    std::string id() const { return std::string(familyName(family)) + "/" + name; }
    TechniqueTraits traits;
    const ParamTable& (*table)();
    std::function<std::unique_ptr<Technique>()> create;
    bool answersAnywhere = false;  ///< a ShadowLookupTechnique
};

/// Makes the name of a folder from its identifier: volume_zfail -> volume-zfail.
std::string techniqueNameFromIdentifier(const char* identifier);

/// The generated table: one pointer per folder of src/techniques/FAMILY.
const std::vector<const TechniqueEntry*>& techniqueEntries();

/// @throws Error(Usage) with a suggestion.
const TechniqueEntry& techniqueEntry(const std::string& id);

/// Makes the technique and sets its parameters.
std::unique_ptr<Technique> createTechnique(const TechniqueSpec& spec);

/// Registers a class: OMBRAGE_TECHNIQUE(shadow, volume_zfail, VolumeZFail, {.title = "...", ...}) in the folder
/// src/techniques/shadow/volume-zfail. The definition is found by the build through its name: no static initialiser.
#define OMBRAGE_FAMILY_shadow ::ombrage::Family::Shadow
#define OMBRAGE_FAMILY_ao ::ombrage::Family::Ao
#define OMBRAGE_FAMILY_filter ::ombrage::Family::Filter
#define OMBRAGE_FAMILY_indirect ::ombrage::Family::Indirect
#define OMBRAGE_FAMILY_aa ::ombrage::Family::Aa
#define OMBRAGE_TECHNIQUE(familyId, nameId, Class, ...)                                                               \
    const ::ombrage::TechniqueEntry& techniqueEntry_##familyId##_##nameId() {                                         \
        static const ::ombrage::TechniqueEntry entry{OMBRAGE_FAMILY_##familyId,                                       \
                                                     ::ombrage::techniqueNameFromIdentifier(#nameId),                 \
                                                     ::ombrage::TechniqueTraits __VA_ARGS__,                          \
                                                     &Class::staticTable,                                             \
                                                     [] { return std::make_unique<Class>(); },                        \
                                                     std::is_base_of_v<::ombrage::ShadowLookupTechnique, Class>};     \
        return entry;                                                                                                 \
    }

}  // namespace ombrage
