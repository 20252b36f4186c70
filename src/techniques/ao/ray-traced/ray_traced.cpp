// SPDX-License-Identifier: MIT
// ao/ray-traced: cosine-weighted rays from the visible points through a hierarchy in storage buffers.
#include <algorithm>

#include "render/frame_context.h"
#include "render/recorder.h"
#include "render/technique.h"
#include "techniques/shared/cosine_visibility.h"
#include "techniques/shared/disks.h"
#include "techniques/shared/gpu_bvh.h"
#include "techniques/shared/shadow_rays.h"

namespace ombrage {

namespace {

/// How the rays of one pixel spread over the hemisphere.
enum class AoRayPattern { Random, Sobol, Rotated, BlueNoise };

}  // namespace

template <>
struct EnumChoices<AoRayPattern> {
    static std::vector<std::string> names() { return {"random", "sobol", "rotated", "blue-noise"}; }
};

namespace {

/// Draws end before a driver's watchdog ends them.
constexpr int kSamplesPerDraw = 32;
/// Floats count no farther by ones.
constexpr int kMostGathered = 1 << 24;

struct RayTracedParams : AoRadius {
    int samples = 16;
    AoRayPattern pattern = AoRayPattern::Sobol;
    bool progressive = false;

    static ParamTable describe() {
        using P = RayTracedParams;
        return fields(
            field(&P::samples, "samples")
                .range(1, 4096, Scale::Log)
                .tune(1, 64)
                .effect(ParamEffect::Host)
                .help("Rays per pixel and frame: four times as many halve the noise of random ones, and leave less "
                      "than that of the other patterns."),
            field(&P::pattern, "pattern")
                .effect(ParamEffect::Define)
                .help("How a pixel's rays spread: independently, by Sobol points scrambled per pixel, or by one Sobol "
                      "set moved from pixel to pixel by interleaved gradient noise or by blue noise, whose grain is "
                      "finer and filters better."),
            aoRadiusField(), aoRadiusPercentField(),
            field(&P::progressive, "progressive")
                .effect(ParamEffect::Host)
                .help("Frames that follow each other add their rays while camera, seed and scene stay as they are. Off "
                      "by default, so that an error and a cost that are measured belong to one frame."));
    }
};

/// Everything stops ambient light, whether it casts shadows of lights or not.
struct AllOccluders : GpuBvh {
    explicit AllOccluders(const GpuScene& scene) : GpuBvh(scene, allTriangles(scene)) {}
};

const GpuBvh& occludersOf(const GpuScene& scene) {
    const auto& instances = scene.flat().instances;
    const bool allCast =
        std::all_of(instances.begin(), instances.end(), [](const FlatInstance& instance) { return instance.casts; });
    return allCast ? scene.derived<GpuBvh>() : scene.derived<AllOccluders>();
}

class RayTraced final : public AoTechniqueOf<RayTracedParams> {
public:
    void prepare(FrameContext&) override { m_gathered.reset(); }

    void render(FrameContext& frame, const gl::Texture& visibility) override {
        const GpuBvh& bvh = occludersOf(*frame.gpuScene);
        const gl::TextureDesc desc{.format = GL_R32F, .width = frame.width, .height = frame.height};
        if (!m_open || m_open.desc() != desc) m_open = gl::Texture(desc, "open rays");
        if (!goesOn(frame))
            m_gathered = Gathered{frame.view.worldFromView, frame.view.clipFromView, frame.normals, frame.seed};
        m_gathered->frame = frame.frameIndex;

        castRays(frame, bvh);
        const auto pass = frame.pass("mean of rays");
        const gl::Framebuffer target({{&visibility}}, {}, "mean of rays");
        target.bind();
        gl::apply({});
        frame.bindGBuffer();
        m_open.bind(kFirstFreeUnit);
        frame.fullscreenProgram(*this, "ao/ray-traced/ray-traced-mean.frag")
            .set("u_perSamples", 1.0f / float(m_gathered->samples));
        frame.drawFullscreen();
        m_bytes = bvh.gpuBytes();
    }

    std::uint64_t gpuBytes() const override {
        return m_bytes + (m_open ? gl::byteSize(m_open.desc()) : 0) +
               (m_blueNoise ? gl::byteSize(m_blueNoise.desc()) : 0);
    }

private:
    /// What the rays in m_open were cast for.
    struct Gathered {
        glm::mat4 worldFromView, clipFromView;
        NormalSource normals;
        std::uint32_t seed;
        std::uint32_t frame = 0;  ///< the last one
        int samples = 0;          ///< of each pixel
    };

    /// Whether this frame's rays add to those of the one before.
    bool goesOn(const FrameContext& frame) const {
        return p().progressive && m_gathered && frame.frameIndex == m_gathered->frame + 1 &&
               frame.view.worldFromView == m_gathered->worldFromView &&
               frame.view.clipFromView == m_gathered->clipFromView && frame.normals == m_gathered->normals &&
               frame.seed == m_gathered->seed;
    }

    void castRays(FrameContext& frame, const GpuBvh& bvh) {
        const auto pass = frame.pass("ambient rays");
        const gl::Framebuffer target({{&m_open}}, {&frame.gbuffer->depth}, "ambient rays");
        target.bind();
        if (m_gathered->samples == 0) target.clearColor(0, glm::vec4(0.0f));
        frame.bindGBuffer();
        const gl::Program& program = frame.fullscreenProgram(*this, "ao/ray-traced/ray-traced.frag");
        bvh.bind(program);
        program.set("u_radius_m",
                    float(p().radiusIn(double(frame.scene->aoRadius_m), frame.gpuScene->bounds().diagonal())));
        if (p().pattern == AoRayPattern::BlueNoise) {
            if (!m_blueNoise) m_blueNoise = blueNoiseTexture();
            m_blueNoise.bind(kFirstFreeUnit);
        }

        // Later samples of a sequence lie between the earlier ones, so frames go on where the last one ended.
        const int first = m_gathered->samples, end = std::min(first + p().samples, kMostGathered);
        for (int from = first; from < end; from += kSamplesPerDraw) {
            program.set("u_sampleRange", glm::ivec2(from, std::min(from + kSamplesPerDraw, end)));
            if (from == first) m_query.begin();
            frame.drawSurfaces(true);
            if (from == first) m_query.end();
        }
        m_gathered->samples = end;
        // Only the frame that is read back anyway waits for the count.
        if (!frame.isReturned()) return;
        frame.counter("rays", end > first ? m_query.pixels() * (end - first) : 0.0);
        if (p().progressive) frame.counter("rays per pixel so far", end);
    }

    std::optional<Gathered> m_gathered;
    gl::Texture m_open, m_blueNoise;
    PixelQuery m_query;
    std::uint64_t m_bytes = 0;
};

std::unique_ptr<AoIntegrand> makeIntegrand(const RayTracedParams& params) {
    return makeCosineVisibility(params);
}

}  // namespace

OMBRAGE_TECHNIQUE(
    ao, ray_traced, RayTraced,
    {.title = "Ray-traced ambient occlusion",
     .summary = "Cosine-weighted rays from every visible point, through a bounding volume hierarchy in storage "
                "buffers: the truth itself with fewer samples, gathered over frames while the view stands still.",
     .papers = {"whitted1980", "cook1984distributed", "zhukov1998ambient", "smits1998", "burley2020owen",
                "ulichney1993voidcluster"},
     .limits = "Noise that falls slowly with the number of rays; the hierarchy is built on the CPU whenever the "
               "geometry changes.",
     .usesSeed = true,
     .integrand = integrandOf(&makeIntegrand)})

}  // namespace ombrage
