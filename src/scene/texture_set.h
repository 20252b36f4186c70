// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <ombrage/image.h>
#include <ombrage/scene.h>

namespace ombrage {

/// Gathers the textures that a file's materials ask for, decodes all of them at once on every core, and keeps each
/// picture once per use (colour or data).
class TextureSet {
public:
    /// Index of a texture of an image file.
    int add(const std::filesystem::path& file, bool srgb);
    /// Index of a texture that `decode` makes; `key` tells it from others. `decode` runs on any thread and may throw
    /// Error.
    int add(const std::string& key, bool srgb, std::function<Image()> decode);

    /// Decodes everything. A picture that cannot be read becomes an empty texture, and a warning.
    std::vector<Texture> decode(std::vector<std::string>& warnings) const;

private:
    struct Request {
        std::string key;
        bool srgb;
        std::function<Image()> decode;
    };
    std::vector<Request> m_requests;
    std::map<std::string, int> m_indices;
};

/// 8-bit RGBA of an image with planes R, G, B or Y, and perhaps A.
Texture toTexture(const Image& image, const std::string& name, bool srgb);

/// True when a texel's alpha is below one half.
bool hasHoles(const Texture& texture);

/// True when most texels hold unit vectors that lean to +z: a tangent-space normal map, not a height map.
bool looksLikeNormalMap(const Texture& texture);

/// The colour texture with the opacity of another picture: of its alpha where that varies, else of its red. Sizes may
/// differ (the opacity is read at the nearest texel).
Texture withOpacity(const Texture& color, const Texture& opacity);

/// Drops textures that no material uses or that are empty, and renumbers the materials' indices.
void compactTextures(std::vector<Texture>& textures, std::vector<Material>& materials);

}  // namespace ombrage
