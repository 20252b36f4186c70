// SPDX-License-Identifier: MIT
// shadow/planar: casters projected onto the planes of flat receivers. See planar.md.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shadow/planar/blur.h"
#include "techniques/shadow/planar/edge_on.h"
#include "techniques/shadow/planar/planar_params.h"
#include "techniques/shadow/planar/receiver_planes.h"

namespace ombrage {

namespace {

using namespace planar;

using Defines = std::vector<std::pair<std::string, std::string>>;

constexpr unsigned kPlaneStorage = 3, kEdgeOnStorage = 4;
/// The mask's border outside of the picture, where blurs reach for what is not seen.
constexpr float kBorderShare = 0.125f;

/// What a draw of the flattened casters is for.
struct CasterDraw {
    Defines defines;
    bool cullsBackFaces = true;
    bool needsColor = false;  ///< the casters' base colour
    glm::vec2 zoom{1.0f};
    float grey = 1;
};

class Planar final : public ShadowTechniqueOf<Params> {
public:
    void prepare(FrameContext&) override {
        m_given.reset();
        m_edgeOn.clear();
    }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const ReceiverPlanes& receivers = findReceivers(frame);
        m_bytes = receivers.planeOf.size();
        const ClipRules clip{p().clipLight, p().clipPlane};
        const int count = p().receivers == Source::Found ? p().planes : 1;
        const std::vector<ActivePlane> active = activePlanes(frame, light, receivers, count, clip);
        frame.counter("receiver planes", double(active.size()));
        const bool isColored = p().style != Style::Plain || frame.wants("planar-passed");
        m_colored = isColored ? takeTarget(frame, GL_RGBA16F, "planar passed light") : nullptr;
        if (m_colored) gl::Framebuffer({{m_colored.get()}}, {}, "planar passed").clearColor(0, glm::vec4(1.0f));
        if (!active.empty()) markReceivers(frame, receivers, active.back().id);
        showStages(frame, light, active, receivers.tolerance_m);
        // A blur spreads the whole shadow over its own surface: it has no use for the defects of single triangles.
        const bool blurs = p().blur != Blur::Off && light.light->hasSize() && p().limit && p().stencil;
        if (blurs)
            drawBlurred(frame, light, active, receivers.tolerance_m, visibility);
        else if (!active.empty())
            drawSharp(frame, light, active, receivers.tolerance_m, visibility);
        if (frame.wants("planar-passed")) frame.expose("planar-passed", *m_colored, ShowAs::Color);
        if (p().style == Style::Plain || active.empty()) m_colored.reset();
    }

    TargetPool::Target takeColored() override { return std::move(m_colored); }

    std::uint64_t gpuBytes() const override { return m_bytes + m_edgeOn.gpuBytes(); }

private:
    const ReceiverPlanes& findReceivers(FrameContext& frame) {
        if (p().receivers == Source::Found) {
            const ReceiverPlanes& found = frame.gpuScene->derived<FoundPlanes>();
            if (found.planes.empty()) frame.warn("shadow/planar finds no flat receiver in this scene");
            return found;
        }
        if (!m_given) m_given.emplace(givenPlane(frame.gpuScene->flat(), p().normal, p().offset_m));
        if (m_given->empty)
            frame.warn(
                fmt::format("no surface lies in the plane that shadow/planar is given, normal=({};{};{}),offset={}, so "
                            "there is no shadow: set both to those of a flat surface, or take receivers=found",
                            p().normal.x, p().normal.y, p().normal.z, p().offset_m));
        return *m_given;
    }

