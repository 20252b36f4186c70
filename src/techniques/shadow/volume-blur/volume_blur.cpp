// SPDX-License-Identifier: MIT
// shadow/volume-blur: the hard shadow of volumes, blurred by a constant width or by what the distance from caster to
// receiver asks.
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/volume_split.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

/// What decides how far a shadow's edge is blurred.
enum class BlurMode { Constant, Contact };

/// Of the constant width.
enum class BlurUnit { Pixels, Metres };

constexpr const char* kHard = "blur-hard";
constexpr const char* kContact = "blur-contact";
constexpr const char* kWidth = "blur-width";

}  // namespace

template <>
struct EnumChoices<BlurMode> {
    static std::vector<std::string> names() { return {"constant", "contact"}; }
};
template <>
struct EnumChoices<BlurUnit> {
    static std::vector<std::string> names() { return {"pixels", "metres"}; }
};

namespace {

struct VolumeBlurParams : VolumeParams {
    BlurMode mode = BlurMode::Contact;
    BlurUnit unit = BlurUnit::Pixels;
    float width = 8.0f;
    float size = 1.0f;
    float reach_px = 64.0f;
    int samples = 48;
    float planeTolerance_px = 2.0f;
    float normalTolerance = 0.7f;

    static ParamTable describe() {
        using P = VolumeBlurParams;
        return volumeTable({
            field(&P::mode, "mode")
                .effect(ParamEffect::Define)
                .help(
                    "constant: every edge is blurred by `width`. contact: the more, the farther the receiver lies from "
                    "the caster, as the light's size has it; a light without size stays hard."),
            field(&P::unit, "unit")
                .effect(ParamEffect::Define)
                .help("Of `width`: pixels of the picture, or metres on the surface."),
            field(&P::width, "width").range(0, 64).tune(0, 32).help("Width of every blurred edge with mode=constant."),
            field(&P::size, "size")
                .range(0, 4)
                .help("With mode=contact the light's size as a multiple of its own: larger is softer."),
            field(&P::reach_px, "reach", Unit::Pixel)
                .range(1, 256, Scale::Log)
                .tune(8, 128)
                .help("Largest radius of the blur: more shows wide penumbrae whole, and takes more passes."),
            field(&P::samples, "samples")
                .range(4, 256, Scale::Log)
                .tune(8, 96)
                .help("Points that a pixel near an edge averages: fewer cost less and show steps."),
            field(&P::planeTolerance_px, "plane-tolerance", Unit::Pixel)
                .range(0.1, 1000, Scale::Log)
                .help(
                    "Distance from the receiver's plane, in sizes of a pixel there, up to which a pixel shows the same "
                    "surface: larger lets shadows bleed over steps."),
            field(&P::normalTolerance, "normal-tolerance")
                .range(-1, 1)
                .help("Least cosine between normals of one surface: higher keeps creases apart and hardens shadows on "
                      "what is round."),
        });
    }
};

class VolumeBlur final : public ShadowTechniqueOf<VolumeBlurParams> {
public:
    void prepare(FrameContext&) override { m_volumes.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const VolumeChoice byZFail = countedByZFail(frame, light, CountingMode::Clamp);
        m_volumes.update(frame, light, ShadowVolumeOptions(p()), byZFail);
        m_volumes.report(frame);
        const VolumeCounter counter(frame, light, m_volumes, p().twoSided);
        {
            const VolumeSplit split(frame, light, m_volumes, CountingMode::Clamp, byZFail);
            const auto pass = frame.pass("shadow volumes");
            counter.begin(split.atTheEye);
            split.count(counter);
        }
        showVolumes(frame, light, m_volumes);
        const bool byContact = p().mode == BlurMode::Contact;
        if (byContact ? !light.light->hasSize() || p().size == 0.0f : p().width == 0.0f) {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
            if (frame.wants(kHard)) frame.expose(kHard, visibility, ShowAs::Value);
            showNothing(frame, {kContact, kWidth});
            return;
        }

        const auto hard = frame.targets->take(visibility.desc(), "hard shadow");
        {
            const auto pass = frame.pass("shadow from stencil");
            const gl::Framebuffer target({{hard.get()}}, {}, "hard shadow");
            target.clearColor(0, glm::vec4(1));
            counter.darken(*hard);
        }
        Contact contact;
        if (byContact) contact = drawContact(frame, light);
        const TargetPool::Target edges = spread(frame, *hard, findEdges(frame, *hard, contact));
        blur(frame, *hard, *edges, visibility);
        if (frame.wants(kHard)) frame.expose(kHard, *hard, ShowAs::Value);
        if (frame.wants(kContact)) show(frame, *edges, true);
        if (frame.wants(kWidth)) show(frame, *edges, false);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes(); }

private:
    struct Contact {
        TargetPool::Target distance, nearness;
    };

