// SPDX-License-Identifier: MIT
// The guarded import: started by the library, never by hand (scene/import_guard.h).
#include "scene/import_guard.h"

int main(int argc, char** argv) {
    return ombrage::runImportProgram(argc, argv);
}
