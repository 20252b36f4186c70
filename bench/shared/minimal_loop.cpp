// SPDX-License-Identifier: MIT
#include "shared/minimal_loop.h"

#include <chrono>
#include <stdexcept>
#include <vector>

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace ombrage::bench {

namespace {

const char* const kSceneVertex = R"(#version 450
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 0) uniform mat4 u_clipFromWorld;
out vec3 v_normal;
void main() { v_normal = a_normal; gl_Position = u_clipFromWorld * vec4(a_position, 1.0); })";

const char* const kSceneFragment = R"(#version 450
layout(location = 1) uniform vec3 u_albedo;
in vec3 v_normal;
layout(location = 0) out vec4 o_albedo;
layout(location = 1) out vec4 o_normal;
void main() { o_albedo = vec4(u_albedo, 1.0); o_normal = vec4(normalize(v_normal) * 0.5 + 0.5, 1.0); })";

const char* const kDepthVertex = R"(#version 450
layout(location = 0) in vec3 a_position;
layout(location = 0) uniform mat4 u_clipFromWorld;
void main() { gl_Position = u_clipFromWorld * vec4(a_position, 1.0); })";

const char* const kDepthFragment = "#version 450\nvoid main() {}";

const char* const kScreenVertex = R"(#version 450
out vec2 v_uv;
void main() {
    v_uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(v_uv * 2.0 - 1.0, 0.0, 1.0);
})";

const char* const kVisibilityFragment = R"(#version 450
layout(binding = 0) uniform sampler2D t_depth;
layout(binding = 3) uniform sampler2DShadow t_map;
layout(location = 0) uniform mat4 u_lightFromClip;
in vec2 v_uv;
layout(location = 0) out float o_visibility;
void main() {
    float depth = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r;
    vec4 p = u_lightFromClip * vec4(vec3(v_uv, depth) * 2.0 - 1.0, 1.0);
    o_visibility = depth == 1.0 ? 1.0 : texture(t_map, p.xyz / p.w * 0.5 + 0.5 - vec3(0.0, 0.0, 0.002));
})";

const char* const kLightFragment = R"(#version 450
layout(binding = 0) uniform sampler2D t_depth;
layout(binding = 1) uniform sampler2D t_albedo;
layout(binding = 2) uniform sampler2D t_normal;
layout(binding = 4) uniform sampler2D t_visibility;
layout(location = 0) uniform vec3 u_toLight;
layout(location = 1) uniform vec3 u_irradiance;
layout(location = 2) uniform float u_ambient;
layout(location = 3) uniform bool u_shadows;
layout(location = 0) out vec4 o_color;
void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    if (texelFetch(t_depth, px, 0).r == 1.0) { o_color = vec4(vec3(u_ambient), 1.0); return; }
    vec3 n = texelFetch(t_normal, px, 0).xyz * 2.0 - 1.0;
    float seen = u_shadows ? texelFetch(t_visibility, px, 0).r : 1.0;
    o_color = vec4(texelFetch(t_albedo, px, 0).rgb * (u_ambient + u_irradiance * max(dot(n, u_toLight), 0.0) * seen), 1.0);
})";

GLuint makeProgram(const char* vertex, const char* fragment) {
    const GLuint program = glCreateProgram();
    for (const auto& [type, text] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(GLenum(type));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("the minimal loop's shaders do not link");
    return program;
}

GLuint makeTexture(GLenum format, int width, int height) {
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, format, width, height);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

GLuint makeFramebuffer(const std::vector<GLuint>& colors, GLuint depth) {
    GLuint framebuffer = 0;
    glCreateFramebuffers(1, &framebuffer);
    std::vector<GLenum> buffers;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        buffers.push_back(GLenum(GL_COLOR_ATTACHMENT0 + i));
        glNamedFramebufferTexture(framebuffer, buffers.back(), colors[i], 0);
    }
    glNamedFramebufferDrawBuffers(framebuffer, GLsizei(buffers.size()), buffers.data());
    if (depth) glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);
    return framebuffer;
}