    static TargetPool::Target takeTarget(FrameContext& frame, GLenum format, const char* label) {
        return frame.targets->take({.format = format, .width = frame.width, .height = frame.height}, label);
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
        program.set("u_highest", unsigned(highestId));
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

    /// Draws the casters through the plane's matrix, into the framebuffer that is bound.
    void drawCasters(FrameContext& frame, const LightFrame& light, const ActivePlane& plane, float tolerance_m,
                     gl::DrawState state, const CasterDraw& how) {
        state.clipDistances = 2;
        const gl::Buffer* edgeOn = m_edgeOn.find(frame, light, tolerance_m);
        const auto draw = [&](DrawFilter::Alpha alpha) {
            const bool isMasked = alpha == DrawFilter::Alpha::MaskedOnly;
            for (const DrawBatch& batch :
                 frame.gpuScene->batches({.castersOnly = true, .excludedByLight = light.index, .alpha = alpha})) {
                const bool isMapped = how.needsColor && batch.textures[0] >= 0;
                const bool hasColors = how.needsColor && frame.gpuScene->hasVertexColors();
                Defines defines = how.defines;
                const auto define = [&](const char* name, bool wanted) {
                    if (wanted) defines.emplace_back(name, "1");
                };
                define("ALPHA_MASK", isMasked);
                define("BASE_COLOR_MAP", isMapped);
                define("VERTEX_COLORS", hasColors);
                define("UV", isMasked || isMapped);
                define("SURFACE", isMasked || how.needsColor);
                define("EDGE_ON", edgeOn != nullptr);
                define("NO_LIGHT_CLIP", !p().clipLight && light.light->type != LightType::Sun);
                define("NO_PLANE_CLIP", !p().clipPlane);
                const gl::Program& program = frame.program(*this,
                                                           {{GL_VERTEX_SHADER, "shadow/planar/planar.vert"},
                                                            {GL_FRAGMENT_SHADER, "shadow/planar/planar.frag"}},
                                                           std::move(defines));
                program.set("u_plane", plane.plane);
                program.set("u_toward", light.toward());
                program.set("u_tolerance_m", tolerance_m);
                program.set("u_zoom", how.zoom);
                program.set("u_grey", how.grey);
                // The lit side of a solid has the whole shadow; eye and light are on one side of the plane, so it keeps
                // its winding.
                const bool culls = how.cullsBackFaces && p().clipLight && p().clipPlane &&
                                   frame.gpuScene->hidesBackFaces(batch, light.toward(), tolerance_m);
                state.cull = culls ? GL_BACK : GL_NONE;
                gl::apply(state);
                const DrawCounts counts = frame.gpuScene->draw(batch, !isMasked && !isMapped && !hasColors && !edgeOn);
                frame.countDraw(counts.draws, counts.triangles);
            }
        };
        frame.gpuScene->bindStorage();
        if (edgeOn) edgeOn->bindStorage(kEdgeOnStorage);
        draw(DrawFilter::Alpha::OpaqueOnly);
        if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly);
    }

    /// Lets through the pixels of a plane.
    static void limitTo(gl::DrawState& state, int id, GLenum afterwards) {
        state.stencilTest = true;
        for (gl::DrawState::StencilFace* face : {&state.stencilFront, &state.stencilBack}) {
            face->func = GL_EQUAL;
            face->reference = id;
            face->depthPass = afterwards;
        }
    }

    /// How shadows reach the picture: the rules of the classical method, each of which can be left out.
    gl::DrawState sharpState(int id) const {
        gl::DrawState state;
        if (p().limit) {
            // Every pixel of the plane takes the first shadow that covers it and no other: its stencil falls to 0.
            limitTo(state, id, p().stencil ? GL_ZERO : GL_KEEP);
        } else {
            // The flattened casters are a piece of geometry like any other, drawn just before the plane; the first one
            // raises the top bit of the stencil.
            state.depthTest = true;
            state.polygonOffsetFactor = 2;
            state.polygonOffsetUnits = 64;
            limitTo(state, 0, p().stencil ? GL_INVERT : GL_KEEP);
            state.stencilFront.readMask = state.stencilBack.readMask = p().stencil ? 0x80 : 0;
            state.stencilWriteMask = 0x80;
        }
        if (!p().stencil) {
            state.blend = true;
            state.blendSource = GL_ZERO;
            state.blendDestination = GL_SRC_COLOR;
        }
        return state;
    }

