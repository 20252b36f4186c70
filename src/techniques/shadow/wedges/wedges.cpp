// SPDX-License-Identifier: MIT
// shadow/wedges: soft shadow volumes. Hard volumes from the light's centre, and a wedge per silhouette edge that mends
// their count by the part of the light that lies beyond the edge.
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/volume_counter.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

/// Of the numbers that edges and volumes are summed in.
enum class CoveragePrecision { Half, Single };

/// Share of open edges from which on a mesh is no body with holes.
constexpr double kSheet = 0.1;

constexpr const char* kCoverage = "wedge-coverage";
constexpr const char* kOverlap = "wedge-overlap";
constexpr const char* kFaces = "wedge-faces";

/// Storage buffer bindings of wedge.vert.
constexpr unsigned kEndStorage = 3, kSideStorage = 4;

/// Corners of a wedge's faces, counter-clockwise from outside (wedge.vert): two along the edge, two at its ends, and
/// the far one.
const std::vector<std::uint32_t> kHull{0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 0, 4, 2, 1, 3, 5, 4, 5, 3, 4, 3, 2};

}  // namespace

template <>
struct EnumChoices<CoveragePrecision> {
    static std::vector<std::string> names() { return {"half", "single"}; }
};

namespace {

struct WedgesParams {
    float size = 1.0f;
    bool horizon = true;
    CoveragePrecision precision = CoveragePrecision::Single;

    static ParamTable describe() {
        using P = WedgesParams;
        return fields(field(&P::size, "size")
                          .range(0, 4)
                          .help("The light's size as a multiple of its own: 0 gives the hard shadow, less than 1 a "
                                "narrower penumbra with less fill."),
                      field(&P::horizon, "horizon")
                          .effect(ParamEffect::Define)
                          .help("What of the light is below the receiver's own plane counts as covered, and what "
                                "casters hide of that part does not count again."),
                      field(&P::precision, "precision")
                          .effect(ParamEffect::Resize)
                          .help("Of the image that the edges' shares are summed in: half takes half the memory and "
                                "rounds each sum to 3 digits."));
    }
};

class Wedges final : public ShadowTechniqueOf<WedgesParams> {
public:
    void prepare(FrameContext&) override {
        m_away.reset();
        m_lit.reset();
    }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const bool isHard = !light.light->hasSize() || p().size == 0.0f;
        m_away.update(frame, light, ShadowVolumeOptions(isHard ? CastingSide::Automatic : CastingSide::Away));
        m_away.report(frame);
        if (isHard) {
            const VolumeCounter counter(frame, light, m_away, true);
            count(frame, counter, m_away.casters());
            showVolumes(frame, light, m_away);
            showNothing(frame, {kCoverage, kOverlap, kFaces});
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
            return;
        }
        const std::vector<Layer> layers = this->layers(frame, light);

        // The edges' shares and the count of volumes in one image, side by side, for each side of the casters.
        const bool isHalf = p().precision == CoveragePrecision::Half;
        const GLenum oneSide = isHalf ? GL_RG16F : GL_RG32F, bothSides = isHalf ? GL_RGBA16F : GL_RGBA32F;
        const auto share = frame.targets->take(
            {.format = layers.size() == 1 ? oneSide : bothSides, .width = frame.width, .height = frame.height},
            "wedge shares");
        const gl::Framebuffer target({{share.get()}}, {&frame.gbuffer->depth}, "wedge shares");
        target.bind();
        target.clearColor(0, glm::vec4(0));
        for (const Layer& layer : layers) {
            count(frame, VolumeCounter(frame, light, *layer.volumes, true), layer.casters);
            if (&layer == layers.data()) showVolumes(frame, light, m_away);
            target.bind();
            addCount(frame, layer);
            const auto pass = frame.pass("wedges");
            addWedges(frame, light, layer, inside(frame), "shadow/wedges/wedge.frag");
        }
        resolve(frame, visibility, *share, layers.size() > 1);
        if (frame.wants(kCoverage)) frame.expose(kCoverage, *share, ShowAs::Count);
        if (frame.wants(kOverlap)) showOverlap(frame, light, layers);
        if (frame.wants(kFaces)) showFaces(frame, light, layers);
    }

