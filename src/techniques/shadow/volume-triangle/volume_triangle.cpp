// SPDX-License-Identifier: MIT
// shadow/volume-triangle: a shadow volume per triangle against a hierarchy of the view's own points, in compute
// shaders.
#include <algorithm>
#include <array>

#include "render/frame_context.h"
#include "render/recorder.h"
#include "render/technique.h"
#include "techniques/shared/gpu_triangles.h"
#include "techniques/shared/volume_fill.h"

namespace ombrage {

namespace {

/// Pixels along a side of the nodes that every volume starts with.
enum class RootSize { Auto, Px64, Px512, Px4096 };

}  // namespace

template <>
struct EnumChoices<RootSize> {
    static std::vector<std::string> names() { return {"auto", "64px", "512px", "4096px"}; }
};

namespace {

struct VolumeTriangleParams {
    RootSize root = RootSize::Auto;
    bool wholeNodes = true;
    bool skipDark = false;
    bool cornerPlanes = true;
    int queue = 1 << 20;

    static ParamTable describe() {
        using P = VolumeTriangleParams;
        return fields(
            field(&P::root, "root")
                .effect(ParamEffect::Host)
                .help("Size of the nodes that every volume starts with: smaller, more work at once, which few large "
                      "triangles need; larger, fewer tests for many small ones. `auto` takes the smallest "
                      "that starts at most 262144 tests."),
            field(&P::wholeNodes, "whole-nodes")
                .effect(ParamEffect::Define)
                .help("Nodes that lie wholly inside of a volume are marked as such, instead of pixel by pixel."),
            field(&P::skipDark, "skip-dark")
                .effect(ParamEffect::Define)
                .help("Pixels and nodes that are in shadow already are not asked again."),
            field(&P::cornerPlanes, "corner-planes")
                .effect(ParamEffect::Define)
                .help("Three more planes per volume, through its corners: fewer nodes beside sharp corners are looked "
                      "into."),
            field(&P::queue, "queue")
                .range(1024, 1 << 22, Scale::Log)
                .effect(ParamEffect::Host)
                .help("Pairs of triangle and node that find room at once, 16 bytes each: more memory for fewer, larger "
                      "batches of triangles."));
    }
};

constexpr int kTopLevel = 4;  // TOP_LEVEL of nodes.glsl
constexpr unsigned kNodeStorage = 0, kQueueStorage = 3;
constexpr unsigned kUnitVolumes = 5, kUnitBoxes = 6, kUnitReceivers = 7;
constexpr std::size_t kCounterWords = 8, kQueues = 4, kQueueWords = 4, kEntryWords = 4;
constexpr std::size_t kHeaderWords = kCounterWords + kQueues * kQueueWords;
constexpr unsigned kExactQueue = 0, kTileQueue = 1;
constexpr std::uint32_t kMostCasters = 65536;  // of one batch: 8 MiB of planes
constexpr int kVolumesAcross = 128, kVolumeTexels = 8;
constexpr std::uint64_t kEnoughLanes = 1u << 18;  // fills a large GPU

/// The triangles that cast, first and without a hierarchy.
struct GpuCasters {
    explicit GpuCasters(const GpuScene& scene) {
        std::vector<std::uint32_t> order = castingTriangles(scene);
        count = std::uint32_t(order.size());
        triangles = GpuTriangles(scene, std::move(order));
    }
    std::uint32_t count = 0;
    GpuTriangles triangles;
};

class VolumeTriangle final : public ShadowTechniqueOf<VolumeTriangleParams> {
public:
    void prepare(FrameContext&) override {
        m_excluded = {};
        m_batch = kMostCasters;
    }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const GpuCasters& casters = frame.gpuScene->derived<GpuCasters>();
        makeRoom(frame, light);
        m_nodes.bindStorage(kNodeStorage);
        m_queues.bindStorage(kQueueStorage);
        gatherReceivers(frame, casters);
        testVolumes(frame, casters);
        resolve(frame, visibility);
        if (frame.recorder->capturing) report(frame, light);
        m_bytes = casters.triangles.gpuBytes() + m_nodes.size() + m_queues.size() + m_excluded.size();
        m_volumes.reset();
        m_receivers.reset();
        m_boxes.reset();
    }

    std::uint64_t gpuBytes() const override { return m_bytes; }

private:
    using Defines = std::vector<std::pair<std::string, std::string>>;

