// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// 8-bit RGBA, row 0 at the top. `srgb` tells colour maps from data maps (normals, roughness, heights).
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    bool srgb = true;
    std::vector<std::uint8_t> rgba;  ///< width*height*4
};

enum class AlphaMode { Opaque, Mask, Blend };

/// A surface. Texture members are indices into Scene::textures, -1 for none; a texture multiplies its factor.
struct Material {
    std::string name;
    glm::vec3 baseColor{0.8f};      ///< linear
    float alpha = 1.0f;
    glm::vec3 specular{0.04f};      ///< Phong and Blinn-Phong specular colour, linear
    float shininess = 32.0f;        ///< Phong exponent; Blinn-Phong uses 4 times it
    float metallic = 0.0f;
    float roughness = 0.8f;
    glm::vec3 emissive{0.0f};       ///< linear radiance
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;       ///< Mask: a texel below it is a hole
    bool doubleSided = true;        ///< shading only: the G-buffer and the truth always see both sides
    int baseColorTexture = -1;      ///< RGB colour, A opacity
    int normalTexture = -1;         ///< tangent space, +Y up (glTF convention)
    int heightTexture = -1;         ///< R height in [0,1]
    int metallicRoughnessTexture = -1;  ///< G roughness, B metallic
    int emissiveTexture = -1;
    float normalScale = 1.0f;
    float heightScale_uv = 0.02f;   ///< height of 1 in units of texture coordinates
};

/// Triangles of one material in local coordinates. All vertex arrays have the same size; indices come in threes,
/// counter-clockwise seen from outside.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< unit length
    std::vector<glm::vec4> tangents;  ///< xyz unit, to growing u; bitangent = w * cross(normal, tangent), w = +-1,
                                      ///< points up in the texture, to smaller v (as in glTF)
    std::vector<glm::vec2> uvs;       ///< v = 0 is the top row of a texture
    std::vector<glm::vec3> colors;    ///< linear, multiplies the base colour; empty: white
    std::vector<std::uint32_t> indices;
    int material = 0;

    std::size_t triangleCount() const { return indices.size() / 3; }
};

/// One placed mesh.
struct Instance {
    int mesh = 0;
    int model = 0;  ///< index into Scene::models
    glm::dmat4 worldFromLocal{1.0};
};

/// One entry of a scene's "models": a file or a generated object.
struct Model {
    std::string name;
    std::string file;      ///< as written in the scene; empty for generated ones
    bool casts = true;
    bool receives = true;
};

enum class LightType { Sun, Spot, Point, Rect };

/// "sun", "spot", "point", "rect".
const char* lightTypeName(LightType type);

/// Every light has a size; 0 makes its shadows hard.
struct Light {
    std::string name;
    LightType type = LightType::Sun;
    glm::dvec3 position{0.0};           ///< point, spot, rect (its centre)
    glm::vec3 direction{0, -1, 0};      ///< unit, where light travels; sun, spot, rect (its one lit side's normal)
    glm::vec3 color{1.0f};              ///< linear
    float intensity = 1.0f;             ///< sun: lx; point and spot: cd; rect: cd/m2
    float radius_m = 0.0f;              ///< point: sphere; spot: disk facing `direction`
    float angle_rad = 0.0f;             ///< sun: full angular diameter
    glm::vec2 size_m{0.0f};             ///< rect: along lightTangent and lightBitangent
    float range_m = std::numeric_limits<float>::infinity();  ///< no light beyond it
    float inner_rad = 0.35f;            ///< spot: half angle of full light
    float outer_rad = 0.52f;            ///< spot: half angle where light ends
    std::vector<int> excludedModels;    ///< models that neither receive this light nor shade it

    /// True when the light's shadows have penumbrae.
    bool hasSize() const;
};

/// The unit axes of a rect (x along size_m.x) or of a spot's disk: tangent = normalize(cross(a, direction)) with a = +Y,
/// or +X where |direction.y| > 0.999; bitangent = cross(direction, tangent).
glm::vec3 lightTangent(const Light& light);
glm::vec3 lightBitangent(const Light& light);

