// SPDX-License-Identifier: MIT
#pragma once

namespace ombrage {

/// "MAJOR.MINOR.PATCH" of the library that is linked.
const char* versionString();

}  // namespace ombrage
