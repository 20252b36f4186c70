// SPDX-License-Identifier: MIT
#include "gl/traffic.h"

#include <map>

namespace ombrage::gl {

namespace {
thread_local std::map<GLuint, std::uint64_t> t_images;
}

void noteImage(GLuint texture, std::uint64_t bytes) {
    t_images[texture] = bytes;
}

std::uint64_t takeTraffic() {
    std::uint64_t bytes = 0;
    for (const auto& [texture, size] : t_images) bytes += size;
    t_images.clear();
    return bytes;
}

}  // namespace ombrage::gl
