// SPDX-License-Identifier: MIT
// shadow/planar: casters projected onto the planes of flat receivers.
#include <algorithm>
#include <cmath>
#include <optional>

#include <ombrage/error.h>

#include "render/frame_context.h"
#include "render/technique.h"
#include "scene/planar_surfaces.h"

namespace ombrage {

namespace {

/// Which planes receive.
enum class PlanarReceivers { Found, Given };

}  // namespace

template <>
struct EnumChoices<PlanarReceivers> {
    static std::vector<std::string> names() { return {"found", "given"}; }
};

namespace {

constexpr int kMostPlanes = int(1 / kLeastPlanarShare);
constexpr unsigned kPlaneStorage = 3;

struct PlanarParams {
    PlanarReceivers receivers = PlanarReceivers::Found;
    int planes = kMostPlanes;
    glm::vec3 normal{0, 1, 0};
    float offset_m = 0;
    float opacity = 1;

    static ParamTable describe() {
        using P = PlanarParams;
        return fields(
            field(&P::receivers, "receivers")
                .effect(ParamEffect::Resize)
                .help(
                    "The flat surfaces found in the scene, floors first, or the one plane given by normal and offset."),
            field(&P::planes, "planes")
                .range(1, kMostPlanes)
                .effect(ParamEffect::Host)
                .help("How many of the planes found receive at most: fewer cost less, and what is left out has no "
                      "shadow."),
            field(&P::normal, "normal")
                .range(-1, 1)
                .effect(ParamEffect::Resize)
                .help("Of the given plane, of any length but 0."),
            field(&P::offset_m, "offset", Unit::Metre)
                .range(-1e6, 1e6)
                .effect(ParamEffect::Resize)
                .help("Distance of the given plane from the world's origin, along its normal."),
            field(&P::opacity, "opacity")
                .range(0, 1)
                .help(
                    "How much of the light a shadow takes: less than 1 is the half-transparent dark that the classical "
                    "method blends."));
    }
};

/// The planes of a scene and, per triangle, which it lies in, for receivers.frag.
struct ReceiverPlanes {
    std::vector<Plane> planes;
    float tolerance_m = 0;
    gl::Buffer planeOf;

    ReceiverPlanes(const FlatScene& flat, PlanarSurfaces surfaces) : planes(std::move(surfaces.planes)) {
        tolerance_m = float(planeTolerance_m(flat));
        surfaces.planeOf.resize((surfaces.planeOf.size() + 3) / 4 * 4 + 4);
        planeOf = gl::Buffer::from(surfaces.planeOf, "receiver planes");
    }
};

/// Found once per scene, whatever the number of lights.
struct FoundPlanes : ReceiverPlanes {
    explicit FoundPlanes(const GpuScene& scene) : ReceiverPlanes(scene.flat(), findPlanarSurfaces(scene.flat())) {}
};

ReceiverPlanes givenPlane(const FlatScene& flat, const PlanarParams& params) {
    const double length = glm::length(glm::dvec3(params.normal));
    if (!(length > 0))
        throw Error(ErrorCode::Usage, "the normal of the plane that shadow/planar is given is 0",
                    "give a direction, as in normal=(0;1;0)");
    PlanarSurfaces surfaces;
    Plane plane;
    plane.normal = glm::dvec3(params.normal) / length;
    plane.offset_m = double(params.offset_m) - glm::dot(plane.normal, flat.origin);
    surfaces.planes = {plane};
    surfaces.planeOf.assign(flat.triangles.size(), 0);
    const double tolerance_m = planeTolerance_m(flat);
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
        if (liesIn(plane, flat, t, tolerance_m)) surfaces.planeOf[t] = 1;
    return {flat, std::move(surfaces)};
}

class Planar final : public ShadowTechniqueOf<PlanarParams> {
public:
    void prepare(FrameContext&) override { m_given.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const ReceiverPlanes* receivers = nullptr;
        if (p().receivers == PlanarReceivers::Found) {
            receivers = &frame.gpuScene->derived<FoundPlanes>();
        } else {
            if (!m_given) m_given.emplace(givenPlane(frame.gpuScene->flat(), p()));
            receivers = &*m_given;
        }
        m_bytes = receivers->planeOf.size();
        if (receivers->planes.empty()) frame.warn("shadow/planar finds no flat receiver in this scene");

        // Planes that the light and the eye see from one side, with a caster above them.
        std::vector<std::pair<int, glm::vec4>> active;
        int used = int(receivers->planes.size());
        if (p().receivers == PlanarReceivers::Found) used = std::min(used, p().planes);
        for (int i = 0; i < used; ++i)
            if (const auto plane = lightSide(frame, light, receivers->planes[std::size_t(i)], receivers->tolerance_m))
                active.emplace_back(i + 1, *plane);
        frame.counter("receiver planes", double(active.size()));
        if (active.empty()) return;
        markReceivers(frame, *receivers, active.back().first);
        if (frame.wants("planar-receivers")) frame.expose("planar-receivers", frame.gbuffer->depth, ShowAs::Stencil);

        const auto pass = frame.pass("projected casters");
        const gl::Framebuffer target({{&visibility}}, {&frame.gbuffer->depth}, "projected casters");
        target.bind();
        frame.gpuScene->bindStorage();
        for (const auto& [id, plane] : active) drawShadows(frame, light, id, plane, receivers->tolerance_m);
    }

