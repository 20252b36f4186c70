// SPDX-License-Identifier: MIT
// Files read under guard and kept in the cache. OMBRAGE_IMPORT_PROGRAM names the guarded program.
#include <ombrage/scene.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene/archive.h"
#include "scene/scene_cache.h"
#include "scene/test_files.h"

namespace ombrage {
namespace {

namespace fs = std::filesystem;

// Sanitized programs have no limit of memory.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

SceneOptions guarded() {
    SceneOptions options;
    options.importer = OMBRAGE_IMPORT_PROGRAM;
    options.cache = "off";
    return options;
}

SceneOptions here() {
    SceneOptions options = guarded();
    options.importer = "off";
    return options;
}

SceneOptions cachedIn(const fs::path& folder) {
    SceneOptions options = here();
    options.cache = folder.string();
    return options;
}

std::size_t openFiles() {
    return std::size_t(std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

Error errorOf(const std::string& file, const SceneOptions& options) {
    try {
        loadScene(file, options);
    } catch (const Error& error) {
        return error;
    }
    return Error(ErrorCode::GateFailed, "no error");
}

/// An environment variable for one test.
class Environment {
public:
    Environment(const char* name, const char* value) : m_name(name) { ::setenv(name, value, 1); }
    ~Environment() { ::unsetenv(m_name); }

private:
    const char* m_name;
};

/// A program that does not behave, in the guarded one's place.
std::string script(const TestFolder& folder, const std::string& body) {
    const std::string file = folder.write("importer", "#!/bin/sh\n" + body + "\n");
    ::chmod(file.c_str(), 0755);
    return file;
}

class Guard : public testing::Test {
protected:
    void SetUp() override {
        m_obj = m_folder.write("t.obj", kTriangleObj);
        m_filesBefore = openFiles();
    }
    void TearDown() override {
        EXPECT_EQ(openFiles(), m_filesBefore) << "descriptors leaked";
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(errno, ECHILD);
    }
    Error errorWith(const std::string& body) {
        SceneOptions options = guarded();
        options.importer = script(m_folder, body);
        return errorOf(m_obj, options);
    }

    TestFolder m_folder;
    std::string m_obj;
    std::size_t m_filesBefore = 0;
};

TEST_F(Guard, GivesTheSameScene) {
    const Scene scene = loadScene(m_obj, guarded());
    EXPECT_EQ(contentHash(scene), contentHash(loadScene(m_obj, here())));
    EXPECT_EQ(scene.models.at(0).file, m_obj);
}

TEST_F(Guard, HandsErrorsOn) {
    const std::string file = m_folder.write("s.json", "{\"models\": [{\"file\": \"t.obj\"}],\n \"lihgts\": []}");
    const Error error = errorOf(file, guarded()), expected = errorOf(file, here());
    EXPECT_EQ(error.code(), ErrorCode::Input);
    EXPECT_EQ(error.where(), file + ":2: /lihgts");
    EXPECT_EQ(error.message(), expected.message());
    EXPECT_EQ(error.hint(), expected.hint());
}

TEST_F(Guard, SurvivesACrash) {
    for (const auto& [signal, name] : {std::pair("SEGV", "Segmentation fault"), std::pair("ABRT", "Aborted")}) {
        const Error error = errorWith(std::string("kill -") + signal + " $$");
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_NE(error.message().find("crashed while reading '" + m_obj + "'"), std::string::npos) << error.message();
        EXPECT_NE(error.message().find(name), std::string::npos) << error.message();
        EXPECT_FALSE(error.hint().empty());
    }
    EXPECT_NE(errorWith("kill -XCPU $$").message().find("ran out of time"), std::string::npos);
    EXPECT_NE(errorWith("kill -KILL $$").message().find("ended by the system"), std::string::npos);
    EXPECT_EQ(errorWith("kill -INT $$").code(), ErrorCode::Interrupted);
}

TEST_F(Guard, BelievesNoResult) {
    EXPECT_NE(errorWith("exit 0").message().find("without a result"), std::string::npos);
    EXPECT_NE(errorWith("exit 77").message().find("exit code 77"), std::string::npos);
    EXPECT_NE(errorWith("exit 10").message().find("without a reason"), std::string::npos);
    EXPECT_NE(errorWith("head -c 100000 /dev/urandom >&3; exit 0").message().find("without a result"),
              std::string::npos);
    EXPECT_NE(errorWith("head -c 100000 /dev/zero | tr '\\0' '\\377' >&3; exit 10").message().find("without a reason"),
              std::string::npos);
}

TEST_F(Guard, AForeignProgramIsNotUsed) {
    // The exit code that says "I belong to another version": the file is then read here.
    SceneOptions options = guarded();
    options.importer = script(m_folder, "exit 12");
    EXPECT_EQ(contentHash(loadScene(m_obj, options)), contentHash(loadScene(m_obj, here())));
    options.importer = "/nowhere/ombrage-import";
    EXPECT_EQ(errorOf(m_obj, options).code(), ErrorCode::Usage);
}

TEST_F(Guard, CancellingEndsIt) {
    SceneOptions options = guarded();
    options.importer = script(m_folder, "exec sleep 60");
    const auto start = std::chrono::steady_clock::now();
    options.cancelled = [&] { return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(100); };
    EXPECT_EQ(errorOf(m_obj, options).code(), ErrorCode::Interrupted);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));  // of 60: killed, not waited for
}

TEST_F(Guard, LimitsEndWhatRunsAway) {
    // 24 MB of vertices: the text alone and the reader's copy of it are more than 40 MiB.
    std::string text;
    for (int i = 0; i < 1200000; ++i) text += "v 0.125 " + std::to_string(i % 1000) + " 1.5\n";
    const std::string file = m_folder.write("large.obj", text + "v 1 1 1\nf -1 -2 -3\n");
    if (!kSanitized) {
        const Environment small("OMBRAGE_IMPORT_MEMORY_MIB", "40");
        const Error error = errorOf(file, guarded());
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_EQ(error.message(), "reading '" + file + "' needs more than 40 MiB of memory");
        EXPECT_EQ(error.where(), file);
    }
    EXPECT_EQ(errorOf(file, guarded()).message(), "no error");
    const Environment wrong("OMBRAGE_IMPORT_TIME_S", "soon");
    EXPECT_EQ(errorOf(file, guarded()).code(), ErrorCode::Usage);
}

TEST_F(Guard, SleepersMeetTheClock) {
    // A pipe in a texture's place: its reader would wait for a writer for ever. It is not a file, so it is
    // not opened.
    ASSERT_EQ(::mkfifo((m_folder.path() / "pipe.png").c_str(), 0600), 0);
    m_folder.write("t.mtl", "newmtl m\nmap_Kd pipe.png\n");
    const std::string file = m_folder.write("piped.obj", std::string("mtllib t.mtl\nusemtl m\n") + kTriangleObj);
    const Scene scene = loadScene(file, guarded());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "texture 'pipe.png' is no file but a pipe, a socket or a device");
}

TEST(LoadScene, RefusesWhatIsNoFile) {
    const TestFolder folder;
    const std::string fifo = (folder.path() / "fifo.obj").string(), loop = (folder.path() / "loop.obj").string();
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    fs::create_symlink("loop.obj", loop);
    fs::create_symlink("nowhere.obj", folder.path() / "dangling.obj");
    for (const SceneOptions& options : {here(), guarded()}) {
        EXPECT_NE(errorOf(fifo, options).message().find("no file but a pipe"), std::string::npos);
        EXPECT_NE(errorOf("/dev/zero", options).message().find("no file but a pipe"), std::string::npos);
        EXPECT_NE(errorOf(folder.path().string(), options).message().find("is a folder"), std::string::npos);
        EXPECT_NE(errorOf(loop, options).message().find("cannot open"), std::string::npos);
        EXPECT_NE(errorOf((folder.path() / "dangling.obj").string(), options).message().find("a link to"),
                  std::string::npos);
        EXPECT_NE(errorOf(folder.write("e.obj", ""), options).message().find("is empty"), std::string::npos);
    }
    // A sparse file: large, and nothing on the disk.
    const std::string huge = folder.write("huge.obj", "v");
    fs::resize_file(huge, std::uintmax_t(5) << 30);
    EXPECT_NE(errorOf(huge, guarded()).message().find("5120 MiB"), std::string::npos);
}

class Cache : public testing::Test {
protected:
    /// Loads, holds the scene against one read without the cache, and tells whether the cache had it before.
    bool hit(const std::string& file) {
        const LoadRequest request{file, fs::current_path().string(), false, false};
        const bool found = SceneCache(m_options).find(request).has_value();
        const Scene scene = loadScene(file, m_options);
        EXPECT_EQ(contentHash(scene), contentHash(loadScene(file, here())));
        EXPECT_EQ(scene.warnings, loadScene(file, here()).warnings);
        return found;
    }
    std::vector<fs::path> entries() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(m_cache.path())) files.push_back(entry.path());
        return files;
    }

    TestFolder m_folder, m_cache;
    SceneOptions m_options = cachedIn(m_cache.path());
};

