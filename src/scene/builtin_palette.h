// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

/// Colours of the built-in scenes, in sRGB.
namespace ombrage::builtin::palette {

inline const glm::vec3 kStone{0.78f, 0.76f, 0.72f};
inline const glm::vec3 kChalk{0.88f, 0.87f, 0.84f};
inline const glm::vec3 kClay{0.80f, 0.47f, 0.34f};
inline const glm::vec3 kSea{0.27f, 0.55f, 0.66f};
inline const glm::vec3 kMoss{0.49f, 0.60f, 0.36f};
inline const glm::vec3 kPlum{0.55f, 0.38f, 0.54f};
inline const glm::vec3 kStraw{0.87f, 0.73f, 0.40f};
inline const glm::vec3 kRed{0.78f, 0.26f, 0.22f};
inline const glm::vec3 kGreen{0.33f, 0.60f, 0.30f};
inline const glm::vec3 kSlate{0.42f, 0.46f, 0.50f};

}  // namespace ombrage::builtin::palette
