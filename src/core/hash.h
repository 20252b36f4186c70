// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ombrage {

/// The bits moved so that every one of them moves every bit of the result; no two numbers give the same (the finaliser
/// of splitmix64: Steele, Lea, Flood 2014). 0 gives 0.
constexpr std::uint64_t mixedBits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

/// Streaming 64-bit content hash (FNV-1a over 8-byte words, finished with the splitmix64 mixer). Not for security.
/// Equal on every machine of one byte order.
class Hasher {
public:
    void bytes(const void* data, std::size_t size);

    template <typename T>
    void value(const T& v) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes(&v, sizeof v);
    }
    /// Length and content.
    void text(std::string_view s) {
        value(std::uint64_t(s.size()));
        bytes(s.data(), s.size());
    }
    /// Length and content of tightly packed elements.
    template <typename T>
    void array(const std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        value(std::uint64_t(v.size()));
        bytes(v.data(), v.size() * sizeof(T));
    }

    std::uint64_t digest() const;
    std::string hex() const;  ///< 16 lower-case digits

private:
    std::uint64_t m_state = 0xcbf29ce484222325ull;
    std::uint64_t m_length = 0;
};

}  // namespace ombrage