    static glm::ivec2 gridOf(const FrameContext& frame, int level) {
        const int side = 1 << 3 * level;
        return {(frame.width + side - 1) / side, (frame.height + side - 1) / side};
    }
    static std::size_t nodesOf(const FrameContext& frame, int level) {
        return std::size_t(gridOf(frame, level).x) * std::size_t(gridOf(frame, level).y);
    }

    void makeRoom(FrameContext& frame, const LightFrame& light) {
        std::size_t entries = 0;
        for (int level = 1; level <= kTopLevel; ++level) entries += nodesOf(frame, level);
        const std::size_t nodeBytes = (kHeaderWords + entries * kEntryWords) * sizeof(std::uint32_t);
        if (m_nodes.size() != nodeBytes) m_nodes = gl::Buffer(nodeBytes, nullptr, "triangle volume nodes");

        // One triangle alone must find room: all tiles, all pixels.
        m_queueSize = std::max(std::uint32_t(p().queue), std::uint32_t(nodesOf(frame, 1)));
        m_exactSize = std::max(m_queueSize, std::uint32_t(frame.width) * std::uint32_t(frame.height));
        const std::size_t queueBytes = (2 * std::size_t(m_queueSize) + m_exactSize) * 2 * sizeof(std::uint32_t);
        if (m_queues.size() != queueBytes) {
            checkStorageSize(queueBytes);
            m_queues = gl::Buffer(queueBytes, nullptr, "triangle volume queues");
        }
        if (!light.light->excludedModels.empty() && !m_excluded)
            m_excluded = excludedInstances(*frame.gpuScene, light.light->excludedModels);

        m_volumes = frame.targets->take({.format = GL_RGBA32F,
                                         .width = kVolumesAcross * kVolumeTexels,
                                         .height = int(kMostCasters) / kVolumesAcross},
                                        "planes of triangle volumes");
        m_receivers =
            frame.targets->take({.format = GL_RGBA32UI, .width = frame.width, .height = frame.height}, "receivers");
        // Boxes of level 1 + k are level 3 k of a chain, whose sides halve: tiles are filled up to nodes of level 3.
        const glm::ivec2 padded = gridOf(frame, 3) * 64;
        m_boxes = frame.targets->take({.kind = gl::TextureKind::Array2D,
                                       .format = GL_RGBA32F,
                                       .width = padded.x,
                                       .height = padded.y,
                                       .layers = 2,
                                       .levels = 7},
                                      "bounds of receivers");
    }

    const gl::Program& program(FrameContext& frame, const char* name, Defines defines = {}) {
        return frame.program(*this, {{GL_COMPUTE_SHADER, std::string("shadow/volume-triangle/") + name}},
                             std::move(defines));
    }

    /// Frames that are read back anyway count what was done.
    static Defines counting(const FrameContext& frame, Defines defines = {}) {
        if (frame.recorder->capturing) defines.emplace_back("COUNT", "1");
        return defines;
    }

    static void dispatch(FrameContext& frame, std::size_t x, std::size_t y) {
        gl::dispatch(int(x), int(y), 1);
        frame.countDraw(1, 0);
    }

    void gatherReceivers(FrameContext& frame, const GpuCasters& casters) {
        const auto pass = frame.pass("receivers");
        m_nodes.upload(0, sizeof(std::uint32_t) * kCounterWords, std::array<std::uint32_t, kCounterWords>{}.data());
        const gl::Program& tiles = program(frame, "receivers.comp", counting(frame));
        casters.triangles.bind(tiles);
        frame.bindGBuffer();
        m_receivers->bindImage(0, GL_WRITE_ONLY);
        m_boxes->bindImage(1, GL_WRITE_ONLY);
        dispatch(frame, std::size_t(gridOf(frame, 1).x), std::size_t(gridOf(frame, 1).y));

        const gl::Program& boxes = program(frame, "boxes.comp");
        m_boxes->bind(kUnitBoxes);
        for (int level = 2; level <= kTopLevel; ++level) {
            gl::barrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
            boxes.set("u_level", level);
            if (level < kTopLevel) m_boxes->bindImage(1, GL_WRITE_ONLY, 3 * (level - 1));
            dispatch(frame, std::size_t(gridOf(frame, level).x), std::size_t(gridOf(frame, level).y));
        }
        gl::barrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    }

