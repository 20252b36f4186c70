// SPDX-License-Identifier: MIT
#include "gl/shader_library.h"

#include <chrono>
#include <filesystem>
#include <fstream>

#include <ombrage/error.h>

#include "gl/objects.h"
#include "gl/shader_source.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVertex = "void main() { gl_Position = vec4(0.0); }\n";

class ShaderLibraryTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        m_folder = fs::path(testing::TempDir()) /
                   ("ombrage_shaders_" + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()));
        fs::create_directories(m_folder);
        write("test/a.vert", kVertex);
    }

    void TearDown() override {
        fs::remove_all(m_folder);
        GlTest::TearDown();
    }

    void write(const std::string& path, const std::string& text) {
        fs::create_directories((m_folder / path).parent_path());
        std::ofstream(m_folder / path, std::ios::binary) << text;
    }

    std::string folder() const { return m_folder.string(); }

    static ProgramDesc withFragment(const std::string& path) {
        ProgramDesc desc;
        desc.stages = {{GL_VERTEX_SHADER, "test/a.vert"}, {GL_FRAGMENT_SHADER, path}};
        return desc;
    }

    // The error that building the program throws. The driver may report its own log as debug messages too.
    static Error failure(ShaderLibrary& library, const ProgramDesc& desc) {
        try {
            library.program(desc);
        } catch (const Error& error) {
            context().takeDebugMessages();
            return error;
        }
        ADD_FAILURE() << "the program was built";
        return Error(ErrorCode::GateFailed, "");
    }

    fs::path m_folder;
};

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(ShaderLibraryTest, CompileErrorNamesLineOfIncludedFile) {
    write("shared/deep.glsl", "float deep() { return 1.0; }\n\nfloat broken() { return nonsense; }\n");
    write("shared/wide.glsl", "// one\n// two\n#include \"shared/deep.glsl\"\n");
    write("test/a.frag", "#include \"shared/wide.glsl\"\nout vec4 color;\nvoid main() { color = vec4(deep()); }\n");
    ShaderLibrary library(folder());
    const Error error = failure(library, withFragment("test/a.frag"));
    EXPECT_EQ(error.code(), ErrorCode::Environment);
    EXPECT_EQ(error.where(), "shared/deep.glsl:3") << error.message();
    EXPECT_TRUE(holds(error.message(), "shared/deep.glsl:3: ")) << error.message();
    EXPECT_TRUE(holds(error.message(), "nonsense")) << error.message();
}

TEST_F(ShaderLibraryTest, CompileErrorAfterIncludeNamesOuterLine) {
    write("shared/deep.glsl", "float deep() { return 1.0; }\n");
    write("test/a.frag", "#include \"shared/deep.glsl\"\n/* over\nlines */\nvoid main() { color = deep(); }\n");
    ShaderLibrary library(folder());
    EXPECT_EQ(failure(library, withFragment("test/a.frag")).where(), "test/a.frag:4");
}

TEST_F(ShaderLibraryTest, LinkErrorNamesThePrograms) {
    write("test/a.frag", "float missing(); out vec4 color; void main() { color = vec4(missing()); }");
    ShaderLibrary library(folder());
    const Error error = failure(library, withFragment("test/a.frag"));
    EXPECT_TRUE(holds(error.message(), "test/a.vert + test/a.frag")) << error.message();
    EXPECT_TRUE(holds(error.message(), "missing")) << error.message();
}

TEST_F(ShaderLibraryTest, UnknownIncludeSuggestsTheNearest) {
    write("shared/noise.glsl", "");
    write("test/a.frag", "\n#include \"shared/nose.glsl\"\nvoid main() {}\n");
    ShaderLibrary library(folder());
    const Error error = failure(library, withFragment("test/a.frag"));
    EXPECT_EQ(error.code(), ErrorCode::Usage);
    EXPECT_EQ(error.where(), "test/a.frag:2");
    EXPECT_TRUE(holds(error.message(), "shared/nose.glsl")) << error.message();
    EXPECT_TRUE(holds(error.hint(), "shared/noise.glsl")) << error.hint();
    EXPECT_EQ(failure(library, withFragment("test/none.frag")).code(), ErrorCode::Usage);
}

