// SPDX-License-Identifier: MIT
// usage: ombrage_docs SOURCE_DIR OUTPUT_DIR [--pictures [FAMILY/NAME]]
// Writes the generated parts of the manual: OUTPUT_DIR/techniques, an index and one page per technique, made of its manual page and
// its declaration; OUTPUT_DIR/scenes, the page of the built-in scenes; with --pictures also what the program renders for them,
// the stages that techniques declare in NAME.pictures.json among it; those of one technique alone where it is named.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <ombrage/error.h>
#include <ombrage/renderer.h>
#include <ombrage/technique.h>

#include "core/strings.h"
#include "lab/plan.h"
#include "render/technique.h"
#include "scene_pages.h"
#include "stage_pictures.h"

namespace {

namespace fs = std::filesystem;
using namespace ombrage;

std::string readText(const fs::path& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input) throw Error(ErrorCode::Input, "cannot read this file", "", file.string());
    return {std::istreambuf_iterator<char>(input), {}};
}

void writeText(const fs::path& file, const std::string& text) {
    std::ofstream output(file, std::ios::binary);
    output << text;
    if (!output) throw Error(ErrorCode::Environment, "cannot write this file", "", file.string());
}

std::string fileName(const TechniqueInfo& info) { return std::string(familyName(info.family)) + "-" + info.name; }

std::string lightsOf(const Domain& domain) {
    std::vector<std::string> names;
    if (domain.sun) names.emplace_back("sun");
    if (domain.spot) names.emplace_back("spot");
    if (domain.point) names.emplace_back("point");
    if (domain.rect) names.emplace_back("rect");
    return join(names, ", ");
}

std::string domainOf(const TechniqueInfo& info) {
    if (info.family != Family::Shadow) return {};
    std::string text = "Lights: " + lightsOf(info.domain) + (info.domain.soft ? ", with their size" : ", taken as points") + ".";
    if (info.domain.closedCastersOnly) text += " Casters must be closed.";
    if (info.domain.planarReceiversOnly) text += " Receivers must be flat.";
    if (!info.domain.alphaTest) text += " The holes of alpha-tested casters are not seen.";
    return text + "\n\n";
}

/// The manual page, then all that the declaration says.
std::string pageOf(const TechniqueInfo& info, const fs::path& source) {
    std::string text = readText(source / "src/techniques" / info.id / (info.name + ".md"));
    docs::stagePictures(source, info, text);  // the text and the declared pictures agree
    text += "\n![" + info.title + "](images/" + fileName(info) + ".png)\n\n## Domain and parameters\n\n" + domainOf(info);
    const TechniqueEntry& entry = techniqueEntry(info.id);
    text += info.params.empty() ? "It has no parameters.\n" : entry.table().markdown();
    if (!info.passes.empty()) {
        text += "\nIntermediate pictures (`ombrage render SCENE --show NAME`):\n\n";
        for (const PassInfo& pass : info.passes) text += "- `" + pass.name + "`: " + pass.description + "\n";
    }
    if (!info.papers.empty()) text += "\nPapers ([references.bib](../references.bib)): " + join(info.papers, ", ") + ".\n";
    return text;
}

std::string indexOf() {
    std::string text =
        "# Techniques\n\nMade by `tools/docs` from the techniques' own folders. `ombrage list techniques` prints the same list.\n\n"
        "| technique | what it does | where it fails |\n|---|---|---|\n";
    for (const TechniqueInfo& info : techniques())
        text += "| [`" + info.id + "`](" + fileName(info) + ".md) | " + info.summary + " | " + info.limits + " |\n";
    return text;
}

/// What the family's picture shows best: the composed picture, or the image that the family makes.
void renderPicture(Renderer& renderer, const TechniqueInfo& info, const fs::path& file) {
    static const Scene shadowScene = loadScene("menger"), aoScene = loadScene("cornell"), lampScene = loadScene("room");
    RenderSettings settings;
    settings.width = 480;
    settings.height = 270;
    const bool usesAo = info.family == Family::Ao || info.family == Family::Filter;
    Pipeline& place = placeOf(info.family, settings);
    place = {{info.id, {}}};
    // A filter is shown on the first technique of its family that leaves it something to do.
    if (info.family == Family::Filter)
        for (const TechniqueInfo& other : techniques())
            if (other.family == Family::Ao && other.name != "none") {
                place.insert(place.begin(), {other.id, {}});
                break;
            }
    settings.show = {usesAo ? "ao" : "final"};
    const Scene& scene = usesAo ? aoScene : info.domain.sun ? shadowScene : lampScene;
    renderer.setScene(scene);
    writeImage(file, renderer.render(settings).shown.at(settings.show.front()));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 3) throw Error(ErrorCode::Usage, "too few arguments", "ombrage_docs SOURCE_DIR OUTPUT_DIR [--pictures [FAMILY/NAME]]");
        const fs::path source = argv[1], output = argv[2];
        const fs::path techniquePages = output / "techniques", scenePages = output / "scenes";
        for (const fs::path& folder : {techniquePages, scenePages}) fs::create_directories(folder / "images");
        writeText(techniquePages / "README.md", indexOf());
        for (const TechniqueInfo& info : techniques())
            writeText(techniquePages / (fileName(info) + ".md"), pageOf(info, source));
        writeText(scenePages / "README.md", docs::scenesPage(source));
        if (argc > 3 && std::string(argv[3]) == "--pictures") {
            const std::string only = argc > 4 ? argv[4] : "";
            if (!only.empty()) technique(only);  // or an error that suggests the nearest
            Renderer renderer;
            for (const TechniqueInfo& info : techniques()) {
                if (!only.empty() && info.id != only) continue;
                renderPicture(renderer, info, techniquePages / "images" / (fileName(info) + ".png"));
                const std::string page = readText(source / "src/techniques" / info.id / (info.name + ".md"));
                for (const docs::StagePicture& picture : docs::stagePictures(source, info, page))
                    docs::renderStagePicture(renderer, picture, techniquePages / "images");
            }
            if (only.empty()) docs::renderScenePictures(source, scenePages / "images");
        }
        return 0;
    } catch (const Error& e) {
        std::cerr << e.what() << "\n";
        return int(e.code());
    }
}