struct Vertex {
    glm::vec3 position, normal;
};

struct Draw {
    glm::vec3 albedo;
    GLsizei count;
    std::size_t first;
    bool casts;
};

}  // namespace

struct MinimalLoop::Impl {
    std::unique_ptr<gl::Context> context;
    int width, height, mapSize;
    std::vector<Draw> draws;
    GLuint vertexArray = 0, depth = 0, albedo = 0, normal = 0, map = 0, visibility = 0, color = 0;
    GLuint gbufferTarget = 0, mapTarget = 0, visibilityTarget = 0, colorTarget = 0;
    GLuint sceneProgram = 0, depthProgram = 0, visibilityProgram = 0, lightProgram = 0;
    glm::mat4 clipFromWorld, lightFromWorld;
    glm::vec3 toLight, irradiance;
    float ambient;

    void upload(const Scene& scene);
    void makeTargets();
    void drawScene(bool castersOnly);
};

void MinimalLoop::Impl::upload(const Scene& scene) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        const auto base = std::uint32_t(vertices.size());
        const glm::dmat3 normalFromLocal = glm::transpose(glm::inverse(glm::dmat3(instance.worldFromLocal)));
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            vertices.push_back({glm::vec3(instance.worldFromLocal * glm::dvec4(mesh.positions[v], 1.0)),
                                glm::vec3(normalFromLocal * glm::dvec3(mesh.normals[v]))});
        draws.push_back({scene.materials[std::size_t(mesh.material)].baseColor, GLsizei(mesh.indices.size()),
                         indices.size(), scene.models[std::size_t(instance.model)].casts});
        for (std::uint32_t index : mesh.indices) indices.push_back(base + index);
    }
    GLuint buffers[2];
    glCreateBuffers(2, buffers);
    glNamedBufferStorage(buffers[0], GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(), 0);
    glNamedBufferStorage(buffers[1], GLsizeiptr(indices.size() * sizeof(std::uint32_t)), indices.data(), 0);
    glCreateVertexArrays(1, &vertexArray);
    glVertexArrayVertexBuffer(vertexArray, 0, buffers[0], 0, sizeof(Vertex));
    glVertexArrayElementBuffer(vertexArray, buffers[1]);
    for (GLuint attribute : {0u, 1u}) {
        glEnableVertexArrayAttrib(vertexArray, attribute);
        glVertexArrayAttribFormat(vertexArray, attribute, 3, GL_FLOAT, GL_FALSE, attribute * GLuint(sizeof(glm::vec3)));
        glVertexArrayAttribBinding(vertexArray, attribute, 0);
    }
}

void MinimalLoop::Impl::makeTargets() {
    depth = makeTexture(GL_DEPTH_COMPONENT32F, width, height);
    albedo = makeTexture(GL_RGBA8, width, height);
    normal = makeTexture(GL_RGB10_A2, width, height);
    visibility = makeTexture(GL_R8, width, height);
    color = makeTexture(GL_RGBA16F, width, height);
    map = makeTexture(GL_DEPTH_COMPONENT32F, mapSize, mapSize);
    glTextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gbufferTarget = makeFramebuffer({albedo, normal}, depth);
    mapTarget = makeFramebuffer({}, map);
    visibilityTarget = makeFramebuffer({visibility}, 0);
    colorTarget = makeFramebuffer({color}, 0);
    sceneProgram = makeProgram(kSceneVertex, kSceneFragment);
    depthProgram = makeProgram(kDepthVertex, kDepthFragment);
    visibilityProgram = makeProgram(kScreenVertex, kVisibilityFragment);
    lightProgram = makeProgram(kScreenVertex, kLightFragment);
}

void MinimalLoop::Impl::drawScene(bool castersOnly) {
    for (const Draw& draw : draws) {
        if (castersOnly && !draw.casts) continue;
        if (!castersOnly) glUniform3fv(1, 1, glm::value_ptr(draw.albedo));
        glDrawElements(GL_TRIANGLES, draw.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(draw.first * sizeof(std::uint32_t)));
    }
}

