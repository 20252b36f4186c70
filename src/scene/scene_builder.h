// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ombrage/scene.h>

namespace ombrage {

/// Puts a generated scene together. Every object is a model of its own, so that it can be excluded from a light.
class SceneBuilder {
public:
    explicit SceneBuilder(std::string name);

    /// Adds a model of one mesh in one colour (given in sRGB, as a designer picks it), `turn_rad` about the vertical
    /// axis through `position`. Tangents are made here.
    SceneBuilder& object(const std::string& name, Mesh mesh, const glm::vec3& color_srgb,
                         const glm::dvec3& position = glm::dvec3(0.0), double turn_deg = 0.0);

    /// The same with a material of any kind (its name is set), placed by any invertible matrix.
    SceneBuilder& object(const std::string& name, Mesh mesh, Material material, const glm::dmat4& worldFromLocal);
    /// Adds a mesh to the last object's model.
    SceneBuilder& part(const std::string& name, Mesh mesh, const glm::vec3& color_srgb,
                       const glm::dmat4& worldFromLocal = glm::dmat4(1.0));
    /// Places the last mesh once more, as a model of its own.
    SceneBuilder& again(const std::string& name, const glm::dmat4& worldFromLocal);

    /// Keeps a texture; returns its index for materials.
    int texture(Texture texture);

    /// The last `count` instances swing together about where they stand, by `amplitude_deg` at a joint given in world
    /// coordinates; they are put into the pose at time 0, `phase` of a period after the middle. Joints of what they
    /// carry come first.
    SceneBuilder& swing(std::size_t count, const glm::dvec3& pivot, const glm::dvec3& axis, double amplitude_deg,
                        double period_s, double phase);

    SceneBuilder& sun(const std::string& name, const glm::vec3& direction, float intensity_lx);
    SceneBuilder& point(const std::string& name, const glm::dvec3& position, float intensity_cd);
    SceneBuilder& spot(const std::string& name, const glm::dvec3& position, const glm::vec3& direction, float inner_deg,
                       float outer_deg, float intensity_cd);
    SceneBuilder& camera(const std::string& name, const glm::dvec3& position, const glm::dvec3& target,
                         float fov_deg = 50.0f);

    /// The finished scene; the builder is empty afterwards.
    Scene finish(float aoRadius_m);

private:
    void place(const std::string& name, Mesh mesh, Material material, const glm::dmat4& worldFromLocal);

    Scene m_scene;
};

/// A matte material of one colour, given in sRGB.
Material paint(const glm::vec3& color_srgb);

}  // namespace ombrage