    /// The level of the nodes that volumes start with. A dispatch has room for 65535 of them.
    int rootLevel(const FrameContext& frame, std::uint32_t casters) const {
        const bool isAuto = p().root == RootSize::Auto;
        int level = isAuto ? 2 : 1 + int(p().root);
        while (level < kTopLevel &&
               (nodesOf(frame, level) > 65535 || (isAuto && casters * nodesOf(frame, level) > kEnoughLanes)))
            ++level;
        return level;
    }

    /// All casters, by batches that leave room in the queues. What a batch that found none has marked is right, so the
    /// half of it asks once more.
    void testVolumes(FrameContext& frame, const GpuCasters& casters) {
        const auto pass = frame.pass("triangle volumes");
        TargetPool::Target tests;
        if (frame.wants("pixel-tests")) {
            const gl::TextureDesc desc{.format = GL_R32UI, .width = frame.width, .height = frame.height};
            tests = frame.targets->take(desc, "pixel tests");
            gl::Framebuffer({{tests.get()}}, {}, "pixel tests").clearColorUint(0, glm::uvec4(0));
        }
        if (m_excluded) m_excluded.bindStorage(kExcludedStorage);
        m_volumes->bind(kUnitVolumes);
        m_boxes->bind(kUnitBoxes);
        m_receivers->bind(kUnitReceivers);

        int batches = 0;
        for (std::uint32_t first = 0; first < casters.count;) {
            const std::uint32_t count = std::min(m_batch, casters.count - first);
            ++batches;
            const double fill = testBatch(frame, casters, first, count, tests.get());
            if (fill > 1.0) {
                m_batch = std::max(1u, count / 2);
                continue;
            }
            first += count;
            if (fill < 0.25) m_batch = std::min(kMostCasters, m_batch * 2);
        }
        frame.counter("batches", batches);
        gl::barrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        if (tests) frame.expose("pixel-tests", *tests, ShowAs::Count);
    }

    /// How full the fullest queue was; over 1 when something found no room.
    double testBatch(FrameContext& frame, const GpuCasters& casters, std::uint32_t first, std::uint32_t count,
                     const gl::Texture* tests) {
        setUpVolumes(frame, casters, first, count);

        // The roots first, then level after level down to the tiles.
        int level = rootLevel(frame, casters.count);
        const gl::Program& roots =
            queueProgram(frame, "descend.comp", casters, first, counting(frame, {{"FROM_ROOTS", "1"}}));
        roots.set("u_casters", count);
        roots.set("u_level", level);
        dispatch(frame, (count + 63) / 64, nodesOf(frame, level));
        if (--level > 1) {
            const gl::Program& descend = queueProgram(frame, "descend.comp", casters, first, counting(frame));
            for (; level > 1; --level) {
                descend.set("u_level", level);
                dispatchQueue(frame, unsigned(level));
            }
        }

        // Their pixels, and the rays of pixels near a plane.
        queueProgram(frame, "pixels.comp", casters, first,
                     counting(frame, tests ? Defines{{"SHOW_TESTS", "1"}} : Defines{}));
        if (tests) tests->bindImage(0, GL_READ_WRITE);
        dispatchQueue(frame, kTileQueue);
        queueProgram(frame, "exact.comp", casters, first);
        dispatchQueue(frame, kExactQueue);
        gl::barrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        return fill();
    }

    /// The planes of the batch, and empty queues.
    void setUpVolumes(FrameContext& frame, const GpuCasters& casters, std::uint32_t first, std::uint32_t count) {
        std::array<std::uint32_t, kQueues * kQueueWords> queues{};
        for (std::size_t q = 0; q < kQueues; ++q) queues[q * kQueueWords + 2] = queues[q * kQueueWords + 3] = 1;
        m_nodes.upload(kCounterWords * sizeof(std::uint32_t), sizeof queues, queues.data());
        const gl::Program& volumes =
            program(frame, "volumes.comp", m_excluded ? Defines{{"EXCLUDES", "1"}} : Defines{});
        casters.triangles.bind(volumes);
        m_volumes->bindImage(0, GL_WRITE_ONLY);
        volumes.set("u_firstCaster", first);
        volumes.set("u_casters", count);
        dispatch(frame, (count + 63) / 64, 1);
        gl::barrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }

    const gl::Program& queueProgram(FrameContext& frame, const char* name, const GpuCasters& casters,
                                    std::uint32_t first, Defines defines = {}) {
        const gl::Program& made = program(frame, name, std::move(defines));
        casters.triangles.bind(made);
        made.set("u_queueSize", m_queueSize);
        made.set("u_exactSize", m_exactSize);
        made.set("u_firstCaster", first);
        return made;
    }

