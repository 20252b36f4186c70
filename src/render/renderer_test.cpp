// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <epoxy/gl.h>

#include "gl/context.h"
#include "render_fixture.h"

namespace ombrage {
namespace {

RenderSettings small(const std::string& shadow = "map:resolution=256") {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 36;
    settings.shadow = parsePipeline(Family::Shadow, shadow);
    return settings;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

class RendererTest : public RenderTest {};

void expectSame(const RenderResult& a, const RenderResult& b) {
    EXPECT_EQ(a.picture, b.picture);
    EXPECT_EQ(a.visibility, b.visibility);
    EXPECT_EQ(a.ao, b.ao);
    EXPECT_EQ(a.instance, b.instance);
    EXPECT_EQ(a.triangle, b.triangle);
}

TEST_F(RendererTest, TheSameSettingsGiveTheSameBits) {
    const Scene scene = loadScene("gap");
    const RenderResult first = render(scene, small());
    expectSame(first, again(small()));
    expectSame(first, render(scene, small()));
    Renderer other(options());
    other.setScene(scene);
    expectSame(first, other.render(small()));
    RenderSettings settings = small();
    settings.frames = 3;
    settings.warmupFrames = 2;
    expectSame(first, again(settings));
}

TEST_F(RendererTest, WhatCameBeforeLeavesNoTrace) {
    const Scene gap = loadScene("gap"), room = loadScene("room");
    const RenderResult first = render(gap, small());
    const RenderResult inRoom = render(room, small());
    EXPECT_NE(inRoom.picture, first.picture);
    expectSame(first, render(gap, small()));

    RenderSettings big = small();
    big.width = 100;
    big.height = 50;
    EXPECT_EQ(again(big).picture.width(), 100);
    expectSame(first, again(small()));
    for (const char* shadow : {"none", "map:resolution=64", "map:resolution=256,bias=slope", "none"})
        again(small(shadow));
    expectSame(first, again(small()));
    expectSame(inRoom, render(room, small()));
}

TEST_F(RendererTest, BytesAreOfWhatIsRenderedNotOfWhatWasBefore) {
    const Scene gap = loadScene("gap"), room = loadScene("room");
    const std::uint64_t none = render(gap, small("none")).gpuBytes, map = again(small("map:resolution=64")).gpuBytes;
    EXPECT_GT(map, none);
    again(small("volume-zfail"));
    EXPECT_EQ(again(small("none")).gpuBytes, none);
    RenderSettings given = small("none");
    given.givenVisibility[0] = Image::grey(given.width, given.height);
    again(given);
    EXPECT_EQ(again(small("none")).gpuBytes, none);
    render(room, small("volume-zfail"));
    EXPECT_EQ(render(gap, small("map:resolution=64")).gpuBytes, map);
}

TEST_F(RendererTest, MemoryDoesNotGrowOverAlternatingCalls) {
    const Scene scene = loadScene("gap");
    RenderSettings a = small(), b = small("map:resolution=128");
    b.width = 50;
    b.composite = Composite::Modulate;
    render(scene, a);
    const std::uint64_t withB = again(b).gpuBytes, withA = again(a).gpuBytes;
    for (int i = 0; i < 25; ++i) {
        EXPECT_EQ(again(b).gpuBytes, withB);
        EXPECT_EQ(again(a).gpuBytes, withA);
    }
    // G-buffer: 4 + 8 + 4 + 4 + 8 bytes per pixel; the map: 4 per texel; visibility, ambient occlusion, two pictures,
    // indirect light.
    const std::uint64_t pixels = 64 * 36;
    EXPECT_GE(withA, pixels * 28 + 256 * 256 * 4);
    EXPECT_LE(withA, pixels * (28 + 64) + 256 * 256 * 4);
}

TEST_F(RendererTest, LightsThatFindNoRoomGiveTheSamePicture) {
    const Scene scene = loadScene("many-lights");
    const std::size_t lights = scene.lights.size();
    for (const char* shadow : {"map:resolution=64", "volume-zfail", "ray-traced"}) {
        SCOPED_TRACE(shadow);
        RenderSettings settings = small(shadow);
        RenderSettings lookups = settings;
        lookups.images = false;
        const RenderResult all = render(scene, settings), looked = again(lookups);
        // Room for some, and for one alone.
        for (const std::uint64_t room : {std::uint64_t(3) * 6 * 64 * 64 * 4, std::uint64_t(1)}) {
            RendererOptions tight = options();
            tight.keptShadowBytes = room;
            Renderer bounded(tight);
            bounded.setScene(scene);
            for (int call = 0; call < 2; ++call) {
                const RenderResult few = bounded.render(settings);
                expectSame(all, few);
                EXPECT_LT(few.gpuBytes, all.gpuBytes);
                ASSERT_EQ(few.footprint.size(), lights);
                ASSERT_EQ(few.range.size(), lights);
                for (const auto& [light, footprint] : all.footprint)
                    EXPECT_EQ(few.footprint.at(light).texelPerMetre, footprint.texelPerMetre);
                ASSERT_FALSE(few.warnings.empty());
                EXPECT_TRUE(has(few.warnings.back(), "find no room")) << few.warnings.back();
            }
            // Visibilities of 0 and 1 pass through an image unchanged.
            EXPECT_EQ(bounded.render(lookups).picture, looked.picture);
        }
        EXPECT_TRUE(std::none_of(all.warnings.begin(), all.warnings.end(),
                                 [](const std::string& warning) { return has(warning, "find no room"); }));
    }
}

TEST_F(RendererTest, SaysWhenLightsNeedTooMuchMemory) {
    Scene scene = loadScene("gap");
    scene.lights.resize(4000, scene.lights.front());
    RenderSettings large = small();
    large.width = 1920;
    large.height = 1080;
    renderer().setScene(scene);
    EXPECT_TRUE(has(refusal(large), "the visibility of 4000 lights at 1920 x 1080 pixels takes 47460 MiB"));
}

TEST_F(RendererTest, FailedCallsLeaveTheRendererUsable) {
    const Scene scene = loadScene("gap");
    const RenderResult first = render(scene, small());
    RenderSettings broken = small();
    broken.ao = {{"ao/none", {}}, {"filter/none", {{"no-such", "1"}}}};
    for (int i = 0; i < 2; ++i)
        EXPECT_TRUE(has(refusal(broken), "filter/none has no parameter 'no-such'")) << "at call " << i;
    expectSame(first, again(small()));
}

TEST_F(RendererTest, AnimationsMoveWithTime) {
    Scene scene = loadScene("gap");
    scene.animations = {{"orbit-camera", "", 12}};
    const RenderResult start = render(scene, small());
    RenderSettings later = small();
    later.time_s = 3;
    EXPECT_NE(again(later).picture, start.picture);
    expectSame(start, again(small()));
    later.time_s = 12;
    // A whole turn comes back but for rounding: most pixels keep their triangle.
    const RenderResult turned = again(later);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < turned.triangle.size(); ++i) differing += turned.triangle[i] != start.triangle[i];
    EXPECT_LE(differing, turned.triangle.size() / 100);
}

TEST_F(RendererTest, ResultsSayWhatWasDone) {
    const Scene scene = loadScene("gap");
    RenderSettings settings = small();
    settings.frames = 5;
    const RenderResult result = render(scene, settings);
    const auto row = [&](const std::string& name) {
        return std::find_if(result.passes.begin(), result.passes.end(),
                            [&](const PassCost& pass) { return pass.name == name; });
    };
    ASSERT_NE(row("g-buffer"), result.passes.end());
    EXPECT_EQ(row("g-buffer")->triangles, scene.triangleCount());
    ASSERT_NE(row("lighting"), result.passes.end());
    EXPECT_EQ(row("lighting")->draws, scene.lights.size());
    EXPECT_GT(result.gpu_ms.median, 0);
    EXPECT_GE(result.gpu_ms.p95, result.gpu_ms.median);
    EXPECT_GT(result.cpu_ms, 0);
    EXPECT_EQ(result.visibility.size(), scene.lights.size());
    EXPECT_GT(result.footprint.at(0).texel_m + result.footprint.at(0).texelPerMetre, 0);
    EXPECT_FALSE(renderer().device().renderer.empty());
    EXPECT_TRUE(renderer().device().clock == "timestamp" || renderer().device().clock == "wall");
}

// Where nobody wants its image, lighting asks the map itself: a visibility of 0 or 1 loses nothing on its way through
// an image, so that the pictures are equal bit by bit. `cornell`'s light has six views.
TEST_F(RendererTest, ThePictureAloneIsTheSameWithoutAnImageOfVisibility) {
    for (const char* name : {"gap", "cornell", "many-lights"}) {
        SCOPED_TRACE(name);
        const Scene scene = loadScene(name);
        RenderSettings settings;
        settings.width = 160;
        settings.height = 90;
        settings.shadow = parsePipeline(Family::Shadow, "map:resolution=256");
        const RenderResult measured = render(scene, settings);
        settings.images = false;
        const RenderResult alone = again(settings);
        EXPECT_EQ(alone.picture, measured.picture);
        EXPECT_TRUE(alone.visibility.empty());
        EXPECT_FALSE(alone.ao);
        EXPECT_TRUE(alone.triangle.empty());
        EXPECT_EQ(alone.passes.back().name, "lighting with shadow/map");
        EXPECT_EQ(measured.passes.back().name, "lighting");

        // A lookup that nothing comes of would pass as well: the picture has shadows.
        settings.shadow = parsePipeline(Family::Shadow, "none");
        EXPECT_NE(again(settings).picture, alone.picture);
    }
}

TEST_F(RendererTest, WhatIsAskedForIsShownWithoutImagesToo) {
    const Scene scene = loadScene("gap");
    RenderSettings settings;
    settings.width = 96;
    settings.height = 54;
    settings.shadow = parsePipeline(Family::Shadow, "map");
    const RenderResult measured = render(scene, settings);
    settings.images = false;
    settings.show = {"visibility"};
    EXPECT_EQ(again(settings).shownRaw.at("visibility"), measured.visibility.at(0));
}

// By hand: the G-buffer writes 4 bytes of depth, 16 of words and, as surfaces of `gap` shine, 4 of material; the map of
// 256 x 256 texels 4 each; visibility has the planes of the G-buffer and the map bound and writes 2 bytes.
TEST_F(RendererTest, PassesCountTheBytesOfTheirImages) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 32;
    settings.shadow = parsePipeline(Family::Shadow, "map:resolution=256");
    std::map<std::string, std::uint64_t> bytes;
    for (const PassCost& pass : render(loadScene("gap"), settings).passes) bytes[pass.name] = pass.bytes;
    const std::uint64_t pixels = 64 * 32, map = 256 * 256 * 4;
    EXPECT_EQ(bytes.at("g-buffer"), pixels * 24);
    EXPECT_EQ(bytes.at("light depth"), map);
    EXPECT_EQ(bytes.at("visibility"), pixels * (24 + 2) + map);
}

TEST_F(RendererTest, NothingIsRenderedWithoutAScene) {
    Renderer fresh(options());
    EXPECT_THROW(fresh.render(small()), Error);
}

Scene twoLights() {
    Scene scene = loadScene("gap");
    scene.lights.push_back(hand::at(LightType::Point, {1, 3, 1}, {0, -1, 0}, 20));
    scene.lights.back().name = "second";
    return scene;
}

TEST_F(RendererTest, EveryNameThatIsOfferedIsShown) {
    const Scene scene = twoLights();
    for (const TechniqueInfo& info : techniques()) {
        RenderSettings settings = small("none");
        const Pipeline pipeline{{info.id, {}}};
        switch (info.family) {
            case Family::Shadow:
                settings.shadow = pipeline;
                break;
            case Family::Ao:
                settings.ao = pipeline;
                break;
            case Family::Filter:
                settings.ao.push_back(pipeline[0]);
                break;
            case Family::Indirect:
                settings.indirect = pipeline;
                break;
            case Family::Aa:
                settings.aa = pipeline;
                break;
        }
        SCOPED_TRACE(info.id);
        // A light that the technique takes, and both where it takes both.
        if (!info.domain.point) settings.light = scene.lights[0].name;
        if (!info.domain.sun) settings.light = scene.lights[1].name;
        RenderSettings all = settings;
        all.show = {"all"};
        const RenderResult result = render(scene, all);
        for (const PassInfo& pass : renderer().showNames(settings)) {
            ASSERT_EQ(result.shown.count(pass.name), 1u) << pass.name;
            ASSERT_EQ(result.shownRaw.count(pass.name), 1u) << pass.name;
            EXPECT_FALSE(result.shown.at(pass.name).empty()) << pass.name;
            EXPECT_FALSE(pass.description.empty()) << pass.name;
            settings.show = {pass.name};
            const RenderResult one = again(settings);
            EXPECT_EQ(one.shown.size(), 1u) << pass.name;
            EXPECT_EQ(one.shown.count(pass.name), 1u) << pass.name;
        }
    }
}

TEST_F(RendererTest, PicturesFitForLookingAtLieBetween0And1) {
    RenderSettings settings = small();
    settings.show = {"all"};
    const RenderResult result = render(loadScene("gap"), settings);
    for (const auto& [name, image] : result.shown) {
        if (image.colorSpace() != ColorSpace::Data) continue;
        for (int p = 0; p < image.planeCount(); ++p)
            for (float v : image.plane(p)) ASSERT_TRUE(v >= 0 && v <= 1) << name << " " << v;
    }
    EXPECT_EQ(result.shownRaw.at("final"), result.picture);
    EXPECT_EQ(result.shownRaw.at("visibility"), result.visibility.at(0));
}

TEST_F(RendererTest, IntermediatesOfFurtherLightsCarryTheirName) {
    const Scene scene = twoLights();
    RenderSettings settings = small();
    settings.show = {"light-depth", "light-depth@second", "visibility@second"};
    const RenderResult result = render(scene, settings);
    for (const std::string& name : settings.show) EXPECT_EQ(result.shown.count(name), 1u) << name;
    EXPECT_EQ(result.shownRaw.at("visibility@second"), result.visibility.at(1));
    // What no light owns has one name only.
    settings.show = {"depth@second"};
    EXPECT_TRUE(has(refusal(settings), "unknown picture to show 'depth@second'"));
}

TEST_F(RendererTest, WrongSettingsAreUsageErrors) {
    const Scene scene = twoLights();
    render(scene, small());
    const auto with = [](auto&& change) {
        RenderSettings settings = small();
        change(settings);
        return refusal(settings);
    };
    EXPECT_TRUE(has(with([](auto& s) { s.width = 0; }), "between 1 and 16384"));
    EXPECT_TRUE(has(with([](auto& s) { s.height = 16385; }), "between 1 and 16384"));
    EXPECT_TRUE(has(with([](auto& s) { s.frames = 0; }), "at least one"));
    EXPECT_TRUE(has(with([](auto& s) { s.warmupFrames = -1; }), "-1 to warm up"));
    EXPECT_TRUE(has(with([](auto& s) { s.overlayOpacity = 1.5; }), "between 0 and 1"));
    EXPECT_TRUE(has(with([](auto& s) { s.camera = "mian"; }), "unknown camera 'mian'"));
    EXPECT_TRUE(has(with([](auto& s) { s.light = "secnod"; }), "did you mean 'second'?"));
    EXPECT_TRUE(has(with([](auto& s) { s.show = {"visibilty"}; }), "did you mean 'visibility'?"));
    EXPECT_TRUE(has(with([](auto& s) { s.shadow = {}; }), "the shadow pipeline is empty"));
    EXPECT_TRUE(has(with([](auto& s) {
                        s.shadow = {{"ao/none", {}}};
                    }),
                    "ao/none cannot stand at place 1 of a shadow pipeline"));
    EXPECT_TRUE(has(with([](auto& s) { s.aa = {{"aa/none", {}}, {"filter/none", {}}}; }), "only aa techniques can"));
    EXPECT_TRUE(has(with([](auto& s) { s.shadow.push_back({"shadow/none", {}}); }), "does not refine another shadow"));
    EXPECT_TRUE(has(with([](auto& s) { s.shadow = {{"shadow/mpa", {}}}; }), "did you mean 'shadow/map'?"));
    EXPECT_TRUE(has(with([](auto& s) {
                        s.shadow = {{"shadow/map", {{"resolution", "8"}}}};
                    }),
                    "resolution takes 16 to 8192"));
    EXPECT_TRUE(has(with([](auto& s) { s.givenVisibility[0] = Image::grey(3, 3); }), "another size"));
    EXPECT_TRUE(has(with([](auto& s) { s.givenVisibility[7] = Image::grey(64, 36); }), "light 7"));
}

TEST_F(RendererTest, ALightThatATechniqueDoesNotSupportIsRefusedByName) {
    const Scene scene = twoLights();
    renderer().setScene(scene);
    for (const TechniqueInfo& info : techniques()) {
        if (info.family != Family::Shadow || info.domain.point) continue;
        RenderSettings settings = small(info.id);
        settings.light = "second";
        const std::string message = refusal(settings);
        EXPECT_TRUE(has(message, info.id + " does not support the point light 'second'")) << message;
    }
}

TEST_F(RendererTest, AHardTechniqueSaysThatItTakesASizedLightAsAPoint) {
    Scene scene = loadScene("gap");
    scene.lights[0].angle_rad = 0.01f;
    scene.lights[0].radius_m = 0.1f;
    const auto& warnings = render(scene, small()).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(has(warnings[0], "as a point at its centre")) << warnings[0];
    EXPECT_TRUE(again(small("none")).warnings.empty());
}

/// State that a host may leave, and that rendering touches: none of it is a default.
struct HostState {
    GLint values[24] = {};
    GLboolean mask[4] = {};
    GLfloat clear[4] = {}, blend[4] = {};
    bool operator==(const HostState&) const = default;
};

HostState readHostState() {
    HostState s;
    constexpr GLenum kNames[] = {GL_CURRENT_PROGRAM,
                                 GL_VERTEX_ARRAY_BINDING,
                                 GL_DRAW_FRAMEBUFFER_BINDING,
                                 GL_READ_FRAMEBUFFER_BINDING,
                                 GL_DEPTH_FUNC,
                                 GL_DEPTH_WRITEMASK,
                                 GL_CULL_FACE_MODE,
                                 GL_FRONT_FACE,
                                 GL_CLIP_ORIGIN,
                                 GL_CLIP_DEPTH_MODE,
                                 GL_ACTIVE_TEXTURE,
                                 GL_UNIFORM_BUFFER_BINDING,
                                 GL_SHADER_STORAGE_BUFFER_BINDING,
                                 GL_PACK_ALIGNMENT,
                                 GL_UNPACK_ROW_LENGTH,
                                 GL_STENCIL_FUNC,
                                 GL_STENCIL_REF,
                                 GL_BLEND_SRC_RGB,
                                 GL_BLEND_EQUATION_RGB,
                                 GL_TEXTURE_BINDING_2D,
                                 GL_SAMPLER_BINDING,
                                 GL_PIXEL_PACK_BUFFER_BINDING};
    int n = 0;
    for (GLenum name : kNames) glGetIntegerv(name, &s.values[n++]);
    const GLenum switches[] = {GL_DEPTH_TEST,         GL_BLEND,          GL_CULL_FACE,
                               GL_SCISSOR_TEST,       GL_STENCIL_TEST,   GL_FRAMEBUFFER_SRGB,
                               GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP, GL_DEPTH_CLAMP,
                               GL_PRIMITIVE_RESTART};
    for (GLenum name : switches) s.values[22] = s.values[22] * 2 + glIsEnabled(name);
    GLint box[8];
    glGetIntegerv(GL_VIEWPORT, box);
    glGetIntegerv(GL_SCISSOR_BOX, box + 4);
    for (GLint v : box) s.values[23] = s.values[23] * 31 + v;
    glGetBooleanv(GL_COLOR_WRITEMASK, s.mask);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, s.clear);
    glGetFloatv(GL_BLEND_COLOR, s.blend);
    return s;
}

