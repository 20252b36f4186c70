// SPDX-License-Identifier: MIT
#include "lab/store.h"

#include <ombrage/error.h>
#include <system_error>

#include <sys/stat.h>

#include "core/strings.h"
#include "core/whole_file.h"
#include "lab/run_record.h"

namespace ombrage {

namespace fs = std::filesystem;

namespace {

/// Marks the file as ours ("Ombr"), and the layout of its tables.
constexpr std::int64_t kApplicationId = 0x4f6d6272;
constexpr std::int64_t kLayout = 1;

constexpr const char* kTables = R"(
    CREATE TABLE results(id INTEGER PRIMARY KEY, kind TEXT NOT NULL, key TEXT NOT NULL UNIQUE, hash TEXT NOT NULL,
                         record TEXT NOT NULL, added TEXT NOT NULL);
    CREATE TABLE pictures(result INTEGER NOT NULL, path TEXT NOT NULL, bytes INTEGER NOT NULL,
                          PRIMARY KEY(result, path)) WITHOUT ROWID;
    CREATE TABLE notes(id INTEGER PRIMARY KEY, call TEXT NOT NULL UNIQUE, note TEXT NOT NULL);
    PRAGMA application_id = 1332568690;
    PRAGMA user_version = 1;
)";
static_assert(kApplicationId == 1332568690 && kLayout == 1, "as the statements above say");

bool isEmpty(const sqlite::Database& database) {
    return database.number("SELECT count(*) FROM sqlite_master") == 0;
}

/// @throws Error(Input) for what another program, or a later version of this one, has made.
void checkMark(const sqlite::Database& database, const fs::path& file) {
    if (database.number("PRAGMA application_id") != kApplicationId)
        throw Error(ErrorCode::Input, "'" + file.string() + "' is the database of another program",
                    "choose another folder with -o DIR, or move the file away", file.string());
    if (database.number("PRAGMA user_version") != kLayout)
        throw Error(ErrorCode::Input, "'" + file.string() + "' was written by another version of the program",
                    "choose another folder with -o DIR, or move the file away", file.string());
}

std::vector<std::string> column(sqlite::Statement statement) {
    std::vector<std::string> texts;
    while (statement.step()) texts.push_back(statement.text(0));
    return texts;
}

std::string asLines(const std::vector<std::string>& texts) {
    return texts.empty() ? "" : join(texts, "\n") + "\n";
}

/// Zeros for a file that is not there.
std::pair<std::uint64_t, std::uint64_t> identityOfFile(const fs::path& file) {
    struct stat found {};
    if (::stat(file.c_str(), &found) != 0) return {};
    return {std::uint64_t(found.st_dev), std::uint64_t(found.st_ino)};
}

}  // namespace

fs::path ResultStore::fileIn(const fs::path& folder) {
    return folder / "results.sqlite";
}

void makeResultFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorCode::Environment, "cannot make the folder '" + folder.string() + "': " + error.message(),
                    "choose another with -o DIR");
}

ResultStore::ResultStore(const fs::path& folder, sqlite::Access access)
    : m_folder(folder), m_database(fileIn(folder), access), m_identity(identityOfFile(fileIn(folder))) {}

void ResultStore::requireFile() const {
    const fs::path file = fileIn(m_folder);
    if (identityOfFile(file) == m_identity) return;
    throw Error(ErrorCode::Environment, "the results '" + file.string() + "' were taken away while they were written",
                "leave the folder alone and run the same command again", file.string());
}

ResultStore::ResultStore(const fs::path& folder) : ResultStore(folder, sqlite::Access::Write) {
    if (!isEmpty(m_database)) checkMark(m_database, fileIn(m_folder));
    m_database.useWriteAheadLog();
    m_database.run("PRAGMA synchronous=FULL");
    // Tables and old records come in one transaction: another process sees all of them or makes them itself.
    sqlite::Transaction transaction(m_database);
    if (isEmpty(m_database)) {
        m_database.run(kTables);
        importLines();
    }
    transaction.commit();
}

std::optional<ResultStore> ResultStore::openForReading(const fs::path& folder) {
    std::error_code failed;
    const fs::path file = fileIn(folder);
    if (!fs::exists(file, failed)) return std::nullopt;
    const auto open = [&](sqlite::Access access) -> std::optional<ResultStore> {
        ResultStore store(folder, access);
        if (isEmpty(store.m_database)) return std::nullopt;
        checkMark(store.m_database, file);
        return store;
    };
    try {
        return open(sqlite::Access::Read);
    } catch (const Error& error) {
        // The log needs a file beside the database even for reading. Where none can be made and none was left, nobody
        // is writing.
        fs::path log = file;
        log += "-wal";
        if (error.code() != ErrorCode::Environment || (fs::exists(log, failed) && fs::file_size(log, failed) > 0))
            throw;
        return open(sqlite::Access::Immutable);
    }
}

