// SPDX-License-Identifier: MIT
#include "scene/gltf_document.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "scene/asset_path.h"
#include "scene/gltf_resource.h"

namespace ombrage {

namespace {
static_assert(std::endian::native == std::endian::little, "accessors are copied as the file holds them");

/// Elements of an accessor without a buffer view (zeros), which no file's size bounds.
constexpr std::uint64_t kMostZeros = 1u << 24;

enum Component { Int8 = 5120, UInt8 = 5121, Int16 = 5122, UInt16 = 5123, UInt32 = 5125, Float32 = 5126 };

std::size_t componentBytes(std::uint64_t type) {
    switch (type) {
        case Int8:
        case UInt8:
            return 1;
        case Int16:
        case UInt16:
            return 2;
        case UInt32:
        case Float32:
            return 4;
        default:
            return 0;
    }
}

int componentsOf(const std::string& type) {
    constexpr std::pair<const char*, int> kTypes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                      {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : kTypes)
        if (type == name) return count;
    return 0;
}

template <typename T>
T fetch(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// One component; normalised ones as section 3.6.2.2 of the glTF 2.0 specification wants them.
template <typename T>
T component(const unsigned char* bytes, std::uint64_t type, bool normalized) {
    const auto scaled = [normalized](auto value, float largest) {
        if constexpr (std::is_same_v<T, float>)
            return normalized ? std::max(float(value) / largest, -1.0f) : float(value);
        else
            return T(value);
    };
    switch (type) {
        case Int8:
            return scaled(fetch<std::int8_t>(bytes), 127.0f);
        case UInt8:
            return scaled(fetch<std::uint8_t>(bytes), 255.0f);
        case Int16:
            return scaled(fetch<std::int16_t>(bytes), 32767.0f);
        case UInt16:
            return scaled(fetch<std::uint16_t>(bytes), 65535.0f);
        case UInt32:
            return T(fetch<std::uint32_t>(bytes));
        default:
            return T(fetch<float>(bytes));
    }
}
}  // namespace

const GltfJson& gltfMember(const GltfJson& object, const char* key) {
    static const GltfJson nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(key);
    return found == object.end() ? nothing : *found;
}

double gltfNumber(const GltfJson& value, double otherwise) {
    return value.is_number() ? value.get<double>() : otherwise;
}

std::string gltfText(const GltfJson& value, const std::string& otherwise) {
    return value.is_string() ? value.get<std::string>() : otherwise;
}

int gltfIndex(const GltfJson& value, const GltfJson& array) {
    if (!value.is_number_integer() || !array.is_array()) return -1;
    const auto index = value.get<std::int64_t>();
    return index >= 0 && index < std::int64_t(array.size()) ? int(index) : -1;
}

struct GltfDocument::Layout {
    const GltfJson& accessor;
    std::uint64_t type = 0, count = 0;
    int components = 0;
    bool normalized = false;
    std::size_t elementBytes() const { return componentBytes(type) * std::size_t(components); }
};

GltfDocument::GltfDocument(const std::string& content, const std::filesystem::path& file)
    : m_name(file.string()), m_folder(file.has_parent_path() ? file.parent_path() : std::filesystem::path(".")) {
    std::string json;
    const bool binary = content.compare(0, 4, "glTF") == 0;
    if (binary) readGlb(content, json);
    try {
        m_root = GltfJson::parse(binary ? json : content);
    } catch (const GltfJson::parse_error& error) {
        // What the library says is "[json.exception...] parse error at line L, column C: reason".
        std::string reason = error.what();
        if (const std::size_t at = reason.find("] "); at != std::string::npos) reason.erase(0, at + 2);
        throw Error(ErrorCode::Input, "the JSON is damaged: " + reason, "", m_name);
    }
    if (!m_root.is_object()) fail("/", "this is no glTF file: its JSON is no object");

    const std::string version = gltfText(gltfMember(gltfMember(m_root, "asset"), "version"), "");
    if (version.compare(0, 2, "2.") != 0)
        fail("/asset/version", version.empty() ? "this is no glTF file: it states no version"
                                               : "glTF version '" + version + "' is not read, only 2.0");
    // What a file requires and is not read would show something else than the file means.
    constexpr const char* kRead[] = {"KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform",
                                     "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness"};
    const GltfJson& required = gltfMember(m_root, "extensionsRequired");
    for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
        const std::string name = gltfText(required[i], "");
        if (std::none_of(std::begin(kRead), std::end(kRead), [&](const char* known) { return name == known; }))
            fail("/extensionsRequired/" + std::to_string(i), "the file requires '" + name + "', which is not read",
                 "export it without that extension");
    }
    const GltfJson& buffers = gltfMember(m_root, "buffers");
    m_buffers.resize(buffers.is_array() ? buffers.size() : 0);
}

void GltfDocument::fail(const std::string& place, const std::string& message, const std::string& hint) const {
    throw Error(ErrorCode::Input, message, hint, m_name + ": " + place);
}

void GltfDocument::readGlb(const std::string& content, std::string& json) {
    // A head of 12 bytes (magic, version, length), then chunks (length, kind, bytes): JSON first, then perhaps BIN.
    const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
    if (content.size() < 20) fail("head", "the file ends within its head");
    if (fetch<std::uint32_t>(bytes + 4) != 2)
        fail("head", fmt::format("GLB version {} is not read, only 2", fetch<std::uint32_t>(bytes + 4)));
    std::uint64_t end = fetch<std::uint32_t>(bytes + 8);
    if (end > content.size()) fail("head", fmt::format("the file ends after {} of {} bytes", content.size(), end));
    if (end < 20) fail("head", "the length is too small to hold a chunk");
    std::uint64_t at = 12;
    for (int chunk = 0; at + 8 <= end; ++chunk) {
        const std::uint64_t length = fetch<std::uint32_t>(bytes + at);
        const std::uint32_t kind = fetch<std::uint32_t>(bytes + at + 4);
        if (length > end - at - 8)
            fail("chunk " + std::to_string(chunk), fmt::format("{} bytes do not fit into the file", length));
        if (chunk == 0 && kind != 0x4e4f534au) fail("chunk 0", "the first chunk is not JSON");
        if (chunk == 0) json = content.substr(at + 8, length);
        if (chunk == 1 && kind == 0x004e4942u) {
            m_binary = content.substr(at + 8, length);
            m_hasBinary = true;
        }
        at += 8 + length;
    }
}

std::uint64_t GltfDocument::whole(const GltfJson& object, const char* key, std::optional<std::uint64_t> otherwise,
                                  const std::string& place) const {
    const GltfJson& value = gltfMember(object, key);
    if (value.is_null() && otherwise) return *otherwise;
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    fail(place + "/" + key, value.is_null() ? "it is missing" : "it is no whole number of 0 or more");
}

std::size_t GltfDocument::find(const char* list, const GltfJson& index, const std::string& place) const {
    const GltfJson& array = gltfMember(m_root, list);
    const int found = gltfIndex(index, array);
    if (found < 0)
        fail(place,
             fmt::format("{} is not among the {} of /{}", index.dump(), array.is_array() ? array.size() : 0, list));
    return std::size_t(found);
}

std::string GltfDocument::resource(const std::string& uri, const std::string& place) const {
    if (uri.compare(0, 5, "data:") == 0) {
        if (auto bytes = decodeDataUri(uri)) return std::move(*bytes);
        fail(place, "the data URI cannot be decoded: it is not base64 and not percent-encoded text");
    }
    const auto file = findGltfFile(m_folder, uri);
    if (!file) fail(place, "there is no file '" + uri + "'");
    return readWholeFile(*file);
}

const std::string& GltfDocument::buffer(std::size_t index) {
    std::optional<std::string>& known = m_buffers[index];
    if (known) return *known;
    const std::string place = "/buffers/" + std::to_string(index);
    const GltfJson& json = m_root["buffers"][index];
    const std::uint64_t length = whole(json, "byteLength", std::nullopt, place);
    const GltfJson& uri = gltfMember(json, "uri");
    if (uri.is_string())
        known = resource(uri.get<std::string>(), place + "/uri");
    else if (index == 0 && m_hasBinary)
        known = std::move(m_binary);
    else
        fail(place, "the buffer has no uri, and the file no binary chunk for it");
    if (known->size() < length)
        fail(place + "/byteLength", fmt::format("{} bytes are stated, {} are there", length, known->size()));
    return *known;
}

std::span<const unsigned char> GltfDocument::view(const GltfJson& index, const std::string& place) {
    const std::size_t number = find("bufferViews", index, place);
    const GltfJson& json = m_root["bufferViews"][number];
    const std::string here = "/bufferViews/" + std::to_string(number);
    const std::string& bytes = buffer(find("buffers", gltfMember(json, "buffer"), here + "/buffer"));
    const std::uint64_t offset = whole(json, "byteOffset", 0, here);
    const std::uint64_t length = whole(json, "byteLength", std::nullopt, here);
    if (offset > bytes.size() || length > bytes.size() - offset)
        fail(here, fmt::format("{} bytes from {} do not lie in the buffer of {} bytes", length, offset, bytes.size()));
    return {reinterpret_cast<const unsigned char*>(bytes.data()) + offset, std::size_t(length)};
}

GltfDocument::Layout GltfDocument::layoutOf(const GltfJson& accessor, const std::string& place) const {
    Layout layout{accessor};
    layout.type = whole(accessor, "componentType", std::nullopt, place);
    layout.count = whole(accessor, "count", std::nullopt, place);
    layout.components = componentsOf(gltfText(gltfMember(accessor, "type"), ""));
    layout.normalized = gltfMember(accessor, "normalized") == true;
    if (componentBytes(layout.type) == 0)
        fail(place + "/componentType", fmt::format("{} is no type of a component", layout.type));
    if (layout.components == 0) fail(place + "/type", "it is no type of an accessor");
    return layout;
}

template <typename T>
void GltfDocument::readInto(const Layout& layout, std::span<const unsigned char> bytes, std::size_t offset,
                            std::size_t stride, std::size_t count, std::vector<T>& out,
                            const std::string& place) const {
    const std::size_t size = layout.elementBytes();
    if (count > 0 && (offset > bytes.size() || size > bytes.size() - offset ||
                      (count - 1) > (bytes.size() - offset - size) / std::max<std::size_t>(stride, 1)))
        fail(place, fmt::format("{} elements of {} bytes from byte {} do not fit into the buffer view of {} bytes",
                                count, size, offset, bytes.size()));
    out.reserve(count * std::size_t(layout.components));
    const std::size_t step = componentBytes(layout.type);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < std::size_t(layout.components); ++c)
            out.push_back(component<T>(bytes.data() + offset + i * stride + c * step, layout.type, layout.normalized));
}

