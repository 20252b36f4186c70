// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <ombrage/image.h>

namespace ombrage {

/// True when the bytes begin as a run-length-coded PCX file of version 5 does. No other kind of picture does.
bool isPcx(std::span<const unsigned char> bytes);

/// Decodes a ZSoft PCX picture: 8 bits with a palette of 256 colours at the end, or 24 bits as three planes. Planes
/// R, G, B in [0,1], space Srgb. `name` is used in errors only.
/// @throws Error(Input) for other kinds, sizes beyond 16384 and files that end too early.
Image decodePcx(std::span<const unsigned char> bytes, const std::string& name);

}  // namespace ombrage
