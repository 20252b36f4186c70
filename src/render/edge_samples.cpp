// SPDX-License-Identifier: MIT
#include "render/edge_samples.h"

#include <algorithm>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage {

namespace {

/// The numbers that every one of the formats can have.
std::vector<int> commonSampleCounts(const std::vector<GLenum>& formats) {
    std::vector<int> common = gl::sampleCounts(formats.front());
    for (const GLenum format : formats) {
        const std::vector<int> counts = gl::sampleCounts(format);
        std::erase_if(common, [&](int n) { return std::find(counts.begin(), counts.end(), n) == counts.end(); });
    }
    return common;
}

/// Whether the samples' mean is the pixel's centre: to 1/64 pixel, a quarter of the grid that drivers place them on.
bool isBalanced(const std::vector<glm::vec2>& positions) {
    glm::vec2 sum(0.0f);
    for (const glm::vec2& p : positions) sum += p;
    return glm::length(sum) <= float(positions.size()) / 64.0f;
}

}  // namespace

GBufferSamples makeSamples(const GBufferLayout& layout) {
    const int count = layout.samples.count;
    const std::vector<int> offered = commonSampleCounts({GL_DEPTH_COMPONENT32F, GL_RGBA32UI, GL_R32UI});
    if (std::find(offered.begin(), offered.end(), count) == offered.end()) {
        std::vector<std::string> names;
        for (const int n : offered) names.insert(names.begin(), std::to_string(n));
        throw Error(
            ErrorCode::Environment, fmt::format("this device does not draw surfaces with {} samples a pixel", count),
            names.empty() ? "it has no multisampled surfaces at all" : fmt::format("it offers {}", join(names, ", ")));
    }
    const auto plane = [&](GLenum format, const char* label) {
        return gl::Texture({.kind = gl::TextureKind::Multisample2D,
                            .format = format,
                            .width = layout.width,
                            .height = layout.height,
                            .samples = count},
                           label);
    };
    GBufferSamples made;
    made.depth = plane(GL_DEPTH_COMPONENT32F, "depth samples");
    made.surface = plane(GL_RGBA32UI, "surface samples");
    std::vector<gl::Attachment> colors{{&made.surface}};
    if (layout.material) {
        made.material = plane(GL_R32UI, "material samples");
        colors.push_back({&made.material});
    }
    made.framebuffer = gl::Framebuffer(colors, {&made.depth}, "g-buffer samples");
    made.positions = made.framebuffer.samplePositions();
    const auto flat = [&](GLenum format, const char* label) {
        return gl::Texture({.format = format, .width = layout.width, .height = layout.height}, label);
    };
    made.edges = flat(GL_R32UI, "edge pixels");
    made.several = flat(GL_R8UI, "pixels of several triangles");
    made.selector = flat(GL_DEPTH_COMPONENT32F, "selector");
    return made;
}

std::uint64_t byteSize(const GBufferSamples& samples) {
    std::uint64_t bytes = 0;
    for (const gl::Texture* plane :
         {&samples.depth, &samples.surface, &samples.material, &samples.edges, &samples.several, &samples.selector})
        if (*plane) bytes += gl::byteSize(plane->desc());
    return bytes;
}

std::vector<std::pair<std::string, std::string>> sampleDefines(const GBuffer& gbuffer) {
    std::string positions;
    for (const glm::vec2& p : gbuffer.samples->positions)
        positions += fmt::format("{}vec2({}, {})", positions.empty() ? "" : ", ", p.x, p.y);
    std::vector<std::pair<std::string, std::string>> defines{
        {"PIXEL_SAMPLES", std::to_string(gbuffer.samples->positions.size())},
        {"PIXEL_SAMPLE_POSITIONS", "vec2[](" + positions + ")"}};
    if (isBalanced(gbuffer.samples->positions)) defines.emplace_back("BALANCED_SAMPLES", "1");
    if (gbuffer.layout.material) defines.emplace_back("SAMPLE_MATERIALS", "1");
    return defines;
}

void bindSamples(const GBuffer& gbuffer) {
    const GBufferSamples& samples = *gbuffer.samples;
    samples.depth.bind(kUnitSampleDepth);
    samples.surface.bind(kUnitSampleSurface);
    if (samples.material) samples.material.bind(kUnitSampleMaterial);
    samples.edges.bind(kUnitEdges);
}

void makePixels(FrameContext& frame) {
    const GBuffer& gbuffer = *frame.gbuffer;
    const GBufferSamples& samples = *gbuffer.samples;
    const auto use = [&](const char* fragment) {
        frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, fragment}},
                      sampleDefines(gbuffer));
    };
    // Every pixel's depth is written, the sky's too.
    gl::DrawState writesDepth;
    writesDepth.depthTest = writesDepth.depthWrite = true;
    writesDepth.depthFunc = GL_ALWAYS;
    {
        const auto pass = frame.pass("g-buffer pixels");
        std::vector<gl::Attachment> colors{{&gbuffer.surface}, {&samples.several}};
        if (gbuffer.material) colors.push_back({&gbuffer.material});
        const gl::Framebuffer target(colors, {&gbuffer.depth}, "g-buffer pixels");
        target.bind();
        gl::apply(writesDepth);
        bindSamples(gbuffer);
        use("ombrage/pixel_of_samples.frag");
        frame.drawFullscreen();
    }
    const auto pass = frame.pass("edge pixels");
    {
        const gl::Framebuffer target({}, {&samples.selector}, "selector");
        target.bind();
        gl::apply(writesDepth);
        samples.several.bind(kFirstFreeUnit);
        use("ombrage/selector.frag");
        frame.drawFullscreen();
    }
    const gl::Framebuffer target({{&samples.edges}}, {&samples.selector}, "edge pixels");
    target.bind();
    target.clearColorUint(0, glm::uvec4(0u));
    frame.bindGBuffer();
    use("ombrage/edge_pixels.frag");
    frame.drawSurfaces();
}

}  // namespace ombrage
