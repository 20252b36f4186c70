// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/model_file.h"
#include "scene/texture_set.h"

namespace ombrage {

/// Finds the pictures that materials name, and makes textures of them once all are named. Indices given out are those
/// of ModelFile::textures after finish().
class MaterialTextures {
public:
    /// Pictures are looked for in `folder`; what is missing goes to `warnings`, which must outlive this object.
    MaterialTextures(std::filesystem::path folder, std::vector<std::string>& warnings);

    /// Index of the texture of a file, looked for in `firstFolder` too; -1 (and one warning per name) when there is
    /// none.
    int pick(const std::string& name, bool srgb, const std::filesystem::path& firstFolder = {});
    /// Index of a texture that `decode` makes; `key` tells it from others.
    int add(const std::string& key, bool srgb, std::function<Image()> decode);

    /// Decodes the pictures into `model.textures`, takes those back from the materials that cannot be read, and puts
    /// normal maps in the height map's place right. `opacity` holds, by material, an index given out here or -1: that
    /// picture becomes the colour texture's alpha.
    void finish(ModelFile& model, const std::vector<int>& opacity = {});

private:
    TextureSet m_set;
    std::filesystem::path m_folder;
    std::vector<std::string>& m_warnings;
};

/// For files without alpha modes: holes in the colour texture cut, a factor below 1 blends.
void guessAlphaMode(Material& material, const std::vector<Texture>& textures);

/// %20 and its kin, as in the addresses of glTF files.
std::string percentDecoded(const std::string& text);

}  // namespace ombrage