TEST_F(Cache, EveryFileOfALoadCounts) {
    const std::string json = "{\"models\": [{\"file\": \"sub/t.obj\"}]}";
    m_folder.write("sub/t.obj", "mtllib T.mtl\nusemtl m\n" + std::string(kTriangleObj));
    const std::string file = m_folder.write("s.json", json);
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    // A material file that was missing is there now, then changes, then another takes precedence by its case.
    m_folder.write("sub/t.mtl", "newmtl m\nKd 1 0 0\nmap_Kd x.tga\n");
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    m_folder.write("sub/t.mtl", "newmtl m\nKd 0 1 0\nmap_Kd x.tga\n");
    EXPECT_FALSE(hit(file));
    m_folder.write("sub/T.mtl", "newmtl m\nKd 0 0 1\nmap_Kd x.tga\n");
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    // A texture that was missing: a TGA of 1 x 1 texels.
    const auto tga = [](char blue) {
        return std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x18\x20", 18) + blue + "\1\2";
    };
    m_folder.write("sub/x.tga", tga(1));
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    m_folder.write("sub/x.tga", tga(9));
    EXPECT_FALSE(hit(file));
    // The model and the scene themselves; then one goes.
    m_folder.write("sub/t.obj", "mtllib T.mtl\nusemtl m\nv 0 0 1\n" + std::string(kTriangleObj));
    EXPECT_FALSE(hit(file));
    m_folder.write("s.json", "{\"models\": [{\"file\": \"sub/t.obj\", \"scale\": 2}]}");
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    fs::remove(m_folder.path() / "sub/x.tga");
    EXPECT_FALSE(hit(file));
    // The same content by way of a link that leaves the folder is refused, not remembered.
    fs::rename(m_folder.path() / "sub/t.obj", m_cache.path() / "t.obj");
    fs::create_symlink(m_cache.path() / "t.obj", m_folder.path() / "sub/t.obj");
    EXPECT_NE(errorOf(file, m_options).message().find("outside"), std::string::npos);
}

