// SPDX-License-Identifier: MIT
// shadow/volume-tiled: stencil shadow volumes counted once per tile, and per pixel only where their boundary passes.
#include "render/technique.h"
#include "techniques/shadow/volume-tiled/tile_classes.h"
#include "techniques/shared/eye_contact.h"
#include "techniques/shared/volume_counter.h"
#include "techniques/shared/volume_fill.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

constexpr const char* kTilesPass = "volume-tiles";
constexpr const char* kStencilPass = "volume-stencil";

constexpr int kMarked = VolumeCounter::kMarked;
constexpr unsigned kAllBits = 0xff;

struct VolumeTiledParams : VolumeParams {
    static ParamTable describe() { return volumeTable(); }
};

std::vector<PassInfo> tiledPasses() {
    std::vector<PassInfo> passes = volumePasses();
    passes.push_back({kTilesPass, "tiles: lit yellow, dark blue, crossed by a volume's boundary red"});
    return passes;
}

class VolumeTiled final : public ShadowTechniqueOf<VolumeTiledParams> {
public:
    void prepare(FrameContext&) override { m_volumes.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const bool tiled = inTiles(frame, light);
        const VolumeChoice withCaps(frame.gpuScene->flat().instances.size(), !tiled);
        m_volumes.update(frame, light, ShadowVolumeOptions(p()), withCaps);
        m_volumes.report(frame);
        if (tiled)
            renderTiles(frame, light, visibility);
        else
            renderWhole(frame, light, visibility);
        showVolumes(frame, light, m_volumes);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes(); }

private:
    /// Z-pass from the eye is what tiles are counted by: not where it cannot be, nor for orthographic cameras.
    bool inTiles(const FrameContext& frame, const LightFrame& light) const {
        if (frame.view.orthographic) return false;
        const auto& instances = frame.gpuScene->flat().instances;
        for (std::size_t i = 0; i < instances.size(); ++i)
            if (instances[i].casts && !countsFromEye(frame, light, i)) return false;
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
        if (frame.countsSavings()) reportFill(frame, countFill(frame, light, m_volumes.options()));
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
        counter.restrictToMarked();
        {
            // Step 3: pixel by pixel, only there.
            const auto pass = frame.pass("shadow volumes");
            counter.begin(0);
            tiles.stencil(true, kMarked | (atTheEye & ~kMarked), kAllBits);
            counter.zPass(casters, true);
            // Dark tiles become pixels that one volume holds.
            tiles.stencil(false, kMarked | 1, kAllBits);
        }
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }

        if (frame.countsSavings()) {
            const gl::Texture mask = tiles.boundaryMask();
            reportFill(frame, countFill(frame, light, m_volumes.options(), &mask));
            tiles.report();
        }
        if (frame.wants(kTilesPass)) frame.expose(kTilesPass, tiles.picture(), ShowAs::Color);
        if (frame.wants(kStencilPass)) {
            // The count alone, to look at.
            const gl::Framebuffer target({}, {&frame.gbuffer->depth}, "shadow volumes");
            target.bind();
            for (const bool boundary : {true, false}) tiles.stencil(boundary, 0, kMarked);
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
     .limits = "The whole picture is counted where a caster touches the eye, has holes or has the eye on its volume's "
               "border, and by orthographic cameras. Hard shadows of opaque triangles only: holes of alpha-tested "
               "casters are filled.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = tiledPasses(),
     .needsStencil = true})

}  // namespace ombrage
