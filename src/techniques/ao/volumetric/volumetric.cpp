// SPDX-License-Identifier: MIT
// ao/volumetric: the free share of the half ball over the surface, by points, lines or areas. See volumetric.md.
#include <cmath>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/volumetric/depth_moments.h"
#include "techniques/ao/volumetric/own.h"
#include "techniques/shared/ao_kernel.h"

namespace ombrage {

namespace volumetric {

ParamTable VolumetricParams::describe() {
    using P = VolumetricParams;
    return screenAoTable(
        {field(&P::sampling, "sampling")
             .effect(ParamEffect::Define)
             .help(
                 "points of the ball, each hidden or not; lines through it along the sight, each free to a length; or "
                 "areas of its outline, each by mean and variance of the depths in it."),
         field(&P::samples, "samples")
             .range(1, 64)
             .tune(1, 64)
             .effect(ParamEffect::Define)
             .help(
                 "How many of them per pixel; the paper compares 33 points, 9 lines and 1 area. More cost time, fewer "
                 "give noise (points, lines) or blur (areas)."),
         field(&P::depths, "depths")
             .effect(ParamEffect::Define)
             .help(
                 "Of areas: normal takes the depths for a normal distribution; steps for a share of the tangent plane "
                 "and one of a surface over it, which keeps what stands far in front from darkening all around."),
         field(&P::clip, "clip")
             .effect(ParamEffect::Define)
             .help("Takes the half of the ball over the tangent plane; without it the whole ball, of which a flat "
                   "surface fills half, so that normals do not count."),
         field(&P::thickness, "thickness")
             .range(0, 100)
             .tune(0, 4)
             .help("Surfaces are this many radii thick along the sight: lower takes away halos behind edges, and with "
                   "them what is under thick things. 0: endlessly.")});
}

namespace {

/// Of each line or area its place in the unit disk, and in z half the ball's mean length along the sight over the ring
/// of the disk that it stands for.
std::vector<glm::vec4> makeDisk(int count) {
    std::vector<glm::vec4> disk = aoKernel(AoOffsets::Screen, AoDistribution::Uniform, count);
    if (count == 1) disk[0] = glm::vec4(0, 0, 0, 1);
    for (int i = 0; i < count; ++i) {
        // The mean of sqrt(1 - r^2) over r^2 from i/N to (i+1)/N.
        const double inner = 1 - double(i) / count, outer = 1 - double(i + 1) / count;
        disk[std::size_t(i)].z = float(2.0 / 3.0 * count * (inner * std::sqrt(inner) - outer * std::sqrt(outer)));
    }
    return disk;
}

}  // namespace

class Volumetric final : public ScreenAoTechniqueOf<VolumetricParams> {
public:
    std::uint64_t gpuBytes() const override { return ScreenAoTechniqueOf::gpuBytes() + m_moments.gpuBytes(); }

protected:
    ScreenAoPass pass(FrameContext& frame) override {
        if (p().sampling == Sampling::Areas) m_moments.update(frame);
        return {.fragmentPath = "ao/volumetric/volumetric.frag", .bind = [this](const gl::Program& program) {
                    const bool isPoints = p().sampling == Sampling::Points;
                    const std::vector<glm::vec4> kernel = isPoints ? aoBallKernel(p().samples) : makeDisk(p().samples);
                    program.set("u_kernel", kernel.data(), p().samples);
                    if (p().sampling == Sampling::Areas) {
                        m_moments.texture().bind(kFirstAoUnit);
                        program.set("u_margin", float(DepthMoments::kMargin));
                        program.set("u_lastLevel", DepthMoments::kLevels - 1);
                    }
                }};
    }

private:
    DepthMoments m_moments;
};

}  // namespace volumetric

using volumetric::Volumetric;

OMBRAGE_TECHNIQUE(ao, volumetric, Volumetric,
                  {.title = "Free volume by points, lines or areas",
                   .summary = "The share of the half ball over each surface point that lies in front of the picture's "
                              "depths, by points in it, lines through it, or the depths' mean and variance over areas.",
                   .papers = {"loos2010volumetric", "bowling2009logistic"},
                   .limits = "A share of volume, not of light: all directions and all distances count alike. Sees only "
                             "what the picture shows.",
                   .usesSeed = true,
                   .integrand = integrandOf(&volumetric::makeIntegrand)})

}  // namespace ombrage
