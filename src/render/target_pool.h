// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gl/objects.h"

namespace ombrage {

/// Lends textures for the length of a frame (or longer) and takes them back for the next one.
class TargetPool {
public:
    /// A borrowed texture; goes back to the pool when the last copy dies. Content is undefined.
    using Target = std::shared_ptr<gl::Texture>;

    Target take(const gl::TextureDesc& desc, const char* label);

    /// Bytes of all textures ever made and still held, lent or not.
    std::uint64_t bytes() const;

    /// Frees what is not lent.
    void trim();

private:
    struct Shelf {
        gl::TextureDesc desc;
        std::vector<std::unique_ptr<gl::Texture>> free;
    };
    std::shared_ptr<std::vector<Shelf>> m_shelves = std::make_shared<std::vector<Shelf>>();
    std::shared_ptr<std::uint64_t> m_bytes = std::make_shared<std::uint64_t>(0);
};

}  // namespace ombrage
