// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/renderer.h>
#include <ombrage/trace.h>

#include "gl/gpu_timer.h"
#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/geometry_samples.h"
#include "render/gpu_scene.h"
#include "render/target_pool.h"
#include "scene/camera_view.h"

namespace ombrage {

class Technique;

/// What a G-buffer is made for.
struct GBufferLayout {
    int width = 0, height = 0;
    GeometrySamples samples;
    bool stencil = false;    ///< a technique counts in the depth's stencil plane
    bool material = false;   ///< lighting, or a view, wants more of the material than its colour
    bool operator==(const GBufferLayout&) const = default;
};

/// The samples that a multisampled G-buffer is made of.
struct GBufferSamples {
    std::vector<glm::vec2> positions;    ///< in pixels from the pixel's centre, right and up
    gl::Texture depth, surface, material;  ///< as those of the pixels
    gl::Framebuffer framebuffer;
    /// R32UI, one texel per pixel: 0 where all samples show one surface; else four bits for each sample: from which pixel of
    /// the 3x3 around it the sample takes what is known of pixels alone (ombrage/edge_samples.glsl).
    gl::Texture edges;
    gl::Texture several;    ///< R8UI: 1 where a pixel's samples show several triangles
    /// The same as a depth, 1 or 0: attached in the place of the G-buffer's, drawSurfaces() draws these pixels alone.
    gl::Texture selector;
};

/// The picture's geometry, one texel per pixel. Depth 0 is the sky.
struct GBuffer {
    GBufferLayout layout;
    gl::Texture depth;      ///< D32F, or D32F_S8 when a technique needs stencil; reversed-Z
    gl::Texture surface;    ///< RGBA32UI, words as in ombrage/surface.glsl: n_g and n_s towards the eye, albedo, triangle
    gl::Texture material;   ///< R32UI: metallic, roughness, specular luminance, shininess/255; empty where nothing asks for it
    gl::Framebuffer framebuffer;
    std::optional<GBufferSamples> samples;  ///< with more than one sample in a pixel: what the planes above are made of
};

/// A light in the space moved by the scene's origin.
struct LightFrame {
    int index = 0;               ///< into Scene::lights
    const Light* light = nullptr;
    glm::vec3 position{0.0f};    ///< of its centre; meaningless for suns
    glm::vec3 direction{0, -1, 0};
    /// Towards the light's centre, homogeneous: (position, 1), or (-direction, 0) for a sun.
    glm::vec4 toward() const;
    /// The same in world space, as exact as the scene has it.
    glm::dvec4 towardInWorld() const;
};

/// How `--show` turns a texture into a picture.
enum class ShowAs {
    Value,        ///< red channel as grey
    Color,        ///< RGB, linear
    Depth01,      ///< depth in [0,1], stretched between the smallest and largest value below 1
    LightDepth,   ///< reversed depth of a light view: near is bright, nothing is black
    Count,        ///< unsigned count from a red integer texture, stretched
    Stencil       ///< the stencil plane of a depth-stencil texture, counted about 0 (255 is -1)
};

/// What a technique sees of the frame, and its way to record passes and intermediates.
class FrameContext {
public:
    int width = 0, height = 0;
    const Scene* scene = nullptr;
    GpuScene* gpuScene = nullptr;
    GBuffer* gbuffer = nullptr;
    CameraView view;
    CameraView fitView;       ///< what techniques fit to what is seen; `view` unless RenderSettings::fitCamera is set
    CameraView centredView;   ///< `view` with its samples in the pixels' centres (AaTechnique::samplePoints)
    CameraView previousView;  ///< the centred view of the frame before, in this call or the last; of this one at the first
    std::uint32_t sample = 0;      ///< which of the points it is that `view` is drawn for
    bool isLastSample = true;
    glm::vec2 jitter_px{0.0f};     ///< that point
    /// Of a multisampled G-buffer, for the anti-aliasing technique: RGBA16F, one layer a sample, linear; only pixels with a
    /// bit in GBufferSamples::edges are written.
    const gl::Texture* edgeColors = nullptr;
    std::uint32_t seed = 1;
    std::uint32_t frameIndex = 0;
    NormalSource normals = NormalSource::Map;
    gl::ShaderLibrary* shaders = nullptr;
    TargetPool* targets = nullptr;