    std::uint64_t gpuBytes() const override { return m_away.gpuBytes() + m_lit.gpuBytes() + m_hull.size(); }

private:
    /// Casters that are drawn alike.
    struct Layer {
        const ShadowVolumes* volumes;
        VolumeChoice casters;
        glm::vec2 sums;  ///< 1 or 0: into that of the sides turned away from the light, into that of the lit ones
    };

    /// Of most casters what is turned away from the light covers as much of it as what faces it, and is enough. Of an
    /// open one either may cover more, and the greater of both sums counts; those that are sheets have
    /// sides that cover what they cover by themselves, and so add up.
    std::vector<Layer> layers(FrameContext& frame, const LightFrame& light) {
        const auto& topology = frame.gpuScene->derived<SceneTopology>();
        const auto& instances = frame.gpuScene->flat().instances;
        Layer away{&m_away, m_away.casters(), {1, 1}}, awayOnly{&m_away, VolumeChoice(instances.size()), {1, 0}};
        Layer litOnly{&m_lit, awayOnly.casters, {0, 1}}, lit{&m_lit, awayOnly.casters, {1, 1}};
        bool some = false;
        for (std::size_t i = 0; i < instances.size(); ++i) {
            if (!away.casters[i] || !m_away.needsBothSides(i)) continue;
            const MeshTopology& mesh = topology.mesh(instances[i].mesh);
            const bool isSheet = double(mesh.openEdgeCount()) > kSheet * double(mesh.edgeCount());
            (isSheet ? lit : litOnly).casters[i] = some = true;
            if (isSheet) continue;
            away.casters[i] = false;
            awayOnly.casters[i] = true;
        }
        if (!some) return {away};
        m_lit.update(frame, light, ShadowVolumeOptions(CastingSide::Lit));
        std::vector<Layer> all{away, awayOnly, litOnly, lit};
        all.erase(std::remove_if(all.begin(), all.end(),
                                 [](const Layer& layer) {
                                     return std::find(layer.casters.begin(), layer.casters.end(), true) ==
                                            layer.casters.end();
                                 }),
                  all.end());
        return all;
    }

    void count(FrameContext& frame, const VolumeCounter& counter, const VolumeChoice& casters) const {
        const auto pass = frame.pass("shadow volumes");
        counter.begin(0);
        counter.zFail(casters);
    }

    /// The stencil's count, two's complement, bit by bit.
    void addCount(FrameContext& frame, const Layer& layer) {
        const auto pass = frame.pass("count from stencil");
        gl::DrawState state;
        state.blend = true;
        state.stencilTest = true;
        const gl::Program& program = frame.fullscreenProgram(*this, "shadow/wedges/count.frag");
        for (int bit = 0; bit < 8; ++bit) {
            for (gl::DrawState::StencilFace* face : {&state.stencilFront, &state.stencilBack}) {
                face->func = GL_EQUAL;
                face->reference = 1 << bit;
                face->readMask = GLuint(1 << bit);
            }
            gl::apply(state);
            program.set("u_count", layer.sums * float(bit == 7 ? -128 : 1 << bit));
            frame.drawFullscreen();
        }
    }

    /// Back faces behind the surface: each pixel that may be inside of a wedge, once.
    static gl::DrawState inside(const FrameContext& frame) {
        gl::DrawState state;
        state.depthTest = true;
        state.depthFunc = GL_LESS;
        state.depthClamp = frame.view.orthographic;
        state.cull = GL_FRONT;
        state.blend = true;
        return state;
    }