std::optional<std::string> ResultStore::find(const ResultKey& key) const {
    sqlite::Statement result = m_database.prepare("SELECT id, record FROM results WHERE key = ?");
    if (!result.bind(key.text()).step()) return std::nullopt;
    sqlite::Statement pictures = m_database.prepare("SELECT path, bytes FROM pictures WHERE result = ?");
    pictures.bind(result.integer(0));
    while (pictures.step()) {
        std::error_code failed;
        const auto size = fs::file_size(m_folder / pictures.text(0), failed);
        if (failed || std::int64_t(size) != pictures.integer(1)) return std::nullopt;
    }
    return result.text(1);
}

void ResultStore::insert(const ResultKey& key, const std::string& record, const std::vector<std::string>& pictures) {
    sqlite::Statement result = m_database.prepare(
        "INSERT INTO results(kind, key, hash, record, added) VALUES(?, ?, ?, ?, datetime('now')) "
        "ON CONFLICT(key) DO UPDATE SET record = excluded.record, added = excluded.added RETURNING id");
    result.bind(key.kind()).bind(key.text()).bind(key.hash()).bind(record).step();
    const std::int64_t id = result.integer(0);
    result.step();
    m_database.prepare("DELETE FROM pictures WHERE result = ?").bind(id).step();
    for (const std::string& path : pictures) {
        std::error_code failed;
        const auto size = fs::file_size(m_folder / path, failed);
        if (failed)
            throw Error(ErrorCode::Environment, "the picture '" + (m_folder / path).string() + "' is gone",
                        "nobody may clear the folder while it is written to", (m_folder / path).string());
        m_database.prepare("INSERT OR REPLACE INTO pictures VALUES(?, ?, ?)")
            .bind(id)
            .bind(path)
            .bind(std::int64_t(size))
            .step();
    }
}

void ResultStore::put(const ResultKey& key, const std::string& record, const std::vector<std::string>& pictures) {
    sqlite::Transaction transaction(m_database);
    requireFile();
    insert(key, record, pictures);
    transaction.commit();
}

std::vector<std::string> ResultStore::records(const std::string& kind) const {
    sqlite::Statement statement = m_database.prepare("SELECT record FROM results WHERE kind = ? ORDER BY id");
    statement.bind(kind);
    return column(std::move(statement));
}

void ResultStore::insertNote(const std::string& call, const std::string& text) {
    // A new row, so that the latest call comes last.
    m_database.prepare("DELETE FROM notes WHERE call = ?").bind(call).step();
    m_database.prepare("INSERT INTO notes(id, call, note) SELECT coalesce(max(id), 0) + 1, ?, ? FROM notes")
        .bind(call)
        .bind(text)
        .step();
}

void ResultStore::note(const std::string& call, const std::string& text) {
    sqlite::Transaction transaction(m_database);
    requireFile();
    insertNote(call, text);
    transaction.commit();
}

std::vector<std::string> ResultStore::notes() const {
    return column(m_database.prepare("SELECT note FROM notes ORDER BY id"));
}

void ResultStore::clear() {
    sqlite::Transaction transaction(m_database);
    m_database.run("DELETE FROM results; DELETE FROM pictures; DELETE FROM notes");
    transaction.commit();
}

void ResultStore::importLines() {
    const auto where = [&](const char* file, int line) {
        return (m_folder / file).string() + ":" + std::to_string(line);
    };
    // What was run twice stands in an old file twice: as in its report, the later one counts.
    int line = 0;
    for (const std::string& text : readLines(m_folder / kRecordsFile)) {
        const RunRecord record = RunRecord::fromJson(text, where(kRecordsFile, ++line));
        insert(ResultKey(kCompareKind).add("imported", identityOf(record)), text, {});
    }
    line = 0;
    for (const std::string& text : readLines(m_folder / kRunsFile)) {
        RunNote::fromJson(text, where(kRunsFile, ++line));
        insertNote("imported " + std::to_string(line), text);
    }
}

void ResultStore::exportLines() const {
    const sqlite::Transaction onlyOne(m_database);
    requireFile();
    writeWhole(m_folder / kRecordsFile, asLines(records(kCompareKind)));
    if (const std::vector<std::string> groups = records(kBenchKind); !groups.empty())
        writeWhole(m_folder / "bench.jsonl", asLines(groups));
    if (const std::vector<std::string> runs = records(kTuneKind); !runs.empty())
        writeWhole(m_folder / "tune.jsonl", asLines(runs));
    writeWhole(m_folder / kRunsFile, asLines(notes()));
}

}  // namespace ombrage
