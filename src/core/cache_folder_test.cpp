// SPDX-License-Identifier: MIT
#include "core/cache_folder.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

namespace fs = std::filesystem;

/// Sets variables of the environment and puts them back.
class Environment {
public:
    void set(const char* name, const char* value) {
        if (m_old.count(name) == 0) {
            const char* const old = std::getenv(name);
            m_old[name] = old != nullptr ? std::optional<std::string>(old) : std::nullopt;
        }
        ::setenv(name, value, 1);
    }
    ~Environment() {
        for (const auto& [name, value] : m_old)
            if (value)
                ::setenv(name.c_str(), value->c_str(), 1);
            else
                ::unsetenv(name.c_str());
    }

private:
    std::map<std::string, std::optional<std::string>> m_old;
};

TEST(CacheFolder, WhereItLies) {
    Environment environment;
    environment.set("OMBRAGE_CACHE", "/o");
    environment.set("XDG_CACHE_HOME", "/x");
    environment.set("HOME", "/h");
    EXPECT_EQ(CacheFolder::locate("/asked", "scenes"), "/asked");
    EXPECT_EQ(CacheFolder::locate("off", "scenes"), "");
    EXPECT_EQ(CacheFolder::locate("", "scenes"), "/o");
    environment.set("OMBRAGE_CACHE", "off");
    EXPECT_EQ(CacheFolder::locate("", "scenes"), "");
    environment.set("OMBRAGE_CACHE", "");
    EXPECT_EQ(CacheFolder::locate("", "scenes"), "/x/ombrage/scenes");
    environment.set("XDG_CACHE_HOME", "relative");
    EXPECT_EQ(CacheFolder::locate("", "programs"), "/h/.cache/ombrage/programs");
    environment.set("HOME", "");
    EXPECT_EQ(CacheFolder::locate("", "programs"), "");
}

TEST(CacheFolder, KeepsToItsOwnFiles) {
    const fs::path folder = fs::path(testing::TempDir()) / "ombrage_cache_folder";
    fs::remove_all(folder);
    const CacheFolder cache(folder, ".mine", {1000, 1});
    const std::byte content[3] = {std::byte(1), std::byte(2), std::byte(3)};
    for (const char* name : {"a", "b"}) cache.write(name, content);
    std::ofstream(folder / "c.other", std::ios::binary) << std::string(5000, 'x');
    cache.evict();
    EXPECT_EQ(int(cache.read("a").has_value()) + int(cache.read("b").has_value()), 1);
    EXPECT_TRUE(fs::exists(folder / "c.other")) << "of another cache in the same folder";

    // A file that fails to be written leaves the old one, and no rest.
    cache.write("d", content);
    cache.write("d", [](int) { return false; });
    ASSERT_TRUE(cache.read("d"));
    EXPECT_EQ(cache.read("d")->span().size(), 3u);
    for (const auto& entry : fs::directory_iterator(folder)) EXPECT_NE(entry.path().extension(), ".part");
    EXPECT_FALSE(CacheFolder().isOn());
    EXPECT_FALSE(CacheFolder().read("a"));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace ombrage
