// SPDX-License-Identifier: MIT
#include "scene/obj_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>

#include "core/strings.h"
#include "scene/asset_path.h"
#include "scene/model_materials.h"
#include "scene/number_text.h"
#include "scene/polygon.h"
#include "scene/text_lines.h"

namespace ombrage {

namespace {
constexpr const char* kNoMaterial = "DefaultMaterial";
constexpr std::uint32_t kNone = 0xffffffffu;

/// Statements without meaning here: names, smoothing groups (edges are told by angle), display and search hints.
bool isIgnored(std::string_view key) {
    constexpr std::string_view kIgnored[] = {
        "o",      "g",      "s",     "mg",         "vp",        "cstype", "deg",   "bmat",     "step",     "parm",
        "trim",   "hole",   "scrv",  "sp",         "end",       "con",    "bevel", "c_interp", "d_interp", "lod",
        "maplib", "usemap", "ctech", "shadow_obj", "trace_obj", "stech",  "call",  "csh"};
    return std::find(std::begin(kIgnored), std::end(kIgnored), key) != std::end(kIgnored);
}

/// What was passed over, and where it stood first.
struct PassedOver {
    std::size_t count = 0;
    int firstLine = 0;
    std::string first;
    void add(int line, std::string_view what) {
        if (count++ > 0) return;
        firstLine = line;
        first = what.substr(0, 40);
    }
};

class ObjReader {
public:
    ObjReader(const std::string& content, const std::filesystem::path& file)
        : m_lines(content), m_name(file.string()), m_fileName(file.filename().string()) {}

    void read() {
        std::string_view line;
        while (m_lines.next(line)) {
            std::size_t position = 0;
            const std::string_view key = takeWord(line, position);
            if (!key.empty() && key[0] != '#') statement(key, line.substr(position));
        }
    }

    ModelFile takeModel() {
        ModelFile model;
        model.meshes = std::move(m_meshes);
        for (std::size_t i = 0; i < model.meshes.size(); ++i) model.parts.push_back({int(i), glm::dmat4(1.0)});
        warn(model, m_points, "points, lines and curves");
        warn(model, m_thinFaces, "faces of fewer than 3 corners");
        warn(model, m_unknown, "statements that no OBJ file has");
        return model;
    }

    const std::vector<std::string>& materialNames() const { return m_materialNames; }
    const std::vector<std::string>& libraries() const { return m_libraries; }
    bool hasColors() const { return m_hasColors; }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Error(ErrorCode::Input, message, "", m_name + ":" + std::to_string(m_lines.number()));
    }

    void warn(ModelFile& model, const PassedOver& passed, const char* what) const {
        if (passed.count > 0)
            model.warnings.push_back(fmt::format("{} {} are left out, the first in {}:{}: '{}'", passed.count, what,
                                                 m_fileName, passed.firstLine, passed.first));
    }

    void statement(std::string_view key, std::string_view rest) {
        if (key == "v")
            readVertex(rest);
        else if (key == "vt")
            readTexcoord(rest);
        else if (key == "vn")
            readNormal(rest);
        else if (key == "f" || key == "fo")
            readFace(rest);
        else if (key == "usemtl")
            m_material = trim(rest);
        else if (key == "mtllib")
            readLibrary(rest);
        else if (key == "l" || key == "p" || key == "curv" || key == "curv2" || key == "surf")
            m_points.add(m_lines.number(), key);
        else if (!isIgnored(key))
            m_unknown.add(m_lines.number(), key);
    }

    /// The numbers of a statement, at most as many as fit.
    template <std::size_t N>
    std::size_t numbers(std::string_view rest, std::array<double, N>& out) const {
        std::size_t count = 0, position = 0;
        while (count < N) {
            const std::string_view word = takeWord(rest, position);
            if (word.empty() || word[0] == '#') break;
            if (!parseNumber(word, out[count])) fail("'" + std::string(word.substr(0, 40)) + "' is no number");
            ++count;
        }
        return count;
    }

