// SPDX-License-Identifier: MIT
// shadow/volume-clamped: stencil shadow volumes of the casters that matter, as long as somebody sees their shadow.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "render/technique.h"
#include "techniques/shadow/volume-clamped/receiver_grid.h"
#include "techniques/shadow/volume-clamped/shadowed_casters.h"
#include "techniques/shared/eye_contact.h"
#include "techniques/shared/volume_counter.h"
#include "techniques/shared/volume_fill.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

namespace {

constexpr const char* kReceiversPass = "volume-receivers";
constexpr const char* kCastersPass = "volume-casters";
constexpr const char* kFillLeftPass = "volume-fill-left";

/// Of a distance and of the scene's diagonal, by which volumes reach beyond receivers: positions are rounded.
constexpr float kMargin = 1e-4f;

/// What became of a caster's volume, in the order of kFateTints.
enum class Fate { None, InShadow, WithoutReceivers, Whole, Clamped, ClampedTwice };
const std::array<glm::vec4, 6> kFateTints{{{0.12f, 0.12f, 0.12f, 1.0f},
                                           {0.05f, 0.15f, 0.8f, 1.0f},
                                           {0.8f, 0.1f, 0.05f, 1.0f},
                                           {0.8f, 0.8f, 0.8f, 1.0f},
                                           {0.8f, 0.6f, 0.1f, 1.0f},
                                           {0.1f, 0.6f, 0.15f, 1.0f}}};

constexpr int kShownWidth = 768;  // pixels, of the picture of the grid
constexpr unsigned kCellStorage = 11, kTintStorage = 11;
constexpr int kBlock = 64;  // pixels along an edge of a work group's share, of receiver_grid.comp

struct VolumeClampedParams : VolumeParams {
    int grid = 16;
    bool cull = true;
    bool clamp = true;

    static ParamTable describe() {
        using P = VolumeClampedParams;
        return volumeTableWithoutEnds(
            {field(&P::grid, "grid")
                 .range(1, 128, Scale::Log)
                 .effect(ParamEffect::Host)
                 .help(
                     "Cells along an edge of the grid over the light's rays that holds the visible receivers (of each "
                     "of six for a point light): tighter volumes for more work on the processor."),
             field(&P::cull, "cull")
                 .effect(ParamEffect::Host)
                 .help("Leave out casters in the shadow of others and those whose shadow falls on nothing visible."),
             field(&P::clamp, "clamp")
                 .effect(ParamEffect::Host)
                 .help("Let volumes begin at the first visible receiver in their way and end behind the last.")});
    }
};

std::vector<PassInfo> clampedPasses() {
    std::vector<PassInfo> passes = volumePasses();
    passes.push_back(
        {kReceiversPass, "distance from the light of the farthest visible receiver in each cell of the grid"});
    passes.push_back({kCastersPass,
                      "casters: culled in another's shadow blue, without receivers red, volumes cut at one end "
                      "yellow, at both green, whole white"});
    passes.push_back({kFillLeftPass, "triangles over each pixel that are left of `volume-fill`"});
    return passes;
}

class VolumeClamped final : public ShadowTechniqueOf<VolumeClampedParams> {
public:
    void prepare(FrameContext&) override {
        m_volumes.reset();
        m_seen.reset();
        m_plan.reset();
    }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        // Volumes that end have more triangles: they are made again only where the plan says other than the last one.
        ShadowVolumeOptions options(p());
        options.slabs = m_ends;
        m_volumes.update(frame, light, options);
        findReceivers(frame, light);
        plan(frame, light);
        options.slabs = m_ends = m_plan->clamped > 0;
        m_volumes.update(frame, light, options);
        if (m_ends) m_volumes.setSlabs(m_plan->slabs);
        m_volumes.report(frame);

        const VolumeCounter counter(frame, light, m_volumes, p().twoSided);
        {
            const auto pass = frame.pass("shadow volumes");
            count(frame, counter);
        }
        showVolumes(frame, light, m_volumes, m_plan->kept);
        if (frame.wants(kReceiversPass)) showReceivers(frame);
        if (frame.wants(kCastersPass)) showCasters(frame);
        if (frame.wants(kFillLeftPass)) {
            const FrameContext::Uncounted aside(frame);
            frame.expose(kFillLeftPass, drawFill(frame, light, m_volumes, m_plan->kept), ShowAs::Count);
        }
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }
        report(frame, light);
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes() + m_cells.size(); }

