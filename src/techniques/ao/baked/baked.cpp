// SPDX-License-Identifier: MIT
// ao/baked: ambient visibility of a scene that stands still, computed beforehand on the CPU and looked up.
#include <bit>
#include <cstring>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/cache_folder.h"
#include "core/log.h"
#include "core/trace.h"
#include "render/frame_context.h"
#include "render/technique.h"
#include "scene/solidity.h"
#include "techniques/ao/baked/bake.h"
#include "techniques/shared/cosine_visibility.h"
#include "techniques/shared/gpu_triangles.h"

namespace ombrage {

template <>
struct EnumChoices<baked::Store> {
    static std::vector<std::string> names() { return {"vertex", "texel"}; }
};

namespace baked {

namespace {

constexpr const char* kExtension = ".ao";
/// What is kept on the disk.
constexpr CacheFolder::Bounds kKept{std::uint64_t(256) << 20, 256};
constexpr GLuint kBlockStorage = 3;

struct BakedParams : AoRadius {
    Store store = Store::Texel;
    int texels = 300000;
    int samples = 128;
    bool dilate = true;

    static ParamTable describe() {
        using P = BakedParams;
        return fields(
            field(&P::store, "store")
                .effect(ParamEffect::Host)
                .help("Where values are kept: at the vertices, which is all that finely tessellated models need, or in "
                      "texels."),
            field(&P::texels, "texels")
                .range(10000, 8000000, Scale::Log)
                .effect(ParamEffect::Host)
                .help("How many texels the triangles that are larger than one share, on both sides where both can be "
                      "seen: the more, the sharper are contacts, and the longer takes the bake."),
            field(&P::samples, "samples")
                .range(8, 4096, Scale::Log)
                .effect(ParamEffect::Host)
                .help("Rays per texel or vertex; more leave less noise in the texture, at no cost when it is drawn."),
            aoRadiusField(), aoRadiusPercentField(),
            field(&P::dilate, "dilate")
                .effect(ParamEffect::Host)
                .help("Fills what lies inside of solids from what lies beside it; off shows the dark rims of contacts "
                      "that come of it."));
    }
};

/// A bake on the GPU.
struct Bake {
    gl::Texture texture;
    gl::Buffer blocks;
    float spacing_m = 0;
};

/// The bakes of one scene, as long as nothing in it moves.
struct Bakes {
    explicit Bakes(const GpuScene&) {}
    std::map<std::string, std::shared_ptr<const Bake>> byKey;
};

/// All but solids, whose back nobody sees from outside.
std::vector<bool> instancesWithBack(const GpuScene& scene) {
    std::map<int, bool> isSolidMesh;
    std::vector<bool> hasBack;
    for (const FlatInstance& instance : scene.flat().instances) {
        const auto [known, isNew] = isSolidMesh.try_emplace(instance.mesh, false);
        if (isNew) known->second = isSolid(scene.scene().meshes[std::size_t(instance.mesh)]);
        const AlphaMode mode = scene.scene().materials[std::size_t(instance.material)].alphaMode;
        hasBack.push_back(mode == AlphaMode::Mask || instance.mirrored || !known->second);
    }
    return hasBack;
}

gl::Buffer blockBuffer(const FlatScene& flat, const Layout& layout) {
    checkStorageSize(layout.blocks.size() * 3 * sizeof(glm::vec4));
    std::vector<glm::vec4> records;
    records.reserve(layout.blocks.size() * 3);
    for (std::size_t t = 0; t < layout.blocks.size(); ++t) {
        const Block& block = layout.blocks[t];
        const std::uint32_t words[3] = {std::uint32_t(block.across) | std::uint32_t(block.up) << 16,
                                        block.place[0].x | block.place[0].y << 16,
                                        block.place[1].x | block.place[1].y << 16};
        for (int k = 0; k < 3; ++k)
            records.emplace_back(flat.positions[flat.triangles[t][(block.first + k) % 3]],
                                 std::bit_cast<float>(words[k]));
    }
    return gl::Buffer::from(records, "baked blocks");
}

/// The texels from the disk, or computed and put there.
std::vector<float> texelsOf(const FrameContext& frame, const Layout& layout, const BakeOptions& options,
                            const std::string& key, bool keep) {
    const FlatScene& flat = frame.gpuScene->flat();
    const CacheFolder folder(CacheFolder::locate("", "scenes"), kExtension, kKept);
    std::vector<float> texels(std::size_t(layout.width) * std::size_t(layout.height));
    const auto kept = folder.read(key);
    // A file of another length is none of ours.
    if (kept && kept->size == texels.size() * sizeof(float)) {
        std::memcpy(texels.data(), kept->bytes.get(), kept->size);
        return texels;
    }
    const TraceScope trace("bake occlusion");
    info(fmt::format("baking the ambient occlusion of {} triangles", flat.triangles.size()));
    texels = bake(*frame.scene, flat, layout, options);
    if (keep) {
        folder.write(key, std::as_bytes(std::span(texels)));
        folder.evict();
    }
    return texels;
}

class Baked final : public AoTechniqueOf<BakedParams> {
public:
    void prepare(FrameContext&) override { m_bake.reset(); }

