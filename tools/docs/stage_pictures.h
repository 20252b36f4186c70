// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <ombrage/renderer.h>
#include <ombrage/technique.h>

namespace ombrage::docs {

/// A picture that a technique's manual page shows of one of its stages, declared in NAME.pictures.json beside the page.
struct StagePicture {
    std::string file;  ///< "shadow-planar-limit.png", in the pages' folder of images
    std::string scene, camera, light, technique, show, composite;
    double lightSize_m = 0;  ///< of every lamp; of suns, the tangent of half their angle
};

/// Those of a technique; none where it declares none. @throws Error(Input) for unknown keys, and for a picture that the
/// page's text does not show or that it shows undeclared.
std::vector<StagePicture> stagePictures(const std::filesystem::path& source, const TechniqueInfo& info,
                                        const std::string& page);

void renderStagePicture(Renderer& renderer, const StagePicture& picture, const std::filesystem::path& images);

}  // namespace ombrage::docs