private:
    /// What the receivers depend on, beside the scene.
    struct Seen {
        glm::mat4 clipFromWorld;
        glm::ivec2 size;
        glm::vec4 toward;
        float range_m;
        int grid;
        bool operator==(const Seen&) const = default;
    };

    /// What is drawn, and how.
    struct Plan {
        bool cull = false, clamp = false;
        VolumeChoice kept, zPass, zFail, beginApart;
        std::vector<VolumeSlab> slabs;
        std::vector<Fate> fates;
        int atTheEye = 0;
        int shadowed = 0, withoutReceivers = 0, clamped = 0, clampedTwice = 0;
    };

    void count(const FrameContext& frame, const VolumeCounter& counter) const {
        const bool clampDepth = !frame.view.orthographic;
        counter.begin(m_plan->atTheEye);
        counter.zPass(m_plan->zPass, clampDepth);
        counter.zPassLightCaps(m_plan->beginApart, clampDepth);
        counter.zFail(m_plan->zFail);
    }

    /// Lloyd et al. 2004, section 4: what of each cell of the light's rays the camera sees. Waits for the GPU.
    void findReceivers(FrameContext& frame, const LightFrame& light) {
        Seen seen{
            frame.view.clipFromWorld, {frame.width, frame.height}, light.toward(), light.light->range_m, p().grid};
        if (m_seen && *m_seen == seen) return;
        m_seen = seen;
        m_plan.reset();
        const auto pass = frame.pass("receivers");
        const GpuScene& scene = *frame.gpuScene;
        m_rays = light.light->type == LightType::Sun
                     ? LightRays::ofSun(light.direction, lightTangent(*light.light),
                                        glm::vec3(scene.bounds().lower - scene.origin()),
                                        glm::vec3(scene.bounds().upper - scene.origin()))
                     : LightRays::from(light.position);

        std::vector<glm::uvec2> cells(std::size_t(m_rays.faces() * p().grid * p().grid),
                                      glm::uvec2(ReceiverGrid::kEmpty, 0u));
        m_cells = gl::Buffer::from(cells, "receiver grid");
        m_cells.bindStorage(kCellStorage);
        frame.bindGBuffer();
        const gl::Program& program = frame.program({{GL_COMPUTE_SHADER, "shadow/volume-clamped/receiver_grid.comp"}},
                                                   {{"GRID", std::to_string(p().grid)}});
        program.set("u_toward", light.toward());
        program.set("u_right", m_rays.right);
        program.set("u_up", m_rays.up);
        program.set("u_lower", m_rays.corner);
        program.set("u_cellsPerMetre", float(p().grid) / m_rays.size);
        program.set("u_start", m_rays.start_m);
        gl::dispatch((frame.width + kBlock - 1) / kBlock, (frame.height + kBlock - 1) / kBlock, 1);
        gl::barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        m_cells.download(0, cells.size() * sizeof cells[0], cells.data());
        m_grid.emplace(m_rays, p().grid, std::move(cells));
    }

    /// Decides caster by caster; what is kept of the volumes is closed.
    void plan(FrameContext& frame, const LightFrame& light) {
        if (m_plan && m_plan->cull == p().cull && m_plan->clamp == p().clamp) return;
        const TraceScope trace("cull and clamp");
        const GpuScene& scene = *frame.gpuScene;
        const VolumeChoice& casters = m_volumes.casters();
        Plan made;
        made.cull = p().cull;
        made.clamp = p().clamp;
        made.kept = casters;
        made.slabs.resize(casters.size());
        made.fates.resize(casters.size());
        made.zPass = made.zFail = made.beginApart = VolumeChoice(casters.size());
        VolumeChoice aroundEye(casters.size());

        const VolumeChoice shadowed =
            p().cull ? shadowedCasters(frame, light, m_volumes, m_rays) : VolumeChoice(casters.size());
        const float diagonal_m = float(glm::length(scene.bounds().upper - scene.bounds().lower));
        for (std::size_t i = 0; i < casters.size(); ++i) {
            if (!casters[i]) continue;
            const auto& [lower, upper] = scene.instanceBounds(i);
            const std::optional<BoxSight> box = m_rays.sight(lower, upper);
            // Nobody sees what lies behind it.
            const float margin_m = kMargin * (diagonal_m + (box ? box->farthest_m : 0.0f));
            const bool useless = p().cull && box && m_grid->farthestOf(*box) < box->closest_m - margin_m;
            made.shadowed += shadowed[i] ? 1 : 0;
            made.withoutReceivers += useless && !shadowed[i] ? 1 : 0;
            made.kept[i] = !shadowed[i] && !useless;
            made.fates[i] = shadowed[i] ? Fate::InShadow : useless ? Fate::WithoutReceivers : Fate::Whole;
            if (!made.kept[i]) continue;

            const bool byZFail = frame.view.orthographic || !countsFromEye(frame, light, i);
            (byZFail ? made.zFail : made.zPass)[i] = true;
            bool holdsEye = true;
            if (p().clamp && box) {
                made.slabs[i] = clampedSlab(frame, i, *box, margin_m, holdsEye);
                const bool beginsApart = made.slabs[i].near != glm::vec4(0.0f), isCut = made.slabs[i] != VolumeSlab{},
                           isCutTwice = beginsApart && made.slabs[i].far != glm::vec4(0.0f);
                made.clamped += isCut ? 1 : 0;
                made.clampedTwice += isCutTwice ? 1 : 0;
                made.beginApart[i] = !byZFail && beginsApart;
                made.fates[i] = isCutTwice ? Fate::ClampedTwice : isCut ? Fate::Clamped : Fate::Whole;
            }
            aroundEye[i] = !byZFail && holdsEye;
        }
        made.atTheEye = m_volumes.around(frame, light, frame.view.eye, aroundEye);
        m_plan = std::move(made);
    }

    /// The slab that holds all receivers in the caster's way; an end that cuts off nothing in view is left out.
    /// @param holdsEye whether the eye lies in it
    VolumeSlab clampedSlab(const FrameContext& frame, std::size_t caster, const BoxSight& box, float margin_m,
                           bool& holdsEye) const {
        const auto receivers = m_grid->receiversOf(box);
        const float eye_m = m_rays.along(box.axis, frame.view.eye), reach_m = frame.view.nearReach_m() + margin_m;
        VolumeSlab slab;
        holdsEye = true;
        // It never ends within the caster, which would turn it inside out, nor at the eye.
        float end_m = std::max(receivers ? receivers->farthest_m : box.farthest_m, box.farthest_m) + margin_m;
        if (std::abs(eye_m - end_m) <= reach_m) end_m = eye_m + 2 * reach_m;
        // A sun's rays must not meet, as endless ones do under an orthographic camera.
        if ((m_rays.sun && frame.view.orthographic) || isSeen(frame, caster, box.axis, end_m, true)) {
            slab.far = m_rays.plane(box.axis, end_m);
            holdsEye = eye_m < end_m;
        }

        const float begin_m = (receivers ? receivers->nearest_m : 0.0f) - margin_m;
        if (begin_m > box.farthest_m + margin_m && std::abs(eye_m - begin_m) > reach_m &&
            isSeen(frame, caster, box.axis, begin_m, false)) {
            slab.near = m_rays.plane(box.axis, begin_m);
            holdsEye = holdsEye && eye_m > begin_m;
        }
        return slab;
    }

    /// Whether the picture may show something of a volume beyond the plane at that distance along the axis, or of what
    /// lies between the caster and it: the rays through the corners of its bounds hold all of that.
    bool isSeen(const FrameContext& frame, std::size_t caster, const glm::vec3& axis, float at_m, bool beyond) const {
        const auto& [lower, upper] = frame.gpuScene->instanceBounds(caster);
        unsigned outside = ~0u;  // of the sides of the picture and of the eye's plane: those that all of it is beyond
        const auto add = [&](const glm::vec4& p_world) {
            const glm::vec4 clip = frame.view.clipFromWorld * p_world;
            outside &= unsigned(clip.x < -clip.w) | unsigned(clip.x > clip.w) << 1 | unsigned(clip.y < -clip.w) << 2 |
                       unsigned(clip.y > clip.w) << 3 | unsigned(clip.w <= 0.0f) << 4;
        };
        for (int c = 0; c < 8; ++c) {
            const glm::vec3 corner(c & 1 ? upper.x : lower.x, c & 2 ? upper.y : lower.y, c & 4 ? upper.z : lower.z);
            const glm::vec3 ray = m_rays.sun ? m_rays.direction : corner - m_rays.position;
            const float steps = (at_m - m_rays.along(axis, corner)) / glm::dot(axis, ray);
            add(glm::vec4(corner + steps * ray, 1.0f));
            add(beyond ? glm::vec4(ray, 0.0f) : glm::vec4(corner, 1.0f));
        }
        return outside == 0;
    }

    void showReceivers(FrameContext& frame) const {
        // Cells as squares, faces side by side.
        const int grid = p().grid, faces = m_rays.faces(), side = std::max(1, kShownWidth / (grid * faces));
        const int width = grid * faces * side, height = grid * side;
        std::vector<float> farthest;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int column = x / side, face = column / grid;
                const int cell = (face * grid + y / side) * grid + column % grid;
                const glm::uvec2 bits = m_grid->cells()[std::size_t(cell)];
                farthest.push_back(bits.x == ReceiverGrid::kEmpty ? 0.0f : std::bit_cast<float>(bits.y));
            }
        gl::Texture image({.format = GL_R32F, .width = width, .height = height}, "receiver grid");
        image.upload(0, GL_RED, GL_FLOAT, farthest.data());
        frame.expose(kReceiversPass, image, ShowAs::Count);
    }

    void showCasters(FrameContext& frame) {
        std::vector<glm::vec4> tints;
        for (const Fate fate : m_plan->fates) tints.push_back(kFateTints[std::size_t(fate)]);
        const gl::Buffer storage = gl::Buffer::from(tints, "tints of casters");
        const gl::Texture picture({.format = GL_RGBA16F, .width = frame.width, .height = frame.height},
                                  "casters shown");
        const gl::Framebuffer target({{&picture}}, {}, "casters shown");
        target.bind();
        gl::apply({});
        frame.bindGBuffer();
        frame.gpuScene->bindStorage();
        storage.bindStorage(kTintStorage);
        frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"},
                       {GL_FRAGMENT_SHADER, "shadow/volume-clamped/casters_view.frag"}});
        frame.drawFullscreen();
        frame.expose(kCastersPass, picture, ShowAs::Color);
    }

    void report(FrameContext& frame, const LightFrame& light) const {
        frame.counter("casters culled in shadow", m_plan->shadowed);
        frame.counter("casters culled without receivers", m_plan->withoutReceivers);
        frame.counter("casters clamped", m_plan->clamped);
        frame.counter("of those at both ends", m_plan->clampedTwice);
        frame.counter("volumes around the eye", m_plan->atTheEye);
        if (!frame.countsSavings()) return;
        ShadowVolumeOptions endless = m_volumes.options();
        endless.slabs = false;
        VolumeFill fill = countFill(frame, light, endless);
        {
            const FrameContext::Uncounted aside(frame);
            fill.counted = sumOf(drawFill(frame, light, m_volumes, m_plan->kept));
        }
        frame.counter("fill", fillOf(frame, light, m_volumes, p().twoSided,
                                     [&](const VolumeCounter& own) { count(frame, own); }));
        reportFill(frame, fill);
    }

    ShadowVolumes m_volumes;
    LightRays m_rays;
    gl::Buffer m_cells;
    std::optional<Seen> m_seen;
    std::optional<ReceiverGrid> m_grid;
    std::optional<Plan> m_plan;
    bool m_ends = false;  ///< the volumes are those that begin and end at slabs
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_clamped, VolumeClamped,
    {.title = "Shadow volumes, culled and clamped",
     .summary = "Stencil shadow volumes that leave out casters whose shadow nobody sees or that lie in another's, and "
                "that reach from the first visible receiver in their way to the last.",
     .papers = {"lloyd2004ccvolumes", "blinn1988me", "crow1977", "kim2008volumes"},
     .limits = "The receivers are read back, one wait per light in frames in which camera, light or scene moved. Hard "
               "shadows of opaque triangles only: holes of alpha-tested casters are filled.",
     .domain = {.rect = false, .closedCastersOnly = true, .alphaTest = false},
     .passes = clampedPasses(),
     .needsStencil = true})

}  // namespace ombrage
