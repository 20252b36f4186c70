// SPDX-License-Identifier: MIT
// shadow/volume-tiled: stencil shadow volumes counted once per tile, and per pixel only where their boundary passes.
#include "render/technique.h"
#include "techniques/shadow/volume-tiled/tile_classes.h"
#include "techniques/shared/volume_counter.h"
#include "techniques/shared/volume_fill.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

constexpr const char* kTilesPass = "volume-tiles";
constexpr const char* kStencilPass = "volume-stencil";

/// The stencil's bit for pixels that are counted one by one; the count has the bits below.
constexpr int kBoundaryBit = 0x80, kCountBits = 0x7f;

struct VolumeTiledParams : VolumeParams {
    static ParamTable describe() { return volumeTable(); }
};

std::vector<PassInfo> tiledPasses() {
    std::vector<PassInfo> passes = volumePasses();
    passes.push_back({kTilesPass, "tiles: lit yellow, dark blue, crossed by a volume's boundary red"});
    return passes;
}

/// Whether a triangle of the instance may pass before the near plane, where the picture does not show it.
bool touchesEye(const FrameContext& frame, std::size_t instance) {
    const glm::vec3& eye = frame.view.eye;
    const float reach_m = frame.view.nearReach_m();
    if (!frame.gpuScene->isWithin(instance, eye, reach_m)) return false;
    const FlatScene& flat = frame.gpuScene->flat();
    const FlatInstance& range = flat.instances[instance];
    for (std::uint32_t t = 0; t < range.triangleCount; ++t) {
        const glm::uvec3& v = flat.triangles[range.firstTriangle + t];
        const glm::vec3 &a = flat.positions[v.x], &b = flat.positions[v.y], &c = flat.positions[v.z];
        // In its bounds, and not far from its plane.
        const glm::vec3 lower = glm::min(a, glm::min(b, c)) - reach_m, upper = glm::max(a, glm::max(b, c)) + reach_m;
        if (glm::any(glm::lessThan(eye, lower)) || glm::any(glm::greaterThan(eye, upper))) continue;
        const glm::vec3 normal = glm::cross(b - a, c - a);
        if (std::abs(glm::dot(normal, eye - a)) <= reach_m * glm::length(normal)) return true;
    }
    return false;
}

class VolumeTiled final : public ShadowTechniqueOf<VolumeTiledParams> {
public:
    void prepare(FrameContext&) override { m_volumes.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        m_volumes.update(frame, light, ShadowVolumeOptions(p()));
        m_volumes.report(frame);
        if (inTiles(frame))
            renderTiles(frame, light, visibility);
        else
            renderWhole(frame, light, visibility);
        showVolumes(frame, light, m_volumes);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes(); }

private:
    /// Z-pass from the eye is what tiles are counted by: not for casters that touch it, nor for orthographic cameras.
    bool inTiles(const FrameContext& frame) const {
        if (frame.view.orthographic) return false;
        for (std::size_t i = 0; i < m_volumes.casters().size(); ++i)
            if (m_volumes.casters()[i] && touchesEye(frame, i)) return false;
        return true;
    }

    void renderWhole(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) {
        const VolumeCounter counter(frame, light, m_volumes, p().twoSided);
        {
            const auto pass = frame.pass("shadow volumes");
            counter.begin(0);
            counter.zFail(m_volumes.casters());
        }
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }
        if (frame.countsSavings()) {
            const VolumeFill fill = countFill(frame, light, m_volumes, m_volumes.casters());
            reportFill(frame, fill);
        }
        if (frame.wants(kTilesPass)) {
            // All of it is counted.
            gl::Texture red({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "tiles shown");
            gl::Framebuffer({{&red}}, {}, "tiles shown").clearColor(0, glm::vec4(0.8f, 0.12f, 0.05f, 1.0f));
            frame.expose(kTilesPass, red, ShowAs::Color);
        }
    }

    void renderTiles(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) {
        const VolumeChoice& casters = m_volumes.casters();
        const int atTheEye = m_volumes.around(frame, light, frame.view.eye, casters);
        frame.counter("volumes around the eye", atTheEye);

        // Steps 1 and 2 of the paper's section 3: tiles that volumes cross, and one count for each of the others.
        TileClasses tiles(frame, light, m_volumes);
        tiles.findBoundary(casters);
        tiles.classify(casters, atTheEye);

        VolumeCounter counter(frame, light, m_volumes, p().twoSided);
        {
            const auto pass = frame.pass("tiles into stencil");
            counter.begin(0);
            tiles.stencil(false, 1, kCountBits);
            tiles.stencil(true, kBoundaryBit | (atTheEye & kCountBits), kBoundaryBit | kCountBits);
        }
        {
            // Step 3: pixel by pixel, only there.
            const auto pass = frame.pass("shadow volumes");
            counter.restrictTo(kBoundaryBit);
            counter.zPass(casters, true);
        }
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }

        if (frame.countsSavings()) {
            const gl::Texture mask = tiles.boundaryMask();
            reportFill(frame, countFill(frame, light, m_volumes, casters, &mask));
            tiles.report();
        }
        if (frame.wants(kTilesPass)) frame.expose(kTilesPass, tiles.picture(), ShowAs::Color);
        if (frame.wants(kStencilPass)) {
            const gl::Framebuffer target({}, {&frame.gbuffer->depth}, "shadow volumes");
            target.bind();
            tiles.stencil(true, 0, kBoundaryBit);
        }
    }

    ShadowVolumes m_volumes;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_tiled, VolumeTiled,
    {.title = "Shadow volumes in tiles",
     .summary = "Stencil shadow volumes counted once for every 8x8 pixels, and pixel by pixel only in the tiles whose "
                "surfaces the boundary of a volume crosses.",
     .papers = {"aila2004hierarchical", "olano1997homogeneous", "crow1977", "kim2008volumes"},
     .limits = "The whole picture is counted where a caster touches the eye, and by orthographic cameras. Hard shadows "
               "of opaque triangles only: holes of alpha-tested casters are filled.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = tiledPasses(),
     .needsStencil = true})

}  // namespace ombrage
