// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

namespace ombrage {

using GltfJson = nlohmann::json;

/// A member of an object, or null; never throws.
const GltfJson& gltfMember(const GltfJson& object, const char* key);
double gltfNumber(const GltfJson& value, double otherwise);
std::string gltfText(const GltfJson& value, const std::string& otherwise);
/// An index into an array, or -1.
int gltfIndex(const GltfJson& value, const GltfJson& array);

template <int N>
glm::vec<N, double, glm::defaultp> gltfVector(const GltfJson& value, glm::vec<N, double, glm::defaultp> otherwise) {
    if (!value.is_array() || value.size() != N) return otherwise;
    for (int i = 0; i < N; ++i) otherwise[i] = gltfNumber(value[std::size_t(i)], otherwise[i]);
    return otherwise;
}

/// A .gltf or .glb file: its JSON, its buffers, and its accessors as numbers. Every place and length is checked, and
/// errors name the file and the JSON path.
class GltfDocument {
public:
    /// @throws Error(Input) for text that is no glTF 2 and for files that require an extension that is not read.
    GltfDocument(const std::string& content, const std::filesystem::path& file);

    const GltfJson& root() const { return m_root; }
    const std::filesystem::path& folder() const { return m_folder; }

    [[noreturn]] void fail(const std::string& place, const std::string& message, const std::string& hint = {}) const;

    /// Number of the element of the root's array `list` that `index` names.
    std::size_t find(const char* list, const GltfJson& index, const std::string& place) const;

    /// The bytes of a buffer view.
    std::span<const unsigned char> view(const GltfJson& index, const std::string& place);

    /// An accessor's values, `components` numbers for each element (a VEC3 accessor is refused where 2 are wanted; 0
    /// takes any). Normalised integers become -1 to 1 or 0 to 1, sparse values are filled in.
    struct Values {
        std::vector<float> numbers;
        int components = 1;
        std::size_t count = 0;
    };
    Values values(const GltfJson& accessor, int components, const std::string& place);
    /// A scalar accessor of unsigned integers.
    std::vector<std::uint32_t> indices(const GltfJson& accessor, const std::string& place);

    /// The content of an address: a data URI, or a file beside this one.
    std::string resource(const std::string& uri, const std::string& place) const;

private:
    struct Layout;
    template <typename T>
    std::vector<T> read(const Layout& layout, const std::string& place);
    template <typename T>
    void readInto(const Layout& layout, std::span<const unsigned char> bytes, std::size_t offset, std::size_t stride,
                  std::size_t count, std::vector<T>& out, const std::string& place) const;
    Layout layoutOf(const GltfJson& accessor, const std::string& place) const;
    void readGlb(const std::string& content, std::string& json);
    std::uint64_t whole(const GltfJson& object, const char* key, std::optional<std::uint64_t> otherwise,
                        const std::string& place) const;
    const std::string& buffer(std::size_t index);

    std::string m_name;
    std::filesystem::path m_folder;
    GltfJson m_root;
    std::string m_binary;  ///< of a .glb
    bool m_hasBinary = false;
    std::vector<std::optional<std::string>> m_buffers;
};

}  // namespace ombrage
