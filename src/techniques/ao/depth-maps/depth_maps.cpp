// SPDX-License-Identifier: MIT
// ao/depth-maps: the scene's depth from many directions; each map answers for one direction of the hemisphere.
#include <algorithm>
#include <cmath>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/depth-maps/directions.h"
#include "techniques/shared/cosine_visibility.h"
#include "techniques/shared/light_views.h"

namespace ombrage {

namespace {

/// As many as the uniforms of any driver hold.
constexpr int kMapsPerDraw = 32;
constexpr int kVectorsPerMap = 5;
/// Of the tangent plane of a receiver to a map's rays; beyond it the cosine makes up for the error.
constexpr float kMostSlope = 16.0f;

struct DepthMapsParams {
    int maps = 256;
    int resolution = 512;
    float bias_texels = 0.0f;

    static ParamTable describe() {
        using P = DepthMapsParams;
        return fields(field(&P::maps, "maps")
                          .range(8, 1024, Scale::Log)
                          .tune(64, 512)
                          .effect(ParamEffect::Host)
                          .help("Directions on the sphere, half of which lie over any surface: more blend the maps' "
                                "hard shadows into a smooth whole."),
                      field(&P::resolution, "resolution", Unit::Texel)
                          .range(32, 2048, Scale::Log)
                          .tune(128, 1024)
                          .effect(ParamEffect::Host)
                          .help("Width and height of each map, which covers the scene: texels too large lose contacts "
                                "and thin occluders. Two bytes a texel of each map are held."),
                      field(&P::bias_texels, "bias", Unit::Texel)
                          .range(0, 8)
                          .tune(0, 3)
                          .effect(ParamEffect::Host)
                          .help("How far surfaces may lie behind what a map holds: hides wrong darkness on curved "
                                "surfaces and in creases, and lets light under contacts."));
    }
};

class DepthMaps final : public AoTechniqueOf<DepthMapsParams> {
public:
    void prepare(FrameContext&) override { m_areDrawn = false; }

    void render(FrameContext& frame, const gl::Texture& visibility) override {
        if (!m_areDrawn) drawMaps(frame);
        m_areDrawn = true;
        if (frame.wants("map")) frame.expose("map", m_maps, ShowAs::LightDepth);

        const auto sums =
            frame.targets->take({.format = GL_RG32F, .width = frame.width, .height = frame.height}, "sums");
        addUp(frame, *sums);
        const auto pass = frame.pass("mean of maps");
        const gl::Framebuffer target({{&visibility}}, {}, "mean of maps");
        target.bind();
        gl::apply({});
        frame.bindGBuffer();
        sums->bind(kFirstFreeUnit);
        frame.fullscreenProgram(*this, "ao/depth-maps/depth-maps-mean.frag");
        frame.drawFullscreen();
    }

    std::uint64_t gpuBytes() const override { return m_maps ? gl::byteSize(m_maps.desc()) : 0; }

private:
    void drawMaps(FrameContext& frame) {
        const auto pass = frame.pass("depth maps");
        const gl::TextureDesc desc{.kind = gl::TextureKind::Array2D,
                                   .format = GL_DEPTH_COMPONENT16,
                                   .width = p().resolution,
                                   .height = p().resolution,
                                   .layers = p().maps};
        if (!m_maps || m_maps.desc() != desc) {
            m_maps = gl::Texture(desc, "depth maps");
            m_maps.setBorder(glm::vec4(0.0f));  // what no map shows is open
        }
        m_uniforms.clear();
        int layer = 0;
        for (const glm::vec3& toLight : depth_maps::evenDirections(p().maps)) {
            Light sun;
            sun.type = LightType::Sun;
            sun.direction = -toLight;
            LightFrame light{-1, &sun};
            light.direction = sun.direction;
            const LightViews views = makeLightViews(frame, light, LightFit::Scene);
            drawMap(frame, light, views, layer++);
            addUniforms(views.views.front());
        }
    }