    /// A pose of many is not worth a file.
    void sceneMoved(FrameContext& frame) override {
        prepare(frame);
        m_hasMoved = true;
    }

    void render(FrameContext& frame, const gl::Texture& visibility) override {
        if (!m_bake) m_bake = bakeOf(frame);
        const auto pass = frame.pass("ao/baked");
        const gl::Framebuffer target({{&visibility}}, {}, "ao/baked");
        target.bind();
        gl::apply({});
        frame.bindGBuffer();
        m_bake->blocks.bindStorage(kBlockStorage);
        m_bake->texture.bind(kFirstFreeUnit);
        frame.fullscreenProgram(*this, "ao/baked/baked.frag")
            .set("u_perTexel", 1.0f / glm::vec2(m_bake->texture.width(), m_bake->texture.height()));
        frame.drawFullscreen();
        if (frame.wants("atlas")) frame.expose("atlas", m_bake->texture, ShowAs::Value);
        frame.counter("texel spacing (mm)", double(m_bake->spacing_m) * 1000);
    }

    std::uint64_t gpuBytes() const override {
        return m_bake ? gl::byteSize(m_bake->texture.desc()) + m_bake->blocks.size() : 0;
    }

private:
    std::shared_ptr<const Bake> bakeOf(const FrameContext& frame) const {
        const GpuScene& scene = *frame.gpuScene;
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        const Layout layout = makeLayout(scene.flat(), instancesWithBack(scene), p().store, std::uint64_t(p().texels),
                                         std::min(largest, 65536));
        const BakeOptions options{p().radiusIn(double(frame.scene->aoRadius_m), scene.bounds().diagonal()), p().samples,
                                  p().dilate};
        const std::string key = bakeKey(*frame.scene, scene.flat(), layout, options);
        std::shared_ptr<const Bake>& known = scene.derived<Bakes>().byKey[key];
        if (known) return known;

        auto made = std::make_shared<Bake>();
        made->blocks = blockBuffer(scene.flat(), layout);
        const std::vector<float> texels = texelsOf(frame, layout, options, key, !m_hasMoved);
        made->texture =
            gl::Texture({.format = GL_R16F, .width = layout.width, .height = layout.height}, "baked occlusion");
        made->texture.upload(0, GL_RED, GL_FLOAT, texels.data());
        made->texture.setFilter(GL_LINEAR, GL_LINEAR);
        made->spacing_m = p().store == Store::Texel ? layout.spacing_m : 0.0f;
        known = made;
        return known;
    }

    std::shared_ptr<const Bake> m_bake;
    bool m_hasMoved = false;
};

std::unique_ptr<AoIntegrand> makeIntegrand(const BakedParams& params) {
    return makeCosineVisibility(params);
}

}  // namespace

}  // namespace baked

using baked::Baked;

OMBRAGE_TECHNIQUE(
    ao, baked, Baked,
    {.title = "Baked ambient occlusion",
     .summary = "Visibility of the vertices or of texels all over the scene, traced once on the CPU by the reference's "
                "own estimator, kept with the scene and looked up.",
     .papers = {"zhukov1998ambient", "kavan2011vertex"},
     .limits = "Scenes that stand still: whatever moves asks for a new bake of seconds. Contacts are as sharp as the "
               "texels are fine, and normals are the meshes' own.",
     .passes = {{"atlas",
                 "The texture: a block for each side of each triangle that can be seen, rows of falling height"}},
     .integrand = integrandOf(&baked::makeIntegrand)})

}  // namespace ombrage