    /// A named span of GPU work: debug group, timer span and, in the record, a row. Spans do not nest.
    class Pass {
    public:
        Pass(FrameContext& frame, const std::string& name);
        ~Pass();
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;

    private:
        FrameContext& m_frame;
        gl::DebugGroup m_group;
        bool m_counts;
        std::optional<TraceScope> m_trace;  ///< the CPU's side: without the wall clock's waiting for the GPU
    };
    Pass pass(const std::string& name) { return Pass(*this, name); }

    /// While it lives, a light's shadow is made: programs of techniques are compiled for its type (LIGHT_TYPE), and what
    /// they expose is called NAME@LIGHT but for the first light.
    class LightScope {
    public:
        LightScope(FrameContext& frame, const LightFrame& light, bool first);
        ~LightScope();
        LightScope(const LightScope&) = delete;
        LightScope& operator=(const LightScope&) = delete;

    private:
        FrameContext& m_frame;
    };

    /// Counts draws and triangles into the open pass.
    void countDraw(std::uint64_t draws, std::uint64_t triangles);

    /// A number for the record ("rays", "volumes clamped"); summed over lights.
    void counter(const std::string& name, double value);

    /// Offers an intermediate to `--show`. Call only when wants(name); the texture is read back at once.
    void expose(const std::string& name, const gl::Texture& texture, ShowAs how, int layer = 0);
    bool wants(const std::string& name) const;

    /// Whether this is the frame that the caller gets to see, the last one: what only informs and makes the GPU wait is
    /// done here alone.
    bool isReturned() const;

    /// Whether what a technique saves is to be counted now: in the frame that is returned, where the caller asks for it
    /// (RenderSettings::countSavings).
    bool countsSavings() const;

    /// While it lives, passes, draws and counters are left out of the record: what is drawn counts what a technique does,
    /// and is not part of it.
    class Uncounted {
    public:
        explicit Uncounted(FrameContext& frame);
        ~Uncounted();
        Uncounted(const Uncounted&) = delete;
        Uncounted& operator=(const Uncounted&) = delete;

    private:
        FrameContext& m_frame;
        bool m_before;
    };

    void warn(const std::string& message);

    /// The program of a technique, in use: its virtual include "FAMILY/NAME/params" and its defines are added from its
    /// parameters, and its uniform block is uploaded and bound at kParamsBinding.
    const gl::Program& program(Technique& technique, std::vector<gl::ShaderStage> stages,
                               std::vector<std::pair<std::string, std::string>> defines = {},
                               std::vector<std::pair<std::string, std::string>> virtuals = {});
    /// A program that has no technique's parameters, in use.
    const gl::Program& program(std::vector<gl::ShaderStage> stages,
                               std::vector<std::pair<std::string, std::string>> defines = {},
                               std::vector<std::pair<std::string, std::string>> virtuals = {});

    /// A full-screen pass: "ombrage/fullscreen.vert" and the given fragment stage, in use.
    const gl::Program& fullscreenProgram(Technique& technique, const std::string& fragmentPath,
                                         std::vector<std::pair<std::string, std::string>> defines = {});

    /// One triangle over the viewport, counted.
    void drawFullscreen();

    /// The same over the surfaces alone: pixels of the sky fail the depth test and cost nothing. The G-buffer's depth is
    /// attached to the bound framebuffer (and may be read, for it is not written); sets the draw state.
    void drawSurfaces(bool blend = false);

    /// Binds the G-buffer's textures to the units of ombrage/gbuffer.glsl.
    void bindGBuffer() const;

    struct Recorder;
    Recorder* recorder = nullptr;   ///< owned by the Renderer
};

/// Uniform block bindings and texture units that every shader agrees on (ombrage/bindings.glsl holds the same numbers).
inline constexpr unsigned kFrameBinding = 0;
inline constexpr unsigned kParamsBinding = 1;
inline constexpr unsigned kLightBinding = 2;
inline constexpr unsigned kInstanceStorage = 0;    ///< b_instances
inline constexpr unsigned kMaterialStorage = 1;    ///< b_materials
inline constexpr unsigned kUnitDepth = 0, kUnitSurface = 1, kUnitMaterial = 2;
inline constexpr unsigned kFirstFreeUnit = 5;      ///< techniques' own textures start here
inline constexpr unsigned kUnitMaterialTextures = 16;  ///< base colour, normal, height, metallic-roughness, emissive

}  // namespace ombrage
