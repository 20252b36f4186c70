// SPDX-License-Identifier: MIT
#include "lab/store.h"

#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "core/whole_file.h"
#include "lab/record_sample.h"

namespace ombrage {
namespace {

namespace fs = std::filesystem;

ResultKey keyOf(int number) {
    return ResultKey(kCompareKind).add("number", number);
}

class Store : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::path(testing::TempDir()) /
                   (std::string("ombrage_store_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(m_folder);
        fs::create_directories(m_folder / "images");
    }
    void TearDown() override {
        fs::permissions(m_folder, fs::perms::owner_all);
        fs::remove_all(m_folder);
    }

    std::string content(const char* name) const {
        std::ifstream in(m_folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const char* name, const std::string& text) const {
        std::ofstream(m_folder / name, std::ios::binary) << text;
    }
    /// Adds a result with one picture, as a comparison does.
    void putNumber(ResultStore& store, int number) const {
        const std::string picture = "images/" + keyOf(number).hash() + ".png";
        writeWhole(m_folder / picture, std::string(std::size_t(100 + number), 'x'));
        RunRecord record = sampleRecord();
        record.seed = std::uint64_t(number);
        record.images = {{"picture", picture}};
        store.put(keyOf(number), record.toJson(), {picture});
    }

    ErrorCode codeOf(const std::function<void()>& call, const char* message) const {
        try {
            call();
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
            EXPECT_FALSE(error.hint().empty());
            return error.code();
        }
        ADD_FAILURE() << "nothing was thrown";
        return ErrorCode::Usage;
    }

    /// Runs in a process of its own; nothing of this one's stores may be open.
    pid_t inChild(const std::function<int()>& work) const {
        const pid_t child = fork();
        if (child != 0) return child;
        int code = 99;
        try {
            code = work();
        } catch (const Error& error) {
            code = 100 + int(error.code());
        } catch (...) {
        }
        _exit(code);
    }
    static int codeOfChild(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    }

    fs::path m_folder;
};

TEST_F(Store, FindsWhatWasPutAndNothingElse) {
    ResultStore store(m_folder);
    EXPECT_FALSE(store.find(keyOf(1)));
    store.put(keyOf(1), "one", {});
    store.put(keyOf(2), "two", {});
    EXPECT_EQ(store.find(keyOf(1)), "one");
    EXPECT_FALSE(store.find(keyOf(3)));
    EXPECT_FALSE(store.find(ResultKey("bench").add("number", 1)));
    EXPECT_EQ(store.records(kCompareKind), (std::vector<std::string>{"one", "two"}));
    // In the place of the old one, not beside it.
    store.put(keyOf(1), "uno", {});
    EXPECT_EQ(store.records(kCompareKind), (std::vector<std::string>{"uno", "two"}));
    EXPECT_TRUE(store.records("bench").empty());
}

TEST_F(Store, KeepsEverythingBetweenProgramsButNotAfterClear) {
    ResultStore(m_folder).put(keyOf(1), "one", {});
    EXPECT_EQ(ResultStore(m_folder).find(keyOf(1)), "one");
    EXPECT_EQ(ResultStore::openForReading(m_folder)->find(keyOf(1)), "one");
    ResultStore(m_folder).clear();
    EXPECT_FALSE(ResultStore(m_folder).find(keyOf(1)));
}

TEST_F(Store, KeysDifferInEveryValueAndInTheirOrder) {
    std::set<std::string> texts, hashes;
    for (const ResultKey& key : {ResultKey("a"), ResultKey("b"), ResultKey("a").add("x", 1), ResultKey("a").add("x", 2),
                                 ResultKey("a").add("x", 1).add("y", 2), ResultKey("a").add("y", 2).add("x", 1),
                                 ResultKey("a").add("x", "1\",\"y\":\"2"), ResultKey("a").add("x", 0.1)}) {
        texts.insert(key.text());
        hashes.insert(key.hash());
    }
    EXPECT_EQ(texts.size(), 8u);
    EXPECT_EQ(hashes.size(), 8u);
    EXPECT_EQ(ResultKey("a").add("x", 0.5).text(), "{\"result\":\"a\",\"x\":\"0.5\"}");
}

TEST_F(Store, ResultIsThereOnlyWithItsPictures) {
    ResultStore store(m_folder);
    putNumber(store, 1);
    ASSERT_TRUE(store.find(keyOf(1)));
    const fs::path picture = m_folder / "images" / (keyOf(1).hash() + ".png");
    fs::resize_file(picture, 50);
    EXPECT_FALSE(store.find(keyOf(1)));
    fs::remove(picture);
    EXPECT_FALSE(store.find(keyOf(1)));
    putNumber(store, 1);
    EXPECT_TRUE(store.find(keyOf(1)));
    EXPECT_EQ(codeOf([&] { store.put(keyOf(2), "two", {"images/none.png"}); }, "gone"), ErrorCode::Environment);
    EXPECT_EQ(store.records(kCompareKind).size(), 1u);
}

TEST_F(Store, NotesOfOneCallReplaceEachOtherAndTheLatestIsLast) {
    ResultStore store(m_folder);
    store.note("a", "a begins");
    store.note("b", "b begins");
    store.note("a", "a ends");
    EXPECT_EQ(store.notes(), (std::vector<std::string>{"b begins", "a ends"}));
}

TEST_F(Store, ExportsWholeLinesThatReplaceTheOldOnes) {
    ResultStore store(m_folder);
    store.exportLines();
    EXPECT_EQ(content(kRecordsFile), "");
    store.put(keyOf(1), "one", {});
    store.put(ResultKey("bench"), "other", {});
    store.note("a", "note");
    store.exportLines();
    store.exportLines();
    EXPECT_EQ(content(kRecordsFile), "one\n");
    EXPECT_EQ(content(kRunsFile), "note\n");
}

TEST_F(Store, TakesOverTheLinesOfAnOlderFolderOnce) {
    const RunRecord first = sampleRecord("shadow/a", 0.1), second = sampleRecord("shadow/b", 0.2),
                    again = sampleRecord("shadow/a", 0.3);
    const RunNote note{{"ombrage", "compare"}, {}, {}, false};
    write(kRecordsFile, first.toJson() + "\n" + second.toJson() + "\n" + again.toJson() + "\n{\"torn");
    write(kRunsFile, note.toJson() + "\n" + note.toJson() + "\n");
    for (int time = 0; time < 2; ++time) {
        ResultStore store(m_folder);
        EXPECT_EQ(store.records(kCompareKind), (std::vector<std::string>{again.toJson(), second.toJson()}));
        EXPECT_EQ(store.notes().size(), 2u);
        store.exportLines();
    }
}

TEST_F(Store, RefusesOlderFoldersWithLinesThatAreNoRecords) {
    write(kRecordsFile, sampleRecord().toJson() + "\n{}\n");
    try {
        ResultStore store(m_folder);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_EQ(error.where(), (m_folder / kRecordsFile).string() + ":2");
    }
    // Nothing is half made: without the line it opens.
    write(kRecordsFile, sampleRecord().toJson() + "\n");
    EXPECT_EQ(ResultStore(m_folder).records(kCompareKind).size(), 1u);
}

TEST_F(Store, DamagedForeignAndLaterFilesAreErrorsThatSaySo) {
    const fs::path file = ResultStore::fileIn(m_folder);
    const auto open = [&] { ResultStore store(m_folder); };
    const auto read = [&] { ResultStore::openForReading(m_folder); };
    write("results.sqlite", std::string(5000, 'z'));
    for (const auto& way : std::vector<std::function<void()>>{open, read})
        EXPECT_EQ(codeOf(way, "damaged or no database"), ErrorCode::Input);

    fs::remove(file);
    sqlite::Database(file, sqlite::Access::Write).run("CREATE TABLE theirs(x)");
    for (const auto& way : std::vector<std::function<void()>>{open, read})
        EXPECT_EQ(codeOf(way, "another program"), ErrorCode::Input);

    fs::remove(file);
    open();
    sqlite::Database(file, sqlite::Access::Write).run("PRAGMA user_version = 99");
    for (const auto& way : std::vector<std::function<void()>>{open, read})
        EXPECT_EQ(codeOf(way, "another version"), ErrorCode::Input);

    fs::remove(file);
    open();
    sqlite::Database(file, sqlite::Access::Write).run("DROP TABLE pictures");
    EXPECT_EQ(codeOf(
                  [&] {
                      ResultStore store(m_folder);
                      putNumber(store, 1);
                  },
                  "no such table"),
              ErrorCode::Input);

    // A header that is whole and pages that are not.
    fs::remove(file);
    {
        ResultStore store(m_folder);
        for (int i = 0; i < 200; ++i) putNumber(store, i);
    }
    {
        std::fstream damaged(file, std::ios::binary | std::ios::in | std::ios::out);
        damaged.seekp(4096);
        damaged << std::string(std::size_t(fs::file_size(file) - 4096), '\x5a');
    }
    EXPECT_EQ(codeOf([&] { ResultStore(m_folder).records(kCompareKind); }, "damaged"), ErrorCode::Input);
}

// What goes into a file that has no name any more is lost.
TEST_F(Store, AFileThatIsTakenAwayIsToldAtTheNextResult) {
    ResultStore store(m_folder);
    putNumber(store, 1);
    for (const char* file : {"results.sqlite", "results.sqlite-wal", "results.sqlite-shm"}) fs::remove(m_folder / file);
    const std::vector<std::function<void()>> ways{[&] { putNumber(store, 2); }, [&] { store.note("call", "{}"); },
                                                  [&] { store.exportLines(); }};
    for (const auto& way : ways) EXPECT_EQ(codeOf(way, "were taken away"), ErrorCode::Environment);
    // Another one of that name is not ours.
    ResultStore other(m_folder);
    for (const auto& way : ways) EXPECT_EQ(codeOf(way, "were taken away"), ErrorCode::Environment);
    putNumber(other, 1);
    EXPECT_EQ(other.records(kCompareKind).size(), 1u);
}

// What is not done when the process dies is done by the next one; what is done is neither lost nor doubled.
TEST_F(Store, SurvivesKillsAtTenMoments) {
    constexpr int kCount = 400;
    std::mt19937 random(7);
    int killed = 0;
    for (int attempt = 0; attempt < 11; ++attempt) {
        const pid_t child = inChild([&] {
            ResultStore store(m_folder);
            for (int i = 0; i < kCount; ++i) {
                if (store.find(keyOf(i))) continue;
                putNumber(store, i);
                if (i % 7 == 0) store.exportLines();
            }
            store.exportLines();
            return 0;
        });
        if (attempt < 10) {
            std::this_thread::sleep_for(std::chrono::microseconds(std::uniform_int_distribution(1000, 20000)(random)));
            kill(child, SIGKILL);
        }
        const int code = codeOfChild(child);
        killed += code == 1000 + SIGKILL;
        EXPECT_TRUE(code == 0 || code == 1000 + SIGKILL) << code;
        const std::string lines = content(kRecordsFile);
        EXPECT_TRUE(lines.empty() || lines.back() == '\n');
    }
    // A machine that does everything in the shortest of the waits would have tested nothing.
    EXPECT_GE(killed, 5);
    std::vector<std::string> found = ResultStore(m_folder).records(kCompareKind);
    std::set<std::uint64_t> seeds;
    for (const std::string& text : found) seeds.insert(RunRecord::fromJson(text, "test").seed);
    EXPECT_EQ(found.size(), std::size_t(kCount));
    EXPECT_EQ(seeds.size(), std::size_t(kCount));
    for (int i = 0; i < kCount; ++i) EXPECT_TRUE(ResultStore(m_folder).find(keyOf(i))) << i;
    EXPECT_EQ(readLines(m_folder / kRecordsFile).size(), std::size_t(kCount));
}

TEST_F(Store, FourProcessesShareAFolder) {
    constexpr int kEach = 60;
    std::vector<pid_t> children;
    for (int process = 0; process < 4; ++process)
        children.push_back(inChild([&, process] {
            // All of them make the store, half of the results are everybody's.
            ResultStore store(m_folder);
            for (int i = 0; i < kEach; ++i) {
                putNumber(store, i % 2 == 0 ? i : 1000 * (process + 1) + i);
                store.exportLines();
            }
            return 0;
        }));
    for (const pid_t child : children) EXPECT_EQ(codeOfChild(child), 0);
    constexpr std::size_t kExpected = kEach / 2 + 4 * kEach / 2;
    EXPECT_EQ(ResultStore(m_folder).records(kCompareKind).size(), kExpected);
    // The last export is of the last state, whoever wrote it.
    EXPECT_EQ(readLines(m_folder / kRecordsFile).size(), kExpected);
}

TEST_F(Store, FolderThatCannotBeWrittenIsReadButNotWritten) {
    {
        ResultStore store(m_folder);
        putNumber(store, 1);
    }
    fs::permissions(m_folder, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                  fs::perms::others_exec | fs::perms::group_read | fs::perms::group_exec);
    fs::permissions(ResultStore::fileIn(m_folder),
                    fs::perms::others_read | fs::perms::group_read | fs::perms::owner_read);
    // Root may write anywhere: it becomes somebody else first.
    const auto child = [&](const std::function<int()>& work) {
        return codeOfChild(inChild([&] { return getuid() == 0 && setuid(65534) != 0 ? 77 : work(); }));
    };
    const int read = child([&] { return int(ResultStore::openForReading(m_folder)->records(kCompareKind).size()); });
    if (read == 77) GTEST_SKIP() << "cannot become another user";
    EXPECT_EQ(read, 1);
    EXPECT_EQ(child([&] {
                  ResultStore store(m_folder);
                  store.put(keyOf(2), "two", {});
                  return 0;
              }),
              100 + int(ErrorCode::Environment));
}

TEST_F(Store, ReportComesFromTheStoreAndFromOldLines) {
    write(kRecordsFile, sampleRecord("shadow/oldest").toJson() + "\n");
    const auto report = [&] {
        writeReport(m_folder);
        return content("report.html");
    };
    EXPECT_NE(report().find("shadow/oldest"), std::string::npos);
    {
        ResultStore store(m_folder);
        store.put(keyOf(1), sampleRecord("shadow/stored").toJson(), {});
    }
    // The export is not needed, and its absence hides nothing.
    fs::remove(m_folder / kRecordsFile);
    const std::string html = report();
    EXPECT_NE(html.find("shadow/oldest"), std::string::npos);
    EXPECT_NE(html.find("shadow/stored"), std::string::npos);
    EXPECT_EQ(codeOf([&] { writeReport(m_folder / "images"); }, "no records"), ErrorCode::Input);
}

}  // namespace
}  // namespace ombrage