struct Camera {
    std::string name;
    glm::dvec3 position{0.0, 0.0, 5.0};
    glm::dvec3 target{0.0};
    glm::vec3 up{0, 1, 0};
    float fovY_rad = 0.8726646f;                 ///< vertical
    std::optional<float> orthoHeight_m;          ///< set: orthographic, this high
};

/// "orbit-camera" or "orbit-light" (about the vertical axis through the scene's centre), or "swing": the instances turn
/// about `axis` through `pivot`, as a limb does at its joint, by amplitude_rad * sin(2 pi (t / period_s + phase)) about the
/// middle of the swing. The scene as loaded is the pose at time 0; pivot and axis belong to it. Animations are carried
/// out in order, each after those before it, so a forearm's swing stands before that of the whole arm, which moves the
/// forearm too.
struct Animation {
    std::string type;
    std::string light;              ///< orbit-light
    double period_s = 12;
    std::vector<int> instances;     ///< swing
    glm::dvec3 pivot{0.0};          ///< swing; world
    glm::dvec3 axis{1.0, 0.0, 0.0}; ///< swing; world, unit
    double amplitude_rad = 0;       ///< swing
    double phase = 0;               ///< swing: share of a period that it is ahead
};

struct Bounds {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
    bool empty() const { return !(lower.x <= upper.x); }
    glm::dvec3 center() const { return (lower + upper) * 0.5; }
    double diagonal() const { return empty() ? 0.0 : glm::length(upper - lower); }
};

/// A scene: what is there, what lights it, who looks. Metres, right-handed, Y up. A plain value; loaders make it valid
/// (indices in range, at least one camera and one light, unit directions).
struct Scene {
    std::string name;
    std::string description;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Model> models;
    std::vector<Instance> instances;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<Animation> animations;
    std::vector<std::string> techniques;     ///< ids that the scene is meant for; empty: all
    float ambient = 0.2f;                    ///< radiance of the surroundings
    float aoRadius_m = 0.0f;                 ///< radius of the ao truth T1; loaders set 5 % of the diagonal by default
    std::vector<std::string> warnings;       ///< what the loader dropped or repaired

    Bounds bounds() const;                   ///< of all finite vertices
    std::size_t triangleCount() const;       ///< over all instances

    /// Index by name; an empty name is the first. @throws Error(Usage) with a suggestion.
    int cameraIndex(const std::string& cameraName) const;
    int lightIndex(const std::string& lightName) const;
};

/// 16 hexadecimal digits over everything that changes a picture or the truth (not names, descriptions or warnings).
std::string contentHash(const Scene& scene);

/// Cameras, lights and instances moved to the given time by the scene's animations.
void animate(Scene& scene, double time_s);

struct SceneOptions {
    bool allowOutside = false;               ///< relative model paths may leave the scene file's folder
    bool ground = false;                     ///< add a floor under a model file
    std::optional<glm::dvec3> eye;           ///< replaces the camera's position
    std::optional<glm::dvec3> target;        ///< replaces the camera's target
    std::string importer;                    ///< the program that reads files under guard; empty: $OMBRAGE_IMPORT, else
                                             ///< ombrage-import where it is found; "off": read them in this process
    std::string cache;                       ///< folder of scenes loaded before; empty: $OMBRAGE_CACHE, else the user's
                                             ///< cache folder; "off": none
    std::function<bool()> cancelled;         ///< asked while a guarded import runs; true ends it
};

/// Opens a built-in scene by name, a scene file (.json) or a model file (framed and lit by default: design section 5).
/// Files are read by another process with limits, so that a damaged one cannot take this one along, and what was read is
/// kept in a cache that every change of a file invalidates.
/// @throws Error(Usage) for an unknown name, Error(Input) naming file, line and JSON path (also when the reader crashed,
/// ran out of time or out of memory), Error(Interrupted) when cancelled.
Scene loadScene(const std::string& nameOrFile, const SceneOptions& options = {});

struct BuiltinScene {
    std::string name;
    std::string description;   ///< one sentence: the failure that it shows
};

/// All built-in scenes, in a fixed order.
const std::vector<BuiltinScene>& builtinScenes();

}  // namespace ombrage
