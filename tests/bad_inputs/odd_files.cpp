// SPDX-License-Identifier: MIT
#include "odd_files.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <sys/stat.h>
#include <unistd.h>

#include "good_files.h"

namespace ombrage::bad_inputs {

namespace fs = std::filesystem;

namespace {
std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

/// Scene texts; @ stands for a list with one good model.
std::map<std::string, std::string> sceneTexts() {
    using namespace std::string_literals;
    return {
        {"nothing", " "},
        {"null", "null"},
        {"list", "[]"},
        {"text", "\"scene\""},
        {"zero-bytes-behind", "{\"models\":@}\0\0\0"s},
        {"zero-byte-inside", "{\"models\":\0@}"s},
        {"more-behind", "{\"models\":@} {}"},
        {"two-commas", "{\"models\":@,,}"},
        {"comment", "{\"models\":@} // no comments in JSON"},
        {"single-quotes", "{'models':@}"},
        {"deep-lists", repeated("[", 100000)},
        {"deep-objects", repeated("{\"a\":", 100000) + "1" + repeated("}", 100000)},
        {"deep-value", "{\"models\":" + repeated("[", 100) + repeated("]", 100) + "}"},
        {"key-twice", "{\"models\":@,\"name\":\"a\",\"name\":\"b\"}"},
        {"number-overflows", "{\"models\":@,\"ambient\":1e999}"},
        {"number-tiny", "{\"models\":@,\"ao_radius_m\":1e-400}"},
        {"number-of-many-digits", "{\"models\":@,\"ambient\":" + repeated("9", 5000) + "}"},
        {"number-nan", "{\"models\":@,\"ambient\":NaN}"},
        {"not-utf8", "{\"models\":@,\"name\":\"\xff\xfe\"}"},
        {"half-a-surrogate", "{\"models\":@,\"name\":\"\\ud800\"}"},
        {"utf16", "\xff\xfe{\0}\0"s},
        {"long-name", "{\"models\":@,\"nam\":\"" + repeated("x", 1 << 20) + "\"}"},
        {"name-with-zero", "{\"models\":[{\"file\":\"m.obj\\u0000.png\"}]}"},
        {"itself", "{\"models\":[{\"file\":\"itself.json\"}]}"},
        {"folder", "{\"models\":[{\"file\":\".\"}]}"},
        {"device", "{\"models\":[{\"file\":\"/dev/zero\"}]}"},
        {"outside", "{\"models\":[{\"file\":\"../../../../../../etc/passwd\"}]}"},
        {"wrong-kind", "{\"models\":[{\"file\":\"wrong-kind.json\"}]}"},
        {"far-away", "{\"models\":[{\"file\":\"m.obj\",\"position\":[1e300,0,0]}]}"},
        {"flat-scale", "{\"models\":[{\"file\":\"m.obj\",\"scale\":[1,0,1]}]}"},
        {"no-direction", "{\"models\":@,\"lights\":[{\"type\":\"sun\",\"direction\":[0,0,0]}]}"},
        {"light-number", "{\"models\":@,\"lights\":[3]}"},
        {"camera-on-target", "{\"models\":@,\"cameras\":[{\"position\":[1,1,1],\"target\":[1,1,1]}]}"},
        {"camera-angle", "{\"models\":@,\"cameras\":[{\"position\":[1,1,1],\"fov_deg\":1e30}]}"},
        {"animation-of-nothing", "{\"models\":@,\"animations\":[{\"type\":\"orbit-light\",\"light\":\"x\"}]}"},
        {"many-unknown-keys",
         "{" + repeated("\"k\":1,", 1) + "\"models\":@," + "\"zz\":" + repeated("[", 20) + repeated("]", 20) + "}"},
    };
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
}  // namespace

std::vector<OddFile> writeOddFiles(const fs::path& folder) {
    std::vector<OddFile> files;
    const fs::path scenes = folder / "scenes";
    writeFile(scenes / "m.obj", kTriangle);
    for (auto [name, text] : sceneTexts()) {
        if (const std::size_t at = text.find('@'); at != std::string::npos)
            text.replace(at, 1, "[{\"file\":\"m.obj\"}]");
        writeFile(scenes / (name + ".json"), text);
        files.push_back({scenes / (name + ".json"), false});
    }
    // A scene of nothing odd shows that the others are refused for what they are.
    writeFile(scenes / "good.json", "{\"models\":[{\"file\":\"m.obj\"}]}");
    files.push_back({scenes / "good.json", true});

    const fs::path odd = folder / "odd";
    fs::create_directories(odd / "folder.obj");
    ::mkfifo((odd / "pipe.obj").c_str(), 0600);
    ::mkfifo((odd / "pipe.json").c_str(), 0600);
    fs::create_symlink("loop.obj", odd / "loop.obj");
    fs::create_symlink("nowhere.obj", odd / "dangling.obj");
    fs::create_symlink("/dev/zero", odd / "endless.obj");
    for (const char* extension :
         {"obj", "gltf", "glb", "ply", "md2", "json", "fbx", "stl", "dae", "3ds", "blend", "x", "off", "unknown"}) {
        writeFile(odd / (std::string("empty.") + extension), "");
        writeFile(odd / (std::string("noise.") + extension), repeated("\x9f\x03\xe1 7 -2 \xff{[", 400));
        for (const char* part : {"empty.", "noise."}) files.push_back({odd / (std::string(part) + extension), false});
    }
    for (const char* name :
         {"folder.obj", "pipe.obj", "pipe.json", "loop.obj", "dangling.obj", "endless.obj", "missing.obj"})
        files.push_back({odd / name, false});
    writeFile(odd / "huge.obj", "v 0 0 0\n");
    fs::resize_file(odd / "huge.obj", std::uintmax_t(6) << 30);
    files.push_back({odd / "huge.obj", false});
    writeFile(odd / "unreadable.obj", kTriangle);
    fs::permissions(odd / "unreadable.obj", fs::perms::none);
    files.push_back(
        {odd / "unreadable.obj", ::access((odd / "unreadable.obj").c_str(), R_OK) == 0});  // the superuser reads all
    writeFile(odd / "not-utf8-\xff\xfe.obj", kTriangle);
    files.push_back({odd / "not-utf8-\xff\xfe.obj", true});
    // Nodes within nodes: readers walk down by calling themselves.
    std::string nodes;
    for (int i = 0; i < 50000; ++i) nodes += "{\"children\":[" + std::to_string(i + 1) + "]},";
    writeFile(odd / "deep.gltf",
              "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + nodes + "{}]}");
    writeFile(odd / "nested.gltf", "{\"asset\":" + repeated("[", 200000) + repeated("]", 200000) + "}");
    writeFile(odd / "nested.dae", "<?xml version=\"1.0\"?><COLLADA>" + repeated("<node>", 100000) +
                                      repeated("</node>", 100000) + "</COLLADA>");
    for (const char* name : {"deep.gltf", "nested.gltf", "nested.dae"}) files.push_back({odd / name, false});
    return files;
}

std::vector<OddFile> writeDegenerateFiles(const fs::path& folder) {
    // Each beside a good triangle, which must be seen.
    const std::string good = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\nf 1 3 4\nf 1 4 2\n";
    const std::map<std::string, std::string> texts = {
        {"nan", "v nan 0 0\nv 1 nan 0\nv 0 1 nan\nf 5 6 7\nf 1 2 5\n"},
        {"infinite", "v inf 0 0\nv 1 -inf 0\nv 1e39 1 1\nf 5 6 7\nf 1 2 5\nf 1 3 7\n"},
        {"no-area", "v 1 1 1\nv 2 2 2\nv 3 3 3\nf 5 6 7\nf 1 1 1\nf 1 2 2\nf 2 2 1\n"},
        {"sliver", "v 0 0 0\nv 1 0 0\nv 1 1e-30 0\nf 5 6 7\n"},
        {"denormal", "v 1e-40 0 0\nv 0 1e-40 0\nv 0 0 1e-40\nf 5 6 7\nv 1e-44 1 1\nf 5 6 8\n"},
        {"twice-the-same", "f 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 2 3\n"},
        {"huge", "v 1e30 0 0\nv 0 1e30 0\nv 0 0 1e30\nf 5 6 7\n"},
        {"huge-alone", "v 3e38 0 0\nv -3e38 1 0\nv 0 3e38 3e38\nf 5 6 7\n"},
        {"index-beyond", "f 1 2 99\nf 1 2 2000000000\nf -1 -2 -99\nf 0 1 2\n"},
        {"zero-normals", "vn 0 0 0\nvn nan nan nan\nvn 1e30 0 0\nvn 1e-30 0 0\nf 1//1 2//2 3//3\nf 1//4 3//4 4//1\n"},
        {"odd-coordinates", "vt nan 0\nvt 1e30 -1e30\nvt 0 0\nf 1/1 2/2 3/3\nf 1/2 3/2 4/2\n"},
        {"many-corners", "f" +
                             [] {
                                 std::string corners;
                                 for (int i = 0; i < 5000; ++i) corners += " " + std::to_string(i % 4 + 1);
                                 return corners;
                             }() +
                             "\n"},
    };
    std::vector<OddFile> files;
    for (const auto& [name, text] : texts) {
        writeFile(folder / (name + ".obj"), good + text);
        // Indices beyond the list may be refused; what is there is not what the author meant.
        files.push_back({folder / (name + ".obj"), name != "index-beyond"});
    }
    return files;
}

}  // namespace ombrage::bad_inputs