    /// Everything stops ambient light, whether it casts shadows of lights or not.
    void drawMap(FrameContext& frame, const LightFrame& light, const LightViews& views, int layer) {
        const gl::Framebuffer target({}, {&m_maps, 0, layer}, "depth map");
        target.bind();
        target.clearDepth(0.0f);
        gl::DrawState state;
        state.depthTest = state.depthWrite = true;
        state.colorWrite = false;
        frame.gpuScene->bindStorage();
        const glm::mat4 clipFromWorld = views.clipFromWorld(0);
        const auto draw = [&](DrawFilter::Alpha alpha, bool positionsOnly) {
            std::vector<std::pair<std::string, std::string>> defines;
            if (!positionsOnly) defines.emplace_back("ALPHA_MASK", "1");
            const gl::Program& program = frame.program(
                {{GL_VERTEX_SHADER, "ombrage/depth_only.vert"}, {GL_FRAGMENT_SHADER, "ombrage/depth_only.frag"}},
                defines);
            program.set("u_clipFromWorld", &clipFromWorld, 1);
            for (const DrawBatch& batch : frame.gpuScene->batches({.alpha = alpha})) {
                // What a solid turns away from the light lies behind what it turns to it.
                state.cull = frame.gpuScene->hidesBackFaces(batch, light.toward(), 0.0f) ? GL_BACK : GL_NONE;
                gl::apply(state);
                const DrawCounts counts = frame.gpuScene->draw(batch, positionsOnly);
                frame.countDraw(counts.draws, counts.triangles);
            }
        };
        draw(DrawFilter::Alpha::OpaqueOnly, true);
        if (frame.gpuScene->hasAlphaMask()) draw(DrawFilter::Alpha::MaskedOnly, false);
    }

    /// What depth-maps.frag reads of one map.
    void addUniforms(const LightView& view) {
        const float range_m = view.far_m - view.near_m;
        const glm::vec2 extent_m = 2.0f * view.halfExtent;
        const glm::vec3 toU = view.right / extent_m.x, toV = view.up / extent_m.y, toT = view.forward / range_m;
        const float texel_m = std::max(extent_m.x, extent_m.y) / float(p().resolution);
        // A unit of the map's 16 bits, and rounding of positions.
        const float precision = 1.0f / 65535.0f + 4e-7f;
        m_uniforms.emplace_back(toU, 0.5f - glm::dot(toU, view.origin));
        m_uniforms.emplace_back(toV, 0.5f - glm::dot(toV, view.origin));
        m_uniforms.emplace_back(toT, -glm::dot(toT, view.origin) - view.near_m / range_m);
        m_uniforms.emplace_back(-view.forward, 0.0f);
        m_uniforms.emplace_back(extent_m * extent_m / range_m, p().bias_texels * texel_m / range_m + precision,
                                kMostSlope * texel_m * std::sqrt(0.5f) / range_m);
    }

    void addUp(FrameContext& frame, const gl::Texture& sums) {
        const auto pass = frame.pass("add maps");
        const gl::Framebuffer target({{&sums}}, {&frame.gbuffer->depth}, "sums of maps");
        target.bind();
        target.clearColor(0, glm::vec4(0.0f));
        frame.bindGBuffer();
        m_maps.bind(kFirstFreeUnit);
        const gl::Program& program = frame.fullscreenProgram(*this, "ao/depth-maps/depth-maps.frag",
                                                             {{"MAPS_PER_DRAW", std::to_string(kMapsPerDraw)}});
        program.set("u_resolution", float(p().resolution));
        for (int first = 0; first < p().maps; first += kMapsPerDraw) {
            const int count = std::min(kMapsPerDraw, p().maps - first);
            program.set("u_firstMap", first);
            program.set("u_mapCount", count);
            program.set("u_maps", &m_uniforms[std::size_t(kVectorsPerMap * first)], kVectorsPerMap * count);
            frame.drawSurfaces(true);
        }
    }

    bool m_areDrawn = false;
    gl::Texture m_maps;
    std::vector<glm::vec4> m_uniforms;
};

std::unique_ptr<AoIntegrand> makeIntegrand(const DepthMapsParams&) {
    return makeUnboundedVisibility();
}

}  // namespace

OMBRAGE_TECHNIQUE(
    ao, depth_maps, DepthMaps,
    {.title = "Ambient occlusion from many depth maps",
     .summary = "Depth maps from directions all over the sphere; each surface adds the cosines of those that see it. "
                "The maps are kept while the scene stands still.",
     .papers = {"sattler2004", "marques2013fibonacci", "dou2014adaptive"},
     .limits = "Answers the unbounded question alone; contacts are as coarse as the maps' texels, and everything is "
               "drawn once per map whenever something moved.",
     .passes = {{"map", "The first map: depth as seen from nearly straight above, near is bright"}},
     .integrand = integrandOf(&makeIntegrand)})

}  // namespace ombrage