    /// A group per 64 entries of the queue.
    void dispatchQueue(FrameContext& frame, unsigned queue) {
        gl::barrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        gl::dispatchIndirect(m_nodes, (kCounterWords + queue * kQueueWords + 1) * sizeof(std::uint32_t));
        frame.countDraw(1, 0);
    }

    double fill() const {
        std::array<std::uint32_t, kQueues * kQueueWords> queues{};
        m_nodes.download(kCounterWords * sizeof(std::uint32_t), sizeof queues, queues.data());
        double fullest = 0.0;
        for (std::size_t q = 0; q < kQueues; ++q)
            fullest =
                std::max(fullest, double(queues[q * kQueueWords]) / (q == kExactQueue ? m_exactSize : m_queueSize));
        return fullest;
    }

    void resolve(FrameContext& frame, const gl::Texture& visibility) {
        {
            const auto pass = frame.pass("shadow from nodes");
            program(frame, "tiles.comp");
            dispatch(frame, std::size_t(gridOf(frame, 1).x + 63) / 64, std::size_t(gridOf(frame, 1).y));
            gl::barrier(GL_SHADER_STORAGE_BARRIER_BIT);
            const gl::Framebuffer target({{&visibility}}, {}, "shadow from nodes");
            target.bind();
            gl::apply({});
            frame.fullscreenProgram(*this, "shadow/volume-triangle/resolve.frag");
            frame.drawFullscreen();
        }
        if (!frame.wants("shadow-level")) return;
        const gl::TextureDesc desc{.format = GL_R8UI, .width = frame.width, .height = frame.height};
        const TargetPool::Target levels = frame.targets->take(desc, "shadow levels");
        const gl::Framebuffer target({{levels.get()}}, {}, "shadow levels");
        target.bind();
        gl::apply({});
        frame.fullscreenProgram(*this, "shadow/volume-triangle/resolve.frag", {{"SHOW_LEVEL", "1"}});
        gl::drawFullscreen();
        frame.expose("shadow-level", *levels, ShowAs::Count);
    }

    /// What was done, beside testing every pixel that the light may reach against every triangle, and beside the
    /// fragments that z-fail would draw.
    void report(FrameContext& frame, const LightFrame& light) {
        std::array<std::uint64_t, kCounterWords / 2> counts{};  // asked, node tests, pixel tests, exact tests
        m_nodes.download(0, sizeof counts, counts.data());
        const auto& without = light.light->excludedModels;
        std::uint64_t casting = 0;
        for (const FlatInstance& instance : frame.gpuScene->flat().instances)
            if (instance.casts && std::find(without.begin(), without.end(), instance.model) == without.end())
                casting += instance.triangleCount;
        frame.counter("node tests", double(counts[1]));
        frame.counter("pixel tests", double(counts[2]));
        frame.counter("exact tests", double(counts[3]));
        frame.counter("pixel tests saved", double(counts[0]) * double(casting) - double(counts[2]));
        if (!frame.countsSavings()) return;
        VolumeFill fill = countFill(frame, light, {});
        fill.counted = double(counts[2]);
        reportFill(frame, fill);
    }

    gl::Buffer m_nodes, m_queues, m_excluded;
    std::uint32_t m_queueSize = 0, m_exactSize = 0;      ///< entries
    std::uint32_t m_batch = kMostCasters;                ///< as many casters as found room last
    TargetPool::Target m_volumes, m_receivers, m_boxes;  ///< of the frame at work
    std::uint64_t m_bytes = 0;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, volume_triangle, VolumeTriangle,
    {.title = "Shadow volumes, one per triangle",
     .summary =
         "The shadow volume of every triangle, by itself, against a hierarchy of the points that are seen: exact "
         "for any soup of triangles and for alpha-tested ones, with neither silhouettes nor stencil.",
     .papers = {"sintorn2011triangle", "davidovic2012"},
     .limits = "Hard shadows only; the cost grows with the number of triangles times the nodes that the border of each "
               "one's shadow crosses.",
     .passes = {{"shadow-level",
                 "what marked each pixel as in shadow: 1 itself, 2 its tile of 8 pixels, 3 and 4 nodes of 64 and 512"},
                {"pixel-tests", "how many triangles each pixel was tested against"}}})

}  // namespace ombrage
