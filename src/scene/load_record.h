// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ombrage {

/// 128 bits of XXH3.
using Fingerprint = std::array<std::uint64_t, 2>;

/// One thing that a load asked of the file system, and the answer.
struct Dependency {
    enum class Kind : std::uint8_t {
        Content,   ///< the content of `path`; `answer` is its canonical path, empty when it could not be read
        Search,    ///< findAsset(path, name); `answer` is the file found, or empty
        Presence,  ///< whether `path` is there; `answer` is "yes" or empty
    };
    Kind kind = Kind::Content;
    std::string path, name, answer;
    Fingerprint fingerprint{};  ///< of the content
};

template <typename Archive, typename T>
requires std::same_as<std::remove_const_t<T>, Dependency>
void fields(Archive& archive, T& dependency) {
    auto& [kind, path, name, answer, fingerprint] = dependency;
    archive(kind, path, name, answer, fingerprint[0], fingerprint[1]);
}

/// Remembers every file that a load reads and every one that it looks for. The loaders report to the record that is in
/// scope on their thread; without one nothing is remembered.
class LoadRecord {
public:
    using OnFile = std::function<void(const std::filesystem::path& file, std::uint64_t size, bool isImage)>;

    /// `onFile` hears of every file before it is read.
    explicit LoadRecord(OnFile onFile = {});
    ~LoadRecord();
    LoadRecord(const LoadRecord&) = delete;
    LoadRecord& operator=(const LoadRecord&) = delete;

    std::vector<Dependency> dependencies() const;

    /// To be called before a file is read, by whoever reads it.
    static void content(const std::filesystem::path& file, bool isImage = false);
    static void search(const std::filesystem::path& folder, const std::string& name,
                       const std::optional<std::filesystem::path>& found);
    static void presence(const std::filesystem::path& file, bool isThere);

private:
    void add(Dependency dependency);

    OnFile m_onFile;
    std::map<std::string, Dependency> m_dependencies;  ///< by kind, path and name
    LoadRecord* m_outer;
};

/// True when the file system still gives every answer.
bool unchanged(const std::vector<Dependency>& dependencies);

/// The bytes' fingerprint.
Fingerprint fingerprintOf(const void* data, std::size_t size);

}  // namespace ombrage
