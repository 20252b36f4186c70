// SPDX-License-Identifier: MIT
#include "lab/sqlite.h"

#include <sqlite3.h>
#include <chrono>
#include <thread>

#include <fmt/format.h>
#include <ombrage/error.h>

namespace ombrage::sqlite {

namespace {

/// A commit takes milliseconds; who has waited this long waits for a process that hangs.
constexpr int kPatience_ms = 60'000;

/// @param file  "": as the database knows it
[[noreturn]] void fail(sqlite3* database, int code, std::string file) {
    const char* const name = database ? sqlite3_db_filename(database, "main") : nullptr;
    if (file.empty() && name) file = name;
    const std::string what = database ? sqlite3_errmsg(database) : sqlite3_errstr(code);
    switch (code & 0xff) {
        case SQLITE_NOTADB:
        case SQLITE_CORRUPT:
            throw Error(ErrorCode::Input, "the results '" + file + "' are damaged or no database: " + what,
                        "move the file away; what lies beside it as JSON lines is then read in its place", file);
        case SQLITE_ERROR:
            throw Error(ErrorCode::Input, "the results '" + file + "' are not as this program makes them: " + what,
                        "move the file away; what lies beside it as JSON lines is then read in its place", file);
        case SQLITE_FULL:
            throw Error(ErrorCode::Environment, "no space left for the results '" + file + "'",
                        "free some space and run the same command again: what was done is kept", file);
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw Error(ErrorCode::Environment, "another process keeps the results '" + file + "' locked",
                        "end it or choose another folder, then run the same command again", file);
        default:
            throw Error(ErrorCode::Environment, "cannot use the results '" + file + "': " + what,
                        "check the folder's permissions and the free space", file);
    }
}

void check(sqlite3* database, int code, const std::string& file = {}) {
    if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE) fail(database, code, file);
}

/// A path as the URI that SQLite takes options in.
std::string uriOf(const std::filesystem::path& file) {
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(file).string())
        if (c == '%' || c == '?' || c == '#')
            uri += fmt::format("%{:02x}", c);
        else
            uri += c;
    return uri + "?immutable=1";
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(sqlite3* database, sqlite3_stmt* statement) : m_database(database), m_statement(statement) {}

Statement& Statement::bind(std::string_view text) {
    check(m_database, sqlite3_bind_text(m_statement.get(), ++m_bound, text.data(), int(text.size()), SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind(std::int64_t number) {
    check(m_database, sqlite3_bind_int64(m_statement.get(), ++m_bound, number));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(m_statement.get());
    check(m_database, code);
    return code == SQLITE_ROW;
}

std::string Statement::text(int column) const {
    const unsigned char* const text = sqlite3_column_text(m_statement.get(), column);
    return text ? std::string(reinterpret_cast<const char*>(text),
                              std::size_t(sqlite3_column_bytes(m_statement.get(), column)))
                : std::string();
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(m_statement.get(), column);
}

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close_v2(database);
}

Database::Database(const std::filesystem::path& file, Access access) {
    const int flags =
        access == Access::Write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    const std::string name = access == Access::Immutable ? uriOf(file) : std::filesystem::absolute(file).string();
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(name.c_str(), &opened, flags, nullptr);
    m_database.reset(opened);
    check(opened, code, file.string());
    sqlite3_busy_timeout(opened, kPatience_ms);
    // Opening looks at nothing: the first question tells whether this is a database.
    number("SELECT count(*) FROM sqlite_master");
}

Statement Database::prepare(const char* sql) const {
    sqlite3_stmt* statement = nullptr;
    check(m_database.get(), sqlite3_prepare_v2(m_database.get(), sql, -1, &statement, nullptr));
    return {m_database.get(), statement};
}

void Database::run(const char* sql) const {
    check(m_database.get(), sqlite3_exec(m_database.get(), sql, nullptr, nullptr, nullptr));
}

std::int64_t Database::number(const char* sql) const {
    Statement statement = prepare(sql);
    return statement.step() ? statement.integer(0) : 0;
}

void Database::useWriteAheadLog() const {
    // The change takes a lock of its own, for which SQLite does not wait.
    using namespace std::chrono;
    const auto end = steady_clock::now() + milliseconds(kPatience_ms);
    int code = SQLITE_BUSY;
    while (code == SQLITE_BUSY) {
        code = sqlite3_exec(m_database.get(), "PRAGMA journal_mode=WAL", nullptr, nullptr, nullptr);
        if (code != SQLITE_BUSY || steady_clock::now() > end) break;
        std::this_thread::sleep_for(milliseconds(5));
    }
    check(m_database.get(), code);
}

Transaction::Transaction(const Database& database) : m_database(database) {
    m_database.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    // What failed may have been undone by SQLite already: then this says so, and no harm is done.
    if (m_open) sqlite3_exec(m_database.m_database.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
    m_database.run("COMMIT");
    m_open = false;
}

}  // namespace ombrage::sqlite
