// SPDX-License-Identifier: MIT
#include "scene/md2_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "scene/asset_path.h"
#include "scene/model_materials.h"

namespace ombrage {

namespace {
constexpr std::size_t kHeadBytes = 68, kSkinBytes = 64, kFrameHeadBytes = 40, kFrameNameBytes = 16;
// The game's own limits are lower; these only keep indices within their 16 bits.
constexpr std::int32_t kMostCorners = 65536;

static_assert(std::endian::native == std::endian::little, "the tables are copied as the file holds them");

/// Where things stand in the head, in words.
enum Head { Ident, Version, SkinWidth, SkinHeight, FrameSize, Skins, Corners, Texcoords, Triangles, Commands, Frames };
enum Offset { SkinsAt = 11, TexcoordsAt, TrianglesAt, FramesAt };

class Md2Reader {
public:
    Md2Reader(const std::string& content, const std::string& name) : m_content(content), m_name(name) {}

    Md2File read() {
        if (m_content.size() < kHeadBytes || m_content.compare(0, 4, "IDP2") != 0)
            fail("this is no MD2 model: it does not begin with 'IDP2'");
        std::memcpy(m_head.data(), m_content.data(), kHeadBytes);
        if (m_head[Version] != 8) fail(fmt::format("version {} is not read, only 8", m_head[Version]));
        if (m_head[SkinWidth] < 1 || m_head[SkinHeight] < 1) fail("the skin has no size");
        if (m_head[Frames] < 1) fail("it has no frames");
        if (m_head[Triangles] < 1) fail("it has no triangles");
        if (m_head[Corners] < 1 || m_head[Corners] > kMostCorners || m_head[Texcoords] > kMostCorners)
            fail(fmt::format("{} corners are not between 1 and {}", m_head[Corners], kMostCorners));
        const std::int64_t frameBytes = std::int64_t(kFrameHeadBytes) + 4 * std::int64_t(m_head[Corners]);
        if (m_head[FrameSize] < frameBytes)
            fail(fmt::format("frames of {} bytes do not hold {} corners", m_head[FrameSize], m_head[Corners]));

        Md2File file;
        file.skinWidth = m_head[SkinWidth];
        file.skinHeight = m_head[SkinHeight];
        const std::string_view skins = table("skins", Skins, SkinsAt, kSkinBytes);
        for (std::size_t at = 0; at < skins.size(); at += kSkinBytes)
            file.skins.push_back(textOf(skins.substr(at, kSkinBytes)));
        copyTable(table("texture coordinates", Texcoords, TexcoordsAt, 4), file.texcoords);
        copyTable(table("triangles", Triangles, TrianglesAt, 12), file.triangles);
        checkTriangles(file);
        readFrames(table("frames", Frames, FramesAt, std::size_t(m_head[FrameSize])), file);
        return file;
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw Error(ErrorCode::Input, message, "", m_name); }

    /// The bytes of a table; lengths and places are checked in 64 bits against the file's end.
    std::string_view table(const char* what, Head count, Offset offset, std::size_t elementBytes) const {
        const std::int64_t n = m_head[std::size_t(count)], begin = m_head[std::size_t(offset)];
        if (n == 0) return {};
        if (n < 0 || begin < 0 || begin + n * std::int64_t(elementBytes) > std::int64_t(m_content.size()))
            fail(fmt::format("the table of {} {} lies outside the file of {} bytes", n, what, m_content.size()));
        return std::string_view(m_content).substr(std::size_t(begin), std::size_t(n) * elementBytes);
    }

    template <typename T>
    static void copyTable(std::string_view bytes, std::vector<T>& out) {
        out.resize(bytes.size() / sizeof(T));
        if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
    }

    static std::string textOf(std::string_view field) { return std::string(field.substr(0, field.find('\0'))); }

    void checkTriangles(const Md2File& file) const {
        for (std::size_t i = 0; i < file.triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if (file.triangles[i].corners[k] >= m_head[Corners])
                    fail(fmt::format("triangle {}: corner {} of {}", i, file.triangles[i].corners[k], m_head[Corners]));
                // A model without texture coordinates is one without a skin.
                if (!file.texcoords.empty() && file.triangles[i].texcoords[k] >= file.texcoords.size())
                    fail(fmt::format("triangle {}: texture coordinate {} of {}", i, file.triangles[i].texcoords[k],
                                     file.texcoords.size()));
            }
    }

