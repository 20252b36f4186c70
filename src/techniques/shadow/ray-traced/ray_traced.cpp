// SPDX-License-Identifier: MIT
// shadow/ray-traced: rays from the visible points to the light through a hierarchy in storage buffers.
#include <algorithm>

#include "render/frame_context.h"
#include "render/recorder.h"
#include "render/technique.h"
#include "techniques/shared/gpu_bvh.h"

namespace ombrage {

namespace {

/// Where the rays of one pixel go on the light.
enum class RayPattern { Random, Sobol, Rotated };

}  // namespace

template <>
struct EnumChoices<RayPattern> {
    static std::vector<std::string> names() { return {"random", "sobol", "rotated"}; }
};

namespace {

struct RayTracedParams {
    int samples = 16;
    RayPattern pattern = RayPattern::Sobol;

    static ParamTable describe() {
        using P = RayTracedParams;
        return fields(field(&P::samples, "samples")
                          .range(1, 256, Scale::Log)
                          .tune(1, 64)
                          .help("Rays per pixel to a light of some size: less noise in penumbrae for proportional "
                                "cost. Hard lights take "
                                "one ray."),
                      field(&P::pattern, "pattern")
                          .effect(ParamEffect::Define)
                          .help("How the rays spread over the light: independently, by Sobol points scrambled per "
                                "pixel, or by one Sobol set "
                                "rotated per pixel, whose noise is finer to the eye."));
    }
};

/// Draws end before a driver's watchdog ends them.
constexpr int kSamplesPerDraw = 32;

/// Counts the pixels that a draw writes.
class PixelQuery {
public:
    PixelQuery() { glCreateQueries(GL_SAMPLES_PASSED, 1, &m_query); }
    ~PixelQuery() { glDeleteQueries(1, &m_query); }
    PixelQuery(const PixelQuery&) = delete;
    PixelQuery& operator=(const PixelQuery&) = delete;

    void begin() { glBeginQuery(GL_SAMPLES_PASSED, m_query); }
    void end() { glEndQuery(GL_SAMPLES_PASSED); }
    /// Waits for the draw.
    double pixels() const {
        GLuint64 count = 0;
        glGetQueryObjectui64v(m_query, GL_QUERY_RESULT, &count);
        return double(count);
    }

private:
    GLuint m_query = 0;
};

class RayTraced final : public ShadowTechniqueOf<RayTracedParams> {
public:
    void prepare(FrameContext&) override { m_excluded = {}; }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        const GpuBvh& bvh = frame.gpuScene->derived<GpuBvh>();
        const bool soft = light.light->hasSize();
        std::vector<std::pair<std::string, std::string>> defines;
        if (soft) defines.emplace_back("SOFT", "1");
        if (!light.light->excludedModels.empty()) {
            defines.emplace_back("EXCLUDES", "1");
            if (!m_excluded) m_excluded = excludedInstances(*frame.gpuScene, light.light->excludedModels);
            m_excluded.bindStorage(kExcludedStorage);
        }
        {
            const auto pass = frame.pass("shadow rays");
            const gl::Framebuffer target({{&visibility}}, {}, "shadow rays");
            target.bind();
            frame.bindGBuffer();
            const gl::Program& program =
                frame.fullscreenProgram(*this, "shadow/ray-traced/ray_traced.frag", std::move(defines));
            bvh.bind(program);
            // The first draw writes the pixels that ask, later ones add their samples.
            const int samples = soft ? p().samples : 1;
            for (int first = 0; first < samples; first += kSamplesPerDraw) {
                gl::DrawState state;
                state.blend = first > 0;
                gl::apply(state);
                if (soft) program.set("u_sampleRange", glm::ivec2(first, std::min(first + kSamplesPerDraw, samples)));
                if (first == 0) m_query.begin();
                frame.drawFullscreen();
                if (first == 0) m_query.end();
            }
        }
        // Only the frame that is read back anyway waits for the count.
        if (frame.recorder->capturing) frame.counter("rays", m_query.pixels() * (soft ? p().samples : 1));
        m_bytes = bvh.gpuBytes() + m_excluded.size();
    }

    std::uint64_t gpuBytes() const override { return m_bytes; }

private:
    PixelQuery m_query;
    gl::Buffer m_excluded;
    std::uint64_t m_bytes = 0;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, ray_traced, RayTraced,
    {.title = "Ray-traced shadows",
     .summary = "Rays from every visible point to the light, through a bounding volume hierarchy in storage buffers: "
                "exact for hard lights, sampled for soft ones.",
     .papers = {"whitted1980", "cook1984distributed", "smits1998", "woop2013watertight", "burley2020owen"},
     .limits =
         "The hierarchy is built on the CPU whenever the geometry changes; soft lights show noise that falls slowly "
         "with the number of rays.",
     .domain = {.soft = true}})

}  // namespace ombrage