    void readVertex(std::string_view rest) {
        std::array<double, 7> n{};
        const std::size_t count = numbers(rest, n);
        if (count < 3) fail("a vertex needs 3 numbers");
        m_positions.emplace_back(float(n[0]), float(n[1]), float(n[2]));
        if (count < 6 && m_colors.empty()) return;
        // Colours as painting programs write them, for a display; vertices without one are white.
        m_hasColors = true;
        m_colors.resize(m_positions.size(), glm::vec3(1.0f));
        if (count >= 6)
            for (int c = 0; c < 3; ++c) m_colors.back()[c] = linearFromSrgb(float(n[std::size_t(3 + c)]));
    }

    void readTexcoord(std::string_view rest) {
        std::array<double, 2> n{};
        if (numbers(rest, n) < 1) fail("a texture coordinate needs 1 to 3 numbers");
        m_uvs.emplace_back(float(n[0]), 1.0f - float(n[1]));  // v counts upwards in OBJ files
    }

    void readNormal(std::string_view rest) {
        std::array<double, 3> n{};
        if (numbers(rest, n) < 3) fail("a normal needs 3 numbers");
        m_normals.emplace_back(float(n[0]), float(n[1]), float(n[2]));
    }

    void readLibrary(std::string_view rest) {
        const std::string name = trim(rest);
        if (!name.empty() && std::find(m_libraries.begin(), m_libraries.end(), name) == m_libraries.end())
            m_libraries.push_back(name);
    }

    struct Corner {
        std::uint32_t position = kNone, uv = kNone, normal = kNone;
    };

    /// An index from 1, or from the end when negative, as one from 0.
    std::uint32_t index(std::string_view text, std::size_t count, const char* what) const {
        long long value = 0;
        const char* end = text.data() + text.size();
        const auto result = std::from_chars(text.data(), end, value);
        if (result.ec == std::errc::invalid_argument || result.ptr != end)
            fail("'" + std::string(text.substr(0, 40)) + "' is no index");
        const auto size = static_cast<long long>(count);
        if (result.ec != std::errc() || value == 0 || value > size || value < -size)
            fail(fmt::format("{} {} is not among the {} so far", what, text, count));
        return std::uint32_t(value > 0 ? value - 1 : size + value);
    }

    /// v, v/t, v//n or v/t/n.
    Corner corner(std::string_view word) const {
        Corner result;
        const std::size_t first = word.find('/');
        result.position = index(word.substr(0, first), m_positions.size(), "vertex");
        if (first == std::string_view::npos) return result;
        word.remove_prefix(first + 1);
        const std::size_t second = word.find('/');
        const std::string_view uv = word.substr(0, second);
        if (!uv.empty()) result.uv = index(uv, m_uvs.size(), "texture coordinate");
        if (second == std::string_view::npos) return result;
        const std::string_view normal = word.substr(second + 1);
        if (!normal.empty()) result.normal = index(normal, m_normals.size(), "normal");
        return result;
    }

    void readFace(std::string_view rest) {
        m_corners.clear();
        std::size_t position = 0;
        for (;;) {
            const std::string_view word = takeWord(rest, position);
            if (word.empty() || word[0] == '#') break;
            m_corners.push_back(corner(word));
        }
        if (m_corners.size() < 3) return m_thinFaces.add(m_lines.number(), "f" + std::string(rest));
        m_polygon.clear();
        m_triangles.clear();
        for (const Corner& c : m_corners) m_polygon.push_back(m_positions[c.position]);
        triangulate(m_polygon, m_triangles);
        Mesh& mesh = currentMesh();
        for (const std::uint32_t c : m_triangles) append(mesh, m_corners[c]);
    }

    /// Every corner is a vertex of its own; equal ones are joined when the mesh is finished.
    void append(Mesh& mesh, const Corner& c) {
        mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
        mesh.positions.push_back(m_positions[c.position]);
        mesh.uvs.push_back(c.uv == kNone ? glm::vec2(0.0f) : m_uvs[c.uv]);
        mesh.normals.push_back(c.normal == kNone ? glm::vec3(0.0f) : m_normals[c.normal]);
        if (m_hasColors) {
            mesh.colors.resize(mesh.positions.size() - 1, glm::vec3(1.0f));
            mesh.colors.push_back(c.position < m_colors.size() ? m_colors[c.position] : glm::vec3(1.0f));
        }
    }

