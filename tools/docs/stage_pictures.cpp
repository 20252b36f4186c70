// SPDX-License-Identifier: MIT
#include "stage_pictures.h"

#include <cmath>
#include <fstream>
#include <set>

#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <ombrage/scene.h>
#include <nlohmann/json.hpp>

#include "lab/plan.h"

namespace ombrage::docs {

namespace fs = std::filesystem;

namespace {

StagePicture pictureOf(const nlohmann::json& entry, const TechniqueInfo& info, const std::string& where) {
    static const std::set<std::string> known{"name", "scene",     "camera",     "light",
                                             "show", "technique", "light-size", "composite"};
    for (const auto& [key, value] : entry.items())
        if (known.count(key) == 0) throw Error(ErrorCode::Input, "unknown key '" + key + "'", "", where);
    StagePicture picture;
    picture.file =
        std::string(familyName(info.family)) + "-" + info.name + "-" + entry.at("name").get<std::string>() + ".png";
    picture.scene = entry.at("scene");
    picture.camera = entry.value("camera", "");
    picture.light = entry.value("light", "");
    picture.technique = entry.value("technique", info.id);
    picture.show = entry.value("show", "final");
    picture.composite = entry.value("composite", "lighting");
    picture.lightSize_m = entry.value("light-size", 0.0);
    return picture;
}

Composite compositeOf(const std::string& name) {
    if (name == "lighting") return Composite::Lighting;
    if (name == "modulate") return Composite::Modulate;
    if (name == "overlay") return Composite::Overlay;
    throw Error(ErrorCode::Input, "unknown way of composing '" + name + "'", "lighting, modulate or overlay");
}

}  // namespace

std::vector<StagePicture> stagePictures(const fs::path& source, const TechniqueInfo& info, const std::string& page) {
    const fs::path file = source / "src/techniques" / info.id / (info.name + ".pictures.json");
    std::vector<StagePicture> pictures;
    if (fs::exists(file)) {
        std::ifstream input(file);
        for (const nlohmann::json& entry : nlohmann::json::parse(input))
            pictures.push_back(pictureOf(entry, info, file.string()));
    }
    for (const StagePicture& picture : pictures)
        if (page.find("(images/" + picture.file + ")") == std::string::npos)
            throw Error(ErrorCode::Input, "the manual page does not show images/" + picture.file, "", file.string());
    const std::string mark = "(images/";
    for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1)) {
        const std::string shown = page.substr(at + mark.size(), page.find(')', at) - at - mark.size());
        bool isDeclared = false;
        for (const StagePicture& picture : pictures) isDeclared = isDeclared || picture.file == shown;
        if (!isDeclared)
            throw Error(ErrorCode::Input, "the manual page shows images/" + shown + ", which is not declared", "",
                        file.string());
    }
    return pictures;
}

void renderStagePicture(Renderer& renderer, const StagePicture& picture, const fs::path& images) {
    Scene scene = loadScene(picture.scene);
    for (Light& light : scene.lights)
        if (picture.lightSize_m > 0) {
            light.radius_m = float(picture.lightSize_m);
            light.angle_rad = 2 * std::atan(float(picture.lightSize_m));
        }
    RenderSettings settings;
    settings.width = 480;
    settings.height = 270;
    settings.camera = picture.camera;
    settings.light = picture.light;
    settings.composite = compositeOf(picture.composite);
    settings.show = {picture.show};
    const auto [family, pipeline] = parseTechnique(picture.technique);
    placeOf(family, settings) = pipeline;
    renderer.setScene(scene);
    writeImage(images / picture.file, renderer.render(settings).shown.at(picture.show));
}

}  // namespace ombrage::docs