TEST_F(ShaderLibraryTest, CycleNamesItsChain) {
    write("shared/a.glsl", "#include \"shared/b.glsl\"\n");
    write("shared/b.glsl", "#include \"shared/a.glsl\"\n");
    write("test/a.frag", "#include \"shared/a.glsl\"\nvoid main() {}\n");
    ShaderLibrary library(folder());
    const Error error = failure(library, withFragment("test/a.frag"));
    EXPECT_EQ(error.code(), ErrorCode::Usage);
    EXPECT_TRUE(holds(error.message(), "shared/a.glsl -> shared/b.glsl -> shared/a.glsl")) << error.message();
    EXPECT_EQ(error.where(), "shared/b.glsl:1");
}

TEST_F(ShaderLibraryTest, MalformedSourcesAreRefused) {
    ShaderLibrary library(folder());
    const auto where = [&](const std::string& text) {
        write("test/a.frag", text);
        const Error error = failure(library, withFragment("test/a.frag"));
        EXPECT_EQ(error.code(), ErrorCode::Usage) << text;
        return error.where();
    };
    EXPECT_EQ(where("\n#version 330\nvoid main() {}\n"), "test/a.frag:2");
    EXPECT_EQ(where("#include <shared/a.glsl>\nvoid main() {}\n"), "test/a.frag:1");
    EXPECT_EQ(where("void main() {}\n#endif\n"), "test/a.frag:2");
    EXPECT_EQ(where("#if 1\nvoid main() {}\n"), "test/a.frag");
    EXPECT_THROW(ShaderLibrary(folder() + "/none"), Error);
}

TEST_F(ShaderLibraryTest, EachFileComesOncePerStage) {
    write("shared/one.glsl", "const float kOne = 1.0;\n");
    write("shared/two.glsl", "#include \"shared/one.glsl\"\nconst float kTwo = kOne + kOne;\n");
    write("test/a.frag",
          "#include \"shared/two.glsl\"\n#include \"shared/one.glsl\"\n"
          "// #include \"shared/none.glsl\"\n/*\n#include \"shared/none.glsl\"\n*/\n"
          "out vec4 color; void main() { color = vec4(kTwo); }\n");
    ShaderLibrary library(folder());
    library.program(withFragment("test/a.frag"));
    const std::string text = library.expand("test/a.frag", {});
    EXPECT_EQ(text.find("kOne ="), text.rfind("kOne ="));
    EXPECT_EQ(text.rfind("#version 450 core\n", 0), 0u);
}

TEST_F(ShaderLibraryTest, IncludeBehindAConditionDoesNotHideLaterOnes) {
    write("shared/inner.glsl", "const float kInner = 1.0;\n");
    write("shared/outer.glsl", "#include \"shared/inner.glsl\"\nconst float kOuter = kInner;\n");
    write("test/a.frag",
          "#ifdef WITH_OUTER\n#include \"shared/outer.glsl\"\n#endif\n#include \"shared/inner.glsl\"\n"
          "#include \"shared/outer.glsl\"\nout vec4 color; void main() { color = vec4(kInner + kOuter); }\n");
    ShaderLibrary library(folder());
    ProgramDesc desc = withFragment("test/a.frag");
    library.program(desc);
    desc.defines = {{"WITH_OUTER", "1"}};
    library.program(desc);
}

TEST_F(ShaderLibraryTest, ExtensionsMoveToTheFront) {
    write("shared/late.glsl",
          "#extension GL_ARB_shader_draw_parameters : enable\n#ifdef NEVER\n#extension GL_NONE_such : require\n#endif\n"
          "const float kLate = 1.0;\n");
    write("test/a.frag",
          "const float kEarly = 1.0;\n#include \"shared/late.glsl\"\n"
          "out vec4 color; void main() { color = vec4(kEarly + kLate); }\n");
    ShaderLibrary library(folder());
    library.program(withFragment("test/a.frag"));
    const std::string text = library.expand("test/a.frag", {});
    EXPECT_LT(text.find("GL_ARB_shader_draw_parameters"), text.find("kEarly"));
    EXPECT_LT(text.find("#ifdef NEVER\n#extension GL_NONE_such : require\n#endif"), text.find("kEarly"));
}

