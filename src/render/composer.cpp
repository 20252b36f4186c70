// SPDX-License-Identifier: MIT
#include "render/composer.h"

#include <algorithm>
#include <cmath>

#include "render/edge_samples.h"

namespace ombrage {

namespace {

/// As in ombrage/light.glsl, std140.
struct LightBlock {
    glm::vec4 position, direction, color, cone, tangent, bitangent;
    glm::uvec4 exclusion;
};

constexpr float kNoRange = 1e30f;
constexpr unsigned kUnitAo = 3, kUnitIndirect = 4, kUnitVisibility = kFirstFreeUnit;

/// What stands behind the lookup's include where lighting looks nothing up.
const std::pair<std::string, std::string> kNoLookup{kShadowLookupPath, ""};

bool isNaive(const RenderSettings& settings, const std::vector<LitLight>& lights) {
    return settings.composite != Composite::Lighting && !lights.empty();
}

/// Each layer as a target of its own.
std::vector<gl::Attachment> layersOf(const gl::Texture& texture) {
    std::vector<gl::Attachment> layers;
    for (int i = 0; i < texture.desc().layers; ++i) layers.push_back({&texture, 0, i});
    return layers;
}

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

void Composer::light(FrameContext& frame, const RenderSettings& settings, const std::vector<LitLight>& lights,
                     const TargetPool::Target& ao, const TargetPool::Target& indirect, bool ofSamples) {
    const bool naive = isNaive(settings, lights);
    frame.gpuScene->bindStorage();
    frame.bindGBuffer();
    if (ofSamples) bindSamples(*frame.gbuffer);
    if (ao) ao->bind(kUnitAo);
    if (indirect) indirect->bind(kUnitIndirect);
    // The first light is drawn together with all that no light owns; later ones are added.
    const std::size_t passes = std::max<std::size_t>(lights.size(), 1);
    for (std::size_t i = 0; i < passes; ++i) {
        std::vector<std::pair<std::string, std::string>> defines = {{"SHADING", std::to_string(int(settings.shading))}};
        if (ofSamples) {
            const auto samples = sampleDefines(*frame.gbuffer);
            defines.insert(defines.end(), samples.begin(), samples.end());
        }
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
        const LitLight* lit = lights.empty() ? nullptr : &lights[i];
        if (lit) {
            bindLight(lit->light, frame.gpuScene->flat().instances.size());
            defines.emplace_back("LIGHT_TYPE", std::to_string(int(lit->light.light->type)));
            define("VISIBILITY", lit->visibility && !naive);
            define("COLORED", lit->colored && !naive);
            if (lit->visibility) (lit->colored ? lit->colored : lit->visibility)->bind(kUnitVisibility);
        }
        const std::vector<gl::ShaderStage> stages = {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"},
                                                     {GL_FRAGMENT_SHADER, "ombrage/lighting.frag"}};
        if (lit && lit->lookup) {
            define("LOOKUP", true);
            defines.insert(defines.end(), lit->lookup->defines.begin(), lit->lookup->defines.end());
            const gl::Program& program =
                frame.program(*lit->technique, stages, std::move(defines), includeOf(*lit->lookup));
            lit->lookup->bind(program);
        } else {
            frame.program(stages, std::move(defines), {kNoLookup});
        }
        frame.drawSurfaces(i > 0);
    }
}

Composed Composer::compose(FrameContext& frame, const RenderSettings& settings, const std::vector<LitLight>& lights,
                           const TargetPool::Target& ao, const TargetPool::Target& indirect) {
    Composed made;
    made.color = frame.targets->take({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "color");
    {
        const bool looksUp = !lights.empty() && lights.front().lookup;
        const auto pass = frame.pass(looksUp ? "lighting with " + lights.front().technique->entry().id() : "lighting");
        const gl::Framebuffer target({{made.color.get()}}, {&frame.gbuffer->depth}, "lighting");
        target.bind();
        // The sky shows the surroundings' own radiance, as in the truth's picture.
        target.clearColor(0, glm::vec4(glm::vec3(frame.scene->ambient), 1.0f));
        light(frame, settings, lights, ao, indirect, false);
    }
    if (frame.gbuffer->samples) {
        made.edgeColors = frame.targets->take({.kind = gl::TextureKind::Array2D,
                                               .format = GL_RGBA16F,
                                               .width = frame.width,
                                               .height = frame.height,
                                               .layers = frame.gbuffer->layout.samples.count},
                                              "edge colors");
        const auto pass = frame.pass("lighting of edges");
        const gl::Framebuffer target(layersOf(*made.edgeColors), {&frame.gbuffer->samples->selector},
                                     "lighting of edges");
        target.bind();
        light(frame, settings, lights, ao, indirect, true);
    }
    return isNaive(settings, lights) ? applyNaively(frame, settings, lights, made) : made;
}

Composed Composer::applyNaively(FrameContext& frame, const RenderSettings& settings,
                                const std::vector<LitLight>& lights, const Composed& unshadowed) {
    const auto pass = frame.pass("naive composite");
    const bool isColored =
        std::any_of(lights.begin(), lights.end(), [](const LitLight& light) { return light.colored != nullptr; });
    const gl::TextureDesc half{
        .format = GLenum(isColored ? GL_RGBA16F : GL_R16F), .width = frame.width, .height = frame.height};
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
        for (const LitLight& light : lights) {
            if (!light.visibility) continue;
            std::vector<std::pair<std::string, std::string>> defines{{"ACCUMULATE", "1"}, {"COMPOSITE", mode}};
            if (light.colored) defines.emplace_back("COLORED", "1");
            const gl::Program& program = frame.program(stages, std::move(defines));
            program.set("u_scale", float(settings.overlayOpacity) / float(lights.size()));
            (light.colored ? light.colored : light.visibility)->bind(kUnitVisibility);
            frame.drawFullscreen();
        }
    }
    Composed made{frame.targets->take(unshadowed.color->desc(), "color"), unshadowed.edgeColors};
    const gl::Framebuffer target({{made.color.get()}}, {}, "naive composite");
    target.bind();
    gl::apply({});
    std::vector<std::pair<std::string, std::string>> defines{{"COMPOSITE", mode}};
    if (isColored) defines.emplace_back("COLORED", "1");
    frame.program(stages, defines);
    unshadowed.color->bind(6);
    factor->bind(7);
    frame.drawFullscreen();
    if (!made.edgeColors) return made;
    const gl::Framebuffer edges(layersOf(*made.edgeColors), {}, "naive composite of edges");
    edges.bind();
    gl::DrawState multiply;
    multiply.blend = true;
    multiply.blendSource = GL_ZERO;
    multiply.blendDestination = GL_SRC_COLOR;
    gl::apply(multiply);
    const auto samples = sampleDefines(*frame.gbuffer);
    defines.insert(defines.end(), samples.begin(), samples.end());
    frame.program(stages, std::move(defines));
    bindSamples(*frame.gbuffer);
    frame.drawFullscreen();
    return made;
}

}  // namespace ombrage