    void drawSharp(FrameContext& frame, const LightFrame& light, const std::vector<ActivePlane>& active,
                   float tolerance_m, const gl::Texture& visibility) {
        const auto pass = frame.pass("projected casters");
        std::vector<gl::Attachment> colors{{&visibility}};
        CasterDraw how;
        // Whoever blends every triangle sees both sides of a solid.
        how.cullsBackFaces = p().stencil;
        how.needsColor = p().style == Style::Textured;
        if (p().style == Style::Hatched) how.defines.emplace_back("ON_PLANE", "1");
        if (m_colored) {
            colors.push_back({m_colored.get()});
            how.defines.emplace_back("COLORED", "1");
        }
        const gl::Framebuffer target(colors, {&frame.gbuffer->depth}, "projected casters");
        target.bind();
        for (const ActivePlane& plane : active)
            drawCasters(frame, light, plane, tolerance_m, sharpState(plane.id), how);
    }

    /// Plane by plane: the casters into a mask that knows nothing of the receiver's edges nor of what stands before it,
    /// then the mask, blurred, onto the receiver.
    void drawBlurred(FrameContext& frame, const LightFrame& light, const std::vector<ActivePlane>& active,
                     float tolerance_m, const gl::Texture& visibility) {
        if (active.empty()) return;
        const int border = int(std::ceil(kBorderShare * float(frame.height)));
        const int width = frame.width + 2 * border, height = frame.height + 2 * border;
        const auto take = [&](GLenum format) {
            auto target =
                frame.targets->take({.format = format, .width = width, .height = height, .levels = 0}, "planar mask");
            target->setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
            return target;
        };
        const auto mask = take(GL_RG16F);
        std::vector<gl::Attachment> maskColors{{mask.get()}}, seenColors{{&visibility}};
        CasterDraw how{.defines = {{"MASK", "1"}, {"HEIGHT", "1"}}};
        how.cullsBackFaces = false;
        how.needsColor = p().style == Style::Textured;
        how.zoom = glm::vec2(frame.width, frame.height) / glm::vec2(width, height);
        TargetPool::Target casterColor;
        if (how.needsColor) {
            casterColor = take(GL_RGBA8);
            maskColors.push_back({casterColor.get()});
            how.defines.emplace_back("COLORED", "1");
        }
        if (m_colored) seenColors.push_back({m_colored.get()});
        const gl::Framebuffer maskTarget(maskColors, {}, "planar mask");
        const gl::Framebuffer seenTarget(seenColors, {&frame.gbuffer->depth}, "planar blur");
        for (const ActivePlane& plane : active) {
            {
                const auto pass = frame.pass("planar mask");
                maskTarget.bind();
                maskTarget.clearColor(0, glm::vec4(0.0f));
                if (casterColor) maskTarget.clearColor(1, glm::vec4(0.0f));
                how.grey = 1 / plane.highest_m;
                gl::DrawState state;
                state.blend = true;
                state.blendEquation = GL_MAX;
                drawCasters(frame, light, plane, tolerance_m, state, how);
                mask->generateMipmap();
                if (casterColor) casterColor->generateMipmap();
            }
            gl::DrawState state;
            limitTo(state, plane.id, GL_KEEP);
            blurMask(frame, *this, p(), light, plane, {mask.get(), casterColor.get(), how.zoom}, seenTarget,
                     m_colored != nullptr, state);
        }
    }

