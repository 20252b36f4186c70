// SPDX-License-Identifier: MIT
#include "techniques/shared/gpu_triangles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage {

namespace {

constexpr GLuint kTriangleStorage = 4, kSlotStorage = 5, kAlphaStorage = 6;
constexpr std::size_t kRecordWords = 8;  // uv of three corners, first word of the bits, size

/// Holes of masked materials: a bit per texel that is below the cut-off, rows from the top, padded to words per
/// material.
class HoleBits {
public:
    explicit HoleBits(const Scene& scene) : m_scene(scene) {}

    /// First word of the material's bits, counted from the first bit field, and its size in texels.
    struct Field {
        std::uint32_t firstWord = 0, width = 1, height = 1;
    };
    Field fieldOf(int index) {
        const auto known = m_fields.find(index);
        if (known != m_fields.end()) return known->second;
        const Material& material = m_scene.materials[std::size_t(index)];
        Field field{std::uint32_t(m_words.size())};
        const Texture* texture =
            material.baseColorTexture >= 0 ? &m_scene.textures[std::size_t(material.baseColorTexture)] : nullptr;
        if (texture) {
            field.width = std::uint32_t(texture->width);
            field.height = std::uint32_t(texture->height);
        }
        const std::size_t texels = std::size_t(field.width) * field.height;
        m_words.resize(m_words.size() + (texels + 31) / 32, 0u);
        for (std::size_t i = 0; i < texels; ++i) {
            const float opacity = texture ? float(texture->rgba[4 * i + 3]) / 255.0f : 1.0f;
            if (material.alpha * opacity < material.alphaCutoff) m_words[field.firstWord + i / 32] |= 1u << (i % 32);
        }
        return m_fields.emplace(index, field).first->second;
    }

    const std::vector<std::uint32_t>& words() const { return m_words; }

private:
    const Scene& m_scene;
    std::map<int, Field> m_fields;
    std::vector<std::uint32_t> m_words;
};

}  // namespace

void checkStorageSize(std::size_t bytes) {
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if (bytes > std::size_t(largest))
        throw Error(ErrorCode::Environment,
                    fmt::format("the scene's ray-tracing data takes {} bytes, and this driver's storage blocks hold {}",
                                bytes, largest),
                    "Use a smaller scene or another technique.");
}

std::vector<std::uint32_t> castingTriangles(const GpuScene& scene) {
    const FlatScene& flat = scene.flat();
    std::vector<std::uint32_t> casting;
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
        if (flat.instances[flat.triangleInstance[t]].casts) casting.push_back(t);
    return casting;
}

std::vector<std::uint32_t> allTriangles(const GpuScene& scene) {
    std::vector<std::uint32_t> all(scene.flat().triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

GpuTriangles::GpuTriangles(const GpuScene& scene, std::vector<std::uint32_t> order) {
    const FlatScene& flat = scene.flat();
    for (const glm::vec3& p : flat.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(p[axis])) m_extent_m = std::max(m_extent_m, std::abs(p[axis]));

    // Those asked for come first, then what no ray hits but a ray may start from.
    std::vector<bool> held(flat.triangles.size(), false);
    for (const std::uint32_t t : order) held[t] = true;
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
        if (!held[t]) order.push_back(t);

    HoleBits holes(scene.scene());
    std::vector<glm::vec4> corners;
    corners.reserve(order.size() * 3);
    std::vector<std::uint32_t> slots(order.size()), alpha;
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
        const std::uint32_t t = order[slot], instance = flat.triangleInstance[t];
        const glm::uvec3 corner = flat.triangles[t];
        slots[t] = std::uint32_t(slot);

        // A record for triangles with holes; counted from 1, for 0 says that there is none.
        std::uint32_t record = 0;
        const int material = flat.instances[instance].material;
        if (scene.scene().materials[std::size_t(material)].alphaMode == AlphaMode::Mask) {
            const HoleBits::Field field = holes.fieldOf(material);
            for (int k = 0; k < 3; ++k)
                for (int axis = 0; axis < 2; ++axis)
                    alpha.push_back(std::bit_cast<std::uint32_t>(flat.uvs[corner[k]][axis]));
            alpha.push_back(field.firstWord);
            alpha.push_back(field.width | field.height << 16);
            record = std::uint32_t(alpha.size() / kRecordWords);
        }
        const std::uint32_t words[3] = {t, instance, record};
        for (int k = 0; k < 3; ++k) corners.emplace_back(flat.positions[corner[k]], std::bit_cast<float>(words[k]));
    }

    // The bits follow the records in one buffer.
    for (std::size_t i = 0; i < alpha.size(); i += kRecordWords) alpha[i + 6] += std::uint32_t(alpha.size());
    alpha.insert(alpha.end(), holes.words().begin(), holes.words().end());
    for (const std::size_t bytes : {corners.size() * sizeof(glm::vec4), alpha.size() * sizeof(std::uint32_t)})
        checkStorageSize(bytes);
    m_triangles = gl::Buffer::from(corners, "ray-tracing triangles");
    m_slots = gl::Buffer::from(slots, "ray-tracing slots");
    m_alpha = gl::Buffer::from(alpha, "ray-tracing holes");
}

void GpuTriangles::bind(const gl::Program& program) const {
    m_triangles.bindStorage(kTriangleStorage);
    m_slots.bindStorage(kSlotStorage);
    m_alpha.bindStorage(kAlphaStorage);
    program.set("u_rayExtent_m", m_extent_m);
}

gl::Buffer excludedInstances(const GpuScene& scene, const std::vector<int>& excludedModels) {
    std::vector<std::uint32_t> flags;
    for (const FlatInstance& instance : scene.flat().instances)
        flags.push_back(
            std::find(excludedModels.begin(), excludedModels.end(), instance.model) != excludedModels.end() ? 1u : 0u);
    return gl::Buffer::from(flags, "ray-tracing exclusions");
}

gl::Buffer instanceModels(const GpuScene& scene) {
    std::vector<std::uint32_t> models;
    for (const FlatInstance& instance : scene.flat().instances) models.push_back(std::uint32_t(instance.model));
    return gl::Buffer::from(models, "ray-tracing models");
}

}  // namespace ombrage
