// SPDX-License-Identifier: MIT
// aa/smaa: enhanced subpixel morphological anti-aliasing, 1x. See smaa.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/aa/smaa/smaa_tables.h"

namespace ombrage {

namespace {
enum class SmaaPreset { Low, Medium, High, Ultra, Custom };
}

template <>
struct EnumChoices<SmaaPreset> {
    static std::vector<std::string> names() { return {"low", "medium", "high", "ultra", "custom"}; }
};

namespace {

struct SmaaParams {
    SmaaPreset preset = SmaaPreset::High;
    float threshold = 0.1f;
    int searchSteps = 16;
    int diagonalSteps = 8;
    float cornerRounding = 0.25f;
    float localContrast = 2.0f;

    static ParamTable describe() {
        using P = SmaaParams;
        const auto host = ParamEffect::Host;
        return ParamTable(
            {field(&P::preset, "preset")
                 .effect(host)
                 .help("Those of the paper, in the place of threshold, search-steps, diagonal-steps and "
                       "corner-rounding: low "
                       "0.15, 4, 0, 1; medium 0.1, 8, 0, 1; high 0.1, 16, 8, 0.25; ultra 0.05, 32, 16, 0.25. custom: "
                       "those "
                       "four as they are set."),
             field(&P::threshold, "threshold")
                 .range(0.01, 0.5)
                 .tune(0.02, 0.2)
                 .effect(host)
                 .help("Step of luma that makes an edge, with preset=custom: lower finds more edges, and softens "
                       "texture."),
             field(&P::searchSteps, "search-steps")
                 .range(1, 112)
                 .tune(2, 32)
                 .effect(host)
                 .help("Steps of two pixels in which an edge is followed each way, with preset=custom: more smooth "
                       "longer, "
                       "nearly level edges."),
             field(&P::diagonalSteps, "diagonal-steps")
                 .range(0, kSmaaDiagonalSize - 1)
                 .tune(0, kSmaaDiagonalSize - 1)
                 .effect(host)
                 .help("Steps in which a diagonal is followed each way, with preset=custom; 0: as pieces of level "
                       "edges."),
             field(&P::cornerRounding, "corner-rounding")
                 .range(0, 1)
                 .tune(0, 1)
                 .effect(host)
                 .help("What a blend keeps of its strength at corners, with preset=custom: 0 leaves them sharp, 1 "
                       "rounds them."),
             field(&P::localContrast, "local-contrast")
                 .range(1, 10)
                 .tune(1.5, 4)
                 .effect(host)
                 .help(
                     "How many times stronger another edge next to it makes an edge be ignored: higher keeps more weak "
                     "edges, and doubles gradients.")});
    }

    /// With the preset's values in place.
    SmaaParams effective() const {
        const auto with = [&](float step, int search, int diagonal, float corner) {
            SmaaParams made = *this;
            made.threshold = step;
            made.searchSteps = search;
            made.diagonalSteps = diagonal;
            made.cornerRounding = corner;
            return made;
        };
        switch (preset) {
            case SmaaPreset::Low:
                return with(0.15f, 4, 0, 1.0f);
            case SmaaPreset::Medium:
                return with(0.1f, 8, 0, 1.0f);
            case SmaaPreset::High:
                return with(0.1f, 16, 8, 0.25f);
            case SmaaPreset::Ultra:
                return with(0.05f, 32, 16, 0.25f);
            case SmaaPreset::Custom:
                break;
        }
        return *this;
    }
};

class Smaa final : public AaTechniqueOf<SmaaParams> {
public:
    void prepare(FrameContext& frame) override {
        if (!m_area) makeTables();
        const auto target = [&](GLenum format, const char* label) {
            return gl::Texture({.format = format, .width = frame.width, .height = frame.height}, label);
        };
        m_edges = target(GL_RG8, "smaa edges");
        m_edges.setFilter(GL_LINEAR, GL_LINEAR);
        m_edges.setBorder(glm::vec4(0.0f));
        m_weights = target(GL_RGBA8, "smaa weights");
    }

    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        const SmaaParams params = p().effective();
        const auto encoded = frame.targets->take(input.desc(), "smaa encoded");
        draw(frame, "smaa encode", "shared/encode_luma.frag", {&input}, *encoded, [](const gl::Program&) {});
        draw(frame, "smaa edges", "aa/smaa/edges.frag", {encoded.get()}, m_edges, [&](const gl::Program& program) {
            program.set("u_threshold", params.threshold);
            program.set("u_localContrast", params.localContrast);
        });
        draw(frame, "smaa weights", "aa/smaa/weights.frag", {&m_edges, &m_area, &m_diagonal, &m_search}, m_weights,
             [&](const gl::Program& program) {
                 program.set("u_searchSteps", params.searchSteps);
                 program.set("u_diagonalSteps", params.diagonalSteps);
                 program.set("u_cornerWeight", params.cornerRounding);
             });
        draw(frame, "smaa blend", "aa/smaa/blend.frag", {&input, &m_weights}, output, [](const gl::Program&) {});
        if (frame.wants("smaa-edges")) frame.expose("smaa-edges", m_edges, ShowAs::Color);
        if (frame.wants("smaa-weights")) frame.expose("smaa-weights", m_weights, ShowAs::Color);
    }