    /// Draws the sides once more: of all that lie over a pixel, how far the one nearest to the surface is from its
    /// caster.
    Contact drawContact(FrameContext& frame, const LightFrame& light) {
        const auto pass = frame.pass("contact distance");
        const auto image = [&frame](GLenum format, const char* label) {
            return frame.targets->take({.format = format, .width = frame.width, .height = frame.height}, label);
        };
        Contact contact{image(GL_R32F, "contact distance"), image(GL_DEPTH_COMPONENT32F, "contact nearness")};
        const gl::Framebuffer target({{contact.distance.get()}}, {contact.nearness.get()}, "contact distance");
        target.bind();
        target.clearColor(0, glm::vec4(0));
        target.clearDepth(0.0f);
        const LightRegion region(frame.view, light);
        if (region.empty) return contact;
        gl::DrawState state;
        state.depthTest = state.depthWrite = true;
        state.depthFunc = GL_GREATER;
        state.scissor = region.scissor;
        gl::apply(state);
        frame.bindGBuffer();
        m_volumes.draw(frame, light, VolumePart::Sides, VolumePart::Sides, m_volumes.casters(),
                       {.fragmentPath = "shadow/volume-blur/contact.frag", .defines = {{"EXTRUSION", ""}}});
        return contact;
    }

    /// A full-screen pass into an image of edges.
    TargetPool::Target edgeImage(FrameContext& frame) const {
        return frame.targets->take({.format = GL_RG32UI, .width = frame.width, .height = frame.height}, "shadow edges");
    }

    TargetPool::Target findEdges(FrameContext& frame, const gl::Texture& hard, const Contact& contact) {
        const auto pass = frame.pass("shadow edges");
        auto edges = edgeImage(frame);
        const gl::Framebuffer target({{edges.get()}}, {&frame.gbuffer->depth}, "shadow edges");
        target.bind();
        target.clearColorUint(0, glm::uvec4(~0u));
        frame.fullscreenProgram(*this, "shadow/volume-blur/edges.frag");
        frame.bindGBuffer();
        hard.bind(kFirstFreeUnit);
        if (contact.distance) {
            contact.distance->bind(kFirstFreeUnit + 1);
            contact.nearness->bind(kFirstFreeUnit + 2);
        }
        frame.drawSurfaces();
        return edges;
    }

    /// Hands every edge to the pixels that it may reach.
    TargetPool::Target spread(FrameContext& frame, const gl::Texture& hard, TargetPool::Target edges) {
        const auto pass = frame.pass("spread edges");
        // Edges of a width in pixels reach no farther than that.
        const bool inPixels = p().mode == BlurMode::Constant && p().unit == BlurUnit::Pixels;
        const float reach_px = inPixels ? std::min(p().reach_px, 0.5f * p().width) : p().reach_px;
        int step = 1;
        while (float(step) < reach_px) step *= 2;
        for (; step >= 1; step /= 2) {
            auto next = edgeImage(frame);
            const gl::Framebuffer target({{next.get()}}, {&frame.gbuffer->depth}, "spread edges");
            target.bind();
            const gl::Program& program = frame.fullscreenProgram(*this, "shadow/volume-blur/spread.frag");
            program.set("u_step", step);
            edges->bind(kFirstFreeUnit);
            hard.bind(kFirstFreeUnit + 1);
            gl::apply({});
            frame.drawFullscreen();
            edges = next;
            frame.counter("spread passes", 1);
        }
        return edges;
    }

    void blur(FrameContext& frame, const gl::Texture& hard, const gl::Texture& edges, const gl::Texture& visibility) {
        const auto pass = frame.pass("blur");
        const gl::Framebuffer target({{&visibility}}, {&frame.gbuffer->depth}, "blur");
        target.bind();
        frame.fullscreenProgram(*this, "shadow/volume-blur/blur.frag");
        frame.bindGBuffer();
        hard.bind(kFirstFreeUnit);
        edges.bind(kFirstFreeUnit + 1);
        frame.drawSurfaces();
    }

    void show(FrameContext& frame, const gl::Texture& edges, bool distance) {
        const auto pass = frame.pass("show blur");
        const gl::Texture value({.format = GL_R32F, .width = frame.width, .height = frame.height}, "blur view");
        const gl::Framebuffer target({{&value}}, {&frame.gbuffer->depth}, "blur view");
        target.bind();
        target.clearColor(0, glm::vec4(0));
        frame.fullscreenProgram(*this, "shadow/volume-blur/show.frag").set("u_distance", distance ? 1 : 0);
        frame.bindGBuffer();
        edges.bind(kFirstFreeUnit);
        frame.drawSurfaces();
        frame.expose(distance ? kContact : kWidth, value, ShowAs::Count);
    }

    ShadowVolumes m_volumes;
};

std::vector<PassInfo> blurPasses() {
    std::vector<PassInfo> passes = volumePasses();
    passes.push_back({kHard, "the shadow before the blur"});
    passes.push_back({kContact, "distance from caster to receiver at the edge that reaches a pixel, in metres"});
    passes.push_back({kWidth, "radius of the blur in pixels"});
    return passes;
}

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_blur, VolumeBlur,
    {.title = "Blurred shadow volumes",
     .summary = "The hard shadow of stencil volumes, blurred along the surfaces: by a constant width, or by a width "
                "that grows with the distance from the contact of caster and receiver.",
     .papers = {"everitt2002volumes", "fernando2005pcss", "rong2006jump", "vogel1979"},
     .limits =
         "Knows the shadows that the picture shows and one caster for each pixel: edges beyond the picture's border or "
         "behind something else are missing, and penumbrae of different widths mix roughly.",
     .domain = {.soft = true, .closedCastersOnly = true, .alphaTest = false},
     .passes = blurPasses(),
     .needsStencil = true,
     .screenSpace = true})

}  // namespace ombrage