TEST_F(RendererTest, AnAdoptedContextKeepsItsStateAndGivesTheSamePicture) {
    const Scene scene = loadScene("gap");
    RenderSettings settings = small();
    settings.show = {"all"};
    const RenderResult own = render(scene, settings);

    const auto host = gl::Context::createHeadless({options().device, true});
    host->makeCurrent();
    host->takeDebugMessages();
    GLuint texture = 0, sampler = 0, buffer = 0, array = 0, framebuffer = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA8, 4, 4);
    glCreateSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, 1 << 16, nullptr, 0);
    glCreateVertexArrays(1, &array);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);

    // Everything that would spoil a picture.
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindVertexArray(array);
    glViewport(1, 2, 3, 4);
    glEnable(GL_SCISSOR_TEST);
    glScissor(1, 1, 2, 2);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    glBlendColor(0.4f, 0.3f, 0.2f, 0.1f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA);
    glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 3, 0xf);
    glEnable(GL_RASTERIZER_DISCARD);
    glEnable(GL_COLOR_LOGIC_OP);
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 77);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffer);
    for (GLuint unit = 0; unit < 24; ++unit) {
        glBindTextureUnit(unit, texture);
        glBindSampler(unit, sampler);
    }
    glActiveTexture(GL_TEXTURE7);

    const HostState before = readHostState();
    {
        Renderer adopted(Renderer::AdoptCurrent{}, options());
        EXPECT_EQ(readHostState(), before) << "after making the renderer";
        adopted.setScene(scene);
        EXPECT_EQ(readHostState(), before) << "after setting the scene";
        const RenderResult result = adopted.render(settings);
        EXPECT_EQ(readHostState(), before) << "after rendering";
        expectSame(own, result);
        for (const auto& [name, image] : own.shownRaw) EXPECT_EQ(result.shownRaw.at(name), image) << name;
        EXPECT_ANY_THROW(adopted.render(small("map:resolution=256+shadow/none")));
        EXPECT_EQ(readHostState(), before) << "after an error";
    }
    EXPECT_EQ(readHostState(), before) << "after the renderer is gone";
    for (const std::string& message : host->takeDebugMessages()) ADD_FAILURE() << "OpenGL says " << message;
}

}  // namespace
}  // namespace ombrage
