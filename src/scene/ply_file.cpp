// SPDX-License-Identifier: MIT
#include "scene/ply_file.h"

#include <array>
#include <cmath>

#include <ombrage/error.h>
#include <ombrage/image.h>

#include "scene/asset_path.h"
#include "scene/model_materials.h"
#include "scene/ply_head.h"
#include "scene/polygon.h"

namespace ombrage {

namespace {
constexpr std::uint64_t kMostVertices = 0xfffffff0u;

/// What a value of 1 is worth for colours: integers span their range.
double colorScale(PlyType type) {
    switch (type) {
        case PlyType::UInt8:
            return 1.0 / 255.0;
        case PlyType::UInt16:
            return 1.0 / 65535.0;
        default:
            return 1.0;
    }
}

class PlyReader {
public:
    PlyReader(const std::string& content, const std::filesystem::path& file)
        : m_name(file.string()), m_head(readPlyHead(content, m_name)), m_data(content, m_head, m_name) {}

    Mesh read() {
        bool hasFaces = false;
        for (const PlyElement& element : m_head.elements) {
            const bool faces = element.name == "face", strips = element.name == "tristrips";
            if (element.name == "vertex")
                readVertices(element);
            else if (faces || strips)
                readFaces(element, strips);
            else
                skip(element);
            hasFaces = hasFaces || ((faces || strips) && element.count > 0);
        }
        if (m_mesh.positions.empty()) throw Error(ErrorCode::Input, "the file has no vertices", "", m_name);
        if (!hasFaces)
            throw Error(ErrorCode::Input, "this is a point cloud: it has vertices, but no faces",
                        "make a surface of it first, for instance with MeshLab", m_name);
        return std::move(m_mesh);
    }

    const std::string& textureFile() const { return m_head.textureFile; }

private:
    [[noreturn]] void fail(const std::string& message, const PlyElement& element, std::uint64_t index) const {
        throw Error(ErrorCode::Input, message, "", m_name + ": " + element.name + " " + std::to_string(index));
    }

    /// The number of values of a list; every one of them takes at least a byte.
    std::size_t listSize(const PlyProperty& property, const PlyElement& element, std::uint64_t index) {
        const double count = m_data.next(property.countType);
        if (!(count >= 0.0) || count != std::floor(count)) fail("a list's length is no whole number", element, index);
        if (count > double(m_data.left())) fail("a list is longer than the file", element, index);
        return std::size_t(count);
    }

    void readList(const PlyProperty& property, const PlyElement& element, std::uint64_t index,
                  std::vector<double>& values) {
        values.resize(listSize(property, element, index));
        for (double& value : values) value = m_data.next(property.type);
    }

    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;
        std::vector<double> ignored;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_data.at(element, i);
            for (const PlyProperty& property : element.properties) {
                if (property.isList)
                    readList(property, element, i, ignored);
                else
                    m_data.next(property.type);
            }
        }
    }

    void readVertices(const PlyElement& element) {
        if (!m_mesh.positions.empty()) fail("a second list of vertices", element, 0);
        // Which property goes where: position, normal, texture coordinates, colour.
        const std::array<int, 11> place{element.find({"x"}),
                                        element.find({"y"}),
                                        element.find({"z"}),
                                        element.find({"nx", "normal_x"}),
                                        element.find({"ny", "normal_y"}),
                                        element.find({"nz", "normal_z"}),
                                        element.find({"u", "s", "texture_u", "texture_s"}),
                                        element.find({"v", "t", "texture_v", "texture_t"}),
                                        element.find({"red", "diffuse_red", "r"}),
                                        element.find({"green", "diffuse_green", "g"}),
                                        element.find({"blue", "diffuse_blue", "b"})};
        const auto has = [&](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i < first + count; ++i)
                if (place[i] < 0 || element.properties[std::size_t(place[i])].isList) return false;
            return true;
        };
        if (!has(0, 3)) fail("vertices without x, y and z", element, 0);
        if (element.count > kMostVertices || element.count > m_data.left())
            fail(std::to_string(element.count) + " vertices do not fit into the file", element, 0);
        const bool normals = has(3, 3), uvs = has(6, 2), colors = has(8, 3);

