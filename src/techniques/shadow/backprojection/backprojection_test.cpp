// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/half_plane_scene.h"
#include "techniques/sized_lights.h"

namespace ombrage::test {
namespace {

/// Texels of a few centimetres, all of them looked at one by one.
const std::string kFine = "shadow/backprojection:max-texels=64,max-radius=1024,resolution=1024";

TEST(Backprojection, Probe) {
    for (const LightType type : {LightType::Spot, LightType::Rect, LightType::Point, LightType::Sun}) {
        const HalfPlane half(type);
        const std::vector<float> row = half.row(kFine), truth = half.row("shadow/ray-traced:samples=256"), coarse = half.row("shadow/backprojection:max-radius=1024");
        for (std::size_t i = 0; i < 30; ++i) printf("%s %zu %.3f %.3f %.3f analytic %.3f\n", lightTypeName(type), i, double(row[i]), double(coarse[i]), double(truth[i]), half.visible(double(i)+.5));
    }
    for (const char* name : {"gap","in-shadow","plane-grazing","room","two-casters","sphere","comb","menger","open-mesh","thin-wall","resting","touching","window","penumbra-ramp","fence","nave","corner","cornell","tree","degenerate","far-origin","mirrored","bicycle","figure","bumpy"}) {
        for (const char* t : {"shadow/backprojection"}) {
        const Scene scene = withSizedLight(name, 0.05f);
        Metrics m = measureFirstLight(scene, t, 64);
        printf("%-14s %-28s acne %.5f hard_ratio %.3f leak %.4f contact %.5f penumbra %.4f wrong %.4f false %.4f\n", name, t, m.at("acne").value_or(-1), m.at("hard_ratio").value_or(-1), m.at("leak").value_or(-1), m.at("contact_gap").value_or(-1), m.at("penumbra").value_or(-1), m.at("wrong").value_or(-1), m.at("false_shadow").value_or(-1));
        }
    }
}

}  // namespace
}  // namespace ombrage::test