TEST_F(ShaderLibraryTest, VirtualIncludesAndDefinesMakeVariants) {
    write("test/a.frag",
          "#include \"test/params\"\nout vec4 color; void main() { color = vec4(params.radius * float(STEPS)); }\n");
    ShaderLibrary library(folder());
    ProgramDesc desc = withFragment("test/a.frag");
    desc.defines = {{"STEPS", "3"}};
    desc.virtuals = {{"test/params", "layout(std140, binding = 1) uniform Params { float radius; } params;\n"}};
    const Program& three = library.program(desc);
    EXPECT_EQ(&library.program(desc), &three);
    ProgramDesc other = desc;
    other.defines = {{"STEPS", "4"}};
    EXPECT_NE(library.program(other).id(), three.id());
    other = desc;
    other.virtuals[0].second += "// changed\n";
    EXPECT_NE(library.program(other).id(), three.id());
}

TEST_F(ShaderLibraryTest, OffsetsAreThoseOfStd140) {
    // Offsets from the std140 rules of the OpenGL specification 4.5, 7.6.2.2: vec3 aligns to 16 and leaves its last
    // four bytes to a scalar; array elements take 16 each; a mat4 is four vec4.
    write("test/a.frag",
          "layout(std140, binding = 0) uniform Named { float a; vec3 b; float c; vec2 d; float e[3]; mat4 f; } named;\n"
          "layout(std140, binding = 1) uniform Plain { int g; vec4 h; };\n"
          "out vec4 color; void main() { color = vec4(named.a + named.b.x + named.c + named.d.x + named.e[2]) + "
          "named.f[3] + h * float(g); }\n");
    ShaderLibrary library(folder());
    const Program& program = library.program(withFragment("test/a.frag"));
    EXPECT_EQ(program.uniformOffset("Named.a"), 0);
    EXPECT_EQ(program.uniformOffset("Named.b"), 16);
    EXPECT_EQ(program.uniformOffset("Named.c"), 28);
    EXPECT_EQ(program.uniformOffset("Named.d"), 32);
    EXPECT_EQ(program.uniformOffset("Named.e"), 48);
    EXPECT_EQ(program.uniformOffset("Named.f"), 96);
    EXPECT_EQ(program.uniformOffset("Plain.h"), 16);
    EXPECT_EQ(program.uniformOffset("Named.h"), -1);
    EXPECT_EQ(program.uniformOffset("Plain.none"), -1);
}

