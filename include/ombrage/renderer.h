// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/image.h>
#include <ombrage/metrics.h>
#include <ombrage/scene.h>
#include <ombrage/technique.h>

namespace ombrage {

enum class NormalSource { Geometry, Bump, Map };
enum class Shading { Phong, Blinn, Pbr };
enum class Composite { Lighting, Modulate, Overlay };
enum class AmbientTerm { Constant, Ao, Off };

/// "geometry", "bump", "map".
const char* normalSourceName(NormalSource source);

/// What the clock brackets: every pass by itself, or the frame as a whole. A wall clock (DeviceInfo::clock) must finish the
/// queue at both ends of what it times, so timing passes by it keeps one from overlapping the next.
enum class Timing { Passes, Frame };

struct RendererOptions {
    std::string device;       ///< "" best with fallback, "software", or an EGL device index
    std::string shaderDir;    ///< read shaders from here instead of the embedded ones
    bool debugContext = false;///< a KHR_debug context; messages end in RenderResult::debugMessages
    /// Folder of programs compiled by earlier runs; empty: $OMBRAGE_CACHE, else the user's cache folder; "off": none.
    /// Not used where the driver hands none out.
    std::string cache = "";
    /// GPU memory that shadow techniques may keep between frames, all lights together. The shadows of lights that do not
    /// fit in are drawn anew in every frame, which costs time and changes no picture; a warning says so.
    std::uint64_t keptShadowBytes = std::uint64_t(1) << 30;
};

/// What to render. Lists of techniques are pipelines: each element feeds the next.
struct RenderSettings {
    int width = 640, height = 360;
    std::string camera;                    ///< "" the first
    std::string light;                     ///< "" all lights
    /// What techniques fit to (a map's extent, cascades) in the place of the camera from which the picture is drawn: how
    /// their answers at the same surface points change while the viewer moves.
    std::optional<Camera> fitCamera;
    Pipeline shadow{{"shadow/none", {}}};
    Pipeline ao{{"ao/none", {}}};
    Pipeline indirect{{"indirect/none", {}}};
    Pipeline aa{{"aa/none", {}}};
    NormalSource normals = NormalSource::Map;
    Shading shading = Shading::Blinn;
    Composite composite = Composite::Lighting;
    double overlayOpacity = 0.5;
    AmbientTerm ambient = AmbientTerm::Ao;
    double time_s = 0;
    int frames = 1;                        ///< frames rendered; the last one is returned, times cover all but warmup
    int warmupFrames = 0;
    int firstFrame = 0;                    ///< number of the first of them, for what changes from frame to frame
    Timing timing = Timing::Passes;
    std::uint64_t seed = 1;
    std::vector<std::string> show;         ///< pictures wanted beside the final one, by name; "all" for every one
    /// False: nothing but the picture and what `show` names is wanted. RenderResult has no visibility, ao and ids then,
    /// and lighting asks shadow techniques that can answer pixel by pixel (shadow/map) without an image between them.
    bool images = true;
    /// Techniques also count what they save against plainer ones (fill, pixels) in the frame that is returned: extra draws and
    /// a wait, outside of the passes' times. Not with Timing::Frame.
    bool countSavings = false;
    /// Called before each frame with the share done in [0,1]; returning false ends the call with Error(Interrupted).
    std::function<bool(double)> progress;
    std::map<int, Image> givenVisibility;  ///< per light index: use this visibility in the shadow pipeline's place
};

struct Stats { double median = 0, p95 = 0; };

struct PassCost {
    std::string name;
    Stats gpu_ms;
    std::uint64_t draws = 0, triangles = 0;
    std::vector<double> frames_ms;              ///< of the frames after the warm-up that have this pass, in order
    /// Of the images that the pass draws to or reads, each counted once; textures of materials and vertices are left out.
    /// Over the memory's bandwidth it is the least time of a pass that touches every pixel.
    std::uint64_t bytes = 0;
};

struct DeviceInfo {
    std::string renderer, vendor, version;
    bool software = false;
    std::string clock;        ///< "timestamp" or "wall"
};

struct RenderResult {
    Image picture;                              ///< linear RGB, before sRGB encoding; after aa
    std::map<std::string, Image> shown;         ///< name -> picture fit for looking at
    std::map<std::string, Image> shownRaw;      ///< name -> its numbers (metres, counts, depths as stored)
    std::map<int, Image> visibility;            ///< per light index, one plane
    std::optional<Image> ao;                    ///< one plane
    std::map<int, TexelFootprint> footprint;    ///< per light index
    std::map<int, ShadowRange> range;           ///< per light index
    std::vector<std::uint32_t> instance, triangle;  ///< ids of the G-buffer, row 0 at the top
    std::vector<PassCost> passes;               ///< with Timing::Frame their gpu_ms are 0
    Stats gpu_ms;                               ///< sum of the passes; with Timing::Frame the frame
    std::vector<double> frames_ms;              ///< of every frame after the warm-up, in order; what gpu_ms sums up
    double cpu_ms = 0;                          ///< of the calling thread, median
    std::vector<double> cpuFrames_ms;           ///< as frames_ms
    std::uint64_t gpuBytes = 0;                 ///< render targets and technique buffers, not the scene's own
    std::map<std::string, double> counters;
    std::vector<std::string> warnings;
    std::vector<std::string> debugMessages;
};

/// Draws scenes off screen. One per thread and context; every call makes its context current and leaves it so.
class Renderer {
public:
    /// Makes a headless context. @throws Error(Environment) with what was tried.
    explicit Renderer(const RendererOptions& options = {});

    /// Uses the context that is current in the calling thread; its state is restored after every call.
    struct AdoptCurrent {};
    Renderer(AdoptCurrent, const RendererOptions& options = {});

    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Uploads the scene; it must stay alive until the next setScene.
    void setScene(const Scene& scene);

    /// Goes on with the same scene whose cameras, lights and instances may stand elsewhere. Techniques keep what they made
    /// of earlier frames, so far as it does not depend on what moved. The scene must stay alive until the next call; it
    /// may be the one given before, changed in place. @throws Error(Usage) where anything else can be seen to differ.
    void moveScene(const Scene& scene);

    /// @throws Error(Usage) for unknown names or a light that the technique does not support.
    RenderResult render(const RenderSettings& settings);

    const DeviceInfo& device() const;

    /// Names that RenderSettings::show takes with these settings, with a sentence each.
    std::vector<PassInfo> showNames(const RenderSettings& settings) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// One line of `ombrage doctor`.
struct DoctorCheck {
    std::string name;
    std::string verdict;   ///< "ok", "missing", "fallback", "failed"
    std::string detail;
};

/// Tries what the program needs and says what is in use; never throws.
std::vector<DoctorCheck> runDoctor(const RendererOptions& options = {});

}  // namespace ombrage
