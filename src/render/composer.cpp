// SPDX-License-Identifier: MIT
#include "render/composer.h"

#include <cmath>

namespace ombrage {

namespace {

/// As in ombrage/light.glsl, std140.
struct LightBlock {
    glm::vec4 position, direction, color, cone, tangent, bitangent;
    glm::uvec4 exclusion;
};

constexpr float kNoRange = 1e30f;

}  // namespace

void Composer::bindLight(const LightFrame& frame, std::size_t instanceCount) {
    const Light& light = *frame.light;
    const bool isSun = light.type == LightType::Sun;
    LightBlock block;
    block.position = glm::vec4(frame.position, isSun ? 0.0f : 1.0f);
    block.direction = glm::vec4(frame.direction, std::isfinite(light.range_m) ? light.range_m : kNoRange);
    block.color = glm::vec4(light.color * light.intensity, float(light.type));
    block.cone = glm::vec4(std::cos(light.inner_rad), std::cos(light.outer_rad),
                           isSun ? std::tan(light.angle_rad * 0.5f) : light.radius_m, light.size_m.x * light.size_m.y);
    block.tangent = glm::vec4(lightTangent(light), light.size_m.x * 0.5f);
    block.bitangent = glm::vec4(lightBitangent(light), light.size_m.y * 0.5f);
    const auto words = std::uint32_t((instanceCount + 31) / 32);
    block.exclusion = glm::uvec4(std::uint32_t(frame.index) * words, light.excludedModels.empty() ? 0u : 1u, 0u, 0u);
    if (!m_lightBlock) m_lightBlock = gl::Buffer(sizeof block, nullptr, "light block");
    m_lightBlock.upload(0, sizeof block, &block);
    m_lightBlock.bindUniform(kLightBinding);
}

TargetPool::Target Composer::compose(FrameContext& frame, const RenderSettings& settings,
                                     const std::vector<LitLight>& lights, const TargetPool::Target& ao,
                                     const TargetPool::Target& indirect) {
    const bool naive = settings.composite != Composite::Lighting && !lights.empty();
    auto color = frame.targets->take({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "color");
    {
        const auto pass = frame.pass("lighting");
        const gl::Framebuffer target({{color.get()}}, {&frame.gbuffer->depth}, "lighting");
        target.bind();
        // The sky shows the surroundings' own radiance, as in the truth's picture.
        target.clearColor(0, glm::vec4(glm::vec3(frame.scene->ambient), 1.0f));
        frame.gpuScene->bindStorage();
        frame.bindGBuffer();
        if (ao) ao->bind(6);
        if (indirect) indirect->bind(7);
        // The first light is drawn together with all that no light owns; later ones are added.
        const std::size_t passes = std::max<std::size_t>(lights.size(), 1);
        for (std::size_t i = 0; i < passes; ++i) {
            std::vector<std::pair<std::string, std::string>> defines = {{"SHADING", std::to_string(int(settings.shading))}};
            const auto define = [&](const char* name, bool wanted) {
                if (wanted) defines.emplace_back(name, "1");
            };
            define("MATERIAL_PLANE", frame.gbuffer->layout.material);
            define("EXCEPTIONS", frame.gpuScene->hasLightExceptions());
            define("FIRST_LIGHT", i == 0);
            define("EMISSION", i == 0 && frame.gpuScene->hasEmission());
            define("AMBIENT", i == 0 && settings.ambient != AmbientTerm::Off);
            define("OCCLUSION", i == 0 && settings.ambient == AmbientTerm::Ao && ao);
            define("INDIRECT", i == 0 && indirect);
            if (!lights.empty()) {
                bindLight(lights[i].light, frame.gpuScene->flat().instances.size());
                defines.emplace_back("LIGHT_TYPE", std::to_string(int(lights[i].light.light->type)));
                define("VISIBILITY", lights[i].visibility && !naive);
                if (lights[i].visibility) lights[i].visibility->bind(5);
            }
            const gl::Program& program = frame.program(
                {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "ombrage/lighting.frag"}},
                std::move(defines));
            program.set("u_ambient", frame.scene->ambient);
            frame.drawSurfaces(i > 0);
        }
    }
    return naive ? applyNaively(frame, settings, lights, color) : color;
}

TargetPool::Target Composer::applyNaively(FrameContext& frame, const RenderSettings& settings,
                                          const std::vector<LitLight>& lights, const TargetPool::Target& unshadowed) {
    const auto pass = frame.pass("naive composite");
    const gl::TextureDesc half{.format = GL_R16F, .width = frame.width, .height = frame.height};
    const auto factor = frame.targets->take(half, "shadow factor");
    const bool modulate = settings.composite == Composite::Modulate;
    const std::string mode = std::to_string(int(settings.composite));
    const std::vector<gl::ShaderStage> stages = {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"},
                                                 {GL_FRAGMENT_SHADER, "ombrage/shade_factor.frag"}};
    frame.bindGBuffer();
    {
        // Modulate multiplies the visibilities; overlay adds up the shadows, each with its part of the opacity.
        const gl::Framebuffer target({{factor.get()}}, {}, "shadow factor");
        target.bind();
        target.clearColor(0, glm::vec4(modulate ? 1.0f : 0.0f));
        gl::DrawState state;
        state.blend = true;
        state.blendSource = modulate ? GL_ZERO : GL_ONE;
        state.blendDestination = modulate ? GL_SRC_COLOR : GL_ONE;
        gl::apply(state);
        const gl::Program& program = frame.program(stages, {{"ACCUMULATE", "1"}, {"COMPOSITE", mode}});
        program.set("u_scale", float(settings.overlayOpacity) / float(lights.size()));
        for (const LitLight& light : lights) {
            if (!light.visibility) continue;
            light.visibility->bind(5);
            frame.drawFullscreen();
        }
    }
    auto color = frame.targets->take(unshadowed->desc(), "color");
    const gl::Framebuffer target({{color.get()}}, {}, "naive composite");
    target.bind();
    gl::apply({});
    frame.program(stages, {{"COMPOSITE", mode}});
    unshadowed->bind(6);
    factor->bind(7);
    frame.drawFullscreen();
    return color;
}

}  // namespace ombrage
