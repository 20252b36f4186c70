// SPDX-License-Identifier: MIT
// shadow/volume-zfail: stencil shadow volumes counted behind the visible surface (Carmack's reverse).
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/shadow_volume.h"

namespace ombrage {

namespace {

/// Whose edges are extruded.
enum class VolumeFacesMode { Facing, Silhouette };

}  // namespace

template <>
struct EnumChoices<VolumeFacesMode> {
    static std::vector<std::string> names() { return {"facing", "silhouette"}; }
};

namespace {

struct VolumeZFailParams {
    bool twoSided = true;
    VolumeFacesMode faces = VolumeFacesMode::Silhouette;

    static ParamTable describe() {
        using P = VolumeZFailParams;
        return fields(
            field(&P::twoSided, "two-sided")
                .effect(ParamEffect::Host)
                .help("One pass that counts front and back faces at once, instead of one pass each; the picture is the same."),
            field(&P::faces, "faces")
                .effect(ParamEffect::Host)
                .help("Extrude the silhouette, or every casting triangle: the same picture for many times the fill."));
    }
};

using StencilFace = gl::DrawState::StencilFace;

class VolumeZFail final : public ShadowTechniqueOf<VolumeZFailParams> {
public:
    void prepare(FrameContext&) override { m_volumes.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        m_volumes.update(frame, light, {.perTriangle = p().faces == VolumeFacesMode::Facing, .caps = true});
        frame.counter("silhouette edges", double(m_volumes.edgeCount()));
        frame.counter("volume triangles", double(m_volumes.triangleCount()));
        countVolumes(frame, light);
        if (frame.wants("volume-stencil")) frame.expose("volume-stencil", frame.gbuffer->depth, ShowAs::Stencil);
        darken(frame, visibility);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes(); }

private:
    /// Everitt and Kilgard 2002, section 3.3: behind the surface, faces that leave a volume count up and those that enter one down.
    /// Reversed depth: what lies behind fails GL_GREATER, and so does the surface itself, which is its own volume's near cap.
    void countVolumes(FrameContext& frame, const LightFrame& light) {
        const auto pass = frame.pass("shadow volumes");
        const gl::Framebuffer target({}, {&frame.gbuffer->depth}, "shadow volumes");
        target.bind();
        target.clearStencil(0);
        const gl::Program& program = frame.program(
            *this, {{GL_VERTEX_SHADER, "shared/shadow_volume.vert"}, {GL_FRAGMENT_SHADER, "shared/empty.frag"}});

        const StencilFace up{.depthFail = GL_INCR_WRAP}, down{.depthFail = GL_DECR_WRAP}, keep{};
        gl::DrawState state;
        state.depthTest = true;
        state.depthFunc = GL_GREATER;
        state.depthClamp = frame.view.orthographic;   // its far plane would cut the volumes open
        state.stencilTest = true;
        state.colorWrite = false;
        for (const bool outward : {true, false}) {
            if (p().twoSided) {
                state.cull = GL_NONE;
                state.stencilFront = outward ? down : up;
                state.stencilBack = outward ? up : down;
                gl::apply(state);
                m_volumes.draw(frame, light, program, outward);
                continue;
            }
            for (const GLenum culled : {GL_FRONT, GL_BACK}) {
                state.cull = culled;
                state.stencilFront = culled == GL_FRONT ? keep : outward ? down : up;
                state.stencilBack = culled == GL_BACK ? keep : outward ? up : down;
                gl::apply(state);
                m_volumes.draw(frame, light, program, outward);
            }
        }
    }

    /// A count other than 0 is inside of a volume.
    void darken(FrameContext& frame, const gl::Texture& visibility) {
        const auto pass = frame.pass("shadow from stencil");
        const gl::Framebuffer target({{&visibility}}, {&frame.gbuffer->depth}, "shadow from stencil");
        target.bind();
        gl::DrawState state;
        state.stencilTest = true;
        state.stencilFront.func = state.stencilBack.func = GL_NOTEQUAL;
        gl::apply(state);
        frame.fullscreenProgram(*this, "shared/dark.frag");
        frame.drawFullscreen();
    }

    ShadowVolumes m_volumes;
};

}  // namespace

OMBRAGE_TECHNIQUE(shadow, volume_zfail, VolumeZFail,
                  {.title = "Shadow volumes, z-fail",
                   .summary = "Stencil shadow volumes of the casters' silhouettes, counted behind the visible surface, so that "
                              "an eye in shadow needs no care (Carmack's reverse).",
                   .papers = {"EverittKilgard2002", "Crow1977", "Bergeron1986", "Kim2008"},
                   .limits = "Hard shadows of opaque triangles only: holes of alpha-tested casters are filled, and the fill cost grows "
                             "with the silhouettes on the screen.",
                   .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
                   .passes = {{"volume-stencil", "count of volumes that hold the visible surface"}},
                   .needsStencil = true})

}  // namespace ombrage
