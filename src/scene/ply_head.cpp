// SPDX-License-Identifier: MIT
#include "scene/ply_head.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <ombrage/error.h>

#include "core/strings.h"
#include "scene/number_text.h"

namespace ombrage {

namespace {
struct TypeName {
    std::string_view shortName, longName;
    PlyType type;
    std::size_t bytes;
};

constexpr std::array<TypeName, 8> kTypes{{{"char", "int8", PlyType::Int8, 1},
                                          {"uchar", "uint8", PlyType::UInt8, 1},
                                          {"short", "int16", PlyType::Int16, 2},
                                          {"ushort", "uint16", PlyType::UInt16, 2},
                                          {"int", "int32", PlyType::Int32, 4},
                                          {"uint", "uint32", PlyType::UInt32, 4},
                                          {"float", "float32", PlyType::Float32, 4},
                                          {"double", "float64", PlyType::Float64, 8}}};

/// Reads the lines of a head.
class HeadReader {
public:
    HeadReader(std::string_view content, const std::string& name) : m_content(content), m_name(name) {}

    PlyHead read() {
        if (line() != "ply") fail("this is no PLY file: its first line is not 'ply'");
        bool hasFormat = false;
        for (;;) {
            if (m_position >= m_content.size()) fail("the head has no 'end_header'");
            m_words = split(line());
            if (m_words.empty()) continue;
            if (m_words[0] == "end_header") break;
            if (m_words[0] == "format") {
                readFormat();
                hasFormat = true;
            } else if (m_words[0] == "element") {
                readElement();
            } else if (m_words[0] == "property") {
                readProperty();
            } else if (m_words[0] == "comment") {
                if (m_words.size() > 2 && m_words[1] == "TextureFile") m_head.textureFile = m_words[2];
            } else if (m_words[0] != "obj_info") {
                fail("'" + m_words[0] + "' is no statement of a PLY head");
            }
        }
        if (!hasFormat) fail("the head states no format");
        m_head.dataBegin = m_position;
        return std::move(m_head);
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Error(ErrorCode::Input, message, "", m_name + ":" + std::to_string(m_line));
    }

    /// The next line without its end (LF, CR LF, or CR before anything else).
    std::string line() {
        ++m_line;
        const std::size_t end = std::min(m_content.find_first_of("\r\n", m_position), m_content.size());
        std::string text(m_content.substr(m_position, end - m_position));
        m_position = std::min(end + 1, m_content.size());
        if (end < m_content.size() && m_content[end] == '\r' && m_position < m_content.size() &&
            m_content[m_position] == '\n')
            ++m_position;
        return text;
    }

    static std::vector<std::string> split(const std::string& text) {
        std::vector<std::string> words;
        for (std::string& word : ombrage::split(text, ' '))
            if (std::string trimmed = trim(word); !trimmed.empty()) words.push_back(std::move(trimmed));
        return words;
    }

    void readFormat() {
        const std::string format = m_words.size() > 1 ? m_words[1] : "";
        if (format == "ascii")
            m_head.format = PlyFormat::Ascii;
        else if (format == "binary_little_endian")
            m_head.format = PlyFormat::LittleEndian;
        else if (format == "binary_big_endian")
            m_head.format = PlyFormat::BigEndian;
        else
            fail("'" + format + "' is no format: ascii, binary_little_endian or binary_big_endian");
    }

    void readElement() {
        long long count = 0;
        if (m_words.size() != 3 || !parseInt(m_words[2], count) || count < 0)
            fail("'element' needs a name and a count of 0 or more");
        m_head.elements.push_back({m_words[1], std::uint64_t(count), {}});
    }

    void readProperty() {
        if (m_head.elements.empty()) fail("a property before any element");
        PlyProperty property;
        property.isList = m_words.size() > 1 && m_words[1] == "list";
        if (m_words.size() != (property.isList ? 5u : 3u)) fail("'property' needs TYPE NAME or list TYPE TYPE NAME");
        property.type = type(m_words[property.isList ? 3 : 1]);
        if (property.isList) property.countType = type(m_words[2]);
        property.name = m_words.back();
        m_head.elements.back().properties.push_back(std::move(property));
    }

    PlyType type(const std::string& word) const {
        for (const TypeName& known : kTypes)
            if (word == known.shortName || word == known.longName) return known.type;
        fail("'" + word + "' is no type");
    }

    std::string_view m_content;
    const std::string& m_name;
    std::size_t m_position = 0;
    int m_line = 0;
    std::vector<std::string> m_words;
    PlyHead m_head;
};

template <typename T>
double fromBytes(const char* bytes, bool swap) {
    std::array<char, sizeof(T)> ordered;
    std::memcpy(ordered.data(), bytes, sizeof(T));
    if (swap) std::reverse(ordered.begin(), ordered.end());
    return double(std::bit_cast<T>(ordered));
}
}  // namespace

std::size_t plyBytes(PlyType type) {
    return kTypes[std::size_t(type)].bytes;
}

int PlyElement::find(std::initializer_list<std::string_view> names) const {
    for (const std::string_view wanted : names)
        for (std::size_t i = 0; i < properties.size(); ++i)
            if (properties[i].name == wanted) return int(i);
    return -1;
}

PlyHead readPlyHead(std::string_view content, const std::string& name) {
    return HeadReader(content, name).read();
}

PlyData::PlyData(std::string_view content, const PlyHead& head, std::string name)
    : m_content(content), m_format(head.format), m_name(std::move(name)), m_position(head.dataBegin) {}

void PlyData::at(const PlyElement& element, std::uint64_t index) {
    m_element = &element;
    m_index = index;
}

void PlyData::fail(const std::string& message) const {
    const std::string where = m_element == nullptr ? "" : ": " + m_element->name + " " + std::to_string(m_index);
    throw Error(ErrorCode::Input, message, "", m_name + where);
}

double PlyData::next(PlyType type) {
    if (m_format == PlyFormat::Ascii) return nextWord();
    const std::size_t size = plyBytes(type);
    if (left() < size) fail("the file ends here");
    const char* bytes = m_content.data() + m_position;
    m_position += size;
    const bool swap = (m_format == PlyFormat::LittleEndian) != (std::endian::native == std::endian::little);
    switch (type) {
        case PlyType::Int8:
            return fromBytes<std::int8_t>(bytes, swap);
        case PlyType::UInt8:
            return fromBytes<std::uint8_t>(bytes, swap);
        case PlyType::Int16:
            return fromBytes<std::int16_t>(bytes, swap);
        case PlyType::UInt16:
            return fromBytes<std::uint16_t>(bytes, swap);
        case PlyType::Int32:
            return fromBytes<std::int32_t>(bytes, swap);
        case PlyType::UInt32:
            return fromBytes<std::uint32_t>(bytes, swap);
        case PlyType::Float32:
            return double(fromBytes<float>(bytes, swap));
        case PlyType::Float64:
            break;
    }
    return fromBytes<double>(bytes, swap);
}

double PlyData::nextWord() {
    const std::string_view word = takeWord(m_content, m_position);
    if (word.empty()) fail("the file ends here");
    double value = 0;
    if (!parseNumber(word, value)) fail("'" + std::string(word.substr(0, 40)) + "' is no number");
    return value;
}

}  // namespace ombrage
