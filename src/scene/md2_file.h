// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/model_file.h"

namespace ombrage {

/// Quake 2's unit: its players are 56 units tall, which makes 1.75 m.
inline constexpr float kMd2Unit_m = 1.0f / 32.0f;

/// One pose: a corner is scale * byte + translate.
struct Md2Frame {
    std::string name;  ///< such as "stand01"
    glm::vec3 scale{1.0f}, translate{0.0f};
    std::vector<std::array<std::uint8_t, 3>> corners;
};

struct Md2Triangle {
    std::array<std::uint16_t, 3> corners;  ///< clockwise from outside, into a frame's corners
    std::array<std::uint16_t, 3> texcoords;
};

/// The tables of a Quake 2 model as the file holds them; every index is in range.
struct Md2File {
    int skinWidth = 0, skinHeight = 0;  ///< texels that the texture coordinates count
    std::vector<std::string> skins;     ///< names of pictures, as the game's tools wrote them
    std::vector<std::array<std::int16_t, 2>> texcoords;
    std::vector<Md2Triangle> triangles;
    std::vector<Md2Frame> frames;

    /// Corners of a frame in metres, Y up, the figure looking to +Z: Quake's axes (X forward, Y left, Z up) turned by
    /// (x, y, z) -> (y, z, x), which is a rotation.
    std::vector<glm::vec3> positions(std::size_t frame) const;
};

/// Reads every table of a model (version 8). @throws Error(Input) naming `name` and the table that is damaged.
Md2File parseMd2(const std::string& content, const std::string& name);

/// The model in its first frame, with its skin: `skin` where that is not empty, else the first picture that the model
/// names and that is there (beside the model, whatever its folder and extension), else one with the model's own name.
/// A skin that is missing is a warning.
ModelFile readMd2(const std::string& content, const std::filesystem::path& file, const std::filesystem::path& skin);

}  // namespace ombrage
