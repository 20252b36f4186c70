// SPDX-License-Identifier: MIT
#include "gl/program_cache.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <ombrage/trace.h>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

namespace fs = std::filesystem;

class ProgramCacheTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        m_folder = fs::path(testing::TempDir()) /
                   (std::string("ombrage_programs_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(m_folder);
        if (!offersProgramBinaries())
            GTEST_SKIP() << "SKIPPED: the driver hands out no compiled programs (Mesa: with its own cache off)";
    }
    void TearDown() override {
        fs::remove_all(m_folder);
        GlTest::TearDown();
    }

    /// A picture of one colour, of which the blue part is a define and the green one a uniform.
    static ProgramDesc colored(const std::string& blue) {
        ProgramDesc desc;
        desc.stages = {{GL_VERTEX_SHADER, "test/a.vert"}, {GL_FRAGMENT_SHADER, "test/a.frag"}};
        desc.defines = {{"BLUE", blue}};
        desc.virtuals = {{"test/a.vert",
                          "void main() { gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, "
                          "float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n"},
                         {"test/a.frag",
                          "uniform float green;\nuniform int unused;\nout vec4 color;\n"
                          "void main() { color = vec4(1.0, green, BLUE, 1.0); }\n"}};
        return desc;
    }

    struct Drawn {
        glm::vec4 color{0.0f};
        bool compiled = false;
    };

    /// Builds the program in a library of its own and draws with it.
    Drawn draw(const std::string& blue, CacheFolder::Bounds bounds = ProgramCache::kBounds) {
        const Trace trace;
        const ProgramCache cache(m_folder.string(), bounds);
        ShaderLibrary library({}, &cache);
        const Texture target({TextureKind::Tex2D, GL_RGBA32F, 4, 4}, "target");
        const Framebuffer framebuffer({Attachment{&target, 0, -1}}, {}, "target");
        const Program& program = library.program(colored(blue));
        beginFrameState();
        framebuffer.bind();
        apply({});
        program.use();
        program.set("green", 0.5f);
        program.set("unused", 1);
        drawFullscreen();
        std::vector<glm::vec4> texels(16);
        target.download(0, 0, GL_RGBA, GL_FLOAT, texels.size() * sizeof(glm::vec4), texels.data());
        return {texels[5], trace.json().find("\"compile shaders\"") != std::string::npos};
    }

    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(m_folder)) found.push_back(entry.path());
        return found;
    }

    fs::path m_folder;
};

TEST_F(ProgramCacheTest, AnEarlierRunsProgramDrawsTheSame) {
    const Drawn first = draw("0.25"), second = draw("0.25");
    EXPECT_TRUE(first.compiled);
    EXPECT_FALSE(second.compiled);
    EXPECT_EQ(first.color, glm::vec4(1.0f, 0.5f, 0.25f, 1.0f));
    EXPECT_EQ(second.color, first.color);
}

TEST_F(ProgramCacheTest, AnotherDefineIsAnotherProgram) {
    draw("0.25");
    const Drawn other = draw("0.75");
    EXPECT_TRUE(other.compiled);
    EXPECT_EQ(other.color.b, 0.75f);
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(ProgramCacheTest, DamagedFilesAreCompiledAnew) {
    draw("0.25");
    ASSERT_EQ(files().size(), 1u);
    const fs::path file = files().front();
    std::ifstream in(file, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    std::vector<std::string> damaged{"", whole.substr(0, 30), whole.substr(0, whole.size() / 2), whole + "x"};
    for (const std::size_t at : {std::size_t(0), std::size_t(9), std::size_t(33), whole.size() / 2, whole.size() - 1}) {
        damaged.push_back(whole);
        damaged.back()[at] = char(damaged.back()[at] ^ 0x55);
    }
    for (const std::string& content : damaged) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
        const Drawn drawn = draw("0.25");
        EXPECT_TRUE(drawn.compiled);
        EXPECT_EQ(drawn.color.b, 0.25f);
        EXPECT_FALSE(draw("0.25").compiled) << "written anew";
    }
}

TEST_F(ProgramCacheTest, AnotherProgramsFileUnderThisNameIsNotUsed) {
    draw("0.25");
    const fs::path quarter = files().front();
    fs::path other;
    draw("0.75");
    for (const fs::path& file : files())
        if (file != quarter) other = file;
    fs::copy_file(other, quarter, fs::copy_options::overwrite_existing);
    const Drawn drawn = draw("0.25");
    EXPECT_TRUE(drawn.compiled);
    EXPECT_EQ(drawn.color.b, 0.25f);
}

TEST_F(ProgramCacheTest, TextsAndStagesAreTheKey) {
    const ProgramCache cache(m_folder.string());
    const std::vector<StageSource> stages{{GL_VERTEX_SHADER, "a"}};
    ShaderLibrary library;
    const Program& good = library.program(colored("0.5"));
    cache.store(good.id(), stages);
    Program empty(glCreateProgram());
    EXPECT_TRUE(cache.load(empty.id(), stages));
    Program other(glCreateProgram());
    EXPECT_FALSE(cache.load(other.id(), {{GL_VERTEX_SHADER, "b"}}));
    EXPECT_FALSE(cache.load(other.id(), {{GL_FRAGMENT_SHADER, "a"}}));
}

TEST_F(ProgramCacheTest, TheFolderIsBounded) {
    for (const char* blue : {"0.1", "0.2", "0.3", "0.4"}) draw(blue, {std::uint64_t(1) << 20, 2});
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(ProgramCacheTest, OffAndUnwritableCostTheCacheAlone) {
    EXPECT_FALSE(ProgramCache("off").isOn());
    fs::create_directories(m_folder.parent_path());
    std::ofstream(m_folder, std::ios::binary) << "a file in the folder's place";
    EXPECT_TRUE(draw("0.25").compiled);
    EXPECT_EQ(draw("0.25").color.b, 0.25f);
}

}  // namespace
}  // namespace ombrage::gl
