// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// Bytes that are no archive, or not a whole one.
class ArchiveError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

namespace archive_detail {
template <typename T>
struct IsPlain : std::bool_constant<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>> {};
template <int N, typename T, glm::qualifier Q>
struct IsPlain<glm::vec<N, T, Q>> : std::true_type {};
template <int C, int R, typename T, glm::qualifier Q>
struct IsPlain<glm::mat<C, R, T, Q>> : std::true_type {};

/// What may be copied bit by bit: every bit pattern is a value.
template <typename T>
inline constexpr bool isPlain = IsPlain<T>::value;

/// Arrays start at multiples of this from the archive's beginning.
inline constexpr std::size_t kAlignment = 8;
}  // namespace archive_detail

/// Writes values, strings, vectors, optionals and structs with a function `fields(archive, struct)` to a sink: anything
/// that takes `sink(const void*, std::size_t)`. Byte order and layout are this machine's.
template <typename Sink>
class ArchiveWriter {
public:
    explicit ArchiveWriter(Sink& sink) : m_sink(sink) {}

    template <typename... T>
    void operator()(const T&... values) {
        (put(values), ...);
    }

private:
    void bytes(const void* data, std::size_t size) {
        m_sink(data, size);
        m_position += size;
    }
    void put(bool value) { put(std::uint8_t(value)); }
    void put(const std::string& text) {
        put(std::uint64_t(text.size()));
        bytes(text.data(), text.size());
    }
    template <typename T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <typename T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t(values.size()));
        if constexpr (archive_detail::isPlain<T>) {
            constexpr char kZeros[archive_detail::kAlignment] = {};
            bytes(kZeros,
                  (archive_detail::kAlignment - m_position % archive_detail::kAlignment) % archive_detail::kAlignment);
            bytes(values.data(), values.size() * sizeof(T));
        } else {
            for (const T& value : values) put(value);
        }
    }
    template <typename T>
    void put(const T& value) {
        if constexpr (archive_detail::isPlain<T> || std::is_enum_v<T>)
            bytes(&value, sizeof value);
        else
            fields(*this, value);
    }

    Sink& m_sink;
    std::size_t m_position = 0;
};

/// Reads what ArchiveWriter wrote. No count is believed: what does not fit into the bytes that are left throws before
/// it is allocated. The bytes start at an address that is a multiple of 8. Values of enumerations are not checked.
class ArchiveReader {
public:
    explicit ArchiveReader(std::span<const std::byte> bytes) : m_bytes(bytes) {}

    /// @throws ArchiveError
    template <typename... T>
    void operator()(T&... values) {
        (get(values), ...);
    }

    std::size_t left() const { return m_bytes.size() - m_position; }

private:
    const std::byte* take(std::size_t size) {
        if (size > left()) throw ArchiveError("the archive ends early");
        const std::byte* data = m_bytes.data() + m_position;
        m_position += size;
        return data;
    }
    std::size_t count(std::size_t elementSize) {
        std::uint64_t n = 0;
        get(n);
        if (n > left() / elementSize) throw ArchiveError("a count is too large");
        return std::size_t(n);
    }
    void get(bool& value) {
        std::uint8_t byte = 0;
        get(byte);
        if (byte > 1) throw ArchiveError("neither true nor false");
        value = byte == 1;
    }
    void get(std::string& text) {
        const std::size_t size = count(1);
        text.assign(reinterpret_cast<const char*>(take(size)), size);
    }
    template <typename T>
    void get(std::optional<T>& value) {
        bool has = false;
        get(has);
        value.reset();
        if (has) get(value.emplace());
    }
    template <typename T>
    void get(std::vector<T>& values) {
        if constexpr (archive_detail::isPlain<T>) {
            const std::size_t size = count(sizeof(T));
            take((archive_detail::kAlignment - m_position % archive_detail::kAlignment) % archive_detail::kAlignment);
            if (size > left() / sizeof(T)) throw ArchiveError("a count is too large");
            const T* first = reinterpret_cast<const T*>(take(size * sizeof(T)));
            values.assign(first, first + size);
        } else {
            // Grown as the elements arrive: a false count ends at the end of the bytes.
            const std::size_t size = count(1);
            values.clear();
            for (std::size_t i = 0; i < size; ++i) get(values.emplace_back());
        }
    }
    template <typename T>
    void get(T& value) {
        if constexpr (archive_detail::isPlain<T> || std::is_enum_v<T>)
            std::memcpy(static_cast<void*>(&value), take(sizeof value), sizeof value);
        else
            fields(*this, value);
    }

    std::span<const std::byte> m_bytes;
    std::size_t m_position = 0;
};

}  // namespace ombrage
