// SPDX-License-Identifier: MIT
#include "scene_pages.h"

#include <fmt/format.h>
#include <ombrage/compare.h>
#include <ombrage/reference.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>

#include "core/strings.h"
#include "scenes/expectations.h"

namespace ombrage::docs {

namespace fs = std::filesystem;
using test::Expectation;
using test::SceneExpectations;

namespace {

SceneExpectations expectationsOf(const fs::path& source, const std::string& scene) {
    return test::readExpectations(source / "tests/scenes/expectations", scene);
}

std::string tableOf(const SceneExpectations& expected) {
    std::string text = "| | technique | measured | why |\n|---|---|---|---|\n";
    const auto row = [&](const char* verb, const Expectation& e) {
        text += fmt::format("| {} | `{}` | `{}` {} {} | {} |\n", verb, e.technique, e.metric, e.min ? "≥" : "≤",
                            formatNumber(e.min.value_or(e.max.value_or(0))), e.why);
    };
    for (const Expectation& e : expected.shows) row("fails", e);
    for (const Expectation& e : expected.holds) row("holds", e);
    return text;
}

/// What lights it, and how many triangles it has.
std::string factsOf(const Scene& scene) {
    std::string lights;
    if (scene.lights.size() > 3)
        lights = fmt::format("{} {} lights", scene.lights.size(), lightTypeName(scene.lights[0].type));
    else
        for (const Light& light : scene.lights)
            lights += fmt::format("{}`{}` ({})", lights.empty() ? "" : ", ", light.name, lightTypeName(light.type));
    return fmt::format("{} triangles; {}{}.", scene.triangleCount(), lights,
                       scene.animations.empty() ? "" : "; moves with `--time`");
}

RenderSettings settingsOf(const SceneExpectations& expected) {
    RenderSettings settings;
    settings.width = test::kExpectationWidth;
    settings.height = test::kExpectationHeight;
    settings.camera = expected.camera;
    settings.time_s = expected.time_s;
    return settings;
}

/// The truth of every light in the techniques' place.
void giveTruth(const Scene& scene, const SceneExpectations& expected, RenderSettings& settings) {
    Scene moved = scene;
    animate(moved, expected.time_s);
    const Reference reference(moved);
    const Camera& camera = moved.cameras[std::size_t(moved.cameraIndex(expected.camera))];
    ReferenceOptions options;
    options.width = settings.width;
    options.height = settings.height;
    const Receivers receivers = reference.receivers(camera, options);
    for (std::size_t light = 0; light < moved.lights.size(); ++light) {
        const ShadowTruth truth = reference.shadow(receivers, camera, int(light), options);
        Image image(truth.width, truth.height, {"visibility"}, ColorSpace::Data);
        std::copy(truth.visibility.begin(), truth.visibility.end(), image.plane(0).begin());
        settings.givenVisibility.emplace(int(light), std::move(image));
    }
}

}  // namespace

std::string scenesPage(const fs::path& source) {
    std::string text =
        "# Built-in scenes\n\n"
        "Made by `tools/docs` from the scenes themselves and from what each declares under "
        "`tests/scenes/expectations`; a test "
        "measures every line at 320x180. `ombrage list scenes` prints the names, `ombrage render NAME -o out.png` "
        "draws one. On the "
        "left the scene with its ray-traced shadows, on the right the first line of its table. Every scene has the "
        "cameras "
        "`main`, `left` and `top`; all lights but those of `area-overlap` and `penumbrae` are hard.\n";
    for (const BuiltinScene& builtin : builtinScenes()) {
        const SceneExpectations expected = expectationsOf(source, builtin.name);
        text +=
            fmt::format("\n## {0}\n\n{1}\n\n![{0}, ray-traced](images/{0}.jpg) ![{0}, {2}](images/{0}-fails.jpg)\n\n",
                        builtin.name, builtin.description, expected.shows.front().technique);
        text += factsOf(loadScene(builtin.name));
        if (!expected.light.empty()) text += fmt::format(" Measured with the light `{}`.", expected.light);
        if (expected.time_s != 0) text += fmt::format(" Measured at {} s.", formatNumber(expected.time_s));
        text += "\n\n" + tableOf(expected);
    }
    return text;
}

void renderScenePictures(const fs::path& source, const fs::path& images) {
    Renderer renderer;
    for (const BuiltinScene& builtin : builtinScenes()) {
        const SceneExpectations expected = expectationsOf(source, builtin.name);
        const Scene scene = loadScene(builtin.name);
        renderer.setScene(scene);
        RenderSettings right = settingsOf(expected);
        giveTruth(scene, expected, right);
        right.show = {"final"};
        writeImage(images / (builtin.name + ".jpg"), renderer.render(right).shown.at("final"));

        const auto [family, pipeline] = parseTechnique(expected.shows.front().technique);
        RenderSettings failing = settingsOf(expected);
        (family == Family::Shadow ? failing.shadow : failing.ao) = pipeline;
        failing.show = {family == Family::Shadow ? "final" : "ao"};
        writeImage(images / (builtin.name + "-fails.jpg"), renderer.render(failing).shown.at(failing.show.front()));
    }
}

}  // namespace ombrage::docs
