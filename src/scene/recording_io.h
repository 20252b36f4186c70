// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/DefaultIOSystem.h>

#include "scene/load_record.h"

namespace ombrage {

/// The model library's way to files, telling the load's record what is read and looked for.
class RecordingIo : public Assimp::DefaultIOSystem {
public:
    bool Exists(const char* file) const override {
        const bool isThere = DefaultIOSystem::Exists(file);
        LoadRecord::presence(file, isThere);
        return isThere;
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        LoadRecord::content(file);
        return DefaultIOSystem::Open(file, mode);
    }
};

}  // namespace ombrage
