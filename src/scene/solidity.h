// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage {

/// Whether the mesh bounds a solid from outside: every edge is run through as often one way as the other, vertices at
/// one position counting as one, and each connected part encloses a positive volume. Seen from outside, such a mesh
/// shows no back face. (A part that passes through itself and turns inside out there is not noticed.) Linear time.
bool isSolid(const Mesh& mesh);

}  // namespace ombrage