MinimalLoop::MinimalLoop(const Scene& scene, int width, int height, int mapSize, const std::string& device)
    : m_impl(std::make_unique<Impl>()) {
    m_impl->context = gl::Context::createHeadless({device, false});
    m_impl->width = width;
    m_impl->height = height;
    m_impl->mapSize = mapSize;
    m_impl->upload(scene);
    m_impl->makeTargets();

    // The camera, and an orthographic view along the sun around the casters' bounding sphere.
    const Camera& camera = scene.cameras.front();
    const Bounds bounds = scene.bounds();
    const double far_m = glm::length(camera.position - bounds.center()) + bounds.diagonal();
    m_impl->clipFromWorld =
        glm::mat4(glm::perspective(double(camera.fovY_rad), double(width) / height, far_m / 1000, far_m) *
                  glm::lookAt(camera.position, camera.target, glm::dvec3(camera.up)));
    const Light& sun = scene.lights.front();
    const glm::dvec3 toLight = -glm::dvec3(sun.direction);
    const double radius = bounds.diagonal() / 2;
    const glm::dvec3 up = std::abs(toLight.y) > 0.999 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    m_impl->lightFromWorld = glm::mat4(glm::ortho(-radius, radius, -radius, radius, 0.0, 2 * radius) *
                                       glm::lookAt(bounds.center() + toLight * radius, bounds.center(), up));
    m_impl->toLight = glm::vec3(toLight);
    m_impl->irradiance = sun.color * sun.intensity / 3.14159265f;
    m_impl->ambient = scene.ambient;
}

MinimalLoop::~MinimalLoop() {
    m_impl->context->makeCurrent();
}

double MinimalLoop::frame(bool shadows) {
    Impl& m = *m_impl;
    m.context->makeCurrent();
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    glBindVertexArray(m.vertexArray);
    glEnable(GL_DEPTH_TEST);
    glViewport(0, 0, m.width, m.height);
    glBindFramebuffer(GL_FRAMEBUFFER, m.gbufferTarget);
    glClear(GL_DEPTH_BUFFER_BIT);
    glUseProgram(m.sceneProgram);
    glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(m.clipFromWorld));
    m.drawScene(false);
    glBindTextureUnit(0, m.depth);
    if (shadows) {
        glViewport(0, 0, m.mapSize, m.mapSize);
        glBindFramebuffer(GL_FRAMEBUFFER, m.mapTarget);
        glClear(GL_DEPTH_BUFFER_BIT);
        glUseProgram(m.depthProgram);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(m.lightFromWorld));
        m.drawScene(true);

        glDisable(GL_DEPTH_TEST);
        glViewport(0, 0, m.width, m.height);
        glBindFramebuffer(GL_FRAMEBUFFER, m.visibilityTarget);
        glUseProgram(m.visibilityProgram);
        const glm::mat4 lightFromClip = m.lightFromWorld * glm::inverse(m.clipFromWorld);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(lightFromClip));
        glBindTextureUnit(3, m.map);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, m.colorTarget);
    glUseProgram(m.lightProgram);
    glUniform3fv(0, 1, glm::value_ptr(m.toLight));
    glUniform3fv(1, 1, glm::value_ptr(m.irradiance));
    glUniform1f(2, m.ambient);
    glUniform1i(3, shadows);
    glBindTextureUnit(1, m.albedo);
    glBindTextureUnit(2, m.normal);
    glBindTextureUnit(4, m.visibility);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Image MinimalLoop::picture() const {
    m_impl->context->makeCurrent();
    Image image = Image::rgb(m_impl->width, m_impl->height);
    std::vector<float> pixels(image.pixelCount() * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(m_impl->color, 0, GL_RGB, GL_FLOAT, GLsizei(pixels.size() * sizeof(float)), pixels.data());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < 3; ++c)
                image.at(c, x, image.height() - 1 - y) = pixels[std::size_t((y * image.width() + x) * 3 + c)];
    return image;
}

}  // namespace ombrage::bench
