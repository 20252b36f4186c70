// SPDX-License-Identifier: MIT
#include "render/target_pool.h"

#include <algorithm>

namespace ombrage {

TargetPool::Target TargetPool::take(const gl::TextureDesc& desc, const char* label) {
    auto shelf = std::find_if(m_shelves->begin(), m_shelves->end(), [&](const Shelf& s) { return s.desc == desc; });
    if (shelf == m_shelves->end()) shelf = m_shelves->insert(m_shelves->end(), Shelf{desc, {}});

    std::unique_ptr<gl::Texture> texture;
    if (!shelf->free.empty()) {
        texture = std::move(shelf->free.back());
        shelf->free.pop_back();
    } else {
        texture = std::make_unique<gl::Texture>(desc, label);
        *m_bytes += gl::byteSize(desc);
    }

    // The texture goes home when its last user lets go, or dies with the pool.
    return Target(texture.release(), [shelves = std::weak_ptr(m_shelves), bytes = m_bytes, desc](gl::Texture* returned) {
        std::unique_ptr<gl::Texture> owned(returned);
        const auto pool = shelves.lock();
        if (!pool) return;
        for (Shelf& candidate : *pool)
            if (candidate.desc == desc) {
                candidate.free.push_back(std::move(owned));
                return;
            }
        *bytes -= gl::byteSize(desc);
    });
}

std::uint64_t TargetPool::bytes() const { return *m_bytes; }

void TargetPool::trim() {
    for (const Shelf& shelf : *m_shelves) *m_bytes -= gl::byteSize(shelf.desc) * shelf.free.size();
    m_shelves->clear();
}

}  // namespace ombrage
