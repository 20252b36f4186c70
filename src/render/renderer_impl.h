// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/renderer.h>

#include "gl/context.h"
#include "gl/program_cache.h"
#include "render/composer.h"
#include "render/geometry_pass.h"
#include "render/recorder.h"
#include "render/request.h"
#include "render/technique_slots.h"

namespace ombrage {

/// The place of the techniques of all lights that find no room for their own.
inline constexpr const char* kSharedShadow = "shadow of the rest";

/// Whether the pipeline changes nothing, so that no pass need run for it.
bool isNeutral(const Pipeline& pipeline);

/// Textures that a frame leaves behind, for reading back.
struct FrameTargets {
    std::map<int, TargetPool::Target> visibility;
    TargetPool::Target ao, indirect, color;
};

/// What the frames of a call took, one entry a frame.
struct FrameCosts {
    std::vector<double> totals_ms, cpu_ms;
    std::vector<std::string> passes;                       ///< in the order of their first draw
    std::map<std::string, std::vector<double>> passes_ms;  ///< passes of one name count as one
};

/// The renderer's parts and steps, in files by subject: renderer.cpp (the context and the scene), renderer_frame.cpp
/// (one frame), renderer_call.cpp (the frames of one call and what they cost), renderer_images.cpp (what is read back).
struct Renderer::Impl {
    std::unique_ptr<gl::Context> context;
    DeviceInfo device;
    std::unique_ptr<gl::GpuTimer> timer;
    std::unique_ptr<gl::ProgramCache> programs;
    std::unique_ptr<gl::ShaderLibrary> shaders;

    // Everything below holds GL objects and dies before the context, in reverse order.
    TargetPool targets;
    FrameContext::Recorder recorder;
    std::unique_ptr<GpuScene> gpuScene;
    const Scene* scene = nullptr;
    Scene posed;                       ///< the scene at the requested time, when it is animated
    const Scene* posedFrom = nullptr;  ///< what `posed` is but for what moves
    std::unique_ptr<GBuffer> gbuffer;
    GeometryPass geometry;
    Composer composer;
    TechniqueSlots slots;
    std::optional<Camera> previousCamera;
    std::vector<glm::dmat4> placements;        ///< of the instances in gpuScene
    std::array<Pipeline, 4> earlierPipelines;  ///< of the last call: shadow, ao, indirect, aa
    std::uint64_t earlierSeed = 0;             ///< of the last call
    std::uint32_t gatheredFrames = 0;          ///< since the histories of what gathers over frames began
    const std::uint64_t keptShadowBytes;

    /// What the shadow techniques of the frame just rendered say of it, per light index.
    struct Shadowed {
        std::map<int, TexelFootprint> footprint;
        std::map<int, ShadowRange> range;
        std::uint64_t keptBytes = 0, largestBytes = 0;  ///< of all lights with techniques of their own, and of one
        std::size_t sharing = 0;                        ///< lights that found no room
    } shadowed;

    Impl(std::unique_ptr<gl::Context> made, const RendererOptions& options);
    ~Impl();

    void upload(const Scene& next);
    void moveScene(const Scene& next);
    void show(const Scene& next);
    void poseScene(double time_s);
    void prepareFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request);
    /// The picture of every point that the anti-aliasing technique asks for. Gives what the last one left.
    FrameTargets renderFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request);
    FrameTargets renderSample(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request);
    /// Frames to draw before those that count, so that what gathers over frames has settled; 0 where nothing does, or
    /// where it goes on with the history of an earlier call.
    int settlingFrames(const RenderSettings& settings) const;
    LitLight renderShadow(FrameContext& frame, const RenderSettings& settings, const LightFrame& light);
    void noteShadow(const LightFrame& light, const ShadowTechnique& technique);
    std::string shadowPlace(const LightFrame& light);
    TargetPool::Target renderAo(FrameContext& frame, const Pipeline& pipeline);
    TargetPool::Target applyFilter(FrameContext& frame, Technique& filter, const TargetPool::Target& input);
    /// Frees what only earlier calls used, so that what a call costs does not depend on them.
    void forgetEarlierPipelines(const RenderSettings& settings, const RenderRequest& request);
    /// The warm-up frames and those that count, whose costs it keeps. Gives what the last one left.
    FrameTargets renderFrames(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request,
                              FrameCosts& costs);
    void readBackImages(RenderResult& result, const FrameTargets& produced);
    void readBack(RenderResult& result, const FrameContext& frame, const FrameTargets& produced, bool images);
    RenderResult render(const RenderSettings& settings);
};

}  // namespace ombrage