        std::vector<double> values(element.properties.size()), ignored;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_data.at(element, i);
            for (std::size_t p = 0; p < values.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.isList)
                    readList(property, element, i, ignored);
                else
                    values[p] = m_data.next(property.type);
            }
            const auto value = [&](std::size_t which) { return values[std::size_t(place[which])]; };
            const auto vec3 = [&](std::size_t first) {
                return glm::vec3(float(value(first)), float(value(first + 1)), float(value(first + 2)));
            };
            m_mesh.positions.push_back(vec3(0));
            if (normals) m_mesh.normals.push_back(vec3(3));
            // v counts upwards in PLY files.
            if (uvs) m_mesh.uvs.emplace_back(float(value(6)), 1.0f - float(value(7)));
            if (!colors) continue;
            glm::vec3 color;
            for (int c = 0; c < 3; ++c) {
                const double scale = colorScale(element.properties[std::size_t(place[std::size_t(8 + c)])].type);
                color[c] = linearFromSrgb(float(value(std::size_t(8 + c)) * scale));
            }
            m_mesh.colors.push_back(color);
        }
        m_vertexCount = m_mesh.positions.size();
    }

    void readFaces(const PlyElement& element, bool strips) {
        const int indices = element.find({"vertex_indices", "vertex_index"});
        const int corners = element.find({"texcoord"});
        if (indices < 0 || !element.properties[std::size_t(indices)].isList)
            fail("faces without a list of vertex indices", element, 0);
        if (m_mesh.positions.empty() && element.count > 0) fail("faces before the vertices", element, 0);
        std::vector<double> list, texcoords, ignored;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_data.at(element, i);
            texcoords.clear();
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (!property.isList)
                    m_data.next(property.type);
                else
                    readList(property, element, i,
                             int(p) == indices ? list : (int(p) == corners ? texcoords : ignored));
            }
            if (strips)
                addStrips(list, element, i);
            else
                addFace(list, texcoords, element, i);
        }
    }

    std::uint32_t index(double value, const PlyElement& element, std::uint64_t i) const {
        if (!(value >= 0.0) || value >= double(m_vertexCount))
            fail("a vertex index is not between 0 and " + std::to_string(m_vertexCount - 1), element, i);
        return std::uint32_t(value);
    }

    void addFace(const std::vector<double>& list, const std::vector<double>& texcoords, const PlyElement& element,
                 std::uint64_t i) {
        m_corners.clear();
        m_positions.clear();
        m_triangles.clear();
        for (const double value : list) m_corners.push_back(index(value, element, i));
        // Texture coordinates of corners make vertices of their own; equal ones are joined later.
        if (texcoords.size() == 2 * list.size() && !list.empty()) {
            m_mesh.uvs.resize(m_mesh.positions.size(), glm::vec2(0.0f));
            for (std::size_t c = 0; c < m_corners.size(); ++c)
                m_corners[c] = copyCorner(m_corners[c], &texcoords[2 * c]);
        }
        for (const std::uint32_t corner : m_corners) m_positions.push_back(m_mesh.positions[corner]);
        triangulate(m_positions, m_triangles);
        for (const std::uint32_t corner : m_triangles) m_mesh.indices.push_back(m_corners[corner]);
    }

    std::uint32_t copyCorner(std::uint32_t vertex, const double* texcoord) {
        const auto copy = [vertex](auto& values) {
            if (values.empty()) return;
            const auto value = values[vertex];
            values.push_back(value);
        };
        copy(m_mesh.positions);
        copy(m_mesh.normals);
        copy(m_mesh.colors);
        m_mesh.uvs.emplace_back(float(texcoord[0]), 1.0f - float(texcoord[1]));
        return std::uint32_t(m_mesh.positions.size() - 1);
    }

    /// Strips end at -1; every second triangle of one runs the other way.
    void addStrips(const std::vector<double>& list, const PlyElement& element, std::uint64_t i) {
        std::vector<std::uint32_t> strip;
        for (const double value : list) {
            if (value == -1.0) {
                strip.clear();
                continue;
            }
            strip.push_back(index(value, element, i));
            const std::size_t n = strip.size();
            if (n < 3) continue;
            const std::uint32_t a = strip[n - 3], b = strip[n - 2], c = strip[n - 1];
            const bool odd = n % 2 == 0;
            // Strips are stitched together by triangles of two corners.
            if (a != b && b != c && a != c) m_mesh.indices.insert(m_mesh.indices.end(), {odd ? b : a, odd ? a : b, c});
        }
    }

    std::string m_name;
    PlyHead m_head;
    PlyData m_data;
    Mesh m_mesh;
    std::size_t m_vertexCount = 0;  ///< of the file; corners with coordinates of their own add more
    std::vector<std::uint32_t> m_corners, m_triangles;
    std::vector<glm::vec3> m_positions;
};
}  // namespace

ModelFile readPly(const std::string& content, const std::filesystem::path& file) {
    PlyReader reader(content, file);
    ModelFile model;
    model.meshes.push_back(reader.read());
    Mesh& mesh = model.meshes.back();
    mesh.name = file.stem().string();
    model.parts.push_back({0, glm::dmat4(1.0)});
    // Vertices from before the first face with coordinates of its corners have none.
    if (!mesh.uvs.empty()) mesh.uvs.resize(mesh.positions.size(), glm::vec2(0.0f));
    model.materials.push_back(plainMaterial(mesh.name, !mesh.colors.empty() || !reader.textureFile().empty()));
    if (!reader.textureFile().empty()) {
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        if (const auto picture = findAsset(folder, reader.textureFile()))
            setColorTexture(model, *picture);
        else
            model.warnings.push_back("texture '" + reader.textureFile() + "' " +
                                     whyNotFound(folder, reader.textureFile()));
    }
    return model;
}

}  // namespace ombrage
