// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/param_table.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"
#include "render/frame_context.h"

namespace ombrage {
namespace {

enum class Mode { Off, NormalOffset };

}  // namespace

template <>
struct EnumChoices<Mode> {
    static std::vector<std::string> names() { return {"off", "normal-offset"}; }
};

namespace {

/// Every type, in every place that std140 gives another rule to.
struct Everything {
    bool flag = true;
    glm::vec3 tint{0.25f, 0.5f, 0.75f};
    float radius_m = 0.1f;
    int count = -3;
    float cone_rad = 0.5235988f;
    glm::vec3 axis{1, 2, 3};
    glm::vec3 second{4, 5, 6};
    Mode mode = Mode::NormalOffset;
    bool last = false;
    int samples = 5;
    float sharpness = 2;
    glm::vec3 offset{0.5f, 1, -2};
    bool fast = true;

    static ParamTable describe() {
        using P = Everything;
        return fields(field(&P::flag, "flag"), field(&P::tint, "tint").range(0, 9),
                      field(&P::radius_m, "max-radius", Unit::Metre).range(0, 9),
                      field(&P::count, "count").range(-9, 9), field(&P::cone_rad, "cone", Unit::Degree).range(0, 90),
                      field(&P::axis, "axis").range(0, 9), field(&P::second, "second").range(0, 9),
                      field(&P::mode, "mode"), field(&P::last, "last"),
                      field(&P::samples, "samples").range(0, 9).effect(ParamEffect::Define),
                      field(&P::sharpness, "sharpness").range(0, 9).effect(ParamEffect::Define),
                      field(&P::offset, "offset").range(-9, 9).effect(ParamEffect::Define),
                      field(&P::fast, "fast").effect(ParamEffect::Define));
    }
};

class ParamBlockTest : public GlTest {};

// Writes down every member and every define as the shader sees it.
const char* kShader = R"(
#include "shadow/test/params"
layout(local_size_x = 1) in;
layout(std430, binding = 0) writeonly buffer Out { float b_out[]; };
void main() {
    b_out[0] = params.flag ? 1.0 : 0.0;
    b_out[1] = params.tint.x; b_out[2] = params.tint.y; b_out[3] = params.tint.z;
    b_out[4] = params.max_radius;
    b_out[5] = float(params.count);
    b_out[6] = params.cone;
    b_out[7] = params.axis.x; b_out[8] = params.axis.y; b_out[9] = params.axis.z;
    b_out[10] = params.second.x; b_out[11] = params.second.y; b_out[12] = params.second.z;
    b_out[13] = params.mode == MODE_NORMAL_OFFSET ? 1.0 : params.mode == MODE_OFF ? 0.0 : -1.0;
    b_out[14] = params.last ? 1.0 : 0.0;
    b_out[15] = float(SAMPLES);
    b_out[16] = 1.0 / SHARPNESS;
    b_out[17] = OFFSET.x; b_out[18] = OFFSET.y; b_out[19] = OFFSET.z;
#if FAST
    b_out[20] = 1.0;
#else
    b_out[20] = 0.0;
#endif
}
)";

TEST_F(ParamBlockTest, OffsetsAndValuesAreTheDrivers) {
    const ParamTable table = Everything::describe();
    const Everything p;
    gl::ShaderLibrary library;
    const gl::Program& program =
        library.program({{{GL_COMPUTE_SHADER, "test.comp"}},
                         table.glslDefines(&p),
                         {{"test.comp", kShader}, {"shadow/test/params", table.glslBlock(kParamsBinding)}}});
    for (const ParamField& field : table.fields()) {
        if (field.info.effect != ParamEffect::Uniform) continue;
        std::string member = "Params." + field.info.key;
        for (char& c : member)
            if (c == '-') c = '_';
        EXPECT_EQ(program.uniformOffset(member.c_str()), table.blockOffset(field.info.key)) << member;
    }

    const std::vector<std::byte> bytes = table.packBlock(&p);
    const gl::Buffer block(bytes.size(), bytes.data(), "params");
    const gl::Buffer out = gl::Buffer::from(std::vector<float>(21, -99.0f), "out");
    block.bindUniform(kParamsBinding);
    out.bindStorage(0);
    program.use();
    gl::dispatch(1, 1, 1);
    gl::barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> values(21);
    out.download(0, values.size() * sizeof(float), values.data());
    const std::vector<float> expected = {1, 0.25f, 0.5f, 0.75f, 0.1f, -3,   0.5235988f, 1, 2,  3, 4,
                                         5, 6,     1,    0,     5,    0.5f, 0.5f,       1, -2, 1};
    EXPECT_EQ(values, expected);
}

}  // namespace
}  // namespace ombrage
