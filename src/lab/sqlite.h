// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace ombrage::sqlite {

/// One statement. Values are bound in the order of its question marks.
class Statement {
public:
    Statement& bind(std::string_view text);
    Statement& bind(std::int64_t number);
    /// True when there is a row to read. @throws Error as Database.
    bool step();
    std::string text(int column) const;
    std::int64_t integer(int column) const;

private:
    friend class Database;
    Statement(sqlite3* database, sqlite3_stmt* statement);
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    sqlite3* m_database;
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
    int m_bound = 0;
};

enum class Access {
    Read,       ///< nothing is written, also where nothing can be
    Immutable,  ///< as Read, in folders that cannot be written; nobody else may be writing
    Write       ///< made when it is not there
};

/// A connection to a database file, for one thread. Waits for other processes up to a minute.
///
/// Every member throws Error(Input) for what is no database or is damaged, and Error(Environment) for a full disk,
/// missing permissions and processes that do not give way.
class Database {
public:
    Database(const std::filesystem::path& file, Access access);
    Statement prepare(const char* sql) const;
    void run(const char* sql) const;
    std::int64_t number(const char* sql) const;
    /// Turns to write-ahead logging where the file system can.
    void useWriteAheadLog() const;

private:
    friend class Transaction;
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> m_database;
};

/// Takes the right to write at once and gives it back at the end, undoing everything unless commit() was called.
class Transaction {
public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

private:
    const Database& m_database;
    bool m_open = true;
};

}  // namespace ombrage::sqlite