TEST_F(Cache, TheBufferOfAGltfFileCounts) {
    const std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"b.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
    const auto buffer = [](float height) {
        const float p[9] = {0, 0, 0, 1, 0, 0, 0, height, 0};
        return std::string(reinterpret_cast<const char*>(p), sizeof p);
    };
    const std::string file = m_folder.write("m.gltf", gltf);
    m_folder.write("b.bin", buffer(1));
    EXPECT_FALSE(hit(file));
    EXPECT_TRUE(hit(file));
    m_folder.write("b.bin", buffer(0.5f));
    EXPECT_FALSE(hit(file));
}

TEST_F(Cache, OptionsCount) {
    const std::string file = m_folder.write("t.obj", kTriangleObj);
    EXPECT_EQ(loadScene(file, m_options).models.size(), 1u);
    m_options.ground = true;
    EXPECT_EQ(loadScene(file, m_options).models.size(), 2u);
    m_options.ground = false;
    EXPECT_EQ(loadScene(file, m_options).models.size(), 1u);
    m_options.eye = glm::dvec3(1, 2, 3);
    EXPECT_EQ(loadScene(file, m_options).cameras[0].position, glm::dvec3(1, 2, 3));
    m_options.eye.reset();
    EXPECT_NE(loadScene(file, m_options).cameras[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(entries().size(), 2u);
}

TEST_F(Cache, DamagedFilesOfTheCacheAreIgnored) {
    const std::string file = m_folder.write("t.obj", kTriangleObj);
    EXPECT_FALSE(hit(file));
    ASSERT_EQ(entries().size(), 1u);
    const fs::path entry = entries()[0];
    const std::uintmax_t size = fs::file_size(entry);
    for (const std::uintmax_t cut : {std::uintmax_t(0), std::uintmax_t(7), size / 2, size - 1}) {
        fs::resize_file(entry, cut);
        EXPECT_FALSE(hit(file)) << cut;
        EXPECT_TRUE(hit(file)) << "written anew";
    }
    std::fstream bytes(entry, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(std::streamoff(size / 2));
    bytes.put('#');
    bytes.close();
    EXPECT_FALSE(hit(file));
    // A link, a folder or a pipe in its place does no harm either.
    fs::remove(entry);
    ASSERT_EQ(::mkfifo(entry.c_str(), 0600), 0);
    EXPECT_FALSE(hit(file));
    fs::remove(entry);
    fs::create_directory(entry);
    EXPECT_FALSE(hit(file));
}

TEST_F(Cache, AFolderThatCannotBeWrittenCostsTheCacheOnly) {
    const std::string file = m_folder.write("t.obj", kTriangleObj);
    for (const char* folder : {"/proc/ombrage", "/dev/null/ombrage", "/dev/full"})
        EXPECT_EQ(contentHash(loadScene(file, cachedIn(folder))), contentHash(loadScene(file, here()))) << folder;
}

TEST_F(Cache, TheOldestGo) {
    const SceneCache cache(m_cache.path(), 100000, 3);
    std::vector<LoadRequest> requests;
    LoadedScene loaded{{}, {}, loadScene("gap")};
    for (int i = 0; i < 5; ++i) {
        loaded.request = {"f" + std::to_string(i), "", false, false};
        requests.push_back(loaded.request);
        cache.store(loaded);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // file times have ticks of some milliseconds
        if (i == 2) {
            EXPECT_TRUE(cache.find(requests[0])) << "used again, so no longer the oldest";
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
    std::vector<bool> kept;
    for (const LoadRequest& request : requests) kept.push_back(cache.find(request).has_value());
    EXPECT_EQ(kept, (std::vector<bool>{true, false, false, true, true}));
    // The bound of bytes.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::uintmax_t one = fs::file_size(entries()[0]);
    SceneCache(m_cache.path(), one + one / 2, 100).store(loaded);
    EXPECT_EQ(entries().size(), 1u);
    EXPECT_TRUE(cache.find(requests[4]));
}

TEST_F(Cache, WhatChangesWhileItIsReadIsNotKept) {
    // The guarded program stands still long enough for the file to change behind it.
    const std::string file = m_folder.write("t.obj", kTriangleObj);
    m_options.importer =
        script(m_folder, "\"" OMBRAGE_IMPORT_PROGRAM "\" \"$1\" $$ \"$3\" \"$4\" \"$5\"; code=$?; echo 'v 9 9 9' >> " +
                             file + "; exit $code");
    loadScene(file, m_options);
    EXPECT_TRUE(entries().empty());
}

}  // namespace
}  // namespace ombrage