    Mesh& currentMesh() {
        if (m_current >= 0 && m_material == m_currentName) return m_meshes[std::size_t(m_current)];
        const std::string name = m_material.empty() ? kNoMaterial : m_material;
        const auto [found, isNew] = m_meshOf.try_emplace(name, int(m_meshes.size()));
        if (isNew) {
            m_meshes.emplace_back();
            m_meshes.back().name = name;
            m_meshes.back().material = found->second;
            m_materialNames.push_back(name);
        }
        m_current = found->second;
        m_currentName = m_material;
        return m_meshes[std::size_t(m_current)];
    }

    TextLines m_lines;
    std::string m_name, m_fileName;
    std::vector<glm::vec3> m_positions, m_normals, m_colors;
    std::vector<glm::vec2> m_uvs;
    bool m_hasColors = false;
    std::string m_material, m_currentName;
    int m_current = -1;
    std::map<std::string, int> m_meshOf;
    std::vector<Mesh> m_meshes;
    std::vector<std::string> m_materialNames, m_libraries;
    PassedOver m_points, m_thinFaces, m_unknown;
    std::vector<Corner> m_corners;
    std::vector<glm::vec3> m_polygon;
    std::vector<std::uint32_t> m_triangles;
};

/// The materials of the libraries that are there. A name holds blanks, or a statement names several files.
MtlLibrary readLibraries(const std::vector<std::string>& statements, const std::filesystem::path& folder,
                         std::vector<std::string>& warnings) {
    MtlLibrary library;
    const auto readOne = [&](const std::string& name) {
        const auto file = findAsset(folder, name);
        if (!file) return false;
        MtlLibrary part = parseMtl(readWholeFile(*file), name, warnings);
        for (auto& entry : part) entry.second.folder = file->parent_path();
        library.merge(part);
        return true;
    };
    for (const std::string& statement : statements) {
        if (readOne(statement)) continue;
        for (const std::string& name : split(statement, ' '))
            if (!trim(name).empty() && !readOne(name))
                warnings.push_back("material file '" + trim(name) + "' " + whyNotFound(folder, name));
    }
    return library;
}
/// The options -s and -o of the colour map move all of a material's maps.
void placeTextures(const MtlLibrary& library, ModelFile& model) {
    for (Mesh& mesh : model.meshes) {
        const auto found = library.find(mesh.name);
        if (found == library.end()) continue;
        const MtlMaterial& mtl = found->second;
        const MtlMap* placed = nullptr;
        bool differ = false;
        for (const MtlMap* map : {&mtl.diffuseMap, &mtl.normalMap, &mtl.heightMap, &mtl.opacityMap, &mtl.emissiveMap}) {
            if (map->empty()) continue;
            differ = differ || (placed != nullptr && (placed->scale != map->scale || placed->offset != map->offset));
            if (placed == nullptr) placed = map;
        }
        if (differ)
            model.warnings.push_back("material '" + mesh.name +
                                     "' places its textures differently; all are placed as " + placed->file);
        if (placed == nullptr) continue;
        for (glm::vec2& uv : mesh.uvs)
            uv = glm::vec2(uv.x * placed->scale.x + placed->offset.x,
                           1.0f - ((1.0f - uv.y) * placed->scale.y + placed->offset.y));
    }
}
}  // namespace

ModelFile readObj(const std::string& content, const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    ObjReader reader(content, file);
    reader.read();
    ModelFile model = reader.takeModel();
    const MtlLibrary library = readLibraries(reader.libraries(), folder, model.warnings);
    readObjMaterials(reader.materialNames(), library, folder, model);
    placeTextures(library, model);
    // Painted vertices of a material without a colour are meant as they are, not darkened by the usual grey.
    for (Mesh& mesh : model.meshes) {
        if (mesh.colors.empty()) continue;
        mesh.colors.resize(mesh.positions.size(), glm::vec3(1.0f));
        const auto found = library.find(mesh.name);
        if (found == library.end() || !found->second.diffuse)
            model.materials[std::size_t(mesh.material)].baseColor = glm::vec3(1.0f);
    }
    return model;
}

}  // namespace ombrage
