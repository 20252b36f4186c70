// SPDX-License-Identifier: MIT
#include "techniques/shared/shadow_rays.h"

#include <algorithm>

#include "render/recorder.h"

namespace ombrage {

namespace {

/// Draws end before a driver's watchdog ends them.
constexpr int kSamplesPerDraw = 32;

}  // namespace

void ShadowRays::draw(FrameContext& frame, Technique& technique, const LightFrame& light, const gl::Texture& visibility,
                      const Options& options) {
    const GpuBvh& bvh = frame.gpuScene->derived<GpuBvh>();
    const bool soft = light.light->hasSize();
    auto defines = options.defines;
    if (soft) defines.emplace_back("SOFT", "1");
    // A light that leaves the receiver's model out lights no receiver of it, so "same model" needs no exclusions.
    if (options.sameModel) {
        defines.emplace_back("SAME_MODEL", "1");
        if (!m_instances) m_instances = instanceModels(*frame.gpuScene);
    } else if (!light.light->excludedModels.empty()) {
        defines.emplace_back("EXCLUDES", "1");
        if (!m_instances) m_instances = excludedInstances(*frame.gpuScene, light.light->excludedModels);
    }
    if (m_instances) m_instances.bindStorage(kExcludedStorage);
    {
        const auto pass = frame.pass("shadow rays");
        const gl::Framebuffer target({{&visibility}}, {}, "shadow rays");
        target.bind();
        frame.bindGBuffer();
        const gl::Program& program = frame.fullscreenProgram(technique, "shared/shadow_rays.frag", std::move(defines));
        bvh.bind(program);
        // The first draw writes the pixels that ask, later ones add their samples.
        const int samples = soft ? options.samples : 1;
        if (soft) program.set("u_sampleCount", samples);
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
    if (frame.recorder->capturing) frame.counter("rays", m_query.pixels() * (soft ? options.samples : 1));
    m_bytes = bvh.gpuBytes() + m_instances.size();
}

}  // namespace ombrage
