// SPDX-License-Identifier: MIT
#include "techniques/shared/moment_map.h"

#include <algorithm>
#include <cmath>

#include "render/frame_context.h"

namespace ombrage {

namespace {

constexpr GLuint kUnitMoments = kFirstFreeUnit;

/// Mip levels of a cube's faces: what lies beside a face takes part in its coarse texels, so that the overlap of the
/// faces must be as wide.
constexpr int kFaceLevels = 4;

/// Variance of the bilinear filter, in texels squared, over all places between texels.
constexpr float kBilinearVariance = 1.0f / 6.0f;

/// Distances along the axes of a light's views between which everything lies that it can meet.
glm::vec2 depthRange(const FrameContext& frame, const LightFrame& light, const LightViews& views) {
    const LightView& first = views.views.front();
    if (!views.perspective) return {first.near_m, first.far_m};
    const Bounds& bounds = frame.gpuScene->bounds();
    const glm::vec3 lower(bounds.lower - frame.gpuScene->origin()), upper(bounds.upper - frame.gpuScene->origin());
    float farthest = 0;
    for (int c = 0; c < 8; ++c) {
        const glm::vec3 corner(c & 1 ? upper.x : lower.x, c & 2 ? upper.y : lower.y, c & 4 ? upper.z : lower.z);
        for (const LightView& view : views.views)
            farthest = std::max(farthest, glm::dot(corner - view.origin, view.forward));
    }
    if (light.light->range_m > 0) farthest = std::min(farthest, light.light->range_m);
    return {first.near_m, std::max(farthest * 1.001f, first.near_m * 1.01f)};
}

/// Sums of as many channels as the format has, in full precision.
GLenum formatBetween(GLenum format) {
    switch (format) {
        case GL_R16F:
        case GL_R32F:
            return GL_R32F;
        case GL_RG16:
        case GL_RG16F:
        case GL_RG32F:
            return GL_RG32F;
        default:
            return GL_RGBA32F;
    }
}

}  // namespace

void MomentMap::reset() {
    m_depth.reset();
    m_made.reset();
}

void MomentMap::update(FrameContext& frame, Technique& technique, const LightFrame& light,
                       const MomentMapParams& params, const Statistics& statistics) {
    updateDepth(frame, light, params);
    updateMoments(frame, technique, params, statistics);
}

bool MomentMap::updateDepth(FrameContext& frame, const LightFrame& light, const MomentMapParams& params) {
    LightDepth::Options options = params.depthOptions();
    m_resolution = params.resolution;
    m_reach_texels = 0.5f * float(params.kernel_texels);
    const int coarsest = params.mipmaps ? 1 << (kFaceLevels - 1) : 1;
    options.margin_texels = int(std::ceil(m_reach_texels)) + coarsest;
    const std::uint64_t before = m_depth.drawn();
    m_depth.update(frame, light, options);
    m_range_m = depthRange(frame, light, m_depth.views());
    return m_depth.drawn() != before;
}

void MomentMap::makeTexture(const MomentMapParams& params, const Statistics& statistics) {
    const int views = int(m_depth.views().views.size()), layers = views * statistics.sheets;
    gl::TextureDesc desc{.kind = layers > 1 ? gl::TextureKind::Array2D : gl::TextureKind::Tex2D,
                         .format = statistics.format,
                         .width = params.resolution,
                         .height = params.resolution,
                         .layers = layers,
                         .levels = params.mipmaps ? 0 : 1};
    if (params.mipmaps && views > 1) desc.levels = std::min(kFaceLevels, gl::levelCount(desc));
    if (!m_moments || !(m_moments.desc() == desc)) {
        m_moments = gl::Texture(desc, "moments");
        m_moments.setFilter(params.mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
        m_made.reset();
    }
}

void MomentMap::updateMoments(FrameContext& frame, Technique& technique, const MomentMapParams& params,
                              const Statistics& statistics) {
    m_statistics = statistics;
    makeTexture(params, statistics);
    const std::vector<float> weights = momentBlurWeights(params.blur, params.kernel_texels);
    m_variance_texels = momentBlurVariance(weights) + kBilinearVariance;
    Made made{m_depth.drawn(), m_range_m,       params.blur,    params.kernel_texels,
              params.mipmaps,  statistics.path, statistics.read};
    if (m_made == made) return;
    m_made = std::move(made);
    m_depth.setPlain();
    drawMoments(frame, technique, statistics);
    if (weights.size() > 1) drawBlur(frame, technique, statistics, weights);
    if (m_moments.levels() > 1) drawMipmaps(frame, technique, statistics);
}

std::vector<std::pair<std::string, std::string>> MomentMap::defines(int sheets) const {
    auto defines = m_depth.defines();
    defines.emplace_back("MOMENT_SHEETS", std::to_string(sheets));
    return defines;
}

void MomentMap::setUniforms(const gl::Program& program) const {
    m_depth.views().setUniforms(program);
    program.set("u_momentRange", glm::vec4(0.5f * (m_range_m.x + m_range_m.y), 2.0f / (m_range_m.y - m_range_m.x),
                                           m_variance_texels, m_reach_texels));
}

void MomentMap::setUniforms(const gl::Program& program, const Statistics& statistics) const {
    setUniforms(program);
    if (statistics.bind) statistics.bind(program);
}

void MomentMap::drawMoments(FrameContext& frame, Technique& technique, const Statistics& statistics) {
    const auto pass = frame.pass("moments");
    gl::apply({});
    m_depth.map().bind(kUnitMoments);
    const gl::Program& program = this->program(frame, technique, statistics, "shared/moment_resolve.frag", {});
    const bool isArray = m_moments.desc().kind == gl::TextureKind::Array2D;
    for (int layer = 0; layer < m_moments.desc().layers; ++layer) {
        const gl::Framebuffer target({{&m_moments, 0, isArray ? layer : 0}}, {}, "moments");
        target.bind();
        program.set("u_view", layer / statistics.sheets);
        program.set("u_sheet", layer % statistics.sheets);
        frame.drawFullscreen();
    }
}

void MomentMap::drawBlur(FrameContext& frame, Technique& technique, const Statistics& statistics,
                         const std::vector<float>& weights) {
    const auto pass = frame.pass("blur");
    gl::apply({});
    const auto between =
        frame.targets->take({.format = formatBetween(statistics.format), .width = m_resolution, .height = m_resolution},
                            "moments between blurs");
    std::vector<glm::vec2> uniformWeights;
    for (float weight : weights) uniformWeights.emplace_back(weight);
    const bool isArray = m_moments.desc().kind == gl::TextureKind::Array2D;
    const auto blur = [&](bool alongX, const gl::Texture& source, const gl::Texture& target, int layer) {
        std::vector<std::pair<std::string, std::string>> given = {{"ALONG_X", alongX ? "1" : "0"},
                                                                  {"RADIUS", std::to_string(weights.size() - 1)}};
        if (source.desc().kind == gl::TextureKind::Array2D) given.emplace_back("SOURCE_ARRAY", "1");
        const gl::Program& program =
            this->program(frame, technique, statistics, "shared/moment_blur.frag", std::move(given));
        program.set("u_weights", uniformWeights.data(), int(uniformWeights.size()));
        program.set("u_layer", layer);
        const gl::Framebuffer framebuffer({{&target, 0, &target == &m_moments && isArray ? layer : 0}}, {}, "moments");
        framebuffer.bind();
        source.bind(kUnitMoments);
        frame.drawFullscreen();
    };
    for (int layer = 0; layer < m_moments.desc().layers; ++layer) {
        blur(true, m_moments, *between, layer);
        blur(false, *between, m_moments, layer);
    }
}

void MomentMap::drawMipmaps(FrameContext& frame, Technique& technique, const Statistics& statistics) {
    const auto pass = frame.pass("mipmaps");
    if (!statistics.logarithmic) {
        m_moments.generateMipmap();
        return;
    }
    gl::apply({});
    const bool isArray = m_moments.desc().kind == gl::TextureKind::Array2D;
    std::vector<std::pair<std::string, std::string>> given;
    if (isArray) given.emplace_back("SOURCE_ARRAY", "1");
    const gl::Program& program =
        this->program(frame, technique, statistics, "shared/moment_mip.frag", std::move(given));
    m_moments.bind(kUnitMoments);
    for (int level = 1; level < m_moments.levels(); ++level) {
        m_moments.setLevels(level - 1, level - 1);
        for (int layer = 0; layer < m_moments.desc().layers; ++layer) {
            const gl::Framebuffer target({{&m_moments, level, isArray ? layer : 0}}, {}, "moments");
            target.bind();
            program.set("u_layer", layer);
            frame.drawFullscreen();
        }
    }
    m_moments.setLevels(0, m_moments.levels() - 1);
}

const gl::Program& MomentMap::program(FrameContext& frame, Technique& technique, const Statistics& statistics,
                                      const char* fragmentPath,
                                      std::vector<std::pair<std::string, std::string>> given) const {
    for (auto& define : defines(statistics.sheets)) given.push_back(std::move(define));
    const gl::Program& program = frame.program(
        technique, {{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, fragmentPath}},
        std::move(given),
        {{"shared/moments_of", "#include \"" + statistics.path + "\"\n"}, {"ombrage/per_pass_lookup.glsl", perPass()}});
    setUniforms(program, statistics);
    return program;
}

std::string MomentMap::perPass() {
    return "#include \"shared/moment_range.glsl\"\nvoid passLookup() { passMomentRange(); }\n";
}

ShadowLookup MomentMap::lookup(const std::string& path) const {
    return {path, defines(m_statistics.sheets),
            [this](const gl::Program& program) {
                setUniforms(program, m_statistics);
                m_moments.bind(kUnitMoments);
            },
            perPass()};
}

void MomentMap::exposeTo(FrameContext& frame) const {
    if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
    if (frame.wants("moments")) frame.expose("moments", m_moments, ShowAs::Value);
}

TexelFootprint MomentMap::footprint() const {
    TexelFootprint footprint = m_depth.views().footprint(m_resolution);
    footprint.kernelRadius_texels = double(m_reach_texels) + 0.5;
    return footprint;
}

ShadowRange MomentMap::shadowRange(const FrameContext& frame) const {
    return m_depth.views().range(frame.gpuScene->origin());
}

std::uint64_t MomentMap::gpuBytes() const {
    return m_depth.gpuBytes() + (m_moments ? gl::byteSize(m_moments.desc()) : 0);
}

}  // namespace ombrage