    std::uint64_t gpuBytes() const override { return m_bytes; }

private:
    /// The plane turned to the light, dot(xyz, p) + w, or nothing where it can show no shadow of this light.
    static std::optional<glm::vec4> lightSide(const FrameContext& frame, const LightFrame& light, const Plane& plane,
                                              float tolerance_m) {
        glm::vec4 turned(plane.normal, -plane.offset_m);
        const glm::vec4 toward = light.toward();
        const float lightHeight = glm::dot(turned, toward);
        if (lightHeight < 0) turned = -turned;
        // A light in the plane grazes it; a sun's height is a sine, a lamp's is in metres.
        if (std::abs(lightHeight) <= (toward.w == 0.0f ? 1e-6f : tolerance_m)) return std::nullopt;

        const bool seen = frame.view.orthographic ? glm::dot(glm::vec3(turned), frame.view.forward) < 0
                                                  : glm::dot(turned, glm::vec4(frame.view.eye, 1.0f)) > 0;
        const glm::vec3 lower = frame.gpuScene->casterLower(), upper = frame.gpuScene->casterUpper();
        float highest = turned.w;
        for (int axis = 0; axis < 3; ++axis)
            highest += std::max(turned[axis] * lower[axis], turned[axis] * upper[axis]);
        if (!seen || highest <= tolerance_m) return std::nullopt;
        return turned;
    }

    /// The stencil of every surface becomes the number of its plane, one bit per pass.
    void markReceivers(FrameContext& frame, const ReceiverPlanes& receivers, int highestId) {
        const auto pass = frame.pass("planar receivers");
        const gl::Framebuffer target({}, {&frame.gbuffer->depth}, "planar receivers");
        target.bind();
        target.clearStencil(0);
        frame.bindGBuffer();
        receivers.planeOf.bindStorage(kPlaneStorage);
        const gl::Program& program = frame.fullscreenProgram(*this, "shadow/planar/receivers.frag");
        gl::DrawState state;
        // The triangle lies at depth 0, the sky's; surfaces have more.
        state.depthTest = true;
        state.depthFunc = GL_LESS;
        state.colorWrite = false;
        state.stencilTest = true;
        state.stencilFront.reference = state.stencilBack.reference = 0xff;
        state.stencilFront.depthPass = state.stencilBack.depthPass = GL_REPLACE;
        for (unsigned bit = 1; bit <= unsigned(highestId); bit <<= 1) {
            state.stencilWriteMask = bit;
            gl::apply(state);
            program.set("u_bit", bit);
            frame.drawFullscreen();
        }
    }

    /// Every pixel of the plane takes the first shadow that covers it and no other: its stencil falls to 0.
    void drawShadows(FrameContext& frame, const LightFrame& light, int id, const glm::vec4& plane, float tolerance_m) {
        gl::DrawState state;
        state.stencilTest = true;
        for (gl::DrawState::StencilFace* face : {&state.stencilFront, &state.stencilBack}) {
            face->func = GL_EQUAL;
            face->reference = id;
            face->depthPass = GL_ZERO;
        }
        state.clipDistances = 2;
        const auto draw = [&](DrawFilter::Alpha alpha, bool positionsOnly) {
            std::vector<std::pair<std::string, std::string>> defines;
            if (!positionsOnly) defines.emplace_back("ALPHA_MASK", "1");
            const gl::Program& program = frame.program(
                *this,
                {{GL_VERTEX_SHADER, "shadow/planar/planar.vert"}, {GL_FRAGMENT_SHADER, "shadow/planar/planar.frag"}},
                std::move(defines));
            program.set("u_plane", plane);
            program.set("u_toward", light.toward());
            program.set("u_tolerance_m", tolerance_m);
            for (const DrawBatch& batch :
                 frame.gpuScene->batches({.castersOnly = true, .excludedByLight = light.index, .alpha = alpha})) {
                // The lit side of a solid has the whole shadow; eye and light are on one side of the plane, so it keeps
                // its winding.
                state.cull = frame.gpuScene->hidesBackFaces(batch, light.toward(), tolerance_m) ? GL_BACK : GL_NONE;
                gl::apply(state);
                const DrawCounts counts = frame.gpuScene->draw(batch, positionsOnly);
                frame.countDraw(counts.draws, counts.triangles);
            }
        };
        draw(DrawFilter::Alpha::OpaqueOnly, true);
        if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly, false);
    }

    std::optional<ReceiverPlanes> m_given;
    std::uint64_t m_bytes = 0;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, planar, Planar,
    {.title = "Planar projected shadows",
     .summary = "Casters flattened by a 4x4 matrix onto the planes of flat receivers, found in the scene or given.",
     .papers = {"blinn1988me", "kilgard1999stencils"},
     .limits =
         "Flat receivers only: whatever does not lie in one of the planes has no shadow, and every plane draws all "
         "casters again.",
     .domain = {.rect = false, .planarReceiversOnly = true},
     .passes = {{"planar-receivers", "number of the plane that the visible surface lies in"}},
     .needsStencil = true})

}  // namespace ombrage