    void readFrames(std::string_view bytes, Md2File& file) const {
        for (std::size_t at = 0; at < bytes.size(); at += std::size_t(m_head[FrameSize])) {
            Md2Frame frame;
            std::memcpy(&frame.scale, bytes.data() + at, 12);
            std::memcpy(&frame.translate, bytes.data() + at + 12, 12);
            frame.name = textOf(bytes.substr(at + 24, kFrameNameBytes));
            frame.corners.resize(std::size_t(m_head[Corners]));
            // A corner is three bytes of position and one that picks a normal of the game's table, which is not used.
            for (std::size_t v = 0; v < frame.corners.size(); ++v)
                std::memcpy(frame.corners[v].data(), bytes.data() + at + kFrameHeadBytes + 4 * v, 3);
            file.frames.push_back(std::move(frame));
        }
    }

    const std::string& m_content;
    const std::string& m_name;
    std::array<std::int32_t, 17> m_head{};
};

bool isFile(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

/// The picture that a skin's name means: the name itself, or (games leave the extension out) with any extension.
std::optional<std::filesystem::path> findSkin(const std::filesystem::path& folder, const std::string& name) {
    std::string plain = name;
    std::replace(plain.begin(), plain.end(), '\\', '/');
    // A leading dot means "beside the model".
    if (!plain.empty() && plain[0] == '.' && plain.compare(0, 2, "./") != 0 && plain.compare(0, 3, "../") != 0)
        plain.erase(0, 1);
    const std::filesystem::path path(plain);
    if (plain.empty() || !path.has_filename()) return std::nullopt;
    if (auto found = findAsset(folder, plain); found && path.has_extension()) return found;
    for (const char* extension : {".pcx", ".png", ".jpg", ".jpeg", ".tga", ".bmp"}) {
        std::filesystem::path other = path;
        if (auto found = findAsset(folder, other.replace_extension(extension).string())) return found;
    }
    return std::nullopt;
}
}  // namespace

std::vector<glm::vec3> Md2File::positions(std::size_t frame) const {
    const Md2Frame& f = frames[frame];
    std::vector<glm::vec3> result;
    result.reserve(f.corners.size());
    for (const auto& corner : f.corners) {
        const glm::vec3 p = f.scale * glm::vec3(corner[0], corner[1], corner[2]) + f.translate;
        result.push_back(glm::vec3(p.y, p.z, p.x) * kMd2Unit_m);
    }
    return result;
}

Md2File parseMd2(const std::string& content, const std::string& name) {
    return Md2Reader(content, name).read();
}

ModelFile readMd2(const std::string& content, const std::filesystem::path& file, const std::filesystem::path& skin) {
    const Md2File md2 = parseMd2(content, file.string());
    ModelFile model;
    Mesh mesh;
    mesh.name = file.stem().string();
    const std::vector<glm::vec3> positions = md2.positions(0);
    for (const Md2Triangle& triangle : md2.triangles)
        for (const std::size_t k : {0u, 2u, 1u}) {  // the file's order is clockwise
            mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.push_back(positions[triangle.corners[k]]);
            if (md2.texcoords.empty()) continue;
            // Coordinates count texels from the top left; the middle of a texel is meant.
            const auto& at = md2.texcoords[triangle.texcoords[k]];
            mesh.uvs.push_back((glm::vec2(at[0], at[1]) + 0.5f) / glm::vec2(md2.skinWidth, md2.skinHeight));
        }
    model.meshes.push_back(std::move(mesh));
    model.parts.push_back({0, glm::dmat4(1.0)});

    // The skin: the one asked for, those that the model names, one of the model's own name.
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    std::optional<std::filesystem::path> picture;
    if (!skin.empty()) {
        if (!isFile(skin)) throw Error(ErrorCode::Input, "there is no skin '" + skin.string() + "'", "", file.string());
        picture = skin;
    }
    for (const std::string& name : md2.skins)
        if (!picture) picture = findSkin(folder, name);
    if (!picture) picture = findSkin(folder, file.stem().string());
    model.materials.push_back(plainMaterial(file.stem().string(), picture.has_value()));
    if (picture)
        setColorTexture(model, *picture);
    else
        model.warnings.push_back("the skin " + (md2.skins.empty() ? "" : "'" + md2.skins[0] + "' ") +
                                 "is missing; pictures beside the model are looked for by its name");
    return model;
}

}  // namespace ombrage