TEST_F(ShaderLibraryTest, SettersReachTheirUniforms) {
    ProgramDesc desc;
    desc.stages = {{GL_COMPUTE_SHADER, "test/c.comp"}};
    desc.virtuals = {{"test/c.comp", R"(
layout(local_size_x = 1) in;
uniform int i; uniform uint u; uniform float f; uniform vec2 v2; uniform vec3 v3; uniform vec4 v4; uniform ivec2 iv;
uniform mat4 m; uniform mat4 ms[2]; uniform vec4 vs[2]; uniform float unused;
layout(std430, binding = 0) buffer b_Out { float values[]; };
void main() {
    values[0] = float(i); values[1] = float(u); values[2] = f; values[3] = v2.y; values[4] = v3.z; values[5] = v4.w;
    values[6] = float(iv.y); values[7] = m[3][1]; values[8] = ms[1][0][2]; values[9] = vs[1].y;
}
)"}};
    ShaderLibrary library;
    const Program& program = library.program(desc);
    glm::mat4 m(0);
    m[3][1] = 8;
    glm::mat4 ms[2] = {};
    ms[1][0][2] = 9;
    const glm::vec4 vs[2] = {glm::vec4(0), glm::vec4(0, 10, 0, 0)};
    program.set("i", -1);
    program.set("u", 2u);
    program.set("f", 3.0f);
    program.set("v2", glm::vec2(0, 4));
    program.set("v3", glm::vec3(0, 0, 5));
    program.set("v4", glm::vec4(0, 0, 0, 6));
    program.set("iv", glm::ivec2(0, 7));
    program.set("m", m);
    program.set("ms", ms, 2);
    program.set("vs", vs, 2);
    program.set("unused", 1.0f);  // optimised away: nothing happens
    const Buffer out(10 * sizeof(float), nullptr, "out");
    out.bindStorage(0);
    program.use();
    dispatch(1, 1, 1);
    barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> values(10);
    out.download(0, 40, values.data());
    EXPECT_EQ(values, (std::vector<float>{-1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_F(ShaderLibraryTest, ReloadTakesGoodSourcesAndKeepsTheOldOnBadOnes) {
    const std::string user = "#include \"shared/x.glsl\"\nout vec4 color; void main() { color = vec4(kX); }\n";
    write("shared/x.glsl", "const float kX = 1.0;\n");
    write("test/a.frag", user);
    ShaderLibrary library(folder());
    const Program& program = library.program(withFragment("test/a.frag"));
    const GLuint first = program.id();
    EXPECT_TRUE(library.reload().empty());
    EXPECT_EQ(program.id(), first);

    write("shared/x.glsl", "const float kX = nonsense;\n");
    const auto errors = library.reload();
    context().takeDebugMessages();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_TRUE(holds(errors[0], "shared/x.glsl:1")) << errors[0];
    EXPECT_EQ(program.id(), first);
    EXPECT_EQ(glIsProgram(first), GL_TRUE);
    EXPECT_TRUE(library.reload().empty()) << "an error is told once";

    // The broken text now reaches for a file that does not exist; making that file mends it.
    write("shared/x.glsl", "#include \"shared/y.glsl\"\n");
    EXPECT_EQ(library.reload().size(), 1u);
    write("shared/y.glsl", "const float kX = 22.0;\n");
    EXPECT_TRUE(library.reload().empty());
    EXPECT_NE(program.id(), first);
    EXPECT_EQ(glIsProgram(first), GL_FALSE);
}

TEST_F(ShaderLibraryTest, SourceTreeIsADirectoryToo) {
    write("render/glsl/frame.glsl", "const float kFrame = 1.0;\n");
    write("techniques/shared/x.glsl", "const float kX = 1.0;\n");
    write("techniques/ao/blocks/blocks.frag",
          "#include \"ombrage/frame.glsl\"\n#include \"shared/x.glsl\"\n"
          "out vec4 color; void main() { color = vec4(kFrame + kX); }\n");
    write("techniques/ao/blocks/blocks.vert", kVertex);
    ShaderLibrary library(folder());
    ProgramDesc desc;
    desc.stages = {{GL_VERTEX_SHADER, "ao/blocks/blocks.vert"}, {GL_FRAGMENT_SHADER, "ao/blocks/blocks.frag"}};
    EXPECT_NE(library.program(desc).id(), 0u);
    write("techniques/ao/blocks/blocks.vert", "#include \"ombrage/frane.glsl\"\n");
    const auto errors = library.reload();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_TRUE(holds(errors[0], "ombrage/frame.glsl")) << errors[0];
}

TEST_F(ShaderLibraryTest, EmbeddedSourcesBackTheDirectory) {
    const auto embedded = ShaderLibrary::embeddedPaths();
    if (embedded.empty()) GTEST_SKIP() << "no shader is embedded in this build";
    const ShaderLibrary library(folder());
    EXPECT_FALSE(library.expand(embedded.front(), {}).empty());
    write(embedded.front(), "// taken from the directory\n");
    EXPECT_TRUE(holds(library.expand(embedded.front(), {}), "taken from the directory"));
}

TEST_F(ShaderLibraryTest, LogsOfAllDriversAreMapped) {
    const std::vector<SourceLine> lines = {
        {"<front>", 1}, {"ao/blocks/blocks.frag", 1}, {"ombrage/frame.glsl", 1}, {"ao/blocks/blocks.frag", 3}};
    EXPECT_EQ(mapLog("0:4(5): error: bad\n", lines), "ao/blocks/blocks.frag:3: error: bad");
    EXPECT_EQ(mapLog("0(3) : error C1503: undefined\n", lines), "ombrage/frame.glsl:1: error C1503: undefined");
    EXPECT_EQ(mapLog("ERROR: 0:2: 'x' : undeclared\n", lines), "ao/blocks/blocks.frag:1: ERROR: 'x' : undeclared");
    EXPECT_EQ(mapLog("0:9(1): error: no such line\n", lines), "0:9(1): error: no such line");
    EXPECT_EQ(mapLog("\nnote: a line\n\n", lines), "note: a line");
}

}  // namespace
}  // namespace ombrage::gl