    void addWedges(FrameContext& frame, const LightFrame& light, const Layer& layer, gl::DrawState state,
                   const char* fragmentPath, std::vector<std::pair<std::string, std::string>> defines = {}) {
        if (!m_hull) {
            m_hull = gl::Buffer::from(kHull, "wedge corners");
            m_corners = gl::VertexArray({}, {}, m_hull.id());
        }
        const LightRegion region(frame.view, light);
        if (region.empty) return;
        state.scissor = region.scissor;
        const gl::DepthBounds bounds(region.depthBounds);
        gl::apply(state);
        frame.bindGBuffer();
        frame.gpuScene->bindStorage();
        frame.gpuScene->derived<VolumeVertices>().buffer.bindStorage(kEndStorage);
        layer.volumes->indices().bindStorage(kSideStorage);
        const gl::Program& program =
            frame.program(*this, {{GL_VERTEX_SHADER, "shadow/wedges/wedge.vert"}, {GL_FRAGMENT_SHADER, fragmentPath}},
                          std::move(defines));
        program.set("u_stride", layer.volumes->indicesPerSide());
        program.set("u_infinity", ShadowVolumes::infinity(frame));
        program.set("u_sums", layer.sums);

        // A command per caster, an instance per side.
        std::vector<gl::DrawElementsIndirect> commands;
        for (std::size_t i = 0; i < layer.casters.size(); ++i) {
            const std::uint32_t sides = layer.volumes->sides(i).second / layer.volumes->indicesPerSide();
            commands.push_back({std::uint32_t(kHull.size()), layer.casters[i] ? sides : 0, 0, 0, 0});
        }
        m_commands = gl::Buffer::from(commands, "wedges");
        std::uint64_t wedges = 0;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            if (commands[i].instanceCount == 0) continue;
            program.set("u_instance", unsigned(i));
            program.set("u_first", layer.volumes->sides(i).first);
            gl::drawElementsIndirect(m_corners, m_commands, i, 1);
            frame.countDraw(1, std::uint64_t(commands[i].instanceCount) * kHull.size() / 3);
            wedges += commands[i].instanceCount;
        }
        frame.counter("wedges", double(wedges));
    }

    void resolve(FrameContext& frame, const gl::Texture& visibility, const gl::Texture& share, bool bothSides) {
        const auto pass = frame.pass("shadow from wedges");
        const gl::Framebuffer target({{&visibility}}, {&frame.gbuffer->depth}, "shadow from wedges");
        target.bind();
        frame.fullscreenProgram(*this, "shadow/wedges/resolve.frag", {{"BOTH_SIDES", bothSides ? "1" : "0"}});
        frame.bindGBuffer();
        share.bind(kFirstFreeUnit);
        frame.drawSurfaces();
    }

    void showOverlap(FrameContext& frame, const LightFrame& light, const std::vector<Layer>& layers) {
        const FrameContext::Uncounted aside(frame);
        const gl::Texture overlap({.format = GL_R32F, .width = frame.width, .height = frame.height}, "wedge overlap");
        const gl::Framebuffer target({{&overlap}}, {&frame.gbuffer->depth}, "wedge overlap");
        target.bind();
        target.clearColor(0, glm::vec4(0));
        for (const Layer& layer : layers) addWedges(frame, light, layer, inside(frame), "shared/volume_one.frag");
        frame.expose(kOverlap, overlap, ShowAs::Count);
    }

    void showFaces(FrameContext& frame, const LightFrame& light, const std::vector<Layer>& layers) {
        const FrameContext::Uncounted aside(frame);
        const gl::Texture picture = volumeBackdrop(frame);
        const gl::Framebuffer target({{&picture}}, {&frame.gbuffer->depth}, "wedge faces");
        target.bind();
        gl::DrawState state = volumeOverlay();
        for (const Layer& layer : layers) addWedges(frame, light, layer, state, kVolumeTintPath);
        state.blendEquation = GL_MAX;
        state.wireframe = true;
        for (const Layer& layer : layers) addWedges(frame, light, layer, state, kVolumeTintPath, {{"OUTLINE", ""}});
        frame.expose(kFaces, picture, ShowAs::Color);
    }

    ShadowVolumes m_away, m_lit;
    gl::Buffer m_hull, m_commands;
    gl::VertexArray m_corners;
};

std::vector<PassInfo> wedgePasses() {
    std::vector<PassInfo> passes = volumePasses();
    passes.push_back(
        {kCoverage, "share of the light that the edges add to the hard shadow of what is turned away from it"});
    passes.push_back({kOverlap, "wedges over each pixel, which is what the pass costs"});
    passes.push_back({kFaces, "the wedges' faces, translucent, with their outlines"});
    return passes;
}

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, wedges, Wedges,
    {.title = "Penumbra wedges",
     .summary = "Soft shadow volumes: a hard shadow from the light's centre, mended by a wedge per silhouette edge in "
                "which every point finds the exact part of the light beyond the edge.",
     .papers = {"assarsson2003soft", "everitt2002volumes"},
     .limits = "Silhouettes are those of the light's centre, and what several casters cover is added up, so "
               "overlapping penumbrae are too dark; holes of alpha-tested casters are filled.",
     .domain = {.soft = true, .closedCastersOnly = true, .alphaTest = false},
     .passes = wedgePasses(),
     .needsStencil = true})

}  // namespace ombrage