template <typename T>
std::vector<T> GltfDocument::read(const Layout& layout, const std::string& place) {
    std::vector<T> out;
    const GltfJson& viewIndex = gltfMember(layout.accessor, "bufferView");
    if (viewIndex.is_null()) {
        if (layout.count > kMostZeros)
            fail(place + "/count",
                 fmt::format("{} elements without a buffer view are over {}", layout.count, kMostZeros));
        out.assign(std::size_t(layout.count) * std::size_t(layout.components), T(0));
    } else {
        const std::span<const unsigned char> bytes = view(viewIndex, place + "/bufferView");
        const std::size_t number = find("bufferViews", viewIndex, place);
        const std::string viewPlace = "/bufferViews/" + std::to_string(number);
        const std::uint64_t stride =
            whole(m_root["bufferViews"][number], "byteStride", layout.elementBytes(), viewPlace);
        if (stride < layout.elementBytes() || stride > 65535)
            fail(viewPlace + "/byteStride",
                 fmt::format("{} is not between {}, an element's size, and 65535", stride, layout.elementBytes()));
        readInto(layout, bytes, whole(layout.accessor, "byteOffset", 0, place), stride, layout.count, out, place);
    }

    // Sparse accessors replace some elements.
    const GltfJson& sparse = gltfMember(layout.accessor, "sparse");
    if (sparse.is_null()) return out;
    const std::string here = place + "/sparse";
    const GltfJson &where = gltfMember(sparse, "indices"), &what = gltfMember(sparse, "values");
    const std::uint64_t count = whole(sparse, "count", std::nullopt, here);
    Layout indexLayout{sparse};
    indexLayout.type = whole(where, "componentType", std::nullopt, here + "/indices");
    indexLayout.components = 1;
    if (indexLayout.type != UInt8 && indexLayout.type != UInt16 && indexLayout.type != UInt32)
        fail(here + "/indices/componentType", "indices are unsigned integers");
    std::vector<std::uint32_t> at;
    readInto(indexLayout, view(gltfMember(where, "bufferView"), here + "/indices/bufferView"),
             whole(where, "byteOffset", 0, here + "/indices"), indexLayout.elementBytes(), count, at,
             here + "/indices");
    std::vector<T> replacements;
    readInto(layout, view(gltfMember(what, "bufferView"), here + "/values/bufferView"),
             whole(what, "byteOffset", 0, here + "/values"), layout.elementBytes(), count, replacements,
             here + "/values");
    const auto components = std::ptrdiff_t(layout.components);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= layout.count) fail(here + "/indices", fmt::format("index {} of {} elements", at[i], layout.count));
        std::copy_n(replacements.begin() + std::ptrdiff_t(i) * components, components,
                    out.begin() + std::ptrdiff_t(at[i]) * components);
    }
    return out;
}

GltfDocument::Values GltfDocument::values(const GltfJson& accessor, int components, const std::string& place) {
    const std::size_t number = find("accessors", accessor, place);
    const std::string here = "/accessors/" + std::to_string(number);
    const Layout layout = layoutOf(m_root["accessors"][number], here);
    if (components != 0 && layout.components != components)
        fail(here + "/type",
             fmt::format("{} components where {} are wanted by {}", layout.components, components, place));
    return {read<float>(layout, here), layout.components, std::size_t(layout.count)};
}

std::vector<std::uint32_t> GltfDocument::indices(const GltfJson& accessor, const std::string& place) {
    const std::size_t number = find("accessors", accessor, place);
    const std::string here = "/accessors/" + std::to_string(number);
    const Layout layout = layoutOf(m_root["accessors"][number], here);
    if (layout.components != 1 || (layout.type != UInt8 && layout.type != UInt16 && layout.type != UInt32))
        fail(here, "indices are scalars of unsigned integers");
    return read<std::uint32_t>(layout, here);
}

}  // namespace ombrage
