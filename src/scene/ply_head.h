// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ombrage {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t plyBytes(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;     ///< of the value, or of a list's values
    PlyType countType = PlyType::UInt8;  ///< of a list's count
    bool isList = false;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the first property with one of these names, or -1.
    int find(std::initializer_list<std::string_view> names) const;
};

struct PlyHead {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::string textureFile;    ///< of a comment "TextureFile NAME", as MeshLab writes it
    std::size_t dataBegin = 0;  ///< offset of the first byte behind the head
};

/// Reads the head of a PLY file's content. @throws Error(Input) with `name`:LINE.
PlyHead readPlyHead(std::string_view content, const std::string& name);

/// The values of a PLY file's elements, one after the other, as numbers. Every read is checked against the end.
class PlyData {
public:
    PlyData(std::string_view content, const PlyHead& head, std::string name);

    /// @throws Error(Input) naming the element where the data ends, or where a word is no number.
    double next(PlyType type);
    /// Bytes that are left, an upper bound of the number of values that can follow.
    std::size_t left() const { return m_content.size() - m_position; }
    /// Says where reading is, for errors.
    void at(const PlyElement& element, std::uint64_t index);

private:
    double nextWord();
    [[noreturn]] void fail(const std::string& message) const;

    std::string_view m_content;
    PlyFormat m_format;
    std::string m_name;
    std::size_t m_position;
    const PlyElement* m_element = nullptr;
    std::uint64_t m_index = 0;
};

}  // namespace ombrage
