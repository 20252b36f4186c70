// SPDX-License-Identifier: MIT
#include "scene/gltf_resource.h"

#include <cstdint>

#include "scene/asset_path.h"
#include "scene/material_textures.h"

namespace ombrage {

namespace {
/// RFC 4648, section 4; white space and padding are passed over.
std::optional<std::string> decodeBase64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        std::uint32_t value = 0;
        if (c >= 'A' && c <= 'Z')
            value = std::uint32_t(c - 'A');
        else if (c >= 'a' && c <= 'z')
            value = std::uint32_t(c - 'a') + 26;
        else if (c >= '0' && c <= '9')
            value = std::uint32_t(c - '0') + 52;
        else if (c == '+' || c == '-')
            value = 62;
        else if (c == '/' || c == '_')
            value = 63;
        else if (c == '=' || c == '\n' || c == '\r' || c == ' ')
            continue;
        else
            return std::nullopt;
        bits = bits << 6 | value;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += char(bits >> count & 0xffu);
    }
    return bytes;
}
}  // namespace

std::optional<std::string> decodeDataUri(const std::string& uri) {
    const std::size_t comma = uri.find(',');
    if (uri.compare(0, 5, "data:") != 0 || comma == std::string::npos) return std::nullopt;
    const std::string_view kind = std::string_view(uri).substr(5, comma - 5);
    const std::string_view data = std::string_view(uri).substr(comma + 1);
    if (kind.size() >= 7 && kind.substr(kind.size() - 7) == ";base64") return decodeBase64(data);
    return percentDecoded(std::string(data));
}

std::optional<std::filesystem::path> findGltfFile(const std::filesystem::path& folder, const std::string& uri) {
    auto file = findAsset(folder, uri);
    return file ? file : findAsset(folder, percentDecoded(uri));
}

}  // namespace ombrage
