// SPDX-License-Identifier: MIT
#include <ombrage/version.h>

namespace ombrage {

const char* versionString() { return OMBRAGE_VERSION; }

}  // namespace ombrage
