// SPDX-License-Identifier: MIT
#include "render/frame_context.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "gl/traffic.h"
#include "render/recorder.h"
#include "render/technique.h"

namespace ombrage {

namespace {

constexpr const char* kFullscreenVertex = "ombrage/fullscreen.vert";

/// Adds what tells the stages of a full-screen pass from others. Returns whether it is one.
bool markFullscreen(const std::vector<gl::ShaderStage>& stages,
                    std::vector<std::pair<std::string, std::string>>& defines) {
    const bool is = !stages.empty() && stages.front().path == kFullscreenVertex;
    if (is) defines.emplace_back("FULLSCREEN", "1");
    return is;
}

}  // namespace

glm::vec4 LightFrame::toward() const {
    return light->type == LightType::Sun ? glm::vec4(-direction, 0.0f) : glm::vec4(position, 1.0f);
}

glm::dvec4 LightFrame::towardInWorld() const {
    if (light->type == LightType::Sun) return glm::dvec4(-glm::dvec3(light->direction), 0.0);
    return glm::dvec4(light->position, 1.0);
}

FrameContext::Pass::Pass(FrameContext& frame, const std::string& name)
    : m_frame(frame), m_group(name.c_str()), m_counts(!frame.recorder->uncounted) {
    if (!m_counts) return;
    frame.recorder->passes.push_back({name});
    if (frame.recorder->timesPasses) frame.recorder->timer->begin(name);
    m_trace.emplace(name);
    gl::takeTraffic();
}

FrameContext::Pass::~Pass() {
    if (!m_counts) return;
    m_trace.reset();
    m_frame.recorder->passes.back().bytes = gl::takeTraffic();
    if (m_frame.recorder->timesPasses) m_frame.recorder->timer->end();
}

FrameContext::LightScope::LightScope(FrameContext& frame, const LightFrame& light, bool first) : m_frame(frame) {
    frame.recorder->lightType = light.light->type;
    frame.recorder->suffix = first ? "" : "@" + light.light->name;
}

FrameContext::LightScope::~LightScope() {
    m_frame.recorder->lightType.reset();
    m_frame.recorder->suffix.clear();
}

void FrameContext::countDraw(std::uint64_t draws, std::uint64_t triangles) {
    if (recorder->uncounted) return;
    assert(!recorder->passes.empty());
    recorder->passes.back().draws += draws;
    recorder->passes.back().triangles += triangles;
}

void FrameContext::counter(const std::string& name, double value) {
    if (!recorder->uncounted) recorder->counters[name] += value;
}

bool FrameContext::wants(const std::string& name) const {
    return recorder->capturing && (recorder->wantsAll || recorder->wanted.count(name + recorder->suffix) > 0);
}

bool FrameContext::isReturned() const {
    return recorder->capturing;
}

bool FrameContext::countsSavings() const {
    return recorder->capturing && recorder->countsSavings;
}

FrameContext::Uncounted::Uncounted(FrameContext& frame)
    : m_frame(frame), m_before(std::exchange(frame.recorder->uncounted, true)) {}

FrameContext::Uncounted::~Uncounted() {
    m_frame.recorder->uncounted = m_before;
    gl::takeTraffic();  // of no pass
}

void FrameContext::expose(const std::string& name, const gl::Texture& texture, ShowAs how, int layer) {
    recorder->shown[name + recorder->suffix] = showTexture(texture, how, layer);
}

void FrameContext::warn(const std::string& message) {
    auto& warnings = recorder->warnings;
    if (std::find(warnings.begin(), warnings.end(), message) == warnings.end()) warnings.push_back(message);
}

const gl::Program& FrameContext::program(Technique& technique, std::vector<gl::ShaderStage> stages,
                                         std::vector<std::pair<std::string, std::string>> defines,
                                         std::vector<std::pair<std::string, std::string>> virtuals) {
    const ParamTable& table = technique.table();
    const auto own = table.glslDefines(technique.params());
    defines.insert(defines.end(), own.begin(), own.end());
    if (recorder->lightType) defines.emplace_back("LIGHT_TYPE", std::to_string(int(*recorder->lightType)));

    // The technique's own block: uploaded when its bytes changed, bound anew because every technique shares the
    // binding.
    auto& block = recorder->blocks[&technique];
    std::vector<std::byte> bytes = table.packBlock(technique.params());
    if (!bytes.empty()) {
        if (block.bytes != bytes) {
            if (block.buffer.size() != bytes.size())
                block.buffer = gl::Buffer(bytes.size(), bytes.data(), "technique parameters");
            else
                block.buffer.upload(0, bytes.size(), bytes.data());
            block.bytes = std::move(bytes);
        }
        block.buffer.bindUniform(kParamsBinding);
    }
    const bool perPass = markFullscreen(stages, defines);
    virtuals.emplace_back(technique.entry().id() + "/params",
                          perPass ? table.glslPerPass(kParamsBinding) : table.glslBlock(kParamsBinding));
    if (perPass) virtuals.emplace_back("ombrage/per_pass_params.glsl", table.glslPassing(kParamsBinding));
    const gl::Program& made = shaders->program({std::move(stages), std::move(defines), std::move(virtuals)});
    made.use();
    return made;
}

const gl::Program& FrameContext::program(std::vector<gl::ShaderStage> stages,
                                         std::vector<std::pair<std::string, std::string>> defines,
                                         std::vector<std::pair<std::string, std::string>> virtuals) {
    markFullscreen(stages, defines);
    const gl::Program& made = shaders->program({std::move(stages), std::move(defines), std::move(virtuals)});
    made.use();
    return made;
}

const gl::Program& FrameContext::fullscreenProgram(Technique& technique, const std::string& fragmentPath,
                                                   std::vector<std::pair<std::string, std::string>> defines) {
    return program(technique, {{GL_VERTEX_SHADER, kFullscreenVertex}, {GL_FRAGMENT_SHADER, fragmentPath}},
                   std::move(defines));
}

void FrameContext::drawFullscreen() {
    gl::drawFullscreen();
    countDraw(1, 1);
}

void FrameContext::drawSurfaces(bool blend) {
    // The triangle lies at depth 0, the sky's; what is nearer has more.
    gl::DrawState state;
    state.depthTest = true;
    state.depthFunc = GL_LESS;
    state.blend = blend;
    gl::apply(state);
    drawFullscreen();
}

void FrameContext::bindGBuffer() const {
    gbuffer->depth.bind(kUnitDepth);
    gbuffer->surface.bind(kUnitSurface);
    if (gbuffer->material) gbuffer->material.bind(kUnitMaterial);
}

}  // namespace ombrage
