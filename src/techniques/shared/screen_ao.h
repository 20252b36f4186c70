// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <ombrage/ao_integrand.h>

#include "core/param_table.h"
#include "gl/objects.h"
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/view_depths.h"

namespace ombrage {

/// How many of the picture's pixels are receivers: all, or one of each 2x2 with joint bilateral upsampling after it.
/// Deinterleaved: all, but in 16 pictures of every fourth pixel across and down, each of which reads its own depths
/// alone (Bavoil 2013).
enum class AoPixels { Full, Half, Deinterleaved };
/// How samples turn from pixel to pixel (aoTurn() in shared/screen_ao.glsl).
enum class AoRotation { None, Gradient, Hash, Tile, BlueNoise };

template <>
struct EnumChoices<AoPixels> {
    static std::vector<std::string> names() { return {"full", "half", "deinterleaved"}; }
};
template <>
struct EnumChoices<AoRotation> {
    static std::vector<std::string> names() { return {"none", "gradient", "hash", "tile", "blue-noise"}; }
};

/// What all techniques have in common that find occluders in the picture's depths; shared/screen_ao.glsl reads it.
/// Parameter structs derive from it, with it as their only base, and put their own fields through screenAoTable().
struct ScreenAoParams {
    float radius_m = 0.0f;
    float radiusPercent = 0.0f;
    float maxRadius_px = 0.0f;
    AoRotation rotation = AoRotation::Gradient;
    AoPixels pixels = AoPixels::Full;

    /// The farthest occluder that is asked for: `radius`, else `radius-percent` of the scene's diagonal, else the
    /// scene's own.
    double radiusIn(double sceneRadius_m, double sceneDiagonal_m) const;
};

/// Their declarations, with `defaults` as defaults, after those of the technique.
ParamTable screenAoTable(std::vector<ParamField> own, const ScreenAoParams& defaults = {});

/// What a technique draws over its receivers.
struct ScreenAoPass {
    std::string fragmentPath;  ///< includes shared/screen_ao.glsl and writes the visibility to location 0
    std::vector<std::pair<std::string, std::string>> defines = {};
    std::function<void(const gl::Program&)> bind = {};  ///< uniforms, and textures from kFirstAoUnit on
    int depthLevels = 0;  ///< of ViewDepths, which aoSurfaceOfLevel() needs; 0: it is not called
};

inline constexpr unsigned kUnitAoNoise = kFirstFreeUnit, kUnitAoDepths = kFirstFreeUnit + 1;
inline constexpr unsigned kUnitAoParts = kFirstFreeUnit + 2;  ///< depths by parts, of AoPixels::Deinterleaved
inline constexpr unsigned kFirstAoUnit = kFirstFreeUnit + 3;

/// Draws occlusion over the picture, or over a quarter of its pixels and then over the rest from these.
class ScreenAo {
public:
    /// In a pass named by the technique's id.
    void render(FrameContext& frame, Technique& technique, const ScreenAoParams& params, const ScreenAoPass& pass,
                const gl::Texture& visibility);

    /// The first half of it: one value for each receiver into a texture of receiversOf().
    void draw(FrameContext& frame, Technique& technique, const ScreenAoParams& params, const ScreenAoPass& pass,
              const gl::Texture& target);

    std::uint64_t gpuBytes() const;

private:
    void drawReceivers(FrameContext& frame, Technique& technique, const ScreenAoParams& params,
                       const ScreenAoPass& pass, const gl::Texture& target, const gl::Texture* parts);

    gl::Texture m_blueNoise;
    ViewDepths m_depths;
};

/// aoOwnShare() for integrands: of the directions about n_s, weighted by their cosine, the share below n_g's plane.
double ownSurfaceShare(const AoReceiver& receiver);

/// How many receivers there are across and down.
glm::ivec2 receiversOf(const FrameContext& frame, const ScreenAoParams& params);

/// From one receiver of each 2x2 pixels (the lower left) to all: of the nearest two or four those count that lie in the
/// pixel's tangent plane and face as it does (Kopf et al. 2007; the plane as in filter/bilateral).
void upsampleAo(FrameContext& frame, const gl::Texture& receivers, const gl::Texture& visibility);

/// A technique of one such pass. P derives from ScreenAoParams.
template <typename P>
class ScreenAoTechniqueOf : public AoTechniqueOf<P> {
public:
    void render(FrameContext& frame, const gl::Texture& visibility) override {
        m_ao.render(frame, *this, this->p(), pass(frame), visibility);
    }
    std::uint64_t gpuBytes() const override { return m_ao.gpuBytes(); }

protected:
    virtual ScreenAoPass pass(FrameContext& frame) = 0;

    ScreenAo& screenAo() { return m_ao; }

private:
    ScreenAo m_ao;
};

}  // namespace ombrage