    std::uint64_t gpuBytes() const override {
        std::uint64_t bytes = 0;
        for (const gl::Texture* texture : {&m_area, &m_diagonal, &m_search, &m_edges, &m_weights})
            if (*texture) bytes += gl::byteSize(texture->desc());
        return bytes;
    }

private:
    void makeTables() {
        const auto upload = [](const std::vector<glm::vec2>& table, int size, const char* label) {
            const int layers = int(table.size()) / (size * size);
            gl::Texture texture(
                {.kind = gl::TextureKind::Array2D, .format = GL_RG16F, .width = size, .height = size, .layers = layers},
                label);
            for (int layer = 0; layer < layers; ++layer)
                texture.upload(layer, GL_RG, GL_FLOAT, table.data() + layer * size * size);
            return texture;
        };
        m_area = upload(smaaAreaTable(), kSmaaAreaSize, "smaa areas");
        m_area.setFilter(GL_LINEAR, GL_LINEAR);
        m_diagonal = upload(smaaDiagonalTable(), kSmaaDiagonalSize, "smaa diagonal areas");
        m_search =
            gl::Texture({.format = GL_RG8UI, .width = kSmaaSearchSize, .height = kSmaaSearchSize}, "smaa search");
        m_search.upload(0, GL_RG_INTEGER, GL_UNSIGNED_BYTE, smaaSearchTable().data());
    }

    template <typename SetUniforms>
    void draw(FrameContext& frame, const char* name, const char* fragmentPath,
              const std::vector<const gl::Texture*>& inputs, const gl::Texture& output, SetUniforms&& set) {
        const auto pass = frame.pass(name);
        const gl::Framebuffer target({{&output}}, {}, name);
        target.bind();
        gl::apply({});
        for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i]->bind(kFirstFreeUnit + GLuint(i));
        set(frame.fullscreenProgram(*this, fragmentPath));
        frame.drawFullscreen();
    }

    gl::Texture m_area, m_diagonal, m_search, m_edges, m_weights;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    aa, smaa, Smaa,
    {.title = "Subpixel morphological anti-aliasing (SMAA 1x)",
     .summary = "Finds edges by luma, follows each to both of its ends, and blends by the area between it and "
                "the line that its crossing edges tell of; diagonals and corners are told apart.",
     .papers = {"jimenez2012smaa", "reshetov2009mlaa"},
     .limits = "Knows only the picture: detail thinner than a pixel keeps breaking up, and edges longer than "
               "the search stay stepped in their middle.",
     .passes = {{"smaa-edges", "edges with the left neighbour (red) and the lower one (green)"},
                {"smaa-weights",
                 "share of the pixel that its lower neighbour takes (red) and gives (green), and "
                 "that the left one takes (blue)"}}})

}  // namespace ombrage