    /// The stages on the way, for those who look at them.
    void showStages(FrameContext& frame, const LightFrame& light, const std::vector<ActivePlane>& active,
                    float tolerance_m) {
        const bool wantsLimit = frame.wants("planar-limit"), wantsPlanes = frame.wants("planar-planes");
        if (wantsLimit || wantsPlanes) {
            const auto pass = frame.pass("shown planes");
            const auto image = takeTarget(frame, GL_RGBA16F, "planar planes");
            const gl::Framebuffer target({{image.get()}}, {&frame.gbuffer->depth}, "planar planes");
            const auto paint = [&](const auto& colorOf) {
                target.bind();
                target.clearColor(0, glm::vec4(0, 0, 0, 1));
                const gl::Program& program = frame.fullscreenProgram(*this, "shadow/planar/shown.frag");
                for (const ActivePlane& plane : active) {
                    gl::DrawState state;
                    limitTo(state, plane.id, GL_KEEP);
                    gl::apply(state);
                    program.set("u_color", colorOf(plane.id));
                    frame.drawFullscreen();
                }
            };
            if (wantsLimit) {
                paint([](int) { return glm::vec3(1.0f); });
                frame.expose("planar-limit", *image, ShowAs::Value);
            }
            if (wantsPlanes) {
                // Hues a golden section of the circle apart, so that neighbours differ.
                paint([](int id) {
                    const glm::vec3 turn = glm::vec3(0.0f, 1.0f, 2.0f) / 3.0f + 0.618034f * float(id);
                    return 0.5f + 0.45f * glm::cos(6.2831853f * turn);
                });
                frame.expose("planar-planes", *image, ShowAs::Color);
            }
        }
        if (frame.wants("planar-projected")) {
            // Every layer of every plane adds a sixth of white, wherever it falls.
            showCasters(frame, light, active, tolerance_m, "planar-projected", GL_FUNC_ADD, false,
                        [](const ActivePlane&) {
                            return CasterDraw{.defines = {{"FLAT", "1"}}, .cullsBackFaces = false, .grey = 1.0f / 6};
                        });
        }
        if (frame.wants("planar-heights"))
            showCasters(frame, light, active, tolerance_m, "planar-heights", GL_MAX, true,
                        [](const ActivePlane& plane) {
                            return CasterDraw{.defines = {{"FLAT", "1"}, {"HEIGHT", "1"}},
                                              .cullsBackFaces = false,
                                              .grey = 1.0f / plane.highest_m};
                        });
    }

    template <typename HowOf>
    void showCasters(FrameContext& frame, const LightFrame& light, const std::vector<ActivePlane>& active,
                     float tolerance_m, const char* name, GLenum equation, bool isLimited, const HowOf& howOf) {
        const auto pass = frame.pass("shown casters");
        const auto image = takeTarget(frame, GL_R16F, "planar shown");
        const gl::Framebuffer target({{image.get()}}, {&frame.gbuffer->depth}, "planar shown");
        target.bind();
        target.clearColor(0, glm::vec4(0.0f));
        for (const ActivePlane& plane : active) {
            gl::DrawState state;
            state.blend = true;
            state.blendEquation = equation;
            if (isLimited) limitTo(state, plane.id, GL_KEEP);
            drawCasters(frame, light, plane, tolerance_m, state, howOf(plane));
        }
        frame.expose(name, *image, ShowAs::Value);
    }

    std::optional<ReceiverPlanes> m_given;
    EdgeOnCasters m_edgeOn;
    TargetPool::Target m_colored;  ///< from render() to takeColored()
    std::uint64_t m_bytes = 0;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, planar, Planar,
    {.title = "Planar projected shadows",
     .summary = "Casters flattened by a 4x4 matrix onto the planes of flat receivers, found in the scene or given.",
     .papers = {"blinn1988me", "kilgard1999stencils", "fernando2005pcss"},
     .limits =
         "Flat receivers only: whatever does not lie in one of the planes has no shadow, and every plane draws all "
         "casters again.",
     .domain = {.rect = false, .soft = true, .planarReceiversOnly = true},
     .passes = {{"planar-planes",
                 "plane that the visible surface lies in, a hue each; black: none that can show a shadow"},
                {"planar-limit", "where the stencil lets shadows be drawn"},
                {"planar-projected", "flattened casters of all planes before any limit, a sixth of white a layer"},
                {"planar-heights",
                 "height of the highest caster over its plane, as a share of what casters reach at most"},
                {"planar-passed", "light that passes, in colour"}},
     .needsStencil = true})

}  // namespace ombrage
